package fieldcal.movement;

import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TeamManner;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** A simulated match in memory, and what can go wrong with its frames. */
final class MatchFrames {
  private final List<VisionFrame> frames;
  private final List<RefereePhase> phases;

  private MatchFrames(List<VisionFrame> frames, List<RefereePhase> phases) {
    this.frames = frames;
    this.phases = phases;
  }

  static MatchFrames of(
      int teamSize, double minutes, long seed, double noise, RobotLimits yellow, RobotLimits blue) {
    return of(teamSize, minutes, seed, noise, yellow, blue, TeamManner.USUAL);
  }

  static MatchFrames of(
      int teamSize,
      double minutes,
      long seed,
      double noise,
      RobotLimits yellow,
      RobotLimits blue,
      TeamManner manner) {
    SimulationSettings s =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withScenario(
                ScenarioSettings.of(ScenarioKind.MATCH, 0)
                    .withMatch(teamSize, minutes)
                    .withLimits(yellow, blue)
                    .withManner(manner));
    // Cameras disagree by 23 mm, as they do.
    s =
        s.withCameras(
            s.cameras().withCount(2).withNoise(0.002, noise).withRegistration(0.0215, 0.023));
    var recording = Simulation.record(s);
    return new MatchFrames(recording.frames(), recording.truth().phases());
  }

  List<VisionFrame> frames() {
    return frames;
  }

  MatchFrames with(List<VisionFrame> other) {
    return new MatchFrames(other, phases);
  }

  /** What an observer counts, told by the referee. */
  MovementObserver observe() {
    MovementObserver observer = new MovementObserver();
    int next = 0;
    for (VisionFrame frame : frames) {
      while (next < phases.size() && phases.get(next).time() <= frame.captureTime()) {
        observer.phase(phase(phases.get(next++).command()));
      }
      observer.accept(frame);
    }
    observer.finish();
    return observer;
  }

  private static PlayPhase phase(String command) {
    if (command.endsWith("_START") || command.startsWith("DIRECT_")) {
      return PlayPhase.RUNNING;
    }
    if (command.startsWith("TIMEOUT")) {
      return PlayPhase.BREAK;
    }
    return command.equals("HALT") ? PlayPhase.HALTED : PlayPhase.STOPPED;
  }

  /** Every n-th frame comes twice, once in a while long after. */
  MatchFrames duplicated(int every) {
    List<VisionFrame> result = new ArrayList<>();
    for (int i = 0; i < frames.size(); i++) {
      result.add(frames.get(i));
      if (i % every == 0) {
        result.add(frames.get(Math.max(0, i - i % 3)));
      }
    }
    return with(result);
  }

  /** For single frames and for short whiles, two robots of a team bear each other's numbers. */
  MatchFrames exchanged(double share, int longest, long seed) {
    Random random = new Random(seed);
    List<VisionFrame> result = new ArrayList<>();
    int left = 0;
    Team team = Team.YELLOW;
    int a = 0;
    int b = 1;
    for (VisionFrame frame : frames) {
      if (left == 0 && random.nextDouble() < share) {
        left = 1 + random.nextInt(longest);
        team = random.nextBoolean() ? Team.YELLOW : Team.BLUE;
        a = random.nextInt(3);
        b = a + 1;
      }
      if (left > 0) {
        left--;
        result.add(exchange(frame, new RobotId(team, a), new RobotId(team, b)));
      } else {
        result.add(frame);
      }
    }
    return with(result);
  }

  private static VisionFrame exchange(VisionFrame frame, RobotId a, RobotId b) {
    List<RobotDetection> robots = new ArrayList<>();
    for (RobotDetection r : frame.robots()) {
      RobotId id = r.id().equals(a) ? b : r.id().equals(b) ? a : r.id();
      robots.add(new RobotDetection(id, r.x(), r.y(), r.orientation(), r.confidence(), r.height()));
    }
    return withRobots(frame, robots);
  }

  /** Some detections are somewhere else. */
  MatchFrames jumping(double share, double distance, long seed) {
    Random random = new Random(seed);
    List<VisionFrame> result = new ArrayList<>();
    for (VisionFrame frame : frames) {
      List<RobotDetection> robots = new ArrayList<>();
      for (RobotDetection r : frame.robots()) {
        boolean jumps = random.nextDouble() < share;
        double direction = 2 * Math.PI * random.nextDouble();
        robots.add(
            new RobotDetection(
                r.id(),
                jumps ? r.x() + distance * Math.cos(direction) : r.x(),
                jumps ? r.y() + distance * Math.sin(direction) : r.y(),
                r.orientation(),
                r.confidence(),
                r.height()));
      }
      result.add(withRobots(frame, robots));
    }
    return with(result);
  }

  private static VisionFrame withRobots(VisionFrame f, List<RobotDetection> robots) {
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime(),
        f.sentTime(),
        f.cameraClockTime(),
        f.balls(),
        robots);
  }
}
