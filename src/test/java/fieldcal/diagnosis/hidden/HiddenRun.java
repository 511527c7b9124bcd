package fieldcal.diagnosis.hidden;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.diagnosis.KickCommand;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * What the code under test makes of a case. It sees frames, geometry and the commands file; the truth stays here for the judge.
 *
 * @param problem what was given to the diagnosis
 * @param answer of the diagnosis
 * @param truth what really happened
 * @param times how long each stage took
 */
public record HiddenRun(DiagnosisProblem problem, Answer answer, Truth truth, Times times) {

  /**
   * How long it took, s.
   *
   * @param simulation simulation and search for kicks
   * @param calibration fits of the kicks and the calibration
   * @param diagnosis the diagnosis
   */
  public record Times(double simulation, double calibration, double diagnosis) {}

  /**
   * Simulates, calibrates, diagnoses.
   *
   * @param hidden the case
   * @param progress of the diagnosis
   * @return the result
   */
  public static HiddenRun of(HiddenCase hidden, Consumer<String> progress) {
    long start = System.nanoTime();
    SeenKicks seen = SeenKicks.of(hidden.settings());
    long found = System.nanoTime();
    DiagnosisProblem problem = problem(seen, hidden.commands());
    long calibrated = System.nanoTime();
    Answer answer = Answer.to(problem, progress);
    long end = System.nanoTime();
    Times times =
        new Times(1e-9 * (found - start), 1e-9 * (calibrated - found), 1e-9 * (end - calibrated));
    return new HiddenRun(problem, answer, seen.truth(), times);
  }

  /**
   * What the diagnosis of a case is given.
   *
   * @param hidden the case
   * @return kicks and cameras as seen, fitted one by one
   */
  public static DiagnosisProblem problem(HiddenCase hidden) {
    return problem(SeenKicks.of(hidden.settings()), hidden.commands());
  }

  /**
   * What the diagnosis of a simulated recording is given, without what the robots were told.
   *
   * @param world to be simulated
   * @return kicks and cameras as seen, fitted one by one
   */
  public static DiagnosisProblem problem(SimulationSettings world) {
    return problem(SeenKicks.of(world), false);
  }

  /**
   * What a diagnosis of these kicks is made from.
   *
   * @param seen what the cameras saw
   * @param commands whether it is told what the robots were told
   * @return the problem
   */
  static DiagnosisProblem problem(SeenKicks seen, boolean commands) {
    FieldGeometry geometry = seen.geometry();
    CameraViews views =
        CameraViews.of(
            seen.cameras().values().stream()
                .map(c -> CameraView.of(c.id(), Optional.of(c)))
                .toList());
    Calibration calibration =
        new Calibrator(FitSettings.defaults())
            .calibrate(
                new CalibrationProblem(
                    seen.kicks(),
                    seen.truth().epoch(),
                    views,
                    geometry.flat().orElse(FlatModel.typical()),
                    geometry.chip().orElse(ChipModel.typical()),
                    Optional.empty(),
                    HandSelection.none()),
                kick -> {});
    List<KickFit> fits = calibration.fitted();
    List<ObservedCamera> observers =
        geometry.cameras().stream()
            .map(c -> ObservedCamera.of(c, seen.cameras().get(c.id()), geometry.cameras().size()))
            .toList();
    return new DiagnosisProblem(
        fits,
        calibration.cameras(),
        observers,
        seen.firstFrame(),
        commands ? commands(fits, seen.truth()) : Map.of(),
        DiagnosisProblem.DEFAULT_MAX_CAUSES,
        FitSettings.defaults().seed());
  }

  private static Map<Integer, KickCommand> commands(List<KickFit> fits, Truth truth) {
    Epoch epoch = truth.epoch();
    List<CommandFile.Command> file = new ArrayList<>();
    for (KickTruth k : truth.commandedKicks()) {
      file.add(
          new CommandFile.Command(
              epoch.unixSeconds(k.time()),
              k.robot(),
              k.kind().label(),
              k.command().speed(),
              k.command().direction(),
              k.command().elevation()));
    }
    Map<Integer, KickCommand> commands = new HashMap<>();
    for (KickFit fit : fits) {
      Kick kick = fit.kick();
      CommandFile.of(file, epoch.unixSeconds(kick.time()), kick.robot())
          .ifPresent(
              c ->
                  commands.put(
                      kick.id(),
                      new KickCommand(c.robot(), c.speed(), c.direction(), c.elevation())));
    }
    return commands;
  }
}
