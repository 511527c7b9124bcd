package fieldcal.camera;

/** What of a published calibration a {@link Camera} believes. */
public enum PoseSource {
  /** Rotation, translation and lens: the position follows from them, and pixels mean something. */
  CALIBRATION,
  /** Only the published position; rotation, translation and lens are placeholders, so there are no pixels. */
  DERIVED_POSITION
}
