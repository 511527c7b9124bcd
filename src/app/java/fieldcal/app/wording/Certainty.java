package fieldcal.app.wording;

/** How sure a finding is, in words: odds instead of logarithms of odds. */
public final class Certainty {
  /** From odds of a thousand million to one on, nobody needs a number. */
  private static final double CERTAIN = Math.log(1e9);

  private static final double MILLION = Math.log(1e6);
  private static final double THOUSAND = Math.log(1e3);

  /** Odds of twenty to one: what is called significant at five per cent. */
  private static final double TWENTY = Math.log(20);

  private Certainty() {}

  /**
   * The odds that a cause is there.
   *
   * @param evidence natural logarithm of the odds; NaN when not known
   * @return for example "certain" or "odds better than a million to one"
   */
  public static String of(double evidence) {
    if (Double.isNaN(evidence)) {
      return "odds not known";
    }
    if (evidence >= CERTAIN) {
      return "certain";
    }
    if (evidence >= MILLION) {
      return "odds better than a million to one";
    }
    if (evidence >= THOUSAND) {
      return "odds better than a thousand to one";
    }
    return evidence >= TWENTY ? "odds better than twenty to one" : "odds below twenty to one";
  }
}
