package fieldcal.live;

import java.util.Objects;

/**
 * A published camera whose geometry, or a part of it, cannot be used. Its detections count all the same; without geometry, flying balls that it sees are taken to lie on the carpet.
 *
 * @param camera its id
 * @param reason one clause for the operator, without the camera's number and without a full stop
 */
public record CameraFault(int camera, String reason) {
  /**
   * Checks that there is a reason. {@inheritDoc}
   *
   * @throws NullPointerException when there is none
   */
  public CameraFault {
    Objects.requireNonNull(reason, "reason");
  }
}
