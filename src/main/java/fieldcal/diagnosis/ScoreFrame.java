package fieldcal.diagnosis;

import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.ObservedCamera;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * The linearised neighbourhood of a fitted hypothesis, for score tests (Rao 1948): the derivative of all predictions by an effect's coordinates, orthogonal to what the unknowns of the
 * hypothesis can absorb, against the residuals. One pass over the observations for each coordinate; nothing is refitted.
 */
final class ScoreFrame {
  private static final double STEP = 0.04;

  private final HypothesisFitter fitter;
  private final SharedState state;
  private final KickFrame[] frames;
  private final int[] free;
  private final CholeskyDecomposition shared;
  private final RealVector sharedRight;

  /** One kick: residuals, derivatives by what is already in the model, and its path. */
  private static final class KickFrame {
    KickModel model;
    ExtendedTrajectory path;
    double[] residual;
    double[][] own;
    double[][] shared;
    CholeskyDecomposition factor;
    RealMatrix solvedShared;
  }

  /** Sums over a kick for one effect, its own unknowns eliminated. */
  record Part(RealMatrix information, RealMatrix withShared, double[] score) {}

  ScoreFrame(HypothesisFitter fitter, FittedHypothesis at) {
    this.fitter = fitter;
    Hypothesis hypothesis = at.hypothesis();
    SharedUnknowns unknowns = fitter.unknowns(hypothesis);
    state = SharedState.of(hypothesis, at.shared(), fitter.observers);
    SharedState[] plus = new SharedState[unknowns.size];
    Perturbation.fill(hypothesis, unknowns, state, fitter.observers, plus);
    free = IntStream.range(0, unknowns.size).filter(k -> plus[k] != null).toArray();
    frames = new KickFrame[fitter.kicks.size()];
    RealMatrix[] parts = new RealMatrix[frames.length];
    RealVector[] rights = new RealVector[frames.length];
    IntStream.range(0, frames.length)
        .parallel()
        .forEach(
            k -> {
              KickModel model =
                  new KickModel(
                      fitter.kicks.get(k), hypothesis.random().size(), fitter.sessionStart);
              model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
              frames[k] = frame(model, unknowns, plus, at.scatter());
              parts[k] = reducedShared(frames[k]);
              rights[k] = reducedScore(frames[k], frames[k].shared);
            });
    int q = Math.max(1, free.length);
    RealMatrix sum = new Array2DRowRealMatrix(q, q);
    RealVector right = new ArrayRealVector(q);
    for (int k = 0; k < frames.length; k++) {
      sum = sum.add(parts[k]);
      right = right.add(rights[k]);
    }
    for (int i = 0; i < free.length; i++) {
      double e = unknowns.step[free[i]] / unknowns.expectedError[free[i]];
      sum.addToEntry(i, i, e * e);
    }
    if (free.length == 0) {
      sum.setEntry(0, 0, 1);
    }
    shared = new CholeskyDecomposition(Score.symmetric(sum), 1e-6, 0);
    sharedRight = right;
  }

  private KickFrame frame(
      KickModel model, SharedUnknowns unknowns, SharedState[] plus, double[] scatter) {
    KickFrame f = new KickFrame();
    int n = 2 * model.data.size;
    f.model = model;
    f.path = model.path(state, model.own);
    f.residual = new double[n];
    model.residuals(state, f.path, f.residual);
    f.own = new double[model.ownSize][n];
    model.ownColumns(state, f.residual, f.own);
    RealMatrix oo = new Array2DRowRealMatrix(model.ownSize, model.ownSize);
    for (int i = 0; i < model.ownSize; i++) {
      scale(f.own[i], model.ownStep(i));
      for (int j = 0; j <= i; j++) {
        double value = KickNormal.dot(f.own[i], f.own[j]);
        oo.setEntry(i, j, value);
        oo.setEntry(j, i, value);
      }
    }
    for (int j = model.kickSize; j < model.ownSize; j++) {
      double e = model.ownStep(j) / scatter[j - model.kickSize];
      oo.addToEntry(j, j, e * e);
    }
    if (!model.data.fromRest) {
      int t = model.data.timeIndex();
      double e = model.ownStep(t) / KickData.TIME_PRIOR;
      oo.addToEntry(t, t, e * e);
    }
    for (int i = 0; i < model.ownSize; i++) {
      oo.addToEntry(i, i, 1e-8 + 1e-10 * oo.getEntry(i, i));
    }
    f.factor = new CholeskyDecomposition(oo, 1e-6, 0);
    f.shared = new double[Math.max(1, free.length)][n];
    for (int i = 0; i < free.length; i++) {
      int k = free[i];
      if (Perturbation.concerns(k, model.data.kind)) {
        model.column(state, f.path, f.residual, plus[k], unknowns.step[k], f.shared[i]);
        scale(f.shared[i], unknowns.step[k]);
      }
    }
    f.solvedShared = f.factor.getSolver().solve(products(f.own, f.shared));
    return f;
  }

  private static void scale(double[] column, double by) {
    for (int i = 0; i < column.length; i++) {
      column[i] *= by;
    }
  }

  private static RealMatrix products(double[][] a, double[][] b) {
    RealMatrix m = new Array2DRowRealMatrix(a.length, b.length);
    for (int i = 0; i < a.length; i++) {
      for (int j = 0; j < b.length; j++) {
        m.setEntry(i, j, KickNormal.dot(a[i], b[j]));
      }
    }
    return m;
  }

  private static RealMatrix reducedShared(KickFrame f) {
    RealMatrix os = products(f.own, f.shared);
    return products(f.shared, f.shared).subtract(os.transpose().multiply(f.solvedShared));
  }

