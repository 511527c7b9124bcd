package fieldcal.diagnosis.model;

import fieldcal.effect.MotionEffect;
import java.util.Arrays;
import java.util.List;

/** An effect whose first magnitude differs from kick to kick; the others are those of one setting of the global parameters. Immutable. */
final class OwnEffect {
  private final Component component;
  private final double[] coordinates;

  /**
   * @param coordinates of the component, the mean first; not copied
   */
  OwnEffect(Component component, double[] coordinates) {
    this.component = component;
    this.coordinates = coordinates;
  }

  /** The effect in a kick that has this value. */
  MotionEffect of(double value) {
    double[] at = coordinates.clone();
    at[0] = value;
    return (MotionEffect) component.effect(at, 0);
  }

  /** Whether two lists do the same in kicks with the same values, whatever the means. */
  static boolean actAlike(List<OwnEffect> some, List<OwnEffect> others) {
    for (int i = 0; i < some.size(); i++) {
      double[] a = some.get(i).coordinates;
      double[] b = others.get(i).coordinates;
      if (!Arrays.equals(a, 1, a.length, b, 1, b.length)) {
        return false;
      }
    }
    return true;
  }
}
