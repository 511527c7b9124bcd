package fieldcal.play;

import java.util.function.Predicate;

/** Decides which kick comes next. */
public interface KickChooser {

  /**
   * The next kick. Asked once per kick; a kick that was not good is not repeated by itself.
   *
   * @param ballX where the ball is, m: it is kicked from there if that leaves enough way, else from the end of the line; NaN when it was never seen
   * @param ballY where the ball is, m
   * @return what is wanted
   */
  PlannedKick next(double ballX, double ballY);

  /**
   * The next kick, by a chooser that saves carrying the ball where it can. Asked once per kick, instead of {@link #next(double, double)}, which it is unless overridden.
   *
   * @param ballX where the ball is, m; NaN when it was never seen
   * @param ballY where the ball is, m
   * @param fromHere whether a kick can be made from where the ball lies
   * @return what is wanted
   */
  default PlannedKick next(double ballX, double ballY, Predicate<PlannedKick> fromHere) {
    return next(ballX, ballY);
  }

  /**
   * Receives the result of a kick.
   *
   * @param kick one that was asked for
   * @param good whether it counts
   */
  void done(PlannedKick kick, boolean good);

  /**
   * Receives that a kick does not count because its ball left the images of all cameras: as fast a kick would leave them again. Called instead of {@link #done}, which it calls unless overridden.
   *
   * @param kick one that was asked for
   */
  default void outOfView(PlannedKick kick) {
    done(kick, false);
  }
}
