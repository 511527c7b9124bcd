package fieldcal.app.play;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.kick.KickKind;
import fieldcal.play.KickChooser;
import fieldcal.play.PlannedKick;
import fieldcal.play.PlayLine;
import fieldcal.play.PlayPlan;
import fieldcal.play.SpreadKicks;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Chooses the most informative next kick: while causes are undecided, the speed and line that best distinguish them; else those after which the least certain parameter, by its
 * relative standard error, is known best. Once all are known well enough, speeds are spread: kicks that are best for the parameters are all alike, and show no cause. Not thread-safe.
 */
final class AdaptiveKicks implements KickChooser {
  private static final int SPEEDS = 10;

  /** Relative standard error from which on a parameter is known well enough, unless the operator wants another. */
  private static final double KNOWN = 0.01;

  /** The error that the operator asks for includes the scatter from kick to kick, so the detections alone must determine the parameter to this share of it. */
  private static final double RESERVE = 0.5;

  /** What is known of a parameter before the first kick, relative. */
  private static final double PRIOR = 0.5;

  /** Weight of the other parameters beside the least certain one, so that of equally good kicks the one that also determines these better is taken. */
  private static final double OTHERS = 0.1;

  /** Changing ends takes as long as a kick, so a kick on the other line must be more informative by this share. */
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
  private final Supplier<UndecidedCauses> undecided;
  private final List<Double> failed = new ArrayList<>();
  private final SpreadKicks spread;
  private final Set<PlannedKick> spreadOut = new HashSet<>();
  private boolean line;
  private boolean inVain;

  AdaptiveKicks(
      SessionRequest request, PlayPlan plan, LiveFits fits, Supplier<UndecidedCauses> undecided) {
    this.request = request;
    this.plan = plan;
    this.fits = fits;
    this.undecided = undecided;
    spread =
        new SpreadKicks(
            request.kicks(),
            request.slowest(),
            request.fastest(),
            request.elevation(),
            request.seed());
  }

  /** Whether kicks would tell undecided causes apart, but none of this play. */
  boolean isInVain() {
    return inVain;
  }

  @Override
  public PlannedKick next(double ballX, double ballY) {
    Optional<PlannedKick> telling = forCauses(undecided.get(), ballX, ballY);
    PlannedKick best = telling.orElseGet(() -> forModel(ballX, ballY));
    line = best.otherLine();
    return best;
  }

  private PlannedKick forModel(double ballX, double ballY) {
    if (!isKnown()) {
      return forParameters(ballX, ballY);
    }
    Optional<PlannedKick> missing = forScatter();
    if (missing.isPresent()) {
      return missing.get();
    }
    PlannedKick kick = spread.next();
    spreadOut.add(kick);
    return kick;
  }

  /** Before a scatter is believed, slow, middling and fast kicks must have shown it: of the third of the speeds that has the fewest. */
  private Optional<PlannedKick> forScatter() {
    int[] good = new int[3];
    PlannedKick most = new PlannedKick(request.fastest(), request.elevation(), line);
    double fastest = Math.max(request.slowest(), spread.inView(most).speed());
    int fewest = 0;
    for (int third = 0; third < 3; third++) {
      good[third] = fits.goodOf(third, request.slowest(), fastest);
      fewest = good[third] < good[fewest] ? third : fewest;
    }
    if (request.precision() == 0 || fits.good() >= LiveFits.FEWEST && good[fewest] > 0) {
      return Optional.empty();
    }
    // Not at the edges, whose kicks are the first to fail.
    double share = (fewest + 0.5) / 3;
    double speed = request.slowest() + share * (fastest - request.slowest());
    return Optional.of(spread.inView(new PlannedKick(speed, request.elevation(), line)));
  }

  /** By what the detections tell; what differs from kick to kick for another reason no choice of kicks makes smaller. */
  private boolean isKnown() {
    double[] values = fits.current();
    double[] errors = relativeErrors(fits.information().add(prior(values)), values);
    double enough = request.precision() > 0 ? RESERVE * request.precision() : KNOWN;
    return Arrays.stream(errors).allMatch(e -> e < enough);
  }

