package fieldcal.simulation;

import fieldcal.vision.VisionPacket;
import java.util.Objects;

/**
 * A packet of vision as a recorder receives it.
 *
 * @param receivedTime session time, s
 * @param packet a frame or the geometry
 */
public record SimulatedPacket(double receivedTime, VisionPacket packet) {

  /**
   * Checks the packet. {@inheritDoc}
   *
   * @throws NullPointerException when there is none
   */
  public SimulatedPacket {
    Objects.requireNonNull(packet, "packet");
  }
}
