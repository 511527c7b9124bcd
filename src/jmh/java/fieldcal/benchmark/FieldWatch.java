package fieldcal.benchmark;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.robot.SimulatedRobot;
import java.util.List;

/** Looks at the true field again and again: how hard the robots of a play meet others, and how near they come to the edge of what they are allowed. For one thread. */
final class FieldWatch {
  /** A faster contact hurts, m/s: the goal of the play. */
  static final double HURTS = 0.1;

  /** Two robots whose centres are nearer touch: their diameter, m. */
  private static final double TOUCH = 0.18;

  /** A robot that is farther away was taken off the field, m. */
  private static final double TAKEN_OFF = 100;

  /** How far beyond the lines the robots of a play may drive, m: {@code --margin}, whose default this is, or what there is up to the wall. */
  private static final double MARGIN = 0.2;

  /** What the margin leaves free before the wall, m: a robot's radius, rounded up. */
  private static final double WALL = 0.1;

  private final InteractiveField field;
  private double contactSpeed;
  private double nearestEdge = Double.POSITIVE_INFINITY;

  FieldWatch(InteractiveField field) {
    this.field = field;
  }

  /** Once in every step or tick. */
  void look() {
    List<SimulatedRobot> robots =
        field.world().robots().stream().filter(r -> Math.abs(r.x()) < TAKEN_OFF).toList();
    for (SimulatedRobot a : robots) {
      if (field.players().contains(a.id())) {
        FieldSize size = field.world().field();
        double margin = Math.min(MARGIN, size.boundary() - WALL);
        nearestEdge = Math.min(nearestEdge, size.length() / 2 + margin - Math.abs(a.x()));
        nearestEdge = Math.min(nearestEdge, size.width() / 2 + margin - Math.abs(a.y()));
        robots.stream().filter(b -> b != a).forEach(b -> meet(a, b));
      }
    }
  }

  private void meet(SimulatedRobot a, SimulatedRobot b) {
    double dx = b.x() - a.x();
    double dy = b.y() - a.y();
    double distance = Math.hypot(dx, dy);
    if (distance < TOUCH) {
      double closing = ((a.vx() - b.vx()) * dx + (a.vy() - b.vy()) * dy) / distance;
      contactSpeed = Math.max(contactSpeed, closing);
    }
  }

  /** The hardest contact so far, m/s; 0 without any. */
  double contactSpeed() {
    return contactSpeed;
  }

  /** The smallest distance to the edge of the margin so far, m; negative when somebody was beyond it. */
  double nearestEdge() {
    return nearestEdge;
  }

  boolean hurt() {
    return contactSpeed > HURTS;
  }

  boolean outside() {
    return nearestEdge < 0;
  }
}
