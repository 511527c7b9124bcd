package fieldcal.fit.joint;

import fieldcal.fit.joint.SharedSolver.OwnFit;
import java.util.List;

/**
 * Fits of single kicks with everything shared held: Levenberg–Marquardt on the own parameters, and the choice among the values of the kick's discrete unknown. Immutable and thread-safe.
 *
 * @param <S> what the global parameters amount to
 */
final class OwnFitter<S> {
  private static final double SAME_COST = 1e-9;

  /** A cost that is less by no more than that share is the same but for rounding. */
  private static final double ROUNDING = 1e-6;

  private final int maxIterations;
  private final double tolerance;
  private final S state;
  private final double[] means;
  private final double[] scatters;

  /**
   * @param maxIterations most steps, accepted or not
   * @param tolerance gain of chi-square, in units of the reduced one, below which a step is the last
   * @param state of the shared model
   * @param means of the random effects
   * @param scatters of the random effects
   */
  OwnFitter(int maxIterations, double tolerance, S state, double[] means, double[] scatters) {
    this.maxIterations = maxIterations;
    this.tolerance = tolerance;
    this.state = state;
    this.means = means;
    this.scatters = scatters;
  }

  /** The fit from a start, which is not changed. */
  OwnFit<S> fit(KickTerm<S> term, double[] start) {
    return fit(term, start, Double.POSITIVE_INFINITY);
  }

  /** The same, but not begun where it would end above a limit: the equations promise less than half of what is missing. */
  private OwnFit<S> fit(KickTerm<S> term, double[] start, double limit) {
    double[] own = start.clone();
    term.clamp(own);
    double[] residuals = new double[term.rows()];
    term.residuals(own, state, residuals);
    double cost = cost(term, own, residuals);
    Damping damping = new Damping();
    KickBlock block = null;
    double[] next = new double[term.rows()];
    double noise = Math.max(1, cost / Math.max(1, term.rows()));
    for (int i = 0; i < maxIterations && Double.isFinite(cost); i++) {
      if (block == null) {
        block = block(term, own, residuals, 1);
      }
      block.factor(damping.lambda());
      double[] step = block.ownStep(new double[0]);
      if (i == 0 && cost - Descent.TRUSTED * KickBlock.dot(step, block.ga) > limit) {
        break;
      }
      double[] candidate = plus(own, step);
      if (!KickBlock.areFinite(candidate)) {
        break;
      }
      term.clamp(candidate);
      term.residuals(candidate, state, next);
      double nextCost = cost(term, candidate, next);
      if (nextCost <= cost) {
        boolean done = cost - nextCost < tolerance * noise;
        own = candidate;
        System.arraycopy(next, 0, residuals, 0, next.length);
        cost = nextCost;
        block = null;
        damping.accepted();
        if (done) {
          break;
        }
      } else {
        if (damping.isLargest() || nextCost - cost < SAME_COST * cost) {
          break;
        }
        damping.rejected();
      }
    }
    return new OwnFit<>(term, own, cost, KickBlock.dot(residuals, residuals));
  }

  private double cost(KickTerm<S> term, double[] own, double[] residuals) {
    return KickBlock.dot(residuals, residuals) + OwnPriors.cost(term, own, means, scatters);
  }

  /** The equations of the own parameters alone. */
  private KickBlock block(KickTerm<S> term, double[] own, double[] residuals, double weight) {
    double[][] columns = new double[own.length][residuals.length];
    term.ownColumns(own, state, residuals, columns);
    KickBlock block = new KickBlock(own.length, 0);
    block.add(columns, new double[0][], residuals, weight);
    OwnPriors.tie(block, term, own, means, null, scatters);
    return block;
  }

  /** One damped step from here. */
  double[] stepped(KickTerm<S> term, double[] own, double weight, double lambda) {
    double[] residuals = new double[term.rows()];
    term.residuals(own, state, residuals);
    KickBlock block = block(term, own, residuals, weight);
    block.factor(lambda);
    double[] next = plus(own, block.ownStep(new double[0]));
    term.clamp(next);
    return next;
  }

  private static double[] plus(double[] own, double[] step) {
    double[] moved = own.clone();
    for (int i = 0; i < moved.length; i++) {
      moved[i] += step[i];
    }
    return moved;
  }

  /**
   * The best of a kick and its neighbours in the discrete unknown.
   *
   * @param stuck whether it is explained so much worse than its fellows that other starts are tried, too
   */
  OwnFit<S> bestVariant(KickTerm<S> term, double[] own, boolean stuck) {
    OwnFit<S> best = fit(term, own);
    for (KickTerm<S> other : term.neighbours()) {
      best = better(best, fit(other, own, priced(best)));
    }
    List<KickTerm.Restart<S>> restarts = stuck ? term.restarts(own, state) : List.of();
    for (KickTerm.Restart<S> other : restarts) {
      best = better(best, fit(other.term(), other.own()));
    }
    return best;
  }

  private OwnFit<S> better(OwnFit<S> best, OwnFit<S> tried) {
    return isLess(priced(tried), priced(best)) ? tried : best;
  }

  private double priced(OwnFit<S> fit) {
    return fit.cost() + fit.term().penalty(fit.own(), state);
  }

  /** By more than rounding; anything is less than what is impossible. */
  static boolean isLess(double a, double b) {
    return Double.isFinite(b) ? a < b - ROUNDING * Math.abs(b) : Double.isFinite(a);
  }
}
