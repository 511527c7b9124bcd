package fieldcal.simulation.robot;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** What real robots and those of other simulators are like, beyond this field's good ones; may be combined. */
public enum RobotCharacter {
  /** As it is: the dribbler holds whatever happens, the kicker fires at once, the robot drives as commanded. */
  IDEAL,
  /** The dribbler holds the ball by friction only: a robot that pulls, brakes or turns too hard loses it. From a front plate that does not dribble the ball rolls off. */
  SLIPPING_DRIBBLER,
  /** The kicker fires some hundredths of a second after the ball has touched it, which is pushed meanwhile; the robot's speed adds to the ball's. */
  LATE_KICKER,
  /** The robot drives 4° beside and 5 % slower than commanded, and creeps a little when it is to stand. */
  DRIFTING,
  /** The robot receives its orders 50 ms later, follows them with a time constant of 0.1 s, and accelerates and brakes with at most 1.5 m/s². */
  SLUGGISH,
  /** The kicker gives half of the kicks, drawn at random, a fifth less speed than the others: it strikes the ball twice, and the second stroke brakes it, as with grSim. */
  UNEVEN_KICKER;

  /** Largest acceleration that friction gives a ball towards the robot and to its sides, m/s² (chosen: a third of what robots do). */
  public static final double HELD_ACCELERATION = 1.2;

  /** Largest speed at which a dribbler pulls a ball, m/s (chosen: a well-known simulator loses it at 1.2 m/s). */
  public static final double HELD_SPEED = 0.9;

  /** Time within which a dribbler that has lost a ball does not catch it again, s. */
  public static final double LOST_FOR = 0.3;

  /** Speed at which a ball leaves a front plate that lets go of it, m/s. */
  public static final double ROLLS_OFF = 0.12;

  /** From the touch to the kick, s (chosen: a light barrier, a radio's cycle of a slow robot). */
  public static final double DEAD_TIME = 0.05;

  /** How far in front of the plate a kicker reaches, m. */
  public static final double KICKER_REACH = 0.012;

  /** Part of the speed that is left after a second stroke: grSim's kicker takes back a fifth of what the ball has ({@code KickerDampFactor} 0.2). */
  public static final double STRUCK_TWICE = 0.8;

  /** Angle between the driven and the commanded direction, rad. */
  public static final double BESIDE = Math.toRadians(4);

  /** Fraction of the commanded speed that it drives (–). */
  public static final double SLOWER = 0.95;

  /** Speed of a robot that is to stand, m/s. */
  public static final double CREEP = 0.01;

  /** Delay that a slow radio and a slow control loop add to an order, s (chosen). */
  public static final double HEARS_LATER = 0.05;

  /** Time constant of a velocity control with a low gain, s (chosen). */
  public static final double FOLLOWS = 0.1;

  /** Largest acceleration with slipping wheels or weak motors, m/s² (chosen: half of what good robots do). */
  public static final double WEAK = 1.5;

  /**
   * Its name on the command line.
   *
   * @return lower case with dashes
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * By their names.
   *
   * @param labels as {@link #label}, separated by commas
   * @return the characters
   * @throws IllegalArgumentException when one is not known; the message names those that are
   */
  public static Set<RobotCharacter> parse(String labels) {
    Set<RobotCharacter> all = EnumSet.noneOf(RobotCharacter.class);
    for (String label : labels.split(",", -1)) {
      all.add(
          Arrays.stream(values())
              .filter(c -> c.label().equals(label.trim()))
              .findFirst()
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          "unknown robots '"
                              + label
                              + "'; known are "
                              + Arrays.stream(values())
                                  .map(RobotCharacter::label)
                                  .collect(Collectors.joining(", ")))));
    }
    return all;
  }
}