  private static RealVector reducedScore(KickFrame f, double[][] columns) {
    double[] score = new double[columns.length];
    double[] own = new double[f.own.length];
    for (int i = 0; i < own.length; i++) {
      own[i] = KickNormal.dot(f.own[i], f.residual);
    }
    RealVector solved = f.factor.getSolver().solve(new ArrayRealVector(own));
    for (int j = 0; j < score.length; j++) {
      score[j] = KickNormal.dot(columns[j], f.residual);
      for (int i = 0; i < own.length; i++) {
        score[j] -= KickNormal.dot(f.own[i], columns[j]) * solved.getEntry(i);
      }
    }
    return new ArrayRealVector(score);
  }

  /** What an effect's columns are to one kick; null when they do not touch it. */
  Part part(int kick, Chart chart) {
    KickFrame f = frames[kick];
    int n = f.residual.length;
    double[][] columns = new double[chart.size()][n];
    double[] at = new double[chart.size()];
    boolean touched = false;
    for (int j = 0; j < columns.length; j++) {
      double h = STEP * chart.scale(j);
      at[j] = h;
      SharedState plus = state.plus(chart.effect(at, 0), fitter.observers);
      at[j] = 0;
      f.model.column(state, f.path, f.residual, plus, h, columns[j]);
      scale(columns[j], chart.scale(j));
      touched |= Arrays.stream(columns[j]).anyMatch(v -> v != 0);
    }
    return touched ? part(f, columns) : null;
  }

  /** The same for several effects of one coordinate each at once, with their products with each other. */
  Part part(int kick, List<Chart> charts) {
    KickFrame f = frames[kick];
    double[][] columns = new double[charts.size()][f.residual.length];
    for (int j = 0; j < columns.length; j++) {
      Chart chart = charts.get(j);
      double h = STEP * chart.scale(0);
      SharedState plus = state.plus(chart.effect(new double[] {h}, 0), fitter.observers);
      f.model.column(state, f.path, f.residual, plus, h, columns[j]);
      scale(columns[j], chart.scale(0));
    }
    return part(f, columns);
  }

  private Part part(KickFrame f, double[][] columns) {
    RealMatrix oc = products(f.own, columns);
    RealMatrix solved = f.factor.getSolver().solve(oc);
    RealMatrix information = products(columns, columns).subtract(oc.transpose().multiply(solved));
    RealMatrix withShared =
        products(f.shared, columns)
            .subtract(products(f.own, f.shared).transpose().multiply(solved));
    return new Part(information, withShared, reducedScore(f, columns).toArray());
  }

  int kicks() {
    return frames.length;
  }

  List<ObservedCamera> observers() {
    return fitter.observers;
  }

  /** Score of an effect that is the same for all kicks. */
  Score score(Chart chart) {
    Part[] parts = new Part[frames.length];
    IntStream.range(0, parts.length).parallel().forEach(k -> parts[k] = part(k, chart));
    return combine(chart, parts);
  }

  /** The score from the kicks' parts; null where a kick is not touched. */
  Score combine(Chart chart, Part[] parts) {
    int m = chart.size();
    RealMatrix information = new Array2DRowRealMatrix(m, m);
    RealMatrix withShared = new Array2DRowRealMatrix(Math.max(1, free.length), m);
    RealVector score = new ArrayRealVector(m);
    for (Part p : parts) {
      if (p != null) {
        information = information.add(p.information);
        withShared = withShared.add(p.withShared);
        score = score.add(new ArrayRealVector(p.score));
      }
    }
    RealMatrix solved = shared.getSolver().solve(withShared);
    information = information.subtract(withShared.transpose().multiply(solved));
    score = score.subtract(solved.preMultiply(sharedRight));
    return Score.of(chart, information, score);
  }

  /** The score of one coordinate from sums over all kicks. */
  Score combine(Chart chart, double information, double[] withShared, double score) {
    RealVector with = new ArrayRealVector(withShared);
    RealVector solved = shared.getSolver().solve(with);
    RealMatrix one = new Array2DRowRealMatrix(1, 1);
    one.setEntry(0, 0, information - with.dotProduct(solved));
    RealVector right = new ArrayRealVector(1, score - solved.dotProduct(sharedRight));
    return Score.of(chart, one, right);
  }

  /** Score of an effect with one coordinate that differs from kick to kick. */
  Score randomScore(Chart chart) {
    double[] information = new double[frames.length];
    double[] score = new double[frames.length];
    IntStream.range(0, frames.length)
        .parallel()
        .forEach(
            k -> {
              Part p = part(k, chart);
              if (p != null) {
                information[k] = p.information.getEntry(0, 0);
                score[k] = p.score[0];
              }
            });
    return Score.ofRandom(chart, information, score);
  }

  /** The state at which this is the neighbourhood. */
  SharedState state() {
    return state;
  }

  /** Where a kick's ball is seen to go: smallest and largest x, smallest and largest y, m. */
  double[] extent(int kick) {
    KickData d = frames[kick].model.data;
    double[] box = {Double.MAX_VALUE, -Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int i = 0; i < d.size; i++) {
      if (d.used[i]) {
        box[0] = Math.min(box[0], d.x[i]);
        box[1] = Math.max(box[1], d.x[i]);
        box[2] = Math.min(box[2], d.y[i]);
        box[3] = Math.max(box[3], d.y[i]);
      }
    }
    return box;
  }

  /** A kick's path. */
  ExtendedTrajectory path(int kick) {
    return frames[kick].path;
  }

  /** The end of what is seen of a kick, s. */
  double lastSeen(int kick) {
    return frames[kick].model.data.kick.endTime();
  }
}
