package fieldcal.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.effect.Arena;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Variable;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularMatrixException;

/**
 * Errors of a camera that come again in time: one that swings on its mount, or stamps with a clock that is set right again and again. Their periods are where the residuals' periodogram is highest (Lomb 1976; Scargle 1982: with sines that are fitted to unevenly
 * spaced times by least squares); a search then decides about them as about any other term.
 */
final class PeriodicTerms {
  /** Longest time over which residuals are averaged, s. */
  private static final double BLOCK = 0.05;

  /** Shortest period, s: four blocks, where averaging leaves nine tenths of a sine. */
  private static final double SHORTEST = 4 * BLOCK;

  /** Frequencies for each that a session can tell from the next: the highest of them is at most an eighth from the peak, where a sine explains 95 %. */
  private static final double OVERSAMPLING = 4;

  /** Periods that the session has at least: what comes fewer times is a curve over the session. */
  private static final double FEWEST_PERIODS = 3;

  /** Longest session that is looked at, s. Chosen: the number of frequencies grows with it, to 36,000 here, and no mount or clock is known to keep its phase for half an hour. */
  private static final double LONGEST = 1800;

  /** Chance that the highest peak of noise reaches what is offered; a search asks for more. */
  private static final double CHANCE = 1e-3;

  /** Finer frequencies to each side of the peak: with four harmonics the fourth tells a period four times as well. */
  private static final int FINER = 8;

  /** Harmonics of a swing, and of a clock that jumps back. */
  private static final int SWING = 1;

  private static final int JUMP = 4;

  /** Sums over residuals that are close in time. */
  private static final class Block {
    private final double end;
    private double times;
    private int size;

    /** Residual times response, which is what a least-squares fit of a constant needs beside its weight. */
    private double products;

    /** Squared response. */
    private double weight;

    Block(double start) {
      end = start + BLOCK;
    }

    boolean reaches(double time) {
      return time < end && time >= end - BLOCK;
    }

    void add(double time, double residual, double response) {
      times += time;
      products += residual * response;
      weight += response * response;
      size++;
    }

    /** Mean of its times, s. */
    double time() {
      return times / size;
    }
  }

  /** Whitened residuals of one camera with what they would be for a unit of an error, summed over blocks that are short for any period. */
  private static final class Series {
    private final List<Block> blocks = new ArrayList<>();
    private double squares;
    private int size;

    /** Time, s, later than those before within a kick; residual; response to the error. */
    void add(double time, double residual, double response) {
      Block last = blocks.isEmpty() ? null : blocks.get(blocks.size() - 1);
      if (last == null || !last.reaches(time)) {
        last = new Block(time);
        blocks.add(last);
      }
      last.add(time, residual, response);
      squares += residual * residual;
      size++;
    }

    /** What the best sine of a frequency takes off chi-square, for frequencies from {@code step} on. */
    double[] powers(double step, int count) {
      int n = blocks.size();
      double[] cos = new double[n];
      double[] sin = new double[n];
      double[] turnCos = new double[n];
      double[] turnSin = new double[n];
      double[] product = new double[n];
      double[] weight = new double[n];
      for (int i = 0; i < n; i++) {
        Block block = blocks.get(i);
        double angle = 2 * Math.PI * step * block.time();
        product[i] = block.products;
        weight[i] = block.weight;
        turnCos[i] = Math.cos(angle);
        turnSin[i] = Math.sin(angle);
        cos[i] = 1;
      }
      double[] powers = new double[count];
      for (int f = 0; f < count; f++) {
        double cc = 0;
        double cs = 0;
        double ss = 0;
        double rc = 0;
        double rs = 0;
        for (int i = 0; i < n; i++) {
          double c = cos[i] * turnCos[i] - sin[i] * turnSin[i];
          double s = sin[i] * turnCos[i] + cos[i] * turnSin[i];
          cos[i] = c;
          sin[i] = s;
          cc += weight[i] * c * c;
          cs += weight[i] * c * s;
          ss += weight[i] * s * s;
          rc += product[i] * c;
          rs += product[i] * s;
        }
        double determinant = cc * ss - cs * cs;
        powers[f] =
            determinant > 0 ? (ss * rc * rc - 2 * cs * rc * rs + cc * rs * rs) / determinant : 0;
      }
      return powers;
    }

    /** What the best sum of harmonics of a period takes off chi-square. */
    double power(Harmonics basis) {
      int size = basis.size();
      double[] values = new double[size];
      double[][] information = new double[size][size];
      double[] gradient = new double[size];
      for (Block block : blocks) {
        basis.values(block.time(), 0, values);
        for (int a = 0; a < size; a++) {
          gradient[a] += block.products * values[a];
          for (int b = 0; b < size; b++) {
            information[a][b] += block.weight * values[a] * values[b];
          }
        }
      }
      RealVector g = new ArrayRealVector(gradient, false);
      try {
        RealMatrix matrix = new Array2DRowRealMatrix(information, false);
        return new LUDecomposition(matrix).getSolver().solve(g).dotProduct(g);
      } catch (SingularMatrixException e) {
        return 0;
      }
    }
  }

