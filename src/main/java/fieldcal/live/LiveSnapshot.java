package fieldcal.live;

import fieldcal.movement.PlayPhase;
import fieldcal.vision.FieldGeometry;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Everything that is known at one moment. Immutable: made for pages and terminals that show it from another thread.
 *
 * @param time capture time of the newest frame, Unix time, s; NaN before the first
 * @param phase what the referee said last; {@link PlayPhase#UNKNOWN} without one, then everything counts
 * @param field the field, when it was published
 * @param ball the ball
 * @param movement the robots
 * @param cameras each camera that sent frames, by id
 * @param cameraFaults published cameras whose geometry, or a part of it, cannot be used, by id; also those that sent no frame
 * @param frames number of frames taken from all cameras
 * @param strayFrames number of frames left out because their time fits no other camera's
 * @param clockJumps how often the clock restarted
 * @param listenerFailures how often a listener threw, or a piece of the work of {@link LiveMonitor#poll} broke
 */
public record LiveSnapshot(
    double time,
    PlayPhase phase,
    Optional<FieldGeometry> field,
    BallSnapshot ball,
    MovementSnapshot movement,
    List<CameraHealth> cameras,
    List<CameraFault> cameraFaults,
    long frames,
    long strayFrames,
    long clockJumps,
    long listenerFailures) {

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public LiveSnapshot {
    Objects.requireNonNull(phase, "phase");
    Objects.requireNonNull(field, "field");
    Objects.requireNonNull(ball, "ball");
    Objects.requireNonNull(movement, "movement");
    cameras = List.copyOf(cameras);
    cameraFaults = List.copyOf(cameraFaults);
  }
}
