package fieldcal.diagnosis;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.function.DoubleUnaryOperator;

/** Kicks whose ball was seen elsewhere. */
public final class MovedBall {
  private MovedBall() {}

  /**
   * Moves what was seen.
   *
   * @param kick as seen
   * @param shift adds to x and y, m, at a time on the kick's clock, s
   */
  public static Kick moved(Kick kick, Shift shift) {
    Observations seen = kick.observations();
    Observations.Builder moved = new Observations.Builder();
    double[] xy = new double[2];
    for (int i = 0; i < seen.size(); i++) {
      xy[0] = seen.x(i);
      xy[1] = seen.y(i);
      shift.add(seen.time(i), xy);
      moved.add(seen.time(i), seen.camera(i), xy[0], xy[1], seen.pixelX(i), seen.pixelY(i));
    }
    return kick.withObservations(moved.build());
  }

  /** By how much a ball was seen elsewhere. */
  @FunctionalInterface
  public interface Shift {
    /** Adds to x and y. */
    void add(double time, double[] xy);
  }

  /**
   * Moves what was seen along y.
   *
   * @param kick as seen
   * @param shift m, by the time since the kick, s
   */
  public static Kick shifted(Kick kick, DoubleUnaryOperator shift) {
    return moved(kick, (t, xy) -> xy[1] += shift.applyAsDouble(t - kick.time()));
  }
}
