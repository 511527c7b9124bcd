package fieldcal.gamelog;

/** The kinds of messages in a game log, with their numbers in the file (RoboCup-SSL/ssl-logtools). */
public enum MessageType {
  /** Filler; to be ignored. */
  BLANK(0),
  /** Of a kind that the recorder or this program does not know. */
  UNKNOWN(1),
  /** Vision with the geometry message in use until 2013. */
  SSL_VISION_2010(2),
  /** The referee. */
  SSL_REFBOX_2013(3),
  /** Vision. */
  SSL_VISION_2014(4),
  /** A tracker's frames. */
  SSL_VISION_TRACKER_2020(5),
  /** A table of where the messages are, at the end of the file. */
  SSL_INDEX_2021(6);

  private static final MessageType[] BY_CODE = values();

  private final int code;

  MessageType(int code) {
    this.code = code;
  }

  /**
   * The type's number in the file.
   *
   * @return 0 … 6
   */
  public int code() {
    return code;
  }

  /**
   * The type of a number.
   *
   * @param code the number in the file
   * @return its type; {@link #UNKNOWN} for numbers that have none
   */
  public static MessageType ofCode(int code) {
    return code >= 0 && code < BY_CODE.length ? BY_CODE[code] : UNKNOWN;
  }
}
