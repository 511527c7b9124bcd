package fieldcal.vision;

import java.util.Objects;
import java.util.Optional;

/**
 * What one packet of vision holds: a frame, the geometry, both, or nothing usable.
 *
 * @param frame the detections
 * @param geometry the field
 */
public record VisionPacket(Optional<VisionFrame> frame, Optional<FieldGeometry> geometry) {
  /** A packet with nothing usable in it. */
  public static final VisionPacket EMPTY = new VisionPacket(Optional.empty(), Optional.empty());

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException if one is null
   */
  public VisionPacket {
    Objects.requireNonNull(frame, "frame");
    Objects.requireNonNull(geometry, "geometry");
  }

  /**
   * A packet with detections only.
   *
   * @param frame the detections
   * @return the packet
   */
  public static VisionPacket of(VisionFrame frame) {
    return new VisionPacket(Optional.of(frame), Optional.empty());
  }

  /**
   * A packet with the geometry only.
   *
   * @param geometry the field
   * @return the packet
   */
  public static VisionPacket of(FieldGeometry geometry) {
    return new VisionPacket(Optional.empty(), Optional.of(geometry));
  }
}
