package fieldcal.app.sslsim;

/** What a simulator or a bridge says is wrong, in a length that an operator reads. */
final class Complaint {
  /** Two lines of a terminal; a packet could hold 65,000 characters. */
  private static final int LONGEST = 200;

  private Complaint() {}

  static String shortened(String text) {
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "…";
  }
}
