package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.Gravity;
import java.util.Arrays;

/** Fits the own unknowns of one kick under shared ones that are given. A working object; not thread-safe. */
final class OwnFit {
  private static final int MAX_ITERATIONS = 25;
  private static final double ENOUGH = 0.01;

  /** What a number of flights against the 10 mm rule costs in chi-square; noise reaches it once in ten thousand kicks. */
  private static final double RULE_PRICE = 15;

  /** Hops up to that many times higher or lower than the rule's limit may be wrongly counted. */
  private static final double NEAR_RULE = 3;

  /** Rises from which a chip in a wrong valley is fitted anew, as multiples of the present one. */
  private static final double[] OTHER_RISES = {0.55, 0.65, 0.75, 0.87, 1.15, 1.3, 1.5, 1.8};

  private final KickModel model;
  private final SharedState state;
  private final double[] scatter;

  OwnFit(KickModel model, SharedState state, double[] scatter) {
    this.model = model;
    this.state = state;
    this.scatter = scatter;
  }

  /** Improves the model's own unknowns in place; returns the cost there. */
  double minimize() {
    int n = 2 * model.data.size;
    int p = model.ownSize;
    double[] residual = new double[n];
    double[][] columns = new double[p][n];
    double[] scale = new double[p];
    Arrays.setAll(scale, model::ownStep);
    double cost = model.cost(state, model.own, scatter, residual);
    double lambda = 1e-4;
    KickNormal normal = null;
    for (int i = 0; i < MAX_ITERATIONS && lambda < 1e8; i++) {
      if (normal == null) {
        model.ownColumns(state, residual, columns);
        normal = new KickNormal(columns, new double[0][], residual, cost, scale);
        model.tie(normal, state, scatter, false);
      }
      normal.reduce(lambda, new double[0][0], new double[0]);
      double[] next = model.moved(normal.ownStep(new double[0]));
      double[] nextResidual = new double[n];
      double nextCost =
          isFinite(next)
              ? model.cost(state, next, scatter, nextResidual)
              : Double.POSITIVE_INFINITY;
      if (nextCost <= cost) {
        double gained = cost - nextCost;
        model.own = next;
        cost = nextCost;
        residual = nextResidual;
        normal = null;
        lambda = Math.max(1e-7, lambda / 8);
        if (gained < ENOUGH) {
          break;
        }
      } else {
        if (nextCost - cost < 1e-9 * cost) {
          break;
        }
        lambda = Math.max(1e-5, lambda * 6);
      }
    }
    return cost;
  }

  /** A step from equations that determine nothing may be no number. */
  static boolean isFinite(double[] values) {
    double sum = 0;
    for (double v : values) {
      sum += v;
    }
    return Double.isFinite(sum);
  }

  /** Tries one flight more and one less, or, far from what the rule says, what it says; true when that explains the kick better. */
  boolean chooseFlights() {
    int n = 2 * model.data.size;
    int kept = model.flights;
    double[] keptOwn = model.own;
    double best = priced(model.cost(state, model.own, scatter, new double[n]));
    int bestFlights = kept;
    double[] bestOwn = keptOwn;
    int rule = model.flightsByRule(state, keptOwn);
    boolean lost = Math.abs(rule - kept) > 1;
    int[] others = lost ? new int[] {rule - 1, rule, rule + 1} : new int[] {kept - 1, kept + 1};
    for (int other : others) {
      boolean possible = other >= 1 && other <= ChipModel.MAX_FLIGHTS;
      if (!possible || !lost && !isNearTheRule(keptOwn, kept, other)) {
        continue;
      }
      model.flights = other;
      model.own = keptOwn.clone();
      double tried = priced(minimize());
      boolean plausible = Math.abs(model.flightsByRule(state, model.own) - other) <= 1;
      if (plausible && tried < best - 0.1) {
        best = tried;
        bestFlights = other;
        bestOwn = model.own;
      }
    }
    model.flights = bestFlights;
    model.own = bestOwn;
    return bestFlights != kept;
  }

  /**
   * Fits a chip that the shared unknowns explain badly from other rises, each with the number of flights that follows from it; true when one explains it better. The height of one hop and the number of all are
   * nearly exchangeable for a single kick, so its own fit may have ended far from what the other kicks say.
   */
  boolean restart() {
    double[] keptOwn = model.own;
    int kept = model.flights;
    double before = priced(model.cost(state, keptOwn, scatter, new double[2 * model.data.size]));
    double best = before;
    double[] bestOwn = keptOwn;
    int bestFlights = kept;
    for (double rise : OTHER_RISES) {
      model.own = keptOwn.clone();
      model.own[4] *= rise;
      model.flights = model.flightsByRule(state, model.own);
      double tried = priced(minimize());
      if (tried < best - RULE_PRICE) {
        best = tried;
        bestOwn = model.own;
        bestFlights = model.flights;
      }
    }
    model.own = bestOwn;
    model.flights = bestFlights;
    return best < before;
  }

  /** Whether another number of flights is worth a fit: the last hop, or the one after it, comes near the rule's height. */
  private boolean isNearTheRule(double[] own, int now, int other) {
    double rise = own[4] * Math.pow(state.chip.dampingZ(), Math.max(now, other) - 1.0);
    double height = rise * rise / (2 * Gravity.ACCELERATION) / ChipModel.MIN_HOP_HEIGHT;
    return other > now ? height > 1 / NEAR_RULE : height < NEAR_RULE;
  }

  private double priced(double cost) {
    return model.flightsByRule(state, model.own) == model.flights ? cost : cost + RULE_PRICE;
  }
}
