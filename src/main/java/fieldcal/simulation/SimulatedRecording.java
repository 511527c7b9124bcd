package fieldcal.simulation;

import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.List;

/**
 * A simulated recording in memory.
 *
 * @param packets in the order of their arrival
 * @param geometry as published
 * @param truth what really happened
 */
public record SimulatedRecording(
    List<SimulatedPacket> packets, FieldGeometry geometry, Truth truth) {

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when it is null
   */
  public SimulatedRecording {
    packets = List.copyOf(packets);
  }

  /**
   * The frames alone.
   *
   * @return in the order of their arrival
   */
  public List<VisionFrame> frames() {
    return packets.stream().flatMap(p -> p.packet().frame().stream()).toList();
  }

  /**
   * The beginning of session time.
   *
   * @return session time zero
   */
  public Epoch epoch() {
    return truth.epoch();
  }
}
