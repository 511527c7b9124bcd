package fieldcal.simulation.scenario;

import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.RefereePhase;
import java.util.List;

/** Decides what the robots do. One instance runs once. */
public interface Scenario {

  /**
   * The robots it needs, where they start.
   *
   * @return yellow first, by number
   */
  List<SimulatedRobot> robots();

  /**
   * Called before each tick.
   *
   * @param world to be looked at and commanded
   */
  void tick(SimulatedWorld world);

  /**
   * Whether there is nothing left to do.
   *
   * @param world the world
   * @return true when the recording ends
   */
  boolean finished(SimulatedWorld world);

  /**
   * How far it is.
   *
   * @param world the world
   * @return share that is done, 0 … 1
   */
  double progress(SimulatedWorld world);

  /**
   * What the referee said so far.
   *
   * @return by time; empty without a referee
   */
  default List<RefereePhase> phases() {
    return List.of();
  }
}
