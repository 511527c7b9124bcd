package fieldcal.fit;

import fieldcal.ball.Parameter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.BiFunction;
import java.util.function.Supplier;

/**
 * Fits the two-phase flat or the bouncing chip trajectory to the detections of one kick.
 *
 * <p>CMA-ES finds the neighbourhood of the global minimum on a subset of the observations under a robust loss, and Levenberg–Marquardt the minimum on all of them;
 * then outliers are left out, and plain least squares, which is efficient, gives the result. A kick that a descent explains, and that determines all parameters, needs no such search. The number of flights of a chip is
 * discrete: each plausible one is fitted, and the residuals decide. Immutable and thread-safe.
 *
 * <p>A fit that throws costs that kick alone: any {@link RuntimeException}, a {@link StackOverflowError} or an {@link AssertionError} becomes a failed fit with that reason. All other errors, such as an {@link
 * OutOfMemoryError}, are the machine's and pass on to the caller.
 */
public final class KickFitter {
  /** A kick with fewer detections after it determines nothing. */
  private static final int FEWEST = 12;

  /** Least vertical speed of a chip, m/s: a slower ball rises less than 13 mm. */
  private static final double LOWEST_CHIP = 0.5;

  /** Tangent of the flattest chip: chip kickers lift the ball by 30 to 60 degrees; this is 17. */
  private static final double FLATTEST_CHIP = 0.3;

  /** Carpets give a ball 0.38 to 0.57 of its vertical speed back (ten matches of 2026, simulators); no carpet returns this much. */
  private static final double MOST_ELASTIC = 0.8;

  /** Length of the first part of a kick that is looked at, s: a ball kicked at 6.5 m/s and 60° flies 1.15 s until it first lands. */
  private static final double FIRST = 1.2;

  /** The shortest first part that is looked at, s: a ball that rises at {@link #LOWEST_CHIP} has been 13 mm high and lands after 0.1 s; one of 30° and 3 m/s, the slowest that chip kickers make, lands after 0.3 s. */
  private static final double SHORTEST = 0.3;

  /** A chip has two more parameters, so it must reduce the loss to less than this part of the flat kick's. */
  private static final double CLEARLY = 0.8;

  /** A chip that reduces the sum of squares below this part of the flat kick's is certain: an order of magnitude, since a flat kick that departs from its model looks like a flight to some extent. */
  private static final double SURELY = 0.1;

  private final FitSettings settings;

  /**
   * A fitter; one is enough for all threads.
   *
   * @param settings seed, effort and outlier limits
   * @throws NullPointerException when there are none
   */
  public KickFitter(FitSettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
  }

  /**
   * Fits a flat kick and, where that explains neither all detections nor those of the first 1.2 s, a chip, and decides between the two. Takes some 10 to 100 ms. Never throws on what a recording holds.
   *
   * @param problem kick, cameras and models
   * @return the better fit; when both fail, the flat one with its {@link KickFit#failure}. When no camera that saw the kick has a known geometry, no chip can be fitted, and a kick that the flat model does not explain fails
   */
  public KickFit fit(FitProblem problem) {
    KickFit flat = fit(problem, KickKind.FLAT);
    if (flat.failure().isEmpty() && flat.statistics().explained()) {
      return flat;
    }
    if (!seesHeights(problem)) {
      String reason =
          "is not a simple flat kick, and without the cameras' geometry no chip can be fitted";
      return KickFit.failed(problem.kick(), KickKind.FLAT, reason, flat.statistics().seed());
    }
    if (flat.failure().isEmpty() && slidesAtFirst(problem)) {
      return flat;
    }
    KickFit chip = fit(problem, KickKind.CHIP);
    if (chip.failure().isPresent()) {
      return flat;
    }
    return flat.failure().isPresent() || isChip(problem, chip, flat) ? chip : flat;
  }

  /** Whether the flat model explains the first part, in which a chip would have flown; most kicks that it does not explain depart from it later. A descent shows that or nothing does: no search is needed to find what is plain. */
  private boolean slidesAtFirst(FitProblem problem) {
    FitProblem part = first(problem, FIRST);
    return explains(fit(part, KickKind.FLAT, FlightFitter::descend));
  }

