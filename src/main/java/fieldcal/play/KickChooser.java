package fieldcal.play;

/** Decides which kick comes next. */
public interface KickChooser {

  /**
   * The next kick. Asked once per kick; a kick that was not good is not repeated by itself.
   *
   * @return what is wanted
   */
  PlannedKick next();

  /**
   * Tells how a kick turned out.
   *
   * @param kick one that was asked for
   * @param good whether it counts
   */
  void done(PlannedKick kick, boolean good);
}
