package fieldcal.calibration;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.JointFit;
import fieldcal.fit.JointFitter;
import fieldcal.fit.JointProblem;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.LensCheck;
import fieldcal.fit.OverlapOffsets;
import fieldcal.fit.TypicalBall;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.vision.Epoch;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;

/**
 * Calibrates the ball: camera noise and offsets, each kick, selection, average, joint fit.
 *
 * <p>Order matters. Offsets between cameras come before any kick is judged, since they are far above the noise; flat kicks come
 * before chips, which roll with the accRoll of the flat ones; for chips that bounce differently from the others, the errors allow for bounces that differ from each other; and when the joint fit has refined the offsets, every kick is fitted
 * once more with them. Immutable and thread-safe; kicks are fitted in parallel, with the same result as one by one.
 */
public final class Calibrator {
  /** Offsets that move less than this are settled: a fourteenth of the noise of good cameras, m. */
  private static final double OFFSET_SETTLED = 5e-5;

  /** An accRoll that moves less than this is settled, m/s². */
  private static final double ROLL_SETTLED = 1e-4;

  private static final int MAX_ROUNDS = 4;

  private final FitSettings settings;
  private final KickFitter fitter;
  private final JointFitter joint;

  /**
   * A calibrator; one is enough for all threads.
   *
   * @param settings of the fits, with the seed: the same seed and data give the same calibration
   */
  public Calibrator(FitSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
    fitter = new KickFitter(settings);
    joint = new JointFitter(settings);
  }

  /**
   * Calibrates: fits each kick, estimates the offsets of the cameras, fits again until these settle, selects, averages, and fits all trusted kicks jointly. Kicks are fitted on all processors.
   *
   * @param problem kicks, cameras, start
   * @param progress called for every kick when it is first fitted, from any thread
   * @return the calibration; without kicks one that is empty
   */
  public Calibration calibrate(CalibrationProblem problem, Consumer<Kick> progress) {
    Selection.Decisions decisions = Selection.Decisions.of(problem);
    CameraViews views = measured(problem.kicks(), problem.cameras());
    List<KickFit> fits = fitAll(problem, views, progress);
    List<KickFit> covered = fits;
    OptionalDouble roll = OptionalDouble.empty();
    Optional<JointFit> together = Optional.empty();
    // Chips that roll differently from the flat kicks, and whose residuals are far above those of
    // the others.
    Set<Kick> rollFreely = ConcurrentHashMap.newKeySet();
    for (int round = 0; round < MAX_ROUNDS; round++) {
      if (round > 0) {
        fits = refitAll(problem, views, fits, roll, rollFreely);
      }
      if (round == 1) {
        fits = searchedAgain(problem, views, fits, roll, rollFreely);
      }
      covered = BounceScatter.covered(fits, views, decisions);
      List<KickFit> good = Selection.trusted(covered, decisions);
      OptionalDouble newRoll = rollOfFlats(problem, views, good);
      Optional<JointFitter.Rough> rough =
          jointly(problem, views, good, newRoll).map(joint::fitRoughly);
      CameraViews next = rough.isPresent() ? withOffsets(views, rough.get().offsets()) : views;
      // The second round searches again for what stands out.
      boolean settled = round > 0 && moved(views, next) < OFFSET_SETTLED && near(roll, newRoll);
      roll = newRoll;
      if (settled || round == MAX_ROUNDS - 1) {
        // The cameras of the result are those that its fits were made with.
        together = rough.map(JointFitter.Rough::refined);
        break;
      }
      views = next;
    }
    List<CalibratedKick> selected = Selection.select(covered, decisions);
    return new Calibration(
        selected,
        Selection.averages(selected, KickKind.FLAT),
        Selection.averages(selected, KickKind.CHIP),
        together,
        views,
        settings.seed());
  }

  /**
   * The same fits under other decisions: which kicks and samples are used, and their averages. Takes milliseconds, since nothing is fitted again; the joint
   * fit and the offsets of the cameras remain those of the decisions before until {@link #calibrate} is called again.
   *
   * @param calibration the fits
   * @param epoch of their times
   * @param selection the new decisions
   * @return the calibration with the new selection and averages
   */
  public static Calibration reselect(
      Calibration calibration, Epoch epoch, HandSelection selection) {
    List<KickFit> fits = calibration.kicks().stream().map(CalibratedKick::fit).toList();
    List<CalibratedKick> selected =
        Selection.select(fits, new Selection.Decisions(selection, epoch));
    return new Calibration(
        selected,
        Selection.averages(selected, KickKind.FLAT),
        Selection.averages(selected, KickKind.CHIP),
        calibration.joint(),
        calibration.cameras(),
        calibration.seed());
  }

  /**
   * Fits judged as {@link #calibrate} judges them: which kicks are believed, which samples are averaged. For fits that were made one by one, as the kicks came.
   *
   * @param fits of all kicks so far
   * @param cameras with which they were made
   * @param seed of the fits
   * @return selection and averages, without a joint fit
   */
  public static Calibration judged(List<KickFit> fits, CameraViews cameras, long seed) {
    Selection.Decisions decisions =
        new Selection.Decisions(HandSelection.none(), Epoch.atSecondOf(0L));
    List<CalibratedKick> selected =
        Selection.select(BounceScatter.covered(fits, cameras, decisions), decisions);
    return new Calibration(
        selected,
        Selection.averages(selected, KickKind.FLAT),
        Selection.averages(selected, KickKind.CHIP),
        Optional.empty(),
        cameras,
        seed);
  }

