package fieldcal.app.play;

import fieldcal.fit.joint.KickTerm;
import java.util.List;

/** A kick of which only the derivatives are known, about zero: a term of the kernel for what a kick would tell. Immutable. */
final class LinearKick implements KickTerm<double[]> {
  private final List<double[]> derivatives;
  private final int size;
  private final int first;
  private final int shared;

  /**
   * A kick.
   *
   * @param derivatives of each observation, whitened, by all parameters; not to be changed
   * @param first index of the first global parameter
   * @param shared how many global parameters there are; the others are per-kick parameters
   */
  LinearKick(List<double[]> derivatives, int first, int shared) {
    this.derivatives = List.copyOf(derivatives);
    this.first = first;
    this.shared = shared;
    size = derivatives.get(0).length;
  }

  @Override
  public int ownSize() {
    return size - shared;
  }

  @Override
  public int rows() {
    return derivatives.size();
  }

  private int unknown(int own) {
    return own < first ? own : own + shared;
  }

  @Override
  public void residuals(double[] own, double[] state, double[] out) {
    for (int i = 0; i < out.length; i++) {
      double[] d = derivatives.get(i);
      out[i] = 0;
      for (int k = 0; k < own.length; k++) {
        out[i] -= d[unknown(k)] * own[k];
      }
      for (int k = 0; k < shared; k++) {
        out[i] -= d[first + k] * state[k];
      }
    }
  }

  @Override
  public void ownColumns(double[] own, double[] state, double[] residuals, double[][] columns) {
    for (int i = 0; i < derivatives.size(); i++) {
      for (int k = 0; k < own.length; k++) {
        columns[k][i] = derivatives.get(i)[unknown(k)];
      }
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
}
