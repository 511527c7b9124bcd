package fieldcal.diagnosis;

import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * How well a hypothesis does on kicks that its shared unknowns were not fitted to: the kicks are dealt into parts, each part is left out once (cross-validation), and only position,
 * velocity and time of its kicks are then fitted. Also predicts each of them from its first 0.3 s.
 *
 * @param squares sum of squared residuals per kick, m²
 * @param counts residuals per kick
 * @param prediction squared distances between predicted and seen positions, m², by horizon
 */
record HoldOut(double[] squares, int[] counts, Map<Double, List<Double>> prediction) {
  /** Parts of the kicks; with fewer kicks each is left out alone. */
  private static final int PARTS = 6;

  /** What the prediction may see of a kick, s. */
  static final double SEEN = 0.3;

  private static final double[] HORIZONS = {0.5, 1, 2};

  /** Detections that near to a horizon count for it, s. */
  private static final double NEAR = 0.01;

  /** Largest error of a prediction, m. */
  private static final double WORST = 10;

  /** Share of a gain that kicks other than the best one must have, unless they gain that much of their own residual by themselves: one long kick may have most to gain by what is right for all. */
  private static final double OF_OTHERS = 0.15;

  private static final double BY_THEMSELVES = 0.03;

  private static final int BOOTSTRAPS = 2000;

  static HoldOut of(HypothesisFitter fitter, FittedHypothesis full, long seed) {
    int n = fitter.kicks.size();
    double[] squares = new double[n];
    int[] counts = new int[n];
    Map<Double, List<Double>> prediction = new TreeMap<>();
    for (List<Integer> part : parts(fitter.kicks, seed)) {
      List<Integer> rest = IntStream.range(0, n).filter(k -> !part.contains(k)).boxed().toList();
      if (rest.isEmpty() || part.isEmpty()) {
        continue;
      }
      HypothesisFitter training = fitter.of(rest.stream().map(fitter.kicks::get).toList());
      FittedHypothesis trained =
          training.fit(full.hypothesis(), full.shared(), pick(full, rest), false);
      SharedState state = SharedState.of(full.hypothesis(), trained.shared(), fitter.observers);
      List<Map<Double, List<Double>>> distances =
          part.parallelStream()
              .map(
                  k -> {
                    KickModel model = model(fitter, full, k);
                    new OwnFit(model, state, trained.scatter()).minimize();
                    score(model, state, k, squares, counts);
                    return predict(fitter, full, k, state, trained.scatter());
                  })
              .toList();
      distances.forEach(
          d ->
              d.forEach(
                  (h, list) -> prediction.computeIfAbsent(h, x -> new ArrayList<>()).addAll(list)));
    }
    return new HoldOut(squares, counts, prediction);
  }

  private static List<List<Integer>> parts(List<KickData> kicks, long seed) {
    List<Integer> order = new ArrayList<>();
    for (KickKind kind : KickKind.values()) {
      List<Integer> of =
          new ArrayList<>(
              IntStream.range(0, kicks.size())
                  .filter(k -> kicks.get(k).kind == kind)
                  .boxed()
                  .toList());
      Collections.shuffle(of, new Random(seed));
      order.addAll(of);
    }
    int count = Math.min(PARTS, kicks.size());
    List<List<Integer>> parts = new ArrayList<>();
    for (int p = 0; p < count; p++) {
      parts.add(new ArrayList<>());
    }
    for (int i = 0; i < order.size(); i++) {
      parts.get(i % count).add(order.get(i));
    }
    return parts;
  }

  private static FittedHypothesis pick(FittedHypothesis f, List<Integer> kicks) {
    return new FittedHypothesis(
        f.hypothesis(),
        f.shared(),
        kicks.stream().map(f.own()::get).toList(),
        kicks.stream().mapToInt(k -> f.flights()[k]).toArray(),
        f.scatter(),
        f.chiSquare(),
        f.cost(),
        f.residuals(),
        f.logEvidence(),
        f.covariance(),
        f.converged());
  }

  private static KickModel model(HypothesisFitter fitter, FittedHypothesis full, int k) {
    KickModel model =
        new KickModel(fitter.kicks.get(k), full.hypothesis().random().size(), fitter.sessionStart);
    model.startFrom(full.own().get(k), full.flights()[k], new double[0]);
    return model;
  }