  private PeriodicTerms() {}

  /** What one camera's residuals would be for a shift along x, along y, and for late stamps. */
  private record Seen(Series x, Series y, Series along) {
    Seen() {
      this(new Series(), new Series(), new Series());
    }
  }

  /**
   * Terms that may describe what a model leaves.
   *
   * @param model fitted to all kicks
   * @param arena what was recorded
   * @param sessionStart begin of the session on the kicks' clock, s
   * @return of each camera a swing and an error of its stamps with the period that shows most; without those that noise may show
   */
  static List<LearnedTerm> of(FittedModel model, Arena arena, double sessionStart) {
    Map<Integer, Seen> seen = new TreeMap<>();
    arena.cameras().forEach(c -> seen.put(c.id(), new Seen()));
    SampledSearch.sample(model.kickCount()).forEach(k -> add(model, k, sessionStart, seen));
    return seen.entrySet().parallelStream().flatMap(e -> terms(e.getKey(), e.getValue())).toList();
  }

  private static Stream<LearnedTerm> terms(int camera, Seen seen) {
    Stream<LearnedFamily> shift =
        basis(SWING, List.of(seen.x, seen.y)).stream()
            .map(b -> LearnedFamily.of(Quantity.SHIFT, Variable.SESSION_TIME, b, camera));
    Stream<LearnedFamily> late =
        basis(JUMP, List.of(seen.along)).stream()
            .map(b -> LearnedFamily.of(Quantity.TIME_ERROR, Variable.SESSION_TIME, b, camera));
    return Stream.concat(shift, late).map(LearnedFamily::absent);
  }

  private static void add(FittedModel model, int k, double sessionStart, Map<Integer, Seen> seen) {
    EffectKick kick = model.kick(k);
    ModelState state = model.solution().state();
    double[] own = model.solution().own(k);
    KickRecord record = kick.record();
    ExtendedTrajectory path = kick.path(own, state);
    boolean[] used = record.used();
    double[] rx = new double[record.size()];
    double[] ry = new double[record.size()];
    kick.plainResiduals(own, state, rx, ry);
    for (int i = 0; i < used.length; i++) {
      Seen of = seen.get(record.camera(i));
      if (!used[i] || of == null) {
        continue;
      }
      double time = record.time(i) - sessionStart;
      double sigma = Math.sqrt(record.variance(i));
      of.x.add(time, rx[i] / sigma, 1 / sigma);
      of.y.add(time, ry[i] / sigma, 1 / sigma);
      if (record.time(i) > path.kickTime()) {
        BallState ball = path.stateAt(record.time(i));
        of.along.add(time, rx[i] / sigma, ball.vx() / sigma);
        of.along.add(time, ry[i] / sigma, ball.vy() / sigma);
      }
    }
  }

  /** Harmonics of the period that shows most; empty when that may be noise. */
  private static Optional<Harmonics> basis(int order, List<Series> series) {
    double first = Double.POSITIVE_INFINITY;
    double last = Double.NEGATIVE_INFINITY;
    double squares = 0;
    int n = 0;
    for (Series s : series) {
      for (Block block : s.blocks) {
        first = Math.min(first, block.time());
        last = Math.max(last, block.time());
      }
      squares += s.squares;
      n += s.size;
    }
    if (!(last > first) || last - first > LONGEST) {
      return Optional.empty();
    }
    double step = 1 / (OVERSAMPLING * (last - first));
    int count = (int) Math.ceil(1 / SHORTEST / step);
    int least = (int) (FEWEST_PERIODS * OVERSAMPLING);
    if (count <= least) {
      return Optional.empty();
    }
    double[] sum = new double[count];
    for (Series s : series) {
      double[] powers = s.powers(step, count);
      for (int f = 0; f < count; f++) {
        sum[f] += powers[f];
      }
    }
    int best = least;
    for (int f = least; f < count; f++) {
      best = sum[f] > sum[best] ? f : best;
    }
    double limit = 2 * series.size() * Math.log(count / CHANCE) * Math.max(1, squares / n);
    if (!(sum[best] > limit)) {
      return Optional.empty();
    }
    double peak = step * (best + 1);
    return IntStream.rangeClosed(-FINER, FINER)
        .mapToObj(i -> new Harmonics(order, 1 / (peak + i * step / FINER)))
        .max(Comparator.comparingDouble(b -> series.stream().mapToDouble(t -> t.power(b)).sum()));
  }
}