  /** The kick that best distinguishes what is undecided; empty when no kick does. */
  private Optional<PlannedKick> forCauses(UndecidedCauses open, double ballX, double ballY) {
    PlannedKick best = null;
    double most = UndecidedCauses.LEAST;
    if (open.mayBeTold()) {
      for (PlannedKick kick : possible()) {
        double change = kick.otherLine() == line ? 1 : 1 - CHANGE;
        double told =
            open.expected(ahead(kick, ballX, ballY).planned(kick, open.time()))
                * promise(kick.speed())
                * change;
        if (told > most) {
          most = told;
          best = kick;
        }
      }
    }
    inVain = best == null && open.mayBeTold();
    return Optional.ofNullable(best);
  }

  private List<PlannedKick> possible() {
    List<PlannedKick> kicks = new ArrayList<>();
    for (int i = 0; i < SPEEDS; i++) {
      double speed =
          request.slowest() + (request.fastest() - request.slowest()) * i / (SPEEDS - 1.0);
      kicks.add(new PlannedKick(speed, request.elevation(), false));
      kicks.add(new PlannedKick(speed, request.elevation(), true));
    }
    return kicks.stream().map(spread::inView).distinct().toList();
  }

  private PlannedKick forParameters(double ballX, double ballY) {
    double[] values = fits.current();
    RealMatrix known = fits.information().add(prior(values));
    KickInformation ahead =
        new KickInformation(fits.cameras(), fits.noise(), plan.limits().settle());
    PlannedKick best = null;
    double bestScore = Double.POSITIVE_INFINITY;
    for (PlannedKick kick : possible()) {
      RealMatrix told =
          predicted(ahead, kick, values, ballX, ballY).scalarMultiply(promise(kick.speed()));
      double change = kick.otherLine() == line ? 0 : CHANGE;
      double score = uncertainty(known.add(told), values) + change;
      if (score < bestScore) {
        bestScore = score;
        best = kick;
      }
    }
    return best;
  }

  private double promise(double speed) {
    double promise = 1;
    for (double f : failed) {
      promise *= Math.abs(f - speed) < NEAR ? FAILED : 1;
    }
    return promise;
  }

  /** Where a kick is made, and how far its ball comes. */
  private record Way(
      KickKind kind, double x, double y, double direction, double run, double settle) {
    SeenKick.Plan planned(PlannedKick kick, double time) {
      return new SeenKick.Plan(
          kind, time, x, y, direction, kick.speed(), kick.elevation(), run, settle);
    }
  }

  /** From where the ball lies towards the farther end, or, if that is too near, over the whole line. */
  private Way ahead(PlannedKick kick, double ballX, double ballY) {
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
    return new Way(request.kind(), x, y, direction, run, plan.limits().settle());
  }

  private RealMatrix predicted(
      KickInformation ahead, PlannedKick kick, double[] v, double ballX, double ballY) {
    Way way = ahead(kick, ballX, ballY);
    if (request.kind() == KickKind.FLAT) {
      FlatModel model = new FlatModel(v[0], v[1], v[2]);
      return ahead.flat(model, way.x, way.y, way.direction, kick.speed(), way.run);
    }
    ChipModel model = new ChipModel(v[0], v[1], v[2], ChipModel.typical().accRoll());
    return ahead.chip(model, way.x, way.y, way.direction, kick.speed(), kick.elevation(), way.run);
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
    double worst = Double.NEGATIVE_INFINITY;
    double all = 0;
    for (double relative : relativeErrors(information, values)) {
      worst = Math.max(worst, Math.log(relative));
      all += Math.log(relative);
    }
    return worst + OTHERS * all / 3;
  }

  private static double[] relativeErrors(RealMatrix information, double[] values) {
    RealMatrix covariance = KickInformation.inverse(information);
    double[] errors = new double[3];
    for (int i = 0; i < 3; i++) {
      errors[i] = Math.sqrt(covariance.getEntry(i, i)) / Math.abs(values[i]);
    }
    return errors;
  }

  @Override
  public void outOfView(PlannedKick kick) {
    spread.outOfView(kick);
    failed.add(kick.speed());
    spreadOut.remove(kick);
  }

  @Override
  public void done(PlannedKick kick, boolean good) {
    if (!good) {
      failed.add(kick.speed());
    }
    if (spreadOut.remove(kick)) {
      spread.done(kick, good);
    }
  }
}
