package fieldcal.live;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.movement.PlayPhase;
import fieldcal.simulation.Preset;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.AirLaw;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.GroundLaw;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.BallModels;
import fieldcal.vision.VisionFrame;
import java.util.List;
import java.util.Optional;

/** Simulated matches on a field whose cameras disagree by 23 mm, as they do, or on one of the presets; and how they are given to a monitor. */
public final class SimulatedMatch {
  /** What the ball does. */
  public static final BallModels TRUTH =
      new BallModels(
          Optional.of(new FlatModel(-3.1, -0.28, 0.65)),
          Optional.of(new ChipModel(0.75, 0.95, 0.52, -0.28)));

  private final SimulatedRecording recording;

  private SimulatedMatch(SimulatedRecording recording) {
    this.recording = recording;
  }

  /**
   * Plays a match.
   *
   * @param seed of all luck
   * @param minutes how long
   * @param accRoll of the carpet, m/s²; the rest is as in {@link #TRUTH}
   * @return the match in memory
   */
  public static SimulatedMatch play(long seed, double minutes, double accRoll) {
    return play(seed, minutes, accRoll, 6);
  }

  /**
   * Plays a match.
   *
   * @param seed of all luck
   * @param minutes how long
   * @param accRoll of the carpet, m/s²; the rest is as in {@link #TRUTH}
   * @param size robots a side
   * @return the match in memory
   */
  public static SimulatedMatch play(long seed, double minutes, double accRoll, int size) {
    SimulationSettings s =
        settings(seed, minutes, size)
            .withPublishedModels(TRUTH)
            .withPhysics(BallPhysics.ideal(-3.1, accRoll, 0.65, 0.75, 0.95, 0.52));
    return new SimulatedMatch(
        Simulation.record(
            s.withCameras(s.cameras().withNoise(0.002, 0.0035).withRegistration(0.0215, 0.023))));
  }

  /**
   * Plays a match of 6 against 6 on a field as it was found, where the ball is braked by rolling and by the air as it is there, or by a factor more at every speed.
   *
   * @param preset the field
   * @param seed of all luck
   * @param minutes how long
   * @param brakes factor on what brakes a rolling ball
   * @return the match in memory
   */
  public static SimulatedMatch on(Preset preset, long seed, double minutes, double brakes) {
    SimulationSettings s = preset.applyTo(settings(seed, minutes, 6));
    BallPhysics physics = s.physics();
    GroundLaw g = physics.ground();
    // Of the carpet's laws presets use these; sliding stays as it is.
    GroundLaw ground =
        GroundLaw.uniform(g.slidingFriction(), brakes * g.rollingDeceleration())
            .withSpeedDependentRoll(
                brakes * g.rollingPerSpeed(), brakes * g.rollingPerSpeedSquared())
            .withNap(g.napAmplitude(), g.napDirection());
    AirLaw air = physics.air();
    return new SimulatedMatch(
        Simulation.record(
            s.withPhysics(
                physics.withGround(ground).withAir(air.withDrag(brakes * air.dragCoefficient())))));
  }

  private static SimulationSettings settings(long seed, double minutes, int size) {
    return SimulationSettings.DEFAULT
        .withSeed(seed)
        .withScenario(ScenarioSettings.of(ScenarioKind.MATCH, 0).withMatch(size, minutes));
  }

  /**
   * The match itself.
   *
   * @return packets and truth
   */
  public SimulatedRecording recording() {
    return recording;
  }

  /**
   * How long it takes.
   *
   * @return s
   */
  public double duration() {
    return recording.truth().duration();
  }

  /**
   * Gives a monitor the match.
   *
   * @param monitor is given geometry, phases and frames, not told to finish
   * @param shift added to all times, s
   */
  public void feed(LiveMonitor monitor, double shift) {
    monitor.geometry(recording.geometry());
    List<RefereePhase> phases = recording.truth().phases();
    int next = 0;
    for (VisionFrame frame : recording.frames()) {
      while (next < phases.size() && phases.get(next).time() <= frame.captureTime()) {
        monitor.phase(phase(phases.get(next++).command()));
      }
      monitor.accept(shift == 0 ? frame : later(frame, shift));
    }
  }

  /**
   * A frame at another time.
   *
   * @param f the frame
   * @param shift added to its times, s
   * @return the changed copy
   */
  public static VisionFrame later(VisionFrame f, double shift) {
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime() + shift,
        f.sentTime() + shift,
        f.cameraClockTime(),
        f.balls(),
        f.robots());
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
}