  /**
   * Estimates noise and offsets of the cameras from the kicks before any kick is fitted.
   *
   * @param kicks all there are
   * @param cameras as published
   * @return the views with noise and offsets; without unusable lenses
   */
  public static CameraViews measured(List<Kick> kicks, CameraViews cameras) {
    CameraViews usable = LensCheck.usable(kicks, cameras);
    Map<Integer, Double> atRest = CameraNoise.atRest(kicks, usable);
    Map<Integer, Double> noise = atRest.isEmpty() ? CameraNoise.inMotion(kicks, usable) : atRest;
    // A camera that saw too little at rest is taken to be as good as the others.
    double typical =
        noise.values().stream()
            .sorted()
            .skip(noise.size() / 2)
            .findFirst()
            .orElse(CameraView.DEFAULT_NOISE);
    CameraViews alike = usable.map(v -> v.withNoise(typical));
    CameraViews measured = CameraNoise.measured(kicks, alike);
    return OverlapOffsets.estimate(kicks, measured);
  }

  private List<KickFit> fitAll(
      CalibrationProblem problem, CameraViews views, Consumer<Kick> progress) {
    return OneByOne.map(
        problem.kicks(),
        kick -> {
          FitProblem one = FitProblem.of(kick, views, problem.flat(), problem.chip());
          KickFit fit =
              problem.kind().map(kind -> fitter.fit(one, kind)).orElseGet(() -> fitter.fit(one));
          progress.accept(kick);
          return fit;
        });
  }

  private List<KickFit> refitAll(
      CalibrationProblem problem,
      CameraViews views,
      List<KickFit> before,
      OptionalDouble roll,
      Set<Kick> rollFreely) {
    return OneByOne.map(
        before,
        fit -> {
          if (fit.failure().isPresent()) {
            return fit;
          }
          FitProblem one = FitProblem.of(fit.kick(), views, problem.flat(), problem.chip());
          boolean held = roll.isPresent() && !rollFreely.contains(fit.kick());
          return fitter.refit(held ? one.withChipRollFixed(roll.getAsDouble()) : one, fit);
        });
  }

  /** Fits the kicks that stand out again with a search, starting from what the other kicks determine: their first search may have had the wrong model, or cameras whose offsets were not known. */
  private List<KickFit> searchedAgain(
      CalibrationProblem problem,
      CameraViews views,
      List<KickFit> fits,
      OptionalDouble roll,
      Set<Kick> rollFreely) {
    List<KickFit> fitted = fits.stream().filter(f -> f.failure().isEmpty()).toList();
    FlatModel flat = TypicalBall.flat(fitted);
    ChipModel chip = TypicalBall.chip(fitted);
    return OneByOne.map(
        fits,
        fit -> {
          if (!Selection.standsOut(fit, fitted)) {
            return fit;
          }
          FitProblem typical = FitProblem.of(fit.kick(), views, flat, chip);
          // A chip held at a rolling that is not its own looks like a flat kick, or like
          // nothing.
          KickFit free =
              problem.kind().map(k -> fitter.fit(typical, k)).orElseGet(() -> fitter.fit(typical));
          KickKind kind = free.kind();
          KickFit held =
              roll.isPresent()
                  ? fitter.fit(typical.withChipRollFixed(roll.getAsDouble()), kind)
                  : free;
          boolean freed = Selection.isBetterFree(held, free, fitted);
          if (freed) {
            rollFreely.add(fit.kick());
          }
          KickFit again = freed ? free : held;
          // A kick of the wrong kind may have the smaller rms: one that bends to the rolling misses
          // the hops. The search chose the kind by the first parts of the kick.
          boolean better = kind != fit.kind() || again.rmsMm() < fit.rmsMm();
          return again.failure().isEmpty() && better ? again : fit;
        });
  }

  /** How the flat kicks roll; empty where no chip asks for it. */
  private OptionalDouble rollOfFlats(
      CalibrationProblem problem, CameraViews views, List<KickFit> good) {
    List<KickFit> flats = good.stream().filter(f -> f.kind() == KickKind.FLAT).toList();
    if (flats.size() == good.size()) {
      return OptionalDouble.empty();
    }
    return jointly(problem, views, flats, OptionalDouble.empty()).map(joint::flatModel).stream()
        .flatMap(List::stream)
        .filter(e -> e.name().equals("accRoll") && e.usable())
        .mapToDouble(Estimate::value)
        .findFirst();
  }

  private static Optional<JointProblem> jointly(
      CalibrationProblem problem, CameraViews views, List<KickFit> fits, OptionalDouble chipRoll) {
    return fits.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new JointProblem(fits, views, problem.flat(), problem.chip(), chipRoll, true));
  }

  private static CameraViews withOffsets(CameraViews views, Map<Integer, JointFit.Offset> offsets) {
    return views.map(
        v -> {
          JointFit.Offset o = offsets.get(v.id());
          return o == null ? v : v.withOffset(o.x(), o.y());
        });
  }

  private static double moved(CameraViews from, CameraViews to) {
    double most = 0;
    for (CameraView view : to.all()) {
      CameraView old = from.get(view.id());
      most =
          Math.max(
              most, Math.hypot(view.offsetX() - old.offsetX(), view.offsetY() - old.offsetY()));
    }
    return most;
  }

  private static boolean near(OptionalDouble a, OptionalDouble b) {
    return a.isPresent() == b.isPresent()
        && (a.isEmpty() || Math.abs(a.getAsDouble() - b.getAsDouble()) < ROLL_SETTLED);
  }
}
