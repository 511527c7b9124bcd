package fieldcal.simulation.truth;

import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.vision.Epoch;
import java.util.List;

/**
 * Everything that is true of a simulated recording.
 *
 * @param settings what was asked for
 * @param physics the laws that the ball obeyed, effects included
 * @param kickBehaviour how kicks differed from commands, effects included
 * @param ballPlane height of the ball's centre that vision assumed, m
 * @param rollingShutter time from the first to the last image row, s
 * @param epoch session time zero
 * @param duration length of the session, s
 * @param cameras by number
 * @param robots yellow first, by number
 * @param phases what the referee said
 * @param kicks by time
 * @param holds when robots had the ball at their dribblers, by time
 */
public record Truth(
    SimulationSettings settings,
    BallPhysics physics,
    KickBehaviour kickBehaviour,
    double ballPlane,
    double rollingShutter,
    Epoch epoch,
    double duration,
    List<CameraTruth> cameras,
    List<RobotTruth> robots,
    List<RefereePhase> phases,
    List<KickTruth> kicks,
    List<BallHold> holds) {

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws NullPointerException when one is null
   */
  public Truth {
    cameras = List.copyOf(cameras);
    robots = List.copyOf(robots);
    phases = List.copyOf(phases);
    kicks = List.copyOf(kicks);
    holds = List.copyOf(holds);
  }

  /**
   * The kicks that a robot was commanded to make.
   *
   * @return without deflections
   */
  public List<KickTruth> commandedKicks() {
    return kicks.stream().filter(kick -> kick.kind() != KickKind.DEFLECTION).toList();
  }
}
