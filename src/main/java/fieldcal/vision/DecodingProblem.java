package fieldcal.vision;

import java.util.Locale;

/** What can be wrong with a vision packet. */
public enum DecodingProblem implements ProblemKind {
  /** The bytes are no protobuf message, or end within one. */
  MALFORMED_PACKET("packet is no vision message; skipped"),
  /** The frame lacks its capture time or its camera. */
  INCOMPLETE_FRAME("frame without capture time or camera; skipped"),
  /** The camera number is beyond {@link VisionDecoder#MAX_CAMERA_ID}. */
  BAD_CAMERA_ID("frame of an impossible camera number; skipped"),
  /** The capture time is no Unix time. */
  BAD_CAPTURE_TIME("frame with a NaN, infinite or impossible capture time; skipped"),
  /** The sending time is no Unix time. */
  BAD_SENT_TIME("frame with a NaN, infinite or impossible sending time; time ignored"),
  /** A ball has no position. */
  INCOMPLETE_BALL("ball without position; skipped"),
  /** A ball's coordinate is NaN or infinite. */
  NON_FINITE_BALL("ball at a NaN or infinite position; skipped"),
  /** A ball is farther out than {@link VisionDecoder#MAX_COORDINATE}. */
  FAR_BALL("ball more than 100 m from the field's centre; skipped"),
  /** A robot has no position or number. */
  INCOMPLETE_ROBOT("robot without position or number; skipped"),
  /** A robot's coordinate is NaN or infinite. */
  NON_FINITE_ROBOT("robot at a NaN or infinite position; skipped"),
  /** A robot is farther out than {@link VisionDecoder#MAX_COORDINATE} or its number beyond {@link VisionDecoder#MAX_ROBOT_NUMBER}. */
  IMPOSSIBLE_ROBOT(
      "robot of an impossible number or more than 100 m from the field's centre; skipped"),
  /** A secondary value (height, orientation, pixel, confidence) is NaN or infinite. */
  NON_FINITE_DETAIL(
      "detection with a NaN or infinite height, orientation, pixel or confidence; value ignored"),
  /** The geometry lacks the field's size, or a size is not positive. */
  BAD_FIELD_SIZE("geometry without a usable field size; skipped"),
  /** A line or an arc of the field is incomplete or not finite. */
  BAD_FIELD_LINE("field line with missing or non-finite values; skipped"),
  /** A camera calibration is incomplete, not finite, or given twice. */
  BAD_CALIBRATION("camera calibration with missing or non-finite values; skipped"),
  /** A published ball model is incomplete or out of its range. */
  BAD_MODEL("published ball model with missing or impossible values; ignored");

  private final String text;

  DecodingProblem(String text) {
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
