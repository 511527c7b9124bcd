package fieldcal.gamelog;

import fieldcal.vision.ProblemKind;
import java.util.Locale;

/** What can be wrong with a recording without making it useless. */
public enum LogProblem implements ProblemKind {
  /** The compressed file ends early. */
  TRUNCATED_GZIP("the gzip file ends early; what comes before is read"),
  /** The compressed data is damaged; what follows is lost. */
  DAMAGED_GZIP("the gzip data are damaged; what comes before is read"),
  /** Something follows the compressed data. */
  BYTES_AFTER_GZIP("bytes follow the gzip data; they are ignored"),
  /** The last record ends after the file. */
  TRUNCATED_RECORD("the last record is longer than the rest of the file; it is skipped"),
  /** A record's length is wrong: another record starts within it. */
  DAMAGED_RECORD(
      "a record has a wrong length; reading goes on with the record that starts within it"),
  /** Bytes that are no record. */
  GARBAGE("some bytes are not a record; reading goes on with the next record"),
  /** A header and nothing after it. */
  NO_MESSAGES("the log has a header and no message: nothing was recorded"),
  /** A message of a type that has no name. */
  UNKNOWN_MESSAGE_TYPE("a message is of an unknown type; it is skipped"),
  /** A referee message that cannot be decoded. */
  MALFORMED_REFEREE("a packet is not a referee message; it is skipped"),
  /** A tracker's message that cannot be decoded. */
  MALFORMED_TRACKER("a packet is not a message of a tracker; it is skipped"),
  /** Detections came before the first geometry. */
  FRAME_BEFORE_GEOMETRY("a frame comes before the first geometry"),
  /** Detections of a camera came before the first geometry that names it. */
  FRAME_BEFORE_CAMERA("a frame comes before the geometry names its camera"),
  /** A camera sends detections but the geometry does not know it. */
  UNCALIBRATED_CAMERA("a frame is of a camera that the geometry does not name"),
  /** The geometry differs from the one before. */
  GEOMETRY_CHANGED("the geometry changes midway"),
  /** The recorder's clock, or a camera's against it, went back. */
  CLOCK_JUMP_BACK("a clock jumps back"),
  /** A camera's clock went forward against the recorder's. */
  CLOCK_JUMP_FORWARD("a clock jumps forward"),
  /** A single frame's time agrees with no other. */
  STRAY_TIME("a frame's time is far from its neighbours'; it is skipped"),
  /** The frame was received before. */
  DUPLICATE_FRAME("a frame comes twice; the second one is skipped");

  private final String text;

  LogProblem(String text) {
    this.text = text;
  }

  @Override
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  @Override
  public String text() {
    return text;
  }
}
