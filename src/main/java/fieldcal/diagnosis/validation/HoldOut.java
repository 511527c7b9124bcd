package fieldcal.diagnosis.validation;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.fit.joint.SharedSolver.OwnFit;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * How well a model does on kicks that its global parameters were not fitted to: the kicks are dealt into parts, each part is left out once (cross-validation), and only its kicks' own parameters are then fitted. Also predicts each of them
 * from its first 0.3 s.
 *
 * @param squares sum of squared residuals of each kick, m²
 * @param counts number of residuals of each kick, two for each detection
 * @param ahead predictions, by horizon in s
 */
public record HoldOut(double[] squares, int[] counts, Map<Double, Ahead> ahead) {
  /** Parts of the kicks; with fewer kicks each is left out alone. */
  private static final int PARTS = 6;

  /** Time after the kick up to which a prediction uses detections, s. */
  private static final double SEEN = 0.3;

  private static final double[] HORIZONS = {0.5, 1, 2};

  /** Detections that near to a horizon count for it, s. */
  private static final double HORIZON_TOLERANCE = 0.01;

  /** Largest error of a prediction, m. A predicted ball that leaves the field, or that no camera could see, counts as this far off. */
  private static final double WORST = 10;

  /** Smallest squared error in a geometric mean, m²: the floor of the cameras' noise. */
  private static final double LEAST = CameraNoise.FLOOR * CameraNoise.FLOOR;

  /**
   * A kick that is predicted worse than that many medians counts as that many in {@link #typicalMm}: where errors are normal, two of a thousand kicks are (the distance from the truth in a plane then has Rayleigh's distribution); chosen. One kick that
   * a model predicts metres off, as a chip whose hops it takes for rolling, would otherwise decide the root mean square of thirty.
   */
  private static final double MOST_MEDIANS = 3;

  /** Index of the lower bound in {@link #gainOn}. */
  public static final int LOWER = 2;

  /** A scatter reduced to this share of its value holds the value of each kick at the mean. */
  private static final double NO_SCATTER = 1e-3;

  private static final int BOOTSTRAPS = 1000;
  private static final double LOW = 0.025;

  /** A prediction whose error is larger by less than this share counts as equally good: the spread of a kick's direction makes more. */
  private static final double NO_WORSE = 0.02;

  /**
   * Predictions of some time ahead.
   *
   * @param squares sum of squared distances between predicted and seen position per kick, m²
   * @param counts how many per kick
   */
  public record Ahead(double[] squares, int[] counts) {
    private Ahead(int kicks) {
      this(new double[kicks], new int[kicks]);
    }

    /** Root mean square of kicks that may come more than once, m; NaN when none of them was predicted so far. */
    private double rms(int[] kicks) {
      return HoldOut.rms(squares, counts, kicks);
    }

    /** Geometric mean of the errors of kicks that may come more than once, m; NaN when none of them was predicted so far. */
    private double geometricMean(int[] kicks) {
      double sum = 0;
      int n = 0;
      for (int k : kicks) {
        if (counts[k] > 0) {
          sum += 0.5 * Math.log(Math.max(LEAST, squares[k] / counts[k]));
          n++;
        }
      }
      return Math.exp(sum / n);
    }

    /** Root mean square over the kicks that were predicted so far, each winsorized (Tukey 1962) at {@link #MOST_MEDIANS}, m. */
    private double typical() {
      double[] errors =
          IntStream.range(0, counts.length)
              .filter(k -> counts[k] > 0)
              .mapToDouble(k -> Math.sqrt(squares[k] / counts[k]))
              .sorted()
              .toArray();
      int n = errors.length;
      double median = (errors[(n - 1) / 2] + errors[n / 2]) / 2;
      double most = MOST_MEDIANS * median;
      double sum = 0;
      for (double e : errors) {
        sum += Math.min(e, most) * Math.min(e, most);
      }
      return Math.sqrt(sum / n);
    }
  }

  /** One kick's part. */
  private record One(double squares, int count, Map<Double, List<Double>> prediction) {}

  /**
   * Validates. All kicks count alike, whatever noise they were given.
   *
   * @param model fitted to all kicks
   * @param predicts whether predictions are made, too
   * @param seed of the parts
   * @return how well it does
   */
  public static HoldOut of(FittedModel model, boolean predicts, long seed) {
    return of(model, predicts, model.solution().scatters(), seed);
  }

