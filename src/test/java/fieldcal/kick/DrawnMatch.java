package fieldcal.kick;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.Preset;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.vision.BallDetection;
import fieldcal.vision.ChangedFrame;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * A match drawn from a seed: which field, how many robots and cameras, how noisy, what goes wrong. On top of what the simulation itself spoils, a white spot may lie on the field and two robots may
 * swap their numbers.
 *
 * @param settings of the simulation
 * @param spot whether something white lies on the field and is taken for a ball in most frames
 * @param swaps whether now and then two robots swap their numbers for some frames
 */
record DrawnMatch(SimulationSettings settings, boolean spot, boolean swaps) {

  /** Everything else of the match follows from these two. */
  static DrawnMatch of(long seed, double minutes) {
    SplittableRandom random = new SplittableRandom(seed);
    boolean large = random.nextBoolean();
    int size = large && random.nextBoolean() ? 11 : 6;
    SimulationSettings base =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withField(large ? FieldSize.DIVISION_A : FieldSize.DIVISION_B)
            .withScenario(ScenarioSettings.of(ScenarioKind.MATCH, 0).withMatch(size, minutes));
    int preset = random.nextInt(4);
    SimulationSettings world = preset == 3 ? base : Preset.values()[preset].applyTo(base);
    int cameras = 1 + random.nextInt(8);
    double noise = random.nextDouble(0.0007, 0.003);
    double apart = random.nextDouble(0, 0.026);
    world =
        world
            .withCameras(
                world
                    .cameras()
                    .withCount(cameras)
                    .withNoise(noise, 1.5 * noise)
                    .withRegistration(world.cameras().ballPlane(), apart))
            .withNuisance(trouble(random, cameras, minutes));
    return new DrawnMatch(world, random.nextInt(3) == 0, random.nextInt(3) == 0);
  }

  private static Nuisance trouble(SplittableRandom random, int cameras, double minutes) {
    double much = random.nextDouble();
    List<Nuisance.Outage> outages = new ArrayList<>();
    if (random.nextInt(3) == 0) {
      outages.add(
          new Nuisance.Outage(
              random.nextInt(cameras), random.nextDouble(50 * minutes), random.nextDouble(3, 15)));
    }
    return new Nuisance(
        0.006 * much,
        0.004 * random.nextDouble() * much,
        0.02 * much,
        0.01 * much,
        0.02 * much,
        0.03 * much,
        random.nextDouble(0.1e-3, 1.3e-3),
        0.05e-3,
        0.005 * much,
        true,
        outages);
  }

  SimulatedRecording record() {
    return Simulation.record(settings);
  }

  /** The recording's frames with the troubles that the simulation does not know. */
  List<VisionFrame> frames(SimulatedRecording recording) {
    SplittableRandom random = new SplittableRandom(settings.seed() + 1);
    double x = random.nextDouble(-0.5, 0.5) * settings.field().length();
    double y = random.nextDouble(-0.5, 0.5) * settings.field().width();
    int spotCamera = random.nextInt(settings.cameras().count());
    List<VisionFrame> frames = new ArrayList<>();
    double swapUntil = 0;
    double nextSwap = 5;
    for (VisionFrame frame : recording.frames()) {
      List<BallDetection> balls = new ArrayList<>(frame.balls());
      if (spot && frame.cameraId() == spotCamera && random.nextDouble() < 0.8) {
        balls.add(0, white(x, y, random));
      }
      if (swaps && frame.captureTime() > nextSwap) {
        swapUntil = nextSwap + random.nextDouble(0.02, 0.3);
        nextSwap += random.nextDouble(2, 10);
      }
      frames.add(
          ChangedFrame.with(
              frame,
              balls,
              frame.captureTime() < swapUntil ? swapped(frame.robots()) : frame.robots()));
    }
    return frames;
  }

  private static BallDetection white(double x, double y, SplittableRandom random) {
    return new BallDetection(
        x + random.nextGaussian(0, 0.004),
        y + random.nextGaussian(0, 0.004),
        Double.NaN,
        0.6,
        40,
        500,
        500);
  }

  private static List<RobotDetection> swapped(List<RobotDetection> robots) {
    List<RobotDetection> changed = new ArrayList<>(robots);
    for (int i = 0; i + 1 < robots.size(); i += 2) {
      RobotDetection a = robots.get(i);
      RobotDetection b = robots.get(i + 1);
      changed.set(i, named(a, b.id()));
      changed.set(i + 1, named(b, a.id()));
    }
    return changed;
  }

  private static RobotDetection named(RobotDetection r, RobotId id) {
    return new RobotDetection(id, r.x(), r.y(), r.orientation(), r.confidence(), r.height());
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "seed %d: %.0f x %.0f m, %d v %d, %d cameras, %.1f mm noise, %.0f mm apart, ball plane %.1f"
            + " mm, %.1f %% frames lost, %d outages%s%s",
        settings.seed(),
        settings.field().length(),
        settings.field().width(),
        settings.scenario().teamSize(),
        settings.scenario().teamSize(),
        settings.cameras().count(),
        1000 * settings.cameras().ballNoise(),
        1000 * settings.cameras().disagreement(),
        1000 * settings.cameras().ballPlane(),
        100 * settings.nuisance().frameDrop(),
        settings.nuisance().outages().size(),
        spot ? ", a white spot" : "",
        swaps ? ", swapped numbers" : "");
  }
}
