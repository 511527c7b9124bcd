package fieldcal.fit.joint;

import java.util.List;

/** A kick that is linear in everything: {@code y = own·a + globals·b}. Own parameters beyond the first {@code plain} are values of random effects. */
final class ToyKick implements KickTerm<double[]> {
  final double[] y;
  final double[][] a;
  final double[][] b;
  private final boolean movable;
  private final double shift;
  private final double most;

  /**
   * @param a one array of rows per own parameter
   * @param b one array of rows per global parameter
   */
  ToyKick(double[] y, double[][] a, double[][] b) {
    this(y, a, b, false, 0, Double.POSITIVE_INFINITY);
  }

  private ToyKick(
      double[] y, double[][] a, double[][] b, boolean movable, double shift, double most) {
    this.y = y;
    this.a = a;
    this.b = b;
    this.movable = movable;
    this.shift = shift;
    this.most = most;
  }

  /** With an upper bound of the first own parameter. */
  ToyKick withMost(double value) {
    return new ToyKick(y, a, b, movable, shift, value);
  }

  @Override
  public void clamp(double[] own) {
    own[0] = Math.min(own[0], most);
  }

  /** With a discrete unknown: a whole number that is added to every prediction; others than 0 to 3 are impossible. */
  ToyKick withShift(int value) {
    return new ToyKick(y, a, b, true, value, most);
  }

  double shift() {
    return shift;
  }

  @Override
  public int ownSize() {
    return a.length;
  }

  @Override
  public int rows() {
    return y.length;
  }

  @Override
  public void residuals(double[] own, double[] state, double[] out) {
    for (int i = 0; i < y.length; i++) {
      out[i] = y[i] - shift * i;
      for (int k = 0; k < a.length; k++) {
        out[i] -= a[k][i] * own[k];
      }
      for (int k = 0; k < b.length; k++) {
        out[i] -= b[k][i] * state[k];
      }
    }
  }

  @Override
  public void ownColumns(double[] own, double[] state, double[] residuals, double[][] columns) {
    for (int k = 0; k < a.length; k++) {
      System.arraycopy(a[k], 0, columns[k], 0, y.length);
    }
  }

  @Override
  public double ownPrior(int index) {
    return 0;
  }

  @Override
  public double ownPrecision(int index) {
    return 0;
  }

  @Override
  public List<KickTerm<double[]>> neighbours() {
    return movable ? List.of(withShift((int) shift - 1), withShift((int) shift + 1)) : List.of();
  }

  @Override
  public double penalty(double[] own, double[] state) {
    return movable && (shift < 0 || shift > 3) ? Double.POSITIVE_INFINITY : 0;
  }
}