  /**
   * Validates with the mean of whatever differs from kick to kick by chance. Otherwise a held-out kick would have a value of its own, which would hide what differs between the kicks by a cause.
   *
   * @param model fitted to all kicks
   * @param seed of the parts
   * @return how well it does; without predictions
   */
  public static HoldOut withoutChance(FittedModel model, long seed) {
    double[] scatters = model.solution().scatters();
    List<Component> random = model.model().random();
    for (int r = 0; r < scatters.length; r++) {
      scatters[r] = random.get(r).isChance() ? NO_SCATTER * scatters[r] : scatters[r];
    }
    return of(model, false, scatters, seed);
  }

  private static HoldOut of(FittedModel model, boolean predicts, double[] scatters, long seed) {
    int n = model.kickCount();
    int[] part = parts(model, seed);
    List<boolean[]> without = new ArrayList<>();
    for (int p = 0; p < PARTS; p++) {
      boolean[] of = new boolean[n];
      for (int k = 0; k < n; k++) {
        of[k] = part[k] == p;
      }
      without.add(of);
    }
    List<double[]> rest = model.solution().valuesWithoutEach(without);
    ModelState[] states = new ModelState[PARTS];
    double[][] means = new double[PARTS][];
    for (int p = 0; p < PARTS; p++) {
      double[] values = rest.get(p);
      states[p] = model.model().at(values);
      means[p] =
          model.solution().problem().randoms().stream()
              .mapToDouble(r -> values[r.mean()])
              .toArray();
    }
    List<One> all =
        IntStream.range(0, n)
            .parallel()
            .mapToObj(k -> one(model, k, states[part[k]], means[part[k]], scatters, predicts))
            .toList();
    double[] squares = all.stream().mapToDouble(One::squares).toArray();
    int[] counts = all.stream().mapToInt(One::count).toArray();
    Map<Double, Ahead> ahead = new TreeMap<>();
    for (int k = 0; k < n; k++) {
      int kick = k;
      all.get(k)
          .prediction
          .forEach(
              (h, list) -> {
                Ahead at = ahead.computeIfAbsent(h, x -> new Ahead(n));
                at.squares[kick] = list.stream().mapToDouble(d -> d).sum();
                at.counts[kick] = list.size();
              });
    }
    return new HoldOut(squares, counts, ahead);
  }

  /** Flat kicks and chips are dealt separately, so that each part gets its share of both. */
  private static int[] parts(FittedModel model, long seed) {
    int[] part = new int[model.kickCount()];
    Random random = new Random(seed);
    int dealt = 0;
    for (KickKind kind : KickKind.values()) {
      List<Integer> of = new ArrayList<>();
      for (int k = 0; k < part.length; k++) {
        if (model.kick(k).record().kind() == kind) {
          of.add(k);
        }
      }
      Collections.shuffle(of, random);
      for (int k : of) {
        part[k] = dealt++ % PARTS;
      }
    }
    return part;
  }

  private static One one(
      FittedModel model,
      int k,
      ModelState state,
      double[] means,
      double[] scatters,
      boolean predicts) {
    SharedSolver solver = SharedSolver.withDefaults().withMaxIterations(20);
    EffectKick term = model.kick(k);
    KickRecord record = term.record();
    OwnFit<ModelState> fit = solver.fitOwn(term, model.solution().own(k), state, means, scatters);
    double[] rx = new double[record.size()];
    double[] ry = new double[record.size()];
    boolean[] used = record.used();
    term.plainResiduals(fit.own(), state, rx, ry);
    double squares = 0;
    int count = 0;
    for (int i = 0; i < rx.length; i++) {
      if (used[i]) {
        squares += rx[i] * rx[i] + ry[i] * ry[i];
        count += 2;
      }
    }
    Map<Double, List<Double>> prediction = new TreeMap<>();
    if (predicts) {
      predict(term, fit.own(), state, means, scatters, solver, prediction);
    }
    return new One(squares, count, prediction);
  }