  private static FitProblem first(FitProblem problem, double seconds) {
    Kick kick = problem.kick();
    double end = kick.time() + seconds;
    return problem.with(
        kick.withObservations(kick.observations().between(Double.NEGATIVE_INFINITY, end)));
  }

  /**
   * Whether the kick was a chip rather than a flat kick. When neither model explains the kick, something else is wrong as well. Most of it then shows where the ball rolls, which takes long and does not show whether the ball flew; a fit that follows the rolling may even miss the hops, and a ball that spins turns where it lands. So shorter and shorter first parts are compared until one of the two explains what was seen, or the flat kick leaves far more than the chip.
   */
  private boolean isChip(FitProblem problem, KickFit chip, KickFit flat) {
    boolean is = flies(chip) && isClearlyBetter(data(problem), chip, flat);
    if (explains(chip)) {
      return is;
    }
    for (double seconds = FIRST; seconds >= SHORTEST; seconds /= 2) {
      FitProblem part = first(problem, seconds);
      KickFit hopping = fit(part, KickKind.CHIP);
      KickFit sliding = fit(part, KickKind.FLAT);
      if (sliding.failure().isPresent()) {
        break;
      }
      boolean flies = flies(hopping);
      FlightData data = data(part);
      if (flies && squares(hopping, data) < SURELY * squares(sliding, data)) {
        return true;
      }
      is = flies && isClearlyBetter(data, hopping, sliding);
      if (explains(sliding) || flies && explains(hopping)) {
        return is;
      }
    }
    return is;
  }

  private static boolean explains(KickFit fit) {
    return fit.failure().isEmpty() && fit.statistics().explained();
  }

  private static FlightData data(FitProblem problem) {
    return FlightData.of(problem.kick().observations(), problem.cameras());
  }

  private boolean isClearlyBetter(FlightData data, KickFit chip, KickFit flat) {
    return loss(chip, data) < CLEARLY * loss(flat, data);
  }

  /** Sum of squares, outliers included. */
  private static double squares(KickFit fit, FlightData data) {
    double sum = 0;
    for (int i = 0; i < data.size; i++) {
      sum += data.squared(i, fit.residualX(i), fit.residualY(i));
    }
    return sum;
  }

  /** Cauchy's loss, outliers included. */
  private double loss(KickFit fit, FlightData data) {
    CauchyLoss loss = new CauchyLoss();
    loss.reset(settings.lossScale());
    for (int i = 0; i < data.size; i++) {
      loss.add(data.squared(i, fit.residualX(i), fit.residualY(i)));
    }
    return loss.sum();
  }

  /** The height of a ball shows only in where cameras at known places project it to. */
  private static boolean seesHeights(FitProblem problem) {
    return Arrays.stream(problem.kick().observations().cameras())
        .anyMatch(id -> problem.cameras().get(id).camera().isPresent());
  }

  /**
   * Whether a chip that explains a kick is one that a robot can have made. A flat kick that the flat model does not explain, for
   * spin or drag or a slope, is often explained a little better by low hops that hardly lose height, for there are more of them to
   * fit with. What is lost at bounces counts only where the ball bounced.
   *
   * @param chip a fit of the chip model
   * @return false also when the fit failed
   */
  public static boolean flies(KickFit chip) {
    if (chip.failure().isPresent()) {
      return false;
    }
    double vz = chip.estimate("vz").value();
    double ground = Math.hypot(chip.estimate("vx").value(), chip.estimate("vy").value());
    Estimate damping = chip.estimate("dampingZ");
    boolean elastic =
        damping.undetermined().isEmpty() && (damping.atBound() || damping.value() > MOST_ELASTIC);
    return vz > LOWEST_CHIP && vz > FLATTEST_CHIP * ground && !elastic;
  }