  private static void score(
      KickModel model, SharedState state, int k, double[] squares, int[] counts) {
    double[] rx = new double[model.data.size];
    double[] ry = new double[model.data.size];
    model.plainResiduals(state, rx, ry);
    for (int i = 0; i < rx.length; i++) {
      if (model.data.used[i]) {
        squares[k] += rx[i] * rx[i] + ry[i] * ry[i];
        counts[k] += 2;
      }
    }
  }

  private static Map<Double, List<Double>> predict(
      HypothesisFitter fitter, FittedHypothesis full, int k, SharedState state, double[] scatter) {
    KickModel model = model(fitter, full, k);
    KickData data = model.data;
    double from = model.own[data.timeIndex()] + SEEN;
    model.until(from);
    new OwnFit(model, state, scatter).minimize();
    if (data.kind == KickKind.CHIP) {
      model.flights = Math.max(1, model.flightsByRule(state, model.own));
    }
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    model.plainResiduals(state, rx, ry);
    Map<Double, List<Double>> distances = new TreeMap<>();
    for (double horizon : HORIZONS) {
      for (int i = 0; i < data.size; i++) {
        if (data.used[i] && Math.abs(data.time[i] - from - horizon) < NEAR) {
          distances
              .computeIfAbsent(horizon, h -> new ArrayList<>())
              .add(atMost(rx[i] * rx[i] + ry[i] * ry[i]));
        }
      }
    }
    return distances;
  }

  /** A prediction that leaves the field, or that no camera could see, is as wrong as can be. */
  private static double atMost(double squared) {
    return squared <= WORST * WORST ? squared : WORST * WORST;
  }

  /** Residual per axis over all kicks, mm; NaN when none was held out. */
  double rmsMm() {
    double sum = 0;
    double n = 0;
    for (int k = 0; k < squares.length; k++) {
      sum += squares[k];
      n += counts[k];
    }
    return n > 0 ? 1000 * Math.sqrt(sum / n) : Double.NaN;
  }

  /** Residual per axis of one kick, mm. */
  double rmsMm(int kick) {
    return counts[kick] > 0 ? 1000 * Math.sqrt(squares[kick] / counts[kick]) : Double.NaN;
  }

  /** Distance between predicted and seen position, root mean square, mm, by horizon. */
  Map<Double, Double> predictionMm() {
    Map<Double, Double> rms = new TreeMap<>();
    prediction.forEach(
        (h, list) ->
            rms.put(
                h,
                1000 * Math.sqrt(list.stream().mapToDouble(d -> d).average().orElse(Double.NaN))));
    return rms;
  }

  /** Whether a gain is that of one kick alone: without the kick that gains most, next to nothing of it is left. */
  boolean gainsByOneKick(HoldOut without) {
    int best = 0;
    double sum = 0;
    double before = 0;
    for (int k = 0; k < squares.length; k++) {
      sum += gained(without, k);
      before += without.squares[k];
      best = gained(without, k) > gained(without, best) ? k : best;
    }
    double ofOthers = sum - gained(without, best);
    double left = Math.max(0, 1 - ofOthers / (before - without.squares[best]));
    return ofOthers < OF_OTHERS * sum && Math.sqrt(left) > 1 - BY_THEMSELVES;
  }

  private double gained(HoldOut without, int kick) {
    return without.squares[kick] - squares[kick];
  }

  /** What this gains on another hypothesis, with bounds from drawing the kicks anew (bootstrap, Efron 1979). */
  Gain gainOn(HoldOut without, long seed) {
    double before = without.rmsMm();
    double after = rmsMm();
    Random random = new Random(seed);
    double[] gains = new double[BOOTSTRAPS];
    for (int b = 0; b < BOOTSTRAPS; b++) {
      double s0 = 0;
      double s1 = 0;
      double n = 0;
      for (int i = 0; i < squares.length; i++) {
        int k = random.nextInt(squares.length);
        s0 += without.squares[k];
        s1 += squares[k];
        n += counts[k];
      }
      gains[b] = n > 0 ? 1000 * (Math.sqrt(s0 / n) - Math.sqrt(s1 / n)) : 0;
    }
    java.util.Arrays.sort(gains);
    return new Gain(
        before - after,
        100 * (before - after) / before,
        gains[(int) (0.025 * BOOTSTRAPS)],
        gains[(int) (0.975 * BOOTSTRAPS)]);
  }
}
