package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * How good the fit of one kick is: error over the Cramér–Rao bound, bias, coverage of the reported errors, wrong minima, time.
 *
 * <p>The bound is the inverse of the Fisher information of the observations that are no outliers, at the truth, with the true
 * noise; no unbiased estimator can be better.
 */
public final class FitBenchmark {
  private static final double[] NOISE = {0.0007, 0.0014, 0.003};

  private FitBenchmark() {}

  /**
   * Prints the tables.
   *
   * @param args number of kicks per kind and condition (default 300), seed (default 1)
   */
  public static void main(String[] args) {
    int kicks = args.length > 0 ? Integer.parseInt(args[0]) : 300;
    long seed = args.length > 1 ? Long.parseLong(args[1]) : 1;
    System.out.printf(Locale.ROOT, "fit of single kicks, %d per row, seed %d%n", kicks, seed);
    for (KickKind kind : KickKind.values()) {
      for (double noise : NOISE) {
        row(kind, new IdealKicks.Conditions(noise, 0, 0), kicks, seed);
        row(kind, new IdealKicks.Conditions(noise, 0.05, 0), kicks, seed);
        row(kind, new IdealKicks.Conditions(noise, 0, 0.3), kicks, seed);
      }
    }
  }

  private static void row(KickKind kind, IdealKicks.Conditions conditions, int kicks, long seed) {
    IdealKicks source = new IdealKicks(conditions.noise());
    SplittableRandom random = new SplittableRandom(seed);
    Tally tally = new Tally(IdealKicks.sizeOf(kind));
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    List<Double> millis = new ArrayList<>();
    List<Double> sizes = new ArrayList<>();
    for (int k = 0; k < kicks; k++) {
      IdealKicks.Sample sample = source.draw(kind, k + 1, conditions, random.split());
      SplittableRandom published = random.split();
      FitProblem problem = problem(sample, source.views(), published);
      long before = System.nanoTime();
      KickFit fit = fitter.fit(problem, kind);
      millis.add((System.nanoTime() - before) * 1e-6);
      sizes.add((double) sample.kick().observations().size());
      tally.add(sample, fit, bound(sample, source.views(), problem), conditions);
    }
    System.out.printf(
        Locale.ROOT,
        "%n%s, noise %.1f mm, %.0f %% outliers, %.0f %% lost: median %.0f observations, %.1f ms"
            + " (p95 %.1f), wrong minima %d of %d, failed %d%n",
        kind.id(),
        1000 * conditions.noise(),
        100 * conditions.outliers(),
        100 * conditions.lost(),
        quantile(sizes, 0.5),
        quantile(millis, 0.5),
        quantile(millis, 0.95),
        tally.wrong,
        kicks,
        tally.failed);
    tally.print();
  }

  private static FitProblem problem(IdealKicks.Sample s, CameraViews views, SplittableRandom r) {
    if (s.kind() == KickKind.FLAT) {
      return FitProblem.of(
          s.kick(), views, IdealKicks.publishedFlat(s.truth(), r), ChipModel.typical());
    }
    return FitProblem.of(
            s.kick(), views, FlatModel.typical(), IdealKicks.publishedChip(s.truth(), r))
        .withChipRollFixed(s.truth()[9]);
  }

  /** Standard deviations that no unbiased estimator can beat; NaN for what is fixed or has no information. */
  private static double[] bound(IdealKicks.Sample s, CameraViews views, FitProblem problem) {
    FlightData data = FlightData.of(s.kick().observations(), views);
    FlightCurve curve =
        s.kind() == KickKind.FLAT ? new FlightCurve.Flat() : new FlightCurve.Chip(s.flights());
    int size = s.truth().length;
    FlightProblem flight = new FlightProblem(data, curve, size);
    for (int i = 0; i < data.size; i++) {
      flight.used()[i] = !s.outlier()[i];
    }
    NormalEquations equations = new NormalEquations(size);
    flight.linearize(s.truth(), equations);
    List<Parameter> model = s.kind() == KickKind.FLAT ? problem.flat() : problem.chip();
    List<Parameter> all = FlightLayout.parameters(s.kind(), s.truth(), model);
    boolean[] free = new boolean[size];
    for (int k = 0; k < size; k++) {
      free[k] = all.get(k).estimated() && equations.a[k][k] > 0;
    }
    double[][] inverse =
        equations.inverse(all.stream().mapToDouble(Parameter::scale).toArray(), free);
    double[] bound = new double[size];
    for (int k = 0; k < size; k++) {
      bound[k] = free[k] && inverse != null ? Math.sqrt(inverse[k][k]) : Double.NaN;
    }
    return bound;
  }

  private static double quantile(List<Double> values, double q) {
    double[] sorted = values.stream().mapToDouble(v -> v).sorted().toArray();
    return sorted[(int) Math.min(sorted.length - 1, q * sorted.length)];
  }

  /** Errors in units of the bound and of the reported error, per parameter. */
  private static final class Tally {
    final List<List<Double>> errors = new ArrayList<>();
    final List<List<Double>> pulls = new ArrayList<>();
    String[] names;
    int wrong;
    int failed;

    Tally(int size) {
      names = new String[size];
      for (int k = 0; k < size; k++) {
        errors.add(new ArrayList<>());
        pulls.add(new ArrayList<>());
      }
    }

    void add(IdealKicks.Sample s, KickFit fit, double[] bound, IdealKicks.Conditions conditions) {
      if (fit.failure().isPresent()) {
        failed++;
        return;
      }
      boolean off = fit.statistics().robustScale() > 1.2;
      for (int k = 0; k < bound.length; k++) {
        Estimate e = fit.estimates().get(k);
        names[k] = e.name();
        if (Double.isNaN(bound[k])
            || e.undetermined().isPresent()
            || e.atBound()
            || !e.parameter().estimated()) {
          continue;
        }
        double error = e.value() - s.truth()[k];
        errors.get(k).add(error / bound[k]);
        pulls.get(k).add(error / e.standardError());
        off |= Math.abs(error) > 6 * bound[k];
      }
      wrong += off ? 1 : 0;
      if (off && Boolean.getBoolean("fieldcal.verbose")) {
        System.out.println(
            "truth " + Arrays.toString(s.truth()) + " flights " + s.flights() + "\n" + fit);
      }
    }

    void print() {
      System.out.printf(
          "  %-22s %6s %12s %12s %8s %8s%n", "", "n", "RMSE/bound", "bias/bound", "68 %", "95 %");
      for (int k = 0; k < names.length; k++) {
        double[] e = errors.get(k).stream().mapToDouble(v -> v).toArray();
        if (e.length == 0) {
          continue;
        }
        double mean = Arrays.stream(e).average().orElse(0);
        double rmse = Math.sqrt(Arrays.stream(e).map(v -> v * v).average().orElse(0));
        double in68 =
            pulls.get(k).stream().filter(p -> Math.abs(p) < 1).count() / (double) e.length;
        double in95 =
            pulls.get(k).stream().filter(p -> Math.abs(p) < 1.96).count() / (double) e.length;
        System.out.printf(
            Locale.ROOT,
            "  %-22s %6d %12.3f %12.3f %7.1f%% %7.1f%%%n",
            names[k],
            e.length,
            rmse,
            mean,
            100 * in68,
            100 * in95);
      }
    }
  }
}
