package fieldcal.diagnosis;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.function.DoubleUnaryOperator;

/** Kicks whose ball was seen elsewhere. */
public final class MovedBall {
  private MovedBall() {}

  /**
   * Moves what was seen along y.
   *
   * @param kick as seen
   * @param shift m, by the time since the kick, s
   */
  public static Kick shifted(Kick kick, DoubleUnaryOperator shift) {
    Observations seen = kick.observations();
    Observations.Builder moved = new Observations.Builder();
    for (int i = 0; i < seen.size(); i++) {
      moved.add(
          seen.time(i),
          seen.camera(i),
          seen.x(i),
          seen.y(i) + shift.applyAsDouble(seen.time(i) - kick.time()),
          seen.pixelX(i),
          seen.pixelY(i));
    }
    return kick.withObservations(moved.build());
  }
}
