package fieldcal.simulation;

import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.scenario.CalibrationScenario;
import fieldcal.simulation.scenario.MatchScenario;
import fieldcal.simulation.scenario.Scenario;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.simulation.truth.RobotTruth;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Runs a scenario and shows it to the cameras. Either all at once ({@link #run}, {@link #record}) or tick by tick ({@link #tick}). An instance runs once; not thread-safe.
 */
public final class Simulation {
  /** Session time zero of seed 0, Unix time in ns; the seed moves it by whole hours, so that two recordings do not overlap. */
  private static final long BASE_NANOS = 1_763_712_000_000_000_000L;

  private static final long HOUR_NANOS = 3_600_000_000_000L;

  private final SimulationSettings settings;
  private final BallPhysics physics;
  private final KickBehaviour behaviour;
  private final Epoch epoch;
  private final Scenario scenario;
  private final SimulatedWorld world;
  private final VisionSystem vision;

  private Simulation(
      SimulationSettings settings, Scenario scenario, boolean interactive, double later) {
    this.settings = settings;
    this.scenario = scenario;
    physics = Effects.physics(settings.physics(), settings.effects());
    behaviour = Effects.kicks(settings.kickBehaviour(), settings.effects());
    long start = BASE_NANOS + Math.floorMod(settings.seed(), 100_000L) * HOUR_NANOS;
    epoch = new Epoch(start + Math.round(later * 1e9));
    List<SimulatedRobot> robots = scenario.robots();
    world = new SimulatedWorld(settings.field(), physics, behaviour, robots, settings.seed());
    vision =
        interactive ? new VisionSystem(settings, world, 0, 0) : new VisionSystem(settings, world);
  }

  /** A simulation whose packets are delivered when they arrive, for programs that drive robots by them; it begins some seconds later than others of its seed. */
  static Simulation interactive(SimulationSettings settings, Scenario scenario, double later) {
    return new Simulation(settings, scenario, true, later);
  }

  /**
   * A simulation of the settings' scenario that has not run yet.
   *
   * @param settings what is to be simulated
   * @return the simulation
   * @throws IllegalArgumentException when an effect leaves the range of the physics
   */
  public static Simulation of(SimulationSettings settings) {
    ScenarioSettings s = settings.scenario();
    ScenarioSettings withEffects =
        s.withLimits(
            Effects.limits(s.yellow(), Team.YELLOW, settings.effects()),
            Effects.limits(s.blue(), Team.BLUE, settings.effects()));
    SimulationSettings all = settings.withScenario(withEffects);
    return with(
        settings,
        s.kind() == ScenarioKind.MATCH ? new MatchScenario(all) : new CalibrationScenario(all));
  }

  /**
   * A simulation with robots that somebody else commands.
   *
   * @param settings field, physics, cameras, effects; its scenario and the robots' effects do not count
   * @param scenario who decides what the robots do
   * @return the simulation
   * @throws IllegalArgumentException when an effect leaves the range of the physics
   */
  public static Simulation with(SimulationSettings settings, Scenario scenario) {
    return new Simulation(settings, scenario, false, 0);
  }

  /**
   * Runs it and keeps everything in memory.
   *
   * @param settings what is to be simulated
   * @return the recording
   * @throws IllegalArgumentException as {@link #of}
   */
  public static SimulatedRecording record(SimulationSettings settings) {
    Simulation simulation = of(settings);
    List<SimulatedPacket> packets = new ArrayList<>();
    Truth truth = simulation.run(packets::add);
    return new SimulatedRecording(packets, simulation.geometry(), truth);
  }

  /**
   * The beginning of session time.
   *
   * @return session time zero
   */
  public Epoch epoch() {
    return epoch;
  }

  /**
   * The geometry as published.
   *
   * @return field, cameras, ball models
   */
  public FieldGeometry geometry() {
    return vision.geometry();
  }

  /**
   * The field itself.
   *
   * @return ball and robots as they are
   */
  public SimulatedWorld world() {
    return world;
  }

  /**
   * What the referee said up to now, for whoever writes it down while the simulation runs.
   *
   * @return by time; empty without a referee
   */
  public List<RefereePhase> phases() {
    return scenario.phases();
  }

  /**
   * How far the simulation is.
   *
   * @return share of the scenario that is done, 0 … 1
   */
  public double progress() {
    return scenario.progress(world);
  }

  /**
   * Runs to the scenario's end.
   *
   * @param sink gets the packets in the order of their arrival
   * @return what really happened
   */
  public Truth run(Consumer<SimulatedPacket> sink) {
    while (tick(sink)) {
      // All work is done in the tick.
    }
    return finish(sink);
  }

  /**
   * One step of {@link SimulatedWorld#TICK}.
   *
   * @param sink gets the packets that arrive meanwhile
   * @return false when the scenario had already ended; then nothing happened
   */
  public boolean tick(Consumer<SimulatedPacket> sink) {
    if (scenario.finished(world)) {
      return false;
    }
    scenario.tick(world);
    world.tick();
    vision.observe(world.time(), sink);
    return true;
  }

  /**
   * Ends the recording now.
   *
   * @param sink gets the packets that are still on their way
   * @return what really happened
   */
  public Truth finish(Consumer<SimulatedPacket> sink) {
    world.finish();
    vision.finish(sink);
    return new Truth(
        settings,
        physics,
        behaviour,
        vision.ballPlane(),
        vision.rollingShutter(),
        epoch,
        world.time(),
        vision.truth(),
        world.robots().stream().map(r -> new RobotTruth(r.id(), r.height(), r.limits())).toList(),
        scenario.phases(),
        world.kicks().finished(),
        world.kicks().holds());
  }
}
