package fieldcal.benchmark;

import fieldcal.app.wording.EffectName;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Average;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.camera.Camera;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.kick.KickKind;
import fieldcal.simulation.Preset;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.vision.FieldGeometry;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Why teams measure a kSwitch of 0.58 to 0.66 though a golf ball is solid and would start to roll at 5/7 of its kick's speed: flat kicks of such a ball on a carpet
 * with Coulomb friction, with one thing wrong at a time; what a team measures then, and what the diagnosis says.
 */
final class KSwitchCauses {
  /** As many as a team records in a few minutes. */
  private static final int KICKS = 12;

  private static final String ROW = "%-44s %-21s %-21s %s%n";

  private KSwitchCauses() {}

  /**
   * One thing that is wrong.
   *
   * @param name for the table
   * @param sessions that are recorded, of the same field and cameras
   */
  private record World(String name, List<SimulationSettings> sessions) {
    World(String name, SimulationSettings settings) {
      this(name, List.of(settings));
    }
  }

  static void run(BenchmarkSettings settings, PrintStream out) {
    out.printf(
        "kSwitch from %d flat kicks each: plain mean and standard deviation of kicks fitted on"
            + " their own; calibrated: weighted mean and what differs from kick to kick beyond the"
            + " noise%n",
        KICKS);
    out.printf(
        ROW, "what is wrong", "each kick on its own", "calibrated", "what the diagnosis says");
    for (World world : worlds(settings.seed())) {
      measure(world, out);
    }
  }

  /** A solid golf ball, sliding with 3.1 and rolling with 0.28 m/s², four cameras with 2 mm of noise. */
  private static List<World> worlds(long seed) {
    SimulationSettings plain =
        SimulationSettings.DEFAULT
            .withScenario(ScenarioKind.FLAT, KICKS)
            .withPhysics(BallPhysics.contact(3.1 / BallPhysics.GRAVITY, 0.28, 0.5))
            .withSeed(seed);
    List<World> worlds = new ArrayList<>();
    worlds.add(new World("nothing", plain));
    for (double spin : new double[] {-0.2, -0.35, -0.5}) {
      for (double scatter : new double[] {0, 0.25}) {
        String name = "backspin %.2f%s".formatted(-spin, scatter > 0 ? " ± " + scatter : "");
        worlds.add(
            new World(
                name, plain.withKickBehaviour(plain.kickBehaviour().withRollSpin(spin, scatter))));
      }
    }
    worlds.add(
        new World(
            "backspin 0.35, and as many kicks without",
            List.of(plain.withKickBehaviour(plain.kickBehaviour().withRollSpin(-0.35, 0)), plain)));
    worlds.add(with(plain, "air drag, cd 0.45", "air_drag:cd=0.45"));
    worlds.add(with(plain, "rolling grows by 0.06 m/s² per m/s", "speed_dependent_roll:0.06"));
    worlds.add(
        new World(
            "neighbouring cameras disagree by 20 mm",
            plain.withCameras(CameraSettings.DEFAULT.withRegistration(0.0215, 0.020))));
    worlds.add(with(plain, "stamps of camera 1 late by 5 ms", "camera_time_offset:ms=5,camera=1"));
    worlds.add(
        with(plain, "friction grows by 10 % per m/s of slip", "slip_dependent_friction:0.1"));
    worlds.add(
        with(plain, "friction falls by 5 % per m/s of slip", "slip_dependent_friction:-0.05"));
    worlds.add(new World("as at the German Open 2026", Preset.GERMAN_OPEN_2026.applyTo(plain)));
    return worlds;
  }

  private static World with(SimulationSettings plain, String name, String effect) {
    return new World(name, plain.withEffects(effect));
  }