  private static void predict(
      EffectKick term,
      double[] own,
      ModelState state,
      double[] means,
      double[] scatters,
      SharedSolver solver,
      Map<Double, List<Double>> prediction) {
    KickRecord record = term.record();
    double from = own[record.timeIndex()] + SEEN;
    boolean[] first = record.used();
    boolean[] used = record.used();
    for (int i = 0; i < first.length; i++) {
      first[i] &= record.time(i) <= from;
    }
    EffectKick begin = term.with(record.withUsed(first));
    double[] seen = solver.fitOwn(begin, own, state, means, scatters).own();
    EffectKick whole =
        record.kind() == KickKind.CHIP
            ? term.withFlights(Math.max(1, term.flightsByRule(seen, state)))
            : term;
    double[] rx = new double[record.size()];
    double[] ry = new double[record.size()];
    whole.plainResiduals(seen, state, rx, ry);
    for (double horizon : HORIZONS) {
      for (int i = 0; i < rx.length; i++) {
        if (used[i] && Math.abs(record.time(i) - from - horizon) < HORIZON_TOLERANCE) {
          double squared = rx[i] * rx[i] + ry[i] * ry[i];
          prediction
              .computeIfAbsent(horizon, h -> new ArrayList<>())
              .add(squared <= WORST * WORST ? squared : WORST * WORST);
        }
      }
    }
  }

  /**
   * The same, with the residuals of each kick divided by how many times the cameras' noise it was given: a model that was fitted with this noise need not explain more.
   *
   * @param model of these kicks
   * @return this where none was given more
   */
  public HoldOut heardBy(FittedModel model) {
    double[] weighed = new double[squares.length];
    for (int k = 0; k < weighed.length; k++) {
      double times = model.kick(k).record().timesNoise();
      weighed[k] = squares[k] / (times * times);
    }
    return Arrays.equals(weighed, squares) ? this : new HoldOut(weighed, counts, ahead);
  }

  /**
   * Residual of all kicks.
   *
   * @return root mean square per axis, mm; NaN without kicks
   */
  public double rmsMm() {
    double n = Arrays.stream(counts).sum();
    return n > 0 ? 1000 * Math.sqrt(Arrays.stream(squares).sum() / n) : Double.NaN;
  }

  /** Root mean square of kicks that may come more than once, m; NaN when none of them has any. */
  private static double rms(double[] squares, int[] counts, int[] kicks) {
    double sum = 0;
    double n = 0;
    for (int k : kicks) {
      sum += squares[k];
      n += counts[k];
    }
    return Math.sqrt(sum / n);
  }

  private double rms(int[] kicks) {
    return rms(squares, counts, kicks);
  }

  /**
   * Residual of one kick.
   *
   * @param kick index
   * @return root mean square per axis, mm; NaN without detections
   */
  public double rmsMm(int kick) {
    return counts[kick] > 0 ? 1000 * Math.sqrt(squares[kick] / counts[kick]) : Double.NaN;
  }

  /**
   * Distance between predicted and seen position.
   *
   * @return root mean square, mm, by horizon in s
   */
  public Map<Double, Double> predictionMm() {
    Map<Double, Double> rms = new TreeMap<>();
    int[] all = IntStream.range(0, squares.length).toArray();
    ahead.forEach((h, at) -> rms.put(h, 1000 * at.rms(all)));
    return rms;
  }

  /**
   * Distance between predicted and seen position of a usual kick, which no single kick decides.
   *
   * @return root mean square over the kicks, where one that is more than three times as wrong as the median kick counts as three times, mm, by horizon in s
   */
  public Map<Double, Double> typicalMm() {
    Map<Double, Double> typical = new TreeMap<>();
    ahead.forEach((h, at) -> typical.put(h, 1000 * at.typical()));
    return typical;
  }

  /**
   * Whether this predicts worse than another model of the same kicks, at any horizon, by more than the choice of the kicks can do (bootstrap, Efron 1979). The root mean square decides, to which the worst kicks contribute most.
   *
   * @param other the other model's, of the same kicks
   * @param seed of the bootstrap
   * @return true when it does
   */
  public boolean predictsWorseThan(HoldOut other, long seed) {
    return isLoss(other, Ahead::rms, seed);
  }

  /**
   * The same, but each kick counts alike: what decides is the mean factor between the errors of the same kick.
   *
   * @param other the other model's, of the same kicks
   * @param seed of the bootstrap
   * @return true when this predicts a usual kick worse
   */
  public boolean predictsMostWorseThan(HoldOut other, long seed) {
    return isLoss(other, Ahead::geometricMean, seed);
  }

