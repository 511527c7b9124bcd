package fieldcal.movement;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A limit of acceleration or braking by direction in the robot's own frame, of whatever shape: a closed polygon over {@link #DIRECTIONS} directions, from standstill, with a standard error at each. Directions in which robots hardly ever accelerated at their limit are left out.
 *
 * @param seenIn {@code acceleration} or {@code braking}
 * @param points the known directions, by angle; empty when none is known
 * @param shareWithout share of the manoeuvres of known direction that lie at the limit without this envelope
 * @param shareWith share of them that lie at it
 * @param shaped whether the envelope describes the manoeuvres clearly better than one limit does, with or without {@link MovementEffect#DIRECTIONAL}. Then its largest value is the team's limit
 */
public record Envelope(
    String seenIn, List<Point> points, double shareWithout, double shareWith, boolean shaped) {
  /** How many directions there are, equally spaced from the front on. */
  public static final int DIRECTIONS = 36;

  /** Between two directions, rad. */
  static final double STEP = 2 * Math.PI / DIRECTIONS;

  /**
   * The limit in one direction.
   *
   * @param angle of the acceleration against the robot's front, rad, 0 … 2π, positive to the left
   * @param value m/s²
   * @param standardError of the value, m/s², from the noise, the number of manoeuvres, and the error of the method itself
   * @param manoeuvres number of manoeuvres at the limit about this direction, weighted with their distance from it
   */
  public record Point(double angle, double value, double standardError, double manoeuvres) {}

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public Envelope {
    Objects.requireNonNull(seenIn, "seenIn");
    points = List.copyOf(points);
  }

  /**
   * The limit in any direction, between two known ones as a straight line over the angle.
   *
   * @param angle against the front, rad, positive to the left
   * @return m/s²; empty when it is not known on both sides
   */
  public OptionalDouble at(double angle) {
    double position = angle / STEP - DIRECTIONS * Math.floor(angle / STEP / DIRECTIONS);
    int before = (int) position % DIRECTIONS;
    double part = position - Math.floor(position);
    Optional<Point> first = point(before);
    Optional<Point> second = part == 0 ? first : point((before + 1) % DIRECTIONS);
    return first.isEmpty() || second.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of((1 - part) * first.get().value() + part * second.get().value());
  }

  private Optional<Point> point(int direction) {
    return points.stream().filter(p -> Math.round(p.angle() / STEP) == direction).findFirst();
  }

  /**
   * The direction with the largest limit.
   *
   * @return empty when none is known
   */
  public Optional<Point> strongest() {
    return points.stream().max(Comparator.comparingDouble(Point::value));
  }

  /**
   * The direction with the smallest limit.
   *
   * @return empty when none is known
   */
  public Optional<Point> weakest() {
    return points.stream().min(Comparator.comparingDouble(Point::value));
  }
}
