package fieldcal.app.wording;

import java.util.Locale;

/**
 * What is wrong, what it does to the game, what to do.
 *
 * @param what one sentence
 * @param consequence one sentence; may be empty
 * @param advice one sentence or two, for an extended model that predicts better than the simple one
 * @param repair the same without the extended model, where that predicts no better; may be empty
 */
record Sentences(String what, String consequence, String advice, String repair) {
  private static final String PREDICT = " predict with the extended model.";

  /** With advice that holds whatever the extended model predicts. */
  Sentences(String what, String consequence, String advice) {
    this(what, consequence, advice, advice);
  }

  /**
   * With a repair, and the extended model for as long as nothing is repaired.
   *
   * @param what one sentence
   * @param consequence one sentence; may be empty
   * @param repair without its full stop, for example "Level the floor"
   * @param joint how the extended model follows, for example "; otherwise"
   * @return the sentences
   */
  static Sentences orExtended(String what, String consequence, String repair, String joint) {
    return new Sentences(what, consequence, repair + joint + PREDICT, repair + ".");
  }

  /**
   * What nobody can repair.
   *
   * @param what one sentence
   * @param consequence one sentence; may be empty
   * @return the sentences
   */
  static Sentences extended(String what, String consequence) {
    return orExtended(what, consequence, "There is nothing to repair", ":");
  }

  /**
   * What to do.
   *
   * @param extendedHelps whether the extended model predicts better than the simple one
   * @return the advice, or the repair alone
   */
  String advice(boolean extendedHelps) {
    return extendedHelps ? advice : repair;
  }

  /** Text with numbers in it, the same on every machine. */
  static String text(String format, Object... args) {
    return String.format(Locale.ROOT, format, args);
  }

  /** With a capital letter. */
  static String begin(String text) {
    return text.isEmpty() ? text : Character.toUpperCase(text.charAt(0)) + text.substring(1);
  }
}
