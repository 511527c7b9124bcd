package fieldcal.simulation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;

/**
 * Something that goes wrong on an {@link InteractiveField}.
 *
 * @param kind what
 * @param time session time when it begins, s
 * @param duration how long it lasts, s; 0 for troubles of an instant
 * @param robot index of the commanded robot that it concerns, 0 or more
 */
public record FieldTrouble(Kind kind, double time, double duration, int robot) {

  /** What can go wrong. */
  public enum Kind {
    /** Kickers do not fire. */
    MISSED_KICK,
    /** Kickers give a fraction of the speed. */
    WEAK_KICK,
    /** The ball lies beyond the lines. */
    BALL_OUTSIDE,
    /** The ball lies in a corner. */
    BALL_IN_CORNER,
    /** The ball lies in a goal. */
    BALL_IN_GOAL,
    /** Somebody takes the ball away and lays it down elsewhere. */
    BALL_HIDDEN,
    /** The ball lies beside a robot. */
    BALL_AT_ROBOT,
    /** The ball sticks to the back of a robot, until it falls off or a hand takes it. */
    BALL_STUCK,
    /** A robot is taken off and comes back. */
    ROBOT_GONE,
    /** A robot does not move: it fell over. */
    ROBOT_STUCK,
    /** A third robot drives to the ball and stands there. */
    THIRD_ROBOT,
    /** The referee says HALT. */
    HALT,
    /** No frame arrives. */
    NO_VISION,
    /** Dribblers slip. */
    SLIPPING_DRIBBLER,
    /** Kickers fire late. */
    LATE_KICKER,
    /** Robots drive off from where they are commanded to go. */
    DRIFTING
  }

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a time or the index is negative, or a time is NaN
   */
  public FieldTrouble {
    Objects.requireNonNull(kind, "kind");
    if (!(time >= 0 && duration >= 0 && robot >= 0)) {
      throw new IllegalArgumentException(
          "trouble must not be negative: " + time + " s, " + duration + " s, robot " + robot);
    }
  }

  boolean covers(double now) {
    return now >= time && now < time + duration;
  }

  /**
   * Troubles drawn at random.
   *
   * @param seed of the draw
   * @param count how many
   * @param span latest session time at which one begins, s, above 2; the earliest is 2 s
   * @return by time
   */
  public static List<FieldTrouble> random(long seed, int count, double span) {
    RandomStream random = RandomStream.of(seed, "troubles");
    List<FieldTrouble> troubles = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Kind kind = Kind.values()[random.below(Kind.values().length)];
      double time = random.uniform(2, span);
      double share = random.uniform(0, 1);
      troubles.add(new FieldTrouble(kind, time, duration(kind, share), random.below(2)));
    }
    troubles.sort(Comparator.comparingDouble(FieldTrouble::time));
    return List.copyOf(troubles);
  }

  private static double duration(Kind kind, double share) {
    return switch (kind) {
      case MISSED_KICK, WEAK_KICK -> 4 + 6 * share;
      case BALL_OUTSIDE, BALL_IN_CORNER, BALL_IN_GOAL, BALL_AT_ROBOT -> 0;
      case BALL_HIDDEN -> 0.5 + 4 * share;
      case ROBOT_GONE, ROBOT_STUCK, BALL_STUCK -> 1 + 12 * share;
      case THIRD_ROBOT -> 5 + 15 * share;
      case HALT -> 1 + 7 * share;
      case NO_VISION -> 0.3 + 4 * share;
      case SLIPPING_DRIBBLER, LATE_KICKER, DRIFTING -> 20 + 40 * share;
    };
  }
}
