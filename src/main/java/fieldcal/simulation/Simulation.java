package fieldcal.simulation;

import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraRig;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.SimulatedCamera;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.scenario.CalibrationScenario;
import fieldcal.simulation.scenario.MatchScenario;
import fieldcal.simulation.scenario.Scenario;
import fieldcal.simulation.truth.CameraTruth;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.simulation.truth.RobotTruth;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.Consumer;

/** Runs a scenario and shows it to the cameras. An instance runs once; not thread-safe. */
public final class Simulation {
  /** Session time zero of seed 0, Unix time in ns; the seed moves it by whole hours, so that two recordings do not overlap. */
  private static final long BASE_NANOS = 1_763_712_000_000_000_000L;

  private static final long HOUR_NANOS = 3_600_000_000_000L;

  /** From vision to the recorder, s. */
  private static final double NETWORK = 0.0003;

  /** Nothing that is exposed from now on can arrive earlier than this before now, s: cameras lag behind the world by less. */
  private static final double SAFE_LAG = 0.1;

  private static final double GEOMETRY_INTERVAL = 1;

  private final SimulationSettings settings;
  private final BallPhysics physics;
  private final KickBehaviour behaviour;
  private final double ballPlane;
  private final double rollingShutter;
  private final Epoch epoch;
  private final Scenario scenario;
  private final SimulatedWorld world;
  private final List<SimulatedCamera> cameras;
  private final long[] frameCounts;
  private final PriorityQueue<Arrival> waiting =
      new PriorityQueue<>(
          Comparator.comparingDouble((Arrival a) -> a.packet().receivedTime())
              .thenComparingLong(Arrival::order));
  private long order;
  private double nextGeometry = 0.004;

  private record Arrival(SimulatedPacket packet, long order) {}

  private Simulation(SimulationSettings settings) {
    this.settings = settings;
    List<EffectSetting> effects = settings.effects();
    physics = Effects.physics(settings.physics(), effects);
    behaviour = Effects.kicks(settings.kickBehaviour(), effects);
    CameraSettings cameraSettings = Effects.cameras(settings.cameras(), effects);
    ballPlane = cameraSettings.ballPlane();
    rollingShutter = Effects.rollingShutter(0, effects);
    epoch = new Epoch(BASE_NANOS + Math.floorMod(settings.seed(), 100_000L) * HOUR_NANOS);
    scenario = scenario(settings);
    world =
        new SimulatedWorld(
            settings.field(), physics, behaviour, scenario.robots(), settings.seed());
    List<CameraErrors> errors = Effects.cameraErrors(cameraSettings.count(), effects);
    cameras =
        CameraRig.over(
            settings.field(),
            cameraSettings,
            settings.nuisance(),
            errors,
            rollingShutter,
            settings.seed());
    frameCounts = new long[cameras.size()];
  }

  private static Scenario scenario(SimulationSettings settings) {
    ScenarioSettings s = settings.scenario();
    ScenarioSettings withEffects =
        s.withLimits(
            Effects.limits(s.yellow(), Team.YELLOW, settings.effects()),
            Effects.limits(s.blue(), Team.BLUE, settings.effects()));
    SimulationSettings all = settings.withScenario(withEffects);
    return s.kind() == ScenarioKind.MATCH ? new MatchScenario(all) : new CalibrationScenario(all);
  }

  /**
   * A simulation that has not run yet.
   *
   * @param settings what is to be simulated
   * @return the simulation
   * @throws IllegalArgumentException when an effect leaves the range of the physics
   */
  public static Simulation of(SimulationSettings settings) {
    return new Simulation(settings);
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
   * Where session times count from.
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
    FieldSize field = settings.field();
    List<CameraCalibration> published =
        cameras.stream().map(SimulatedCamera::publishedCalibration).toList();
    return FieldGeometry.of(
            field.length(),
            field.width(),
            field.goalWidth(),
            field.goalDepth(),
            field.boundary(),
            published)
        .withModels(settings.publishedModels().flat(), settings.publishedModels().chip());
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
    FieldGeometry geometry = geometry();
    while (!scenario.finished(world)) {
      scenario.tick(world);
      world.tick();
      expose(world.time());
      publish(geometry);
      deliver(world.time() - SAFE_LAG, sink);
    }
    world.finish();
    deliver(Double.POSITIVE_INFINITY, sink);
    return truth();
  }

  private void expose(double now) {
    List<VisionFrame> frames = new ArrayList<>(2);
    for (int i = 0; i < cameras.size(); i++) {
      SimulatedCamera camera = cameras.get(i);
      while (camera.nextExposure() + camera.exposureSpan() <= now) {
        frames.clear();
        camera.expose(world, frames);
        for (VisionFrame frame : frames) {
          frameCounts[i]++;
          double received = frame.sentTime() + NETWORK * (1 + 0.1 * (order % 7));
          add(received, VisionPacket.of(frame));
        }
      }
    }
  }

  private void publish(FieldGeometry geometry) {
    if (world.time() >= nextGeometry) {
      add(nextGeometry, VisionPacket.of(geometry));
      nextGeometry += GEOMETRY_INTERVAL;
    }
  }

  private void add(double received, VisionPacket packet) {
    waiting.add(new Arrival(new SimulatedPacket(received, packet), order++));
  }

  private void deliver(double until, Consumer<SimulatedPacket> sink) {
    while (!waiting.isEmpty() && waiting.peek().packet().receivedTime() <= until) {
      sink.accept(waiting.poll().packet());
    }
  }

  private Truth truth() {
    List<CameraTruth> cameraTruths = new ArrayList<>();
    for (int i = 0; i < cameras.size(); i++) {
      SimulatedCamera c = cameras.get(i);
      cameraTruths.add(
          new CameraTruth(
              c.trueCalibration(), c.publishedCalibration(), c.errors(), c.rate(), frameCounts[i]));
    }
    return new Truth(
        settings,
        physics,
        behaviour,
        ballPlane,
        rollingShutter,
        epoch,
        world.time(),
        cameraTruths,
        world.robots().stream().map(r -> new RobotTruth(r.id(), r.height(), r.limits())).toList(),
        scenario.phases(),
        world.kicks().finished(),
        world.kicks().holds());
  }
}