  /**
   * Fits one model, whatever the other would explain. Never throws on what a recording holds.
   *
   * @param problem kick, cameras and models
   * @param kind which model
   * @return the fit; one that failed says why in {@link KickFit#failure}. The same seed and data give the same fit
   */
  public KickFit fit(FitProblem problem, KickKind kind) {
    return fit(problem, kind, FlightFitter::fit);
  }

  private KickFit fit(
      FitProblem problem, KickKind kind, BiFunction<FlightFitter, List<double[]>, KickFit> how) {
    long seed = settings.seed() + 7919L * problem.kick().id();
    return guarded(problem, kind, seed, () -> started(problem, kind, seed, how));
  }

  /** Whatever a recording holds, only this kick is lost. An error of the machine, such as no memory, is not the kick's. */
  static KickFit guarded(FitProblem problem, KickKind kind, long seed, Supplier<KickFit> fit) {
    try {
      return fit.get();
    } catch (RuntimeException | StackOverflowError | AssertionError e) {
      return KickFit.failed(problem.kick(), kind, "the fit broke off: " + e, seed);
    }
  }

  private KickFit started(
      FitProblem problem,
      KickKind kind,
      long seed,
      BiFunction<FlightFitter, List<double[]>, KickFit> how) {
    Kick kick = problem.kick();
    FlightData data = FlightData.of(kick.observations(), problem.cameras());
    int after = 0;
    for (int i = 0; i < data.size; i++) {
      after += data.time[i] > kick.time() ? 1 : 0;
    }
    if (after < FEWEST) {
      return KickFit.failed(
          kick,
          kind,
          "only " + after + " detections after the kick, at least " + FEWEST + " are needed",
          seed);
    }
    List<double[]> starts =
        kind == KickKind.FLAT
            ? List.of(flatStart(kick, data))
            : ChipStart.firstFlights(data, kick.time(), settings.lossScale());
    if (starts.isEmpty()) {
      return KickFit.failed(
          kick, kind, "the detections after the kick do not look like a flight", seed);
    }
    List<Parameter> model = kind == KickKind.FLAT ? problem.flat() : problem.chip();
    List<Parameter> parameters = FlightLayout.parameters(kind, starts.get(0), model);
    FlightFitter fitter = new FlightFitter(problem, kind, data, parameters, settings, seed);
    return how.apply(fitter, starts);
  }

  /**
   * Fits again from where another fit of the same kick ended, without a search: for cameras whose offsets changed a little.
   *
   * @param problem the same kick
   * @param before its fit, not a failed one
   * @return the fit, of the same kind
   */
  public KickFit refit(FitProblem problem, KickFit before) {
    return guarded(
        problem, before.kind(), before.statistics().seed(), () -> refitted(problem, before));
  }

  private KickFit refitted(FitProblem problem, KickFit before) {
    KickKind kind = before.kind();
    FlightData data = FlightData.of(problem.kick().observations(), problem.cameras());
    List<Parameter> model = kind == KickKind.FLAT ? problem.flat() : problem.chip();
    List<Parameter> parameters = FlightLayout.parameters(kind, before.values(), model);
    return new FlightFitter(problem, kind, data, parameters, settings, before.statistics().seed())
        .refit(before);
  }

  /** The kick as it was found, with the resting position taken from the detections before it, each camera's offset taken out. */
  private static double[] flatStart(Kick kick, FlightData data) {
    List<double[]> rest = new ArrayList<>();
    for (int i = 0; i < data.size && data.time[i] < kick.time() - 0.01; i++) {
      rest.add(new double[] {data.x[i], data.y[i]});
    }
    double x = kick.x();
    double y = kick.y();
    if (kick.fromRest() && rest.size() >= 3) {
      x = rest.stream().mapToDouble(p -> p[0]).sorted().skip(rest.size() / 2).findFirst().orElse(x);
      y = rest.stream().mapToDouble(p -> p[1]).sorted().skip(rest.size() / 2).findFirst().orElse(y);
    }
    return new double[] {x, y, kick.vx(), kick.vy(), kick.time()};
  }
}