  private static void measure(World world, PrintStream out) {
    List<SimulatedRecording> recordings =
        world.sessions().stream().map(Simulation::record).toList();
    SimulatedRecording recording = recordings.get(0);
    FieldGeometry field = recording.geometry();
    Map<Integer, Camera> cameras =
        field.cameras().stream().map(Camera::of).collect(Collectors.toMap(Camera::id, c -> c));
    List<Kick> kicks = kicks(recordings, cameras);
    CameraViews views =
        CameraViews.of(
            cameras.values().stream().map(c -> CameraView.of(c.id(), Optional.of(c))).toList());
    Calibration calibration =
        new Calibrator(FitSettings.defaults())
            .calibrate(
                new CalibrationProblem(
                    kicks,
                    recording.epoch(),
                    views,
                    FlatModel.typical(),
                    ChipModel.typical(),
                    Optional.of(KickKind.FLAT),
                    HandSelection.none()),
                kick -> {});
    Diagnosis diagnosis =
        new Diagnoser().diagnose(problem(recording, cameras, calibration), stage -> {});
    Average average = calibration.flat().get("kSwitch");
    out.printf(
        Locale.ROOT,
        ROW,
        world.name(),
        alone(kicks, views),
        text(average.mean(), average.scatter()),
        text(diagnosis));
  }

  private static List<Kick> kicks(
      List<SimulatedRecording> recordings, Map<Integer, Camera> cameras) {
    List<Kick> kicks = new ArrayList<>();
    for (SimulatedRecording recording : recordings) {
      KickFinder finder =
          new KickFinder(
              KickFinderSettings.defaults(), kick -> kicks.add(kick.withId(kicks.size() + 1)));
      finder.geometry(recording.geometry(), cameras);
      recording.frames().forEach(finder::accept);
      finder.finish();
    }
    return kicks;
  }

  /** What a team gets that trusts the published cameras and averages its kicks. */
  private static String alone(List<Kick> kicks, CameraViews views) {
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    double[] values =
        kicks.stream()
            .map(k -> FitProblem.of(k, views, FlatModel.typical(), ChipModel.typical()))
            .map(problem -> fitter.fit(problem, KickKind.FLAT))
            .filter(fit -> fit.failure().isEmpty() && fit.estimate("kSwitch").usable())
            .mapToDouble(fit -> fit.estimate("kSwitch").value())
            .toArray();
    return text(StatUtils.mean(values), Math.sqrt(StatUtils.variance(values)));
  }

  private static DiagnosisProblem problem(
      SimulatedRecording recording, Map<Integer, Camera> cameras, Calibration calibration) {
    List<ObservedCamera> observers =
        recording.geometry().cameras().stream()
            .map(c -> ObservedCamera.of(c, cameras.get(c.id()), cameras.size()))
            .toList();
    return new DiagnosisProblem(
        calibration.fitted(),
        calibration.cameras(),
        observers,
        recording.frames().get(0).captureTime(),
        Map.of(),
        DiagnosisProblem.DEFAULT_MAX_CAUSES,
        FitSettings.defaults().seed());
  }

  private static String text(double mean, double scatter) {
    return String.format(Locale.ROOT, "%.3f ± %.3f", mean, scatter);
  }

  private static String text(Diagnosis diagnosis) {
    String causes =
        diagnosis.causes().stream().map(KSwitchCauses::text).collect(Collectors.joining("; "));
    return switch (diagnosis.verdict()) {
      case MODEL_ADEQUATE -> "model adequate";
      case EXPLAINED -> causes;
      case PARTLY_EXPLAINED ->
          Stream.of(
                  Stream.of(causes).filter(c -> !c.isEmpty()),
                  diagnosis.learned().stream()
                      .map(l -> "%s depends on %s".formatted(l.actsOn(), l.dependsOn())),
                  Stream.of("%.2f mm remain".formatted(diagnosis.unexplained().systematicMm())))
              .flatMap(s -> s)
              .collect(Collectors.joining("; "));
      case UNEXPLAINED_STRUCTURE ->
          "%.2f mm unexplained, depends on %s"
              .formatted(
                  diagnosis.unexplained().systematicMm(), diagnosis.unexplained().dependsOn());
    };
  }

  private static String text(Cause cause) {
    String scatter = cause.scatter() > 0 ? ", kick to kick ± %.2f".formatted(cause.scatter()) : "";
    String ties =
        cause.indistinguishableFrom().isEmpty()
            ? ""
            : cause.indistinguishableFrom().stream()
                .map(EffectName::of)
                .collect(Collectors.joining(" or ", " (or ", ")"));
    return EffectName.of(cause.effect())
        + ' '
        + EffectName.strength(cause.effect(), cause.standardErrors())
        + scatter
        + ties;
  }
}
