package fieldcal.play;

import fieldcal.vision.RobotId;
import java.util.Objects;
import java.util.Optional;

/**
 * What the play waits for, so that it can be shown on a drawing of the field: a robot, a place, a robot that should be in a place, or nothing that has one.
 *
 * @param robot that is missing, late, or in the way; not always one of the two that play
 * @param place where the robot should be or was seen last, or else where the ball is or should be
 */
public record WaitingFor(Optional<RobotId> robot, Optional<Place> place) {
  /** Nothing that has a place on the field. */
  public static final WaitingFor NOTHING = new WaitingFor(Optional.empty(), Optional.empty());

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public WaitingFor {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(place, "place");
  }

  /**
   * A place on the field.
   *
   * @param x m
   * @param y m
   */
  public record Place(double x, double y) {}

  static WaitingFor robot(RobotId robot) {
    return new WaitingFor(Optional.of(robot), Optional.empty());
  }

  static WaitingFor place(double x, double y) {
    return new WaitingFor(Optional.empty(), Optional.of(new Place(x, y)));
  }

  /** The same robot with a place. */
  WaitingFor at(double x, double y) {
    return new WaitingFor(robot, Optional.of(new Place(x, y)));
  }
}
