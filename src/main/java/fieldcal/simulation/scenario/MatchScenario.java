package fieldcal.simulation.scenario;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;

/**
 * Two teams play under a referee: passes, receptions, redirects, chips, dribbling, shots. Teams whose limits are {@link RobotLimits#DEFAULT} get limits drawn from the seed; the truth contains
 * them.
 */
public final class MatchScenario implements Scenario {
  private final MatchReferee referee;
  private final TeamPlay yellow;
  private final TeamPlay blue;
  private final List<SimulatedRobot> robots;
  private final double duration;
  private boolean yellowAtTheBall = true;

  /**
   * A match of the settings' size and length; with a number of kicks it ends when they are played, if its time is not up before.
   *
   * @param all the simulation's settings
   */
  public MatchScenario(SimulationSettings all) {
    ScenarioSettings settings = all.scenario();
    FieldSize field = all.field();
    duration = 60 * settings.minutes() + MatchReferee.BREAK;
    referee = new MatchReferee(field, settings, RandomStream.of(all.seed(), "match referee"));
    RandomStream random = RandomStream.of(all.seed(), "match teams");
    RandomStream strengths = RandomStream.of(all.seed(), "match strengths");
    yellow = team(Team.YELLOW, settings, settings.yellow(), field, random, strengths);
    blue = team(Team.BLUE, settings, settings.blue(), field, random, strengths);
    List<SimulatedRobot> both = new ArrayList<>(yellow.robots());
    both.addAll(blue.robots());
    robots = List.copyOf(both);
  }

  private static TeamPlay team(
      Team team,
      ScenarioSettings settings,
      RobotLimits given,
      FieldSize field,
      RandomStream random,
      RandomStream strengths) {
    double velocity = random.uniform(1.8, 3.6);
    double acceleration = random.uniform(2, 4.5);
    double braking = random.uniform(2.8, 6);
    RobotLimits limits = given;
    RobotLimits plain =
        given
            .withTorqueLoss(0)
            .withDirectionality(0)
            .withShape(RobotLimits.DEFAULT.shape())
            .withTurning(
                RobotLimits.DEFAULT.angularVelocity(), RobotLimits.DEFAULT.angularAcceleration());
    if (plain.equals(RobotLimits.DEFAULT)) {
      limits =
          RobotLimits.uniform(velocity, acceleration, braking)
              .withTorqueLoss(given.torqueLoss())
              .withDirectionality(given.directionality())
              .withShape(given.shape())
              .withTurning(given.angularVelocity(), given.angularAcceleration());
    }
    double height = random.uniform(0.14, 0.149);
    double side = team == Team.YELLOW ? -1 : 1;
    List<SimulatedRobot> robots = new ArrayList<>();
    for (int i = 0; i < settings.teamSize(); i++) {
      double x = i == 0 ? 0.47 : random.uniform(0.05, 0.4);
      double y = i == 0 ? 0 : (double) i / settings.teamSize() - 0.5;
      TeamManner manner = settings.manner();
      double strength = i == manner.weakRobot() ? manner.strength() : 1;
      SimulatedRobot robot =
          new SimulatedRobot(
              new RobotId(team, i),
              limits.times(strength * (1 + strengths.gaussian(manner.difference()))),
              height,
              side * x * field.length(),
              y * 0.9 * field.width(),
              side > 0 ? Math.PI : 0);
      robot.settles(manner.settling());
      robots.add(robot);
    }
    return new TeamPlay(field, List.copyOf(robots), settings.manner().facing(), random);
  }

  @Override
  public List<SimulatedRobot> robots() {
    return robots;
  }

  @Override
  public List<RefereePhase> phases() {
    return referee.phases();
  }

  @Override
  public boolean finished(SimulatedWorld world) {
    return referee.over(world.time());
  }

  @Override
  public double progress(SimulatedWorld world) {
    return Math.min(1, Math.max(world.time() / duration, referee.kicked(world)));
  }

  @Override
  public void tick(SimulatedWorld world) {
    referee.tick(world);
    if (referee.halted()) {
      yellow.halt();
      blue.halt();
    } else if (!referee.playing()) {
      yellow.stayAway(world, 1.4);
      blue.stayAway(world, 1.4);
      yellowAtTheBall = referee.restart() == Team.YELLOW;
    } else {
      double yellowReach = yellow.reach(world);
      double blueReach = blue.reach(world);
      // Who is at the ball stays until the other one is clearly nearer.
      if (yellowAtTheBall ? blueReach < yellowReach - 0.5 : yellowReach < blueReach - 0.5) {
        yellowAtTheBall = !yellowAtTheBall;
      }
      yellow.play(world, referee.attack(Team.YELLOW), yellowAtTheBall);
      blue.play(world, referee.attack(Team.BLUE), !yellowAtTheBall);
    }
    if (referee.enough(world)) {
      robots.forEach(r -> r.command(r.command().kicking(Kick.NONE)));
    }
  }
}
