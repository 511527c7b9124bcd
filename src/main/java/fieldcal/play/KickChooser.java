package fieldcal.play;

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
   * Tells how a kick turned out.
   *
   * @param kick one that was asked for
   * @param good whether it counts
   */
  void done(PlannedKick kick, boolean good);
}
