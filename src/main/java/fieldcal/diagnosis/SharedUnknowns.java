package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import java.util.Arrays;
import java.util.List;

/**
 * The unknowns that all kicks share, in order: accSlide, accRoll, kSwitch, the three dampings, then the coordinates of the effects. Flat kicks and chips roll alike. Immutable.
 */
final class SharedUnknowns {
  static final int ACC_SLIDE = 0;
  static final int ACC_ROLL = 1;
  static final int K_SWITCH = 2;
  static final int FIRST_HOP = 3;
  static final int OTHER_HOPS = 4;
  static final int DAMPING_Z = 5;
  static final int MODEL = 6;

  /** kSwitch of a solid ball that is kicked without spin, 1/(1 + 2/5). Spin of all kicks alike cannot be told from another kSwitch, so whoever names spin must say which of them is known. */
  static final double SOLID_BALL = 5.0 / 7;

  /** Parameters of the simple model are known beforehand to that many of their scales: next to nothing, but what no kick shows stays where it is. */
  private static final double VAGUE = 20;

  /** Step of numerical derivatives by effects, in their scales. */
  private static final double STEP = 0.04;

  private static final double[] MODEL_STEPS = {4e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3};

  final int size;
  final boolean[] free;
  final double[] min;
  final double[] max;
  final double[] step;
  final double[] expectedValue;
  final double[] expectedError;

  SharedUnknowns(
      Hypothesis hypothesis, FlatModel flat, ChipModel chip, boolean flats, boolean chips) {
    size = MODEL + hypothesis.coordinates();
    free = new boolean[size];
    min = new double[size];
    max = new double[size];
    step = Arrays.copyOf(MODEL_STEPS, size);
    expectedValue = new double[size];
    expectedError = new double[size];
    List<Parameter> f = flat.parameters();
    List<Parameter> c = chip.parameters();
    boolean spins = hypothesis.hasEffect("kick_spin");
    take(ACC_SLIDE, f.get(0), flats);
    take(ACC_ROLL, flats ? f.get(1) : c.get(3), true);
    take(K_SWITCH, spins ? f.get(2).withValue(SOLID_BALL) : f.get(2), flats && !spins);
    take(FIRST_HOP, c.get(0), chips);
    take(OTHER_HOPS, c.get(1), chips);
    take(DAMPING_Z, c.get(2), chips);
    int k = MODEL;
    for (Chart chart : hypothesis.charts()) {
      for (int j = 0; j < chart.size(); j++, k++) {
        free[k] = true;
        min[k] = -chart.limit(j);
        max[k] = chart.limit(j);
        step[k] = STEP * chart.scale(j);
        expectedError[k] = chart.expected(j);
      }
    }
  }

  private void take(int index, Parameter p, boolean isFree) {
    free[index] = isFree;
    min[index] = p.min();
    max[index] = p.max();
    expectedValue[index] = p.clamp(p.value());
    expectedError[index] = VAGUE * p.scale();
  }

  double clamp(int index, double value) {
    return Math.max(min[index], Math.min(max[index], value));
  }

  static FlatModel flat(double[] shared) {
    return new FlatModel(shared[ACC_SLIDE], shared[ACC_ROLL], shared[K_SWITCH]);
  }

  static ChipModel chip(double[] shared) {
    return new ChipModel(
        shared[FIRST_HOP], shared[OTHER_HOPS], shared[DAMPING_Z], shared[ACC_ROLL]);
  }
}
