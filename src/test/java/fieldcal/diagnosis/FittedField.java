package fieldcal.diagnosis;

import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.Effort;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.effect.Arena;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.Screening;
import fieldcal.fit.TypicalBall;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A simulated recording as the stages of a diagnosis get it: kicks with their noise, and the simple model fitted to all of them. Immutable; the common ones are made once for all tests.
 *
 * @param problem kicks and cameras
 * @param noise the cameras' noise of a moving ball
 * @param fitter of all kicks
 * @param simple the simple model, fitted
 */
public record FittedField(
    DiagnosisProblem problem, MovingNoise noise, ModelFitter fitter, FittedModel simple) {
  private static final Map<SimulationSettings, FittedField> KNOWN = new ConcurrentHashMap<>();

  /** Nothing wrong: a ball that obeys the league's model to the letter, two cameras. */
  public static final SimulationSettings SOUND =
      SimulationSettings.DEFAULT
          .withPhysics(BallPhysics.ideal(-3.1, -0.28, 5.0 / 7, 0.75, 0.95, 0.52))
          .withCameras(CameraSettings.DEFAULT.withCount(2))
          .withSeed(7);

  /** The solver of all tests. */
  public static final SharedSolver SOLVER = SharedSolver.withDefaults().withMaxIterations(25);

  /** Ten flat kicks. */
  public static FittedField flats(String... effects) {
    return of(SOUND.withScenario(ScenarioKind.FLAT, 10).withEffects(effects));
  }

  /** Ten chips. */
  public static FittedField chips(String... effects) {
    return of(SOUND.withScenario(ScenarioKind.CHIP, 10).withEffects(effects));
  }

  /** Twelve kicks of both kinds. */
  public static FittedField mixed(String... effects) {
    return of(SOUND.withScenario(ScenarioKind.MIXED, 12).withEffects(effects));
  }

  /** The field of a simulation, made once. */
  public static FittedField of(SimulationSettings world) {
    return KNOWN.computeIfAbsent(world, w -> of(HiddenRun.problem(w)));
  }

  /** The field of any recording. */
  public static FittedField of(DiagnosisProblem problem) {
    List<KickFit> fits = problem.fits();
    List<boolean[]> kept = fits.stream().map(f -> Screening.kept(f, problem.cameras())).toList();
    MovingNoise noise = MovingNoise.of(fits, kept, problem.cameras());
    List<KickRecord> kicks = fits.stream().map(f -> KickScreen.record(f, noise)).toList();
    ModelFitter fitter =
        new ModelFitter(kicks, problem.sessionStart(), new Effort(Long.MAX_VALUE), fitted -> {});
    FittedModel simple =
        fitter.fit(
            EffectModel.simple(
                TypicalBall.flat(fits),
                TypicalBall.chip(fits),
                has(kicks, KickKind.FLAT),
                has(kicks, KickKind.CHIP),
                problem.observers()),
            SOLVER.settlingVariants());
    return new FittedField(problem, noise, fitter, simple);
  }

  private static boolean has(List<KickRecord> kicks, KickKind kind) {
    return kicks.stream().anyMatch(k -> k.kind() == kind);
  }

  /** The field's problem with its kicks seen or fitted otherwise. */
  public DiagnosisProblem problem(List<KickFit> fits) {
    return new DiagnosisProblem(
        fits,
        problem.cameras(),
        problem.observers(),
        problem.sessionStart(),
        problem.commands(),
        problem.maxCauses(),
        problem.seed());
  }

  /** The same field, some of whose flat balls a gust pushes aside, each at another time: 1 m/s² for up to a second. */
  public FittedField withGusts(int... pushed) {
    List<KickFit> fits = new ArrayList<>(problem.fits());
    for (int k : pushed) {
      double from = 0.2 + 0.05 * k;
      Kick kick =
          MovedBall.shifted(
              fits.get(k).kick(), t -> 0.5 * Math.pow(Math.min(1, Math.max(0, t - from)), 2));
      fits.set(k, fit(kick, KickKind.FLAT));
    }
    return of(problem(fits));
  }

  /** A kick's own fit, begun at the simple model. */
  public KickFit fit(Kick kick, KickKind kind) {
    ModelState state = simple.solution().state();
    return new KickFitter(FitSettings.defaults())
        .fit(FitProblem.of(kick, noise.cameras(), state.flat(), state.chip()), kind);
  }

  /** A kick fitted again, all of its detections taken for the ball. */
  public KickRecord again(Kick kick, KickKind kind) {
    boolean[] kept = new boolean[kick.observations().size()];
    Arrays.fill(kept, true);
    return new KickRecord(fit(kick, kind), kept, noise);
  }

  /** The simple model, fitted to other records of the field's kicks. */
  public FittedModel simple(List<KickRecord> kicks) {
    return fitter(kicks)
        .fit(
            simple.model().forKinds(has(kicks, KickKind.FLAT), has(kicks, KickKind.CHIP)),
            SOLVER.settlingVariants());
  }

  /** The screen of a diagnosis of this field. */
  public KickScreen screen() {
    return new KickScreen(noise, simple.model(), problem.sessionStart(), FitSettings.defaults());
  }

  /** The same field with other kicks. */
  public ModelFitter fitter(List<KickRecord> kicks) {
    return new ModelFitter(kicks, problem.sessionStart(), new Effort(Long.MAX_VALUE), fitted -> {});
  }

  /** What was recorded. */
  public Arena arena() {
    return arena(List.of());
  }

  /** What was recorded, with the commands of some robots. */
  public Arena arena(List<RobotId> robots) {
    List<KickRecord> kicks = fitter.kicks();
    List<ObservedCamera> cameras = problem.observers();
    return new Arena(
        -4.5,
        4.5,
        -3,
        3,
        kicks.stream().mapToDouble(k -> k.kick().time() - problem.sessionStart()).toArray(),
        has(kicks, KickKind.FLAT),
        has(kicks, KickKind.CHIP),
        cameras,
        robots);
  }
}
