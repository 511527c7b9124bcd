package fieldcal.app.play;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.kick.KickKind;
import fieldcal.play.KickChooser;
import fieldcal.play.PlannedKick;
import fieldcal.play.PlayLine;
import fieldcal.play.PlayPlan;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Chooses the next kick for what it will tell: the speed and line after which the least certain parameter, by its relative standard error, is known best. Not thread-safe.
 */
final class AdaptiveKicks implements KickChooser {
  private static final int SPEEDS = 10;

  /** What is known of a parameter before the first kick, relative. */
  private static final double PRIOR = 0.5;

  /** Beside the least certain parameter the others count a little, so that of equal kicks the one that tells more of them is taken. */
  private static final double OTHERS = 0.1;

  /** Changing ends takes as long as a kick: a kick on the other line has to tell that much more. */
  private static final double CHANGE = 0.15;

  /** Kicks near a speed that did not determine its parameters promise less. */
  private static final double FAILED = 0.25;

  private static final double NEAR = 0.5;

  /** A ball that has less of a line before it is carried to its end first. */
  private static final double LEAST_RUN = 0.55;

  /** Part of a line that the ball rolls until it is received. */
  private static final double RUN = 0.95;

  private final SessionRequest request;
  private final PlayPlan plan;
  private final LiveFits fits;
  private final List<Double> failed = new ArrayList<>();
  private boolean line;

  AdaptiveKicks(SessionRequest request, PlayPlan plan, LiveFits fits) {
    this.request = request;
    this.plan = plan;
    this.fits = fits;
  }

  @Override
  public PlannedKick next(double ballX, double ballY) {
    double[] values = fits.current();
    RealMatrix known = fits.information().add(prior(values));
    KickInformation ahead =
        new KickInformation(fits.cameras(), fits.noise(), plan.limits().settle());
    PlannedKick best = null;
    double bestScore = Double.POSITIVE_INFINITY;
    for (int i = 0; i < SPEEDS; i++) {
      double speed =
          request.slowest() + (request.fastest() - request.slowest()) * i / (SPEEDS - 1.0);
      for (boolean other : new boolean[] {false, true}) {
        PlannedKick kick = new PlannedKick(speed, request.elevation(), other);
        RealMatrix told =
            predicted(ahead, kick, values, ballX, ballY).scalarMultiply(promise(speed));
        double score = uncertainty(known.add(told), values) + (other == line ? 0 : CHANGE);
        if (score < bestScore) {
          bestScore = score;
          best = kick;
        }
      }
    }
    line = best.otherLine();
    return best;
  }

  private double promise(double speed) {
    double promise = 1;
    for (double f : failed) {
      promise *= Math.abs(f - speed) < NEAR ? FAILED : 1;
    }
    return promise;
  }

  /** What a kick tells from where the ball lies towards the farther end, or, if that is too near, over the whole line. */
  private RealMatrix predicted(
      KickInformation ahead, PlannedKick kick, double[] v, double ballX, double ballY) {
    PlayLine l = kick.otherLine() ? plan.otherLine() : plan.line();
    boolean toFirst =
        Math.hypot(l.x0() - ballX, l.y0() - ballY) > Math.hypot(l.x1() - ballX, l.y1() - ballY);
    double toX = toFirst ? l.x0() : l.x1();
    double toY = toFirst ? l.y0() : l.y1();
    boolean fromHere = Math.hypot(toX - ballX, toY - ballY) > LEAST_RUN * l.length();
    double x = fromHere ? ballX : toFirst ? l.x1() : l.x0();
    double y = fromHere ? ballY : toFirst ? l.y1() : l.y0();
    double direction = Math.atan2(toY - y, toX - x);
    double run = RUN * Math.hypot(toX - x, toY - y);
    if (request.kind() == KickKind.FLAT) {
      return ahead.flat(new FlatModel(v[0], v[1], v[2]), x, y, direction, kick.speed(), run);
    }
    ChipModel model = new ChipModel(v[0], v[1], v[2], ChipModel.typical().accRoll());
    return ahead.chip(model, x, y, direction, kick.speed(), kick.elevation(), run);
  }

  private static RealMatrix prior(double[] values) {
    RealMatrix prior = MatrixUtils.createRealMatrix(3, 3);
    for (int i = 0; i < 3; i++) {
      prior.setEntry(i, i, 1 / Math.pow(PRIOR * values[i], 2));
    }
    return prior;
  }

  /** Logarithm of the largest relative error, and a little of the others. */
  private static double uncertainty(RealMatrix information, double[] values) {
    RealMatrix covariance = KickInformation.inverse(information);
    double worst = Double.NEGATIVE_INFINITY;
    double all = 0;
    for (int i = 0; i < 3; i++) {
      double relative = Math.log(Math.sqrt(covariance.getEntry(i, i)) / Math.abs(values[i]));
      worst = Math.max(worst, relative);
      all += relative;
    }
    return worst + OTHERS * all / 3;
  }

  @Override
  public void done(PlannedKick kick, boolean good) {
    if (!good) {
      failed.add(kick.speed());
    }
  }
}
