package fieldcal.vision;

import java.util.Locale;

/** What can be wrong with a vision packet. */
public enum DecodingProblem implements ProblemKind {
  /** The bytes are no protobuf message, or end within one. */
  MALFORMED_PACKET("a packet is not a vision message; it is skipped"),
  /** The frame lacks its capture time or its camera. */
  INCOMPLETE_FRAME("a frame has no capture time or no camera; it is skipped"),
  /** The camera number is beyond {@link VisionDecoder#MAX_CAMERA_ID}. */
  BAD_CAMERA_ID("a frame has an impossible camera number; it is skipped"),
  /** The capture time is no Unix time. */
  BAD_CAPTURE_TIME("a frame's capture time is NaN, infinite or impossible; it is skipped"),
  /** The sending time is no Unix time. */
  BAD_SENT_TIME("a frame's sending time is NaN, infinite or impossible; the time is ignored"),
  /** A ball has no position. */
  INCOMPLETE_BALL("a ball has no position; it is skipped"),
  /** A ball's coordinate is NaN or infinite. */
  NON_FINITE_BALL("a ball's position is NaN or infinite; it is skipped"),
  /** A ball is farther out than {@link VisionDecoder#MAX_COORDINATE}. */
  FAR_BALL("a ball is more than 100 m from the field's centre; it is skipped"),
  /** A robot has no position or number. */
  INCOMPLETE_ROBOT("a robot has no position or no number; it is skipped"),
  /** A robot's coordinate is NaN or infinite. */
  NON_FINITE_ROBOT("a robot's position is NaN or infinite; it is skipped"),
  /** A robot is farther out than {@link VisionDecoder#MAX_COORDINATE} or its number beyond {@link VisionDecoder#MAX_ROBOT_NUMBER}. */
  IMPOSSIBLE_ROBOT(
      "a robot has an impossible number, or is more than 100 m from the field's centre; it is"
          + " skipped"),
  /** A secondary value (height, orientation, pixel, confidence) is NaN or infinite. */
  NON_FINITE_DETAIL(
      "a detection has a NaN or infinite height, orientation, pixel or confidence; the value is"
          + " ignored"),
  /** The geometry lacks the field's size, or a size is not positive. */
  BAD_FIELD_SIZE("a geometry has no usable field size; it is skipped"),
  /** A line or an arc of the field is incomplete or not finite. */
  BAD_FIELD_LINE("a field line has missing or non-finite values; it is skipped"),
  /** A camera calibration is incomplete, not finite, or given twice. */
  BAD_CALIBRATION("a camera's calibration has missing or non-finite values; it is skipped"),
  /** A published ball model is incomplete or out of its range. */
  BAD_MODEL("a published ball model has missing or impossible values; it is ignored");

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
