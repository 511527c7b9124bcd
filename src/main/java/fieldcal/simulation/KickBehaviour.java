package fieldcal.simulation;

import fieldcal.simulation.physics.Table;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Optional;

/**
 * How a kick differs from its command.
 *
 * @param speedScatter standard deviation of speed over commanded speed (–)
 * @param directionScatter standard deviation of the direction, rad
 * @param elevationScatter standard deviation of the elevation, rad; chips only
 * @param rollSpin mean spin about the rolling axis in units of rolling spin, negative = backspin
 * @param rollSpinScatter its standard deviation from kick to kick, in the same unit
 * @param chipSpin what chips have beyond that mean, in the same unit
 * @param sideSpin mean spin about the direction of travel in the same unit
 * @param sideSpinScatter its standard deviation from kick to kick, in the same unit
 * @param biases robots that kick faster than commanded, or in another direction
 * @param spinTables measured spins without a formula that are added to the mean spin about the rolling axis
 */
public record KickBehaviour(
    double speedScatter,
    double directionScatter,
    double elevationScatter,
    double rollSpin,
    double rollSpinScatter,
    double chipSpin,
    double sideSpin,
    double sideSpinScatter,
    List<Bias> biases,
    List<SpinTable> spinTables) {

  /** Scatter of a good kicker, no spin. */
  public static final KickBehaviour DEFAULT =
      new KickBehaviour(0.015, 0.006, 0.02, 0, 0, 0, 0, 0, List.of(), List.of());

  /**
   * Copies the list and checks the scatters. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a scatter is not in [0, 10) or NaN
   */
  public KickBehaviour {
    double[] scatters = {
      speedScatter, directionScatter, elevationScatter, rollSpinScatter, sideSpinScatter
    };
    for (double scatter : scatters) {
      if (!(scatter >= 0 && scatter < 10)) {
        throw new IllegalArgumentException("scatter must not be negative, but is " + scatter);
      }
    }
    biases = List.copyOf(biases);
    spinTables = List.copyOf(spinTables);
  }

  /**
   * The bias of one robot or of a whole team.
   *
   * @param speed relative excess of speed (–)
   * @param yaw turn of the direction to the left, rad
   * @param team whose
   * @param number which; empty = all of the team
   */
  public record Bias(double speed, double yaw, Team team, Optional<Integer> number) {
    boolean concerns(RobotId robot) {
      return robot.team() == team && (number.isEmpty() || number.get() == robot.number());
    }
  }

  /**
   * Spin that depends on the kick.
   *
   * @param byHeading whether it depends on the direction of the kick, rad, instead of its horizontal speed, m/s
   * @param table added to the mean, in units of rolling spin
   */
  public record SpinTable(boolean byHeading, Table table) {
    double of(double speed, double direction) {
      return table.at(byHeading ? Math.IEEEremainder(direction, 2 * Math.PI) : speed, 0);
    }
  }

  /**
   * Mean spin about the rolling axis of a kick.
   *
   * @param speed horizontal, m/s
   * @param direction rad
   * @param chips whether it is a chip
   * @return in units of rolling spin
   */
  double rollSpinOf(double speed, double direction, boolean chips) {
    double spin = chips ? rollSpin + chipSpin : rollSpin;
    for (SpinTable table : spinTables) {
      spin += table.of(speed, direction);
    }
    return spin;
  }

  /**
   * Other tables of spin.
   *
   * @param tables instead of the present ones
   * @return the changed behaviour
   */
  public KickBehaviour withSpinTables(List<SpinTable> tables) {
    return new KickBehaviour(
        speedScatter,
        directionScatter,
        elevationScatter,
        rollSpin,
        rollSpinScatter,
        chipSpin,
        sideSpin,
        sideSpinScatter,
        biases,
        tables);
  }

  /**
   * Another spin about the rolling axis.
   *
   * @param mean in units of rolling spin
   * @param scatter from kick to kick
   * @return the changed behaviour
   */
  public KickBehaviour withRollSpin(double mean, double scatter) {
    return new KickBehaviour(
        speedScatter,
        directionScatter,
        elevationScatter,
        mean,
        scatter,
        chipSpin,
        sideSpin,
        sideSpinScatter,
        biases,
        spinTables);
  }

  /**
   * Another spin of chips.
   *
   * @param difference what they have beyond the mean of flat kicks, in units of rolling spin
   * @return the changed behaviour
   */
  public KickBehaviour withChipSpin(double difference) {
    return new KickBehaviour(
        speedScatter,
        directionScatter,
        elevationScatter,
        rollSpin,
        rollSpinScatter,
        difference,
        sideSpin,
        sideSpinScatter,
        biases,
        spinTables);
  }

  /**
   * Another spin about the direction of travel.
   *
   * @param mean in units of rolling spin
   * @param scatter from kick to kick
   * @return the changed behaviour
   */
  public KickBehaviour withSideSpin(double mean, double scatter) {
    return new KickBehaviour(
        speedScatter,
        directionScatter,
        elevationScatter,
        rollSpin,
        rollSpinScatter,
        chipSpin,
        mean,
        scatter,
        biases,
        spinTables);
  }

  /**
   * Other biases.
   *
   * @param newBiases instead of the present ones
   * @return the changed behaviour
   */
  public KickBehaviour withBiases(List<Bias> newBiases) {
    return new KickBehaviour(
        speedScatter,
        directionScatter,
        elevationScatter,
        rollSpin,
        rollSpinScatter,
        chipSpin,
        sideSpin,
        sideSpinScatter,
        newBiases,
        spinTables);
  }
}
