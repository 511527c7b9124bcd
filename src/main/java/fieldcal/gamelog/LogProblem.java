package fieldcal.gamelog;

import fieldcal.vision.ProblemKind;
import java.util.Locale;

/** What can be wrong with a recording without making it useless. */
public enum LogProblem implements ProblemKind {
  /** The compressed file ends early. */
  TRUNCATED_GZIP("the gzip file ends early; read up to there"),
  /** The compressed data is damaged; what follows is lost. */
  DAMAGED_GZIP("the gzip data is damaged; read up to there"),
  /** Something follows the compressed data. */
  BYTES_AFTER_GZIP("bytes after the gzip data; ignored"),
  /** The last record ends after the file. */
  TRUNCATED_RECORD("the last record is longer than the rest of the file; skipped"),
  /** A record's length is wrong: another record starts within it. */
  DAMAGED_RECORD("record with a wrong length; skipped to the record that starts within it"),
  /** Bytes that are no record. */
  GARBAGE("bytes that are no record; skipped to the next one"),
  /** A message of a type that has no name. */
  UNKNOWN_MESSAGE_TYPE("message of an unknown type; skipped"),
  /** A referee message that is none. */
  MALFORMED_REFEREE("packet is no referee message; skipped"),
  /** Detections came before the first geometry. */
  FRAME_BEFORE_GEOMETRY("frame before the first geometry"),
  /** A camera sends detections but the geometry does not know it. */
  UNCALIBRATED_CAMERA("frame of a camera that the geometry does not name"),
  /** The geometry is not the one before. */
  GEOMETRY_CHANGED("the geometry changed midway"),
  /** The recorder's clock, or a camera's against it, went back. */
  CLOCK_JUMP_BACK("a clock jumped back"),
  /** A camera's clock went forward against the recorder's. */
  CLOCK_JUMP_FORWARD("a clock jumped forward"),
  /** A single frame's time agrees with no other. */
  STRAY_TIME("frame with a time far from its neighbours'; skipped"),
  /** The frame was there already. */
  DUPLICATE_FRAME("frame that was there already; skipped");

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