  /**
   * The factor by which the prediction errors of this are larger than those of another model of the same kicks.
   *
   * @param other the other model's, of the same kicks
   * @return geometric mean over kicks and horizons, below 1 where this is better; 1 when nothing was predicted
   */
  public double errorFactor(HoldOut other) {
    int[] all = IntStream.range(0, squares.length).toArray();
    double mean =
        ahead.entrySet().stream()
            .filter(e -> other.ahead.containsKey(e.getKey()))
            .mapToDouble(
                e ->
                    Math.log(e.getValue().geometricMean(all))
                        - Math.log(other.ahead.get(e.getKey()).geometricMean(all)))
            .filter(Double::isFinite)
            .average()
            .orElse(0);
    return Math.exp(mean);
  }

  private boolean isLoss(HoldOut other, ToDoubleBiFunction<Ahead, int[]> measure, long seed) {
    Random random = new Random(seed);
    for (Map.Entry<Double, Ahead> entry : ahead.entrySet()) {
      Ahead now = entry.getValue();
      Ahead before = other.ahead.get(entry.getKey());
      if (before == null) {
        continue;
      }
      double[] losses =
          drawn(
              random,
              kicks ->
                  measure.applyAsDouble(now, kicks)
                      - tolerated(measure.applyAsDouble(before, kicks)));
      if (losses[(int) (LOW * BOOTSTRAPS)] > 0) {
        return true;
      }
    }
    return false;
  }

  /** Up to which error a prediction is not worse than one with the given error, m. No closed form is more accurate than the floor of the cameras' noise. */
  private static double tolerated(double error) {
    return Math.max((1 + NO_WORSE) * error, error + CameraNoise.FLOOR);
  }

  /** The values of a measure in bootstrap samples of the kicks, ascending; 0 where it is NaN. */
  private double[] drawn(Random random, ToDoubleFunction<int[]> measure) {
    int[] kicks = new int[squares.length];
    double[] values = new double[BOOTSTRAPS];
    for (int b = 0; b < BOOTSTRAPS; b++) {
      for (int i = 0; i < kicks.length; i++) {
        kicks[i] = random.nextInt(kicks.length);
      }
      double value = measure.applyAsDouble(kicks);
      values[b] = Double.isNaN(value) ? 0 : value;
    }
    Arrays.sort(values);
    return values;
  }

  /**
   * Residual of a usual kick: each counts alike, and none decides alone.
   *
   * @return geometric mean over the kicks of their root mean squares per axis, mm; NaN without kicks
   */
  public double usualMm() {
    return 1000
        * Math.exp(
            IntStream.range(0, squares.length)
                .mapToDouble(this::level)
                .average()
                .orElse(Double.NaN));
  }

  /** Logarithm of a kick's residual, m. */
  private double level(int kick) {
    return 0.5 * Math.log(Math.max(LEAST, squares[kick] / Math.max(1, counts[kick])));
  }

  /**
   * Whether this follows a usual kick more closely than another model of the same kicks, by more than the choice of the kicks can do.
   *
   * @param other the other model's
   * @param seed of the bootstrap
   * @return true when it does
   */
  public boolean followsMostBetterThan(HoldOut other, long seed) {
    double[] gains =
        drawn(
            new Random(seed),
            kicks -> Arrays.stream(kicks).mapToDouble(k -> other.level(k) - level(k)).sum());
    return gains[(int) (LOW * BOOTSTRAPS)] > 0;
  }

  /**
   * What this gains on another model of the same kicks, with bounds from drawing the kicks again (bootstrap, Efron 1979).
   *
   * @param without the other model's
   * @param seed of the bootstrap
   * @return gain of the residual: mm, per cent, 2.5 % and 97.5 % quantile in mm
   */
  public double[] gainOn(HoldOut without, long seed) {
    double before = without.rmsMm();
    double after = rmsMm();
    double[] gains = drawn(new Random(seed), kicks -> 1000 * (without.rms(kicks) - rms(kicks)));
    return new double[] {
      before - after,
      100 * (before - after) / before,
      gains[(int) (LOW * BOOTSTRAPS)],
      gains[(int) ((1 - LOW) * BOOTSTRAPS)]
    };
  }
}
