package fieldcal.gamelog;

import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;

/**
 * Receives what a recording holds, in order. All methods do nothing unless overridden.
 *
 * <p>Times count from the {@linkplain RecordingReader#epoch() recording's epoch}.
 */
public interface RecordingListener {

  /**
   * A frame of one camera. Frames come in the order of their capture times over all cameras, within the reader's tolerance; duplicates
   * and stray ones are left out.
   *
   * @param frame what the camera saw
   * @param receivedTime when the recorder received it, s, on the recorder's clock
   */
  default void onFrame(VisionFrame frame, double receivedTime) {}

  /**
   * The field's geometry: the first one, and each that differs from the one before. Comes before the frames that were received after it.
   *
   * @param geometry the field from now on
   */
  default void onGeometry(FieldGeometry geometry) {}

  /**
   * The recorder says that it may have lost packets of vision here ({@link RecordingGap}). Comes before the frames that were received after it.
   *
   * @param receivedTime when the recorder went on, s, on its clock
   */
  default void onLost(double receivedTime) {}

  /** The recording says that its field was simulated ({@link RecordingOrigin}). */
  default void onSimulationMark() {}

  /**
   * A message of the referee, some ten times a second.
   *
   * @param state what it says
   * @param receivedTime when the recorder received it, s, on the recorder's clock
   */
  default void onReferee(RefereeState state, double receivedTime) {}

  /**
   * Whether {@link #onTracker} is to be called: trackers send half of the bytes of a match, and decoding them takes as long as all else.
   *
   * @return false unless overridden
   */
  default boolean wantsTrackers() {
    return false;
  }

  /**
   * A frame of a tracker, as it was received: not ordered with the frames of the cameras, which wait for older ones.
   *
   * @param frame what the tracker says
   * @param receivedTime when the recorder received it, s, on the recorder's clock
   */
  default void onTracker(TrackerFrame frame, double receivedTime) {}

  /**
   * A camera's clock jumped against the recorder's; the camera's next frame is on the new time. Nothing may be concluded from the
   * difference of times before and after.
   *
   * @param cameraId the camera
   * @param jump how far the clock went, s; negative: back
   */
  default void onClockJump(int cameraId, double jump) {}

  /**
   * Reports how much of the file has been read; called from time to time, and at the end.
   *
   * @param bytesRead of the file, as it lies on the disk
   * @param totalBytes the file's size
   */
  default void onProgress(long bytesRead, long totalBytes) {}
}
