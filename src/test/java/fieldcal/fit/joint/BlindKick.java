package fieldcal.fit.joint;

import java.util.Arrays;
import java.util.List;

/**
 * A linear kick that nobody can predict where its first own parameter is too large, like a ball that flies above the camera.
 *
 * @param kick elsewhere
 * @param most largest first own parameter with a prediction
 */
record BlindKick(ToyKick kick, double most) implements KickTerm<double[]> {
  @Override
  public int ownSize() {
    return kick.ownSize();
  }

  @Override
  public int rows() {
    return kick.rows();
  }

  @Override
  public void residuals(double[] own, double[] state, double[] out) {
    for (double v : own) {
      if (Double.isNaN(v)) {
        throw new IllegalArgumentException("asked for no number");
      }
    }
    kick.residuals(own, state, out);
    if (own[0] > most) {
      Arrays.fill(out, Double.NaN);
    }
  }

  @Override
  public void ownColumns(double[] own, double[] state, double[] residuals, double[][] columns) {
    kick.ownColumns(own, state, residuals, columns);
    if (own[0] > most) {
      Arrays.fill(columns[0], Double.NaN);
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
    return List.of(this);
  }

  @Override
  public List<Restart<double[]>> restarts(double[] own, double[] state) {
    return List.of(new Restart<>(this, new double[ownSize()]));
  }
}
