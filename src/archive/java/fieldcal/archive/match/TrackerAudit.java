package fieldcal.archive.match;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import java.util.Arrays;
import java.util.List;

/**
 * How well a tracker follows the ball, against the fits of the kicks: each fit is the whole path of the raw detections of all cameras, known some ten times better than what a tracker can know at the moment.
 *
 * @param samples frames that were compared
 * @param delay by how much the tracker's ball is behind on its path, s, the median; NaN without a ball in motion
 * @param positionError root mean square distance in the plane, m; NaN without samples
 * @param positionErrorWithoutDelay the same with the delay taken out, m
 * @param velocityError root mean square of the difference of velocities in the plane, m/s; NaN when the tracker tells none
 * @param reported kicks that the tracker reports
 * @param matched of the kicks that are known well, those it reports
 * @param missed of the kicks that are known well, those it does not report though it was there
 * @param invented reported kicks at which the detections show none
 * @param speedBias mean of reported minus fitted speed right after the kick, m/s, both with the vertical part; NaN when none matches
 * @param speedScatter standard deviation of it, m/s; NaN with fewer than two
 * @param stops matched kicks whose ball was seen to stop, and for which a place was told 0.3 s after the kick
 * @param stopPositionError root mean square distance of the places told from where it stopped, m; NaN without any
 * @param stopTimeError root mean square of the times told minus when it stopped, s; NaN without any
 */
record TrackerAudit(
    long samples,
    double delay,
    double positionError,
    double positionErrorWithoutDelay,
    double velocityError,
    int reported,
    int matched,
    int missed,
    int invented,
    double speedBias,
    double speedScatter,
    int stops,
    double stopPositionError,
    double stopTimeError) {
  /** A report belongs to a kick when it starts within that time of it, s: a tracker sees a kick some frames late … */
  private static final double SAME_TIME = 0.3;

  /** … and begins within that distance, m. */
  private static final double SAME_PLACE = 0.5;

  /** Right after a kick every tracker still has the ball at rest, s. */
  private static final double SETTLING = 0.1;

  /** Slower balls tell nothing about a delay, m/s. */
  private static final double MOVING = 1;

  /**
   * A kick as its detections show it.
   *
   * @param start s
   * @param end until when the ball was seen, s
   * @param x where it was kicked, m
   * @param y where it was kicked, m
   * @param speed right after the kick, m/s; NaN when it could not be fitted
   * @param trusted whether the fit is
   * @param stopped whether the ball was seen to stop
   * @param path of a trusted fit; null for others
   */
  record KnownKick(
      double start,
      double end,
      double x,
      double y,
      double speed,
      boolean trusted,
      boolean stopped,
      BallTrajectory path) {}

  static TrackerAudit of(TrackerWatch.Source source, List<KnownKick> kicks) {
    Motion motion = new Motion(source, kicks);
    Kicks reports = new Kicks(source, kicks);
    return new TrackerAudit(
        motion.samples,
        motion.delay,
        motion.position,
        motion.positionWithoutDelay,
        motion.velocity,
        source.reports().size(),
        reports.matched,
        reports.missed,
        reports.invented,
        reports.bias,
        reports.scatter,
        reports.stops,
        reports.stopPosition,
        reports.stopTime);
  }

  /** Positions and velocities during the kicks that are trusted. */
  private static final class Motion {
    private long samples;
    private final double delay;
    private final double position;
    private double positionWithoutDelay;
    private double velocity;
    private double[] lags = new double[256];
    private int moving;

    Motion(TrackerWatch.Source source, List<KnownKick> kicks) {
      position = compare(source, kicks, 0, true);
      double[] sorted = Arrays.copyOf(lags, moving);
      Arrays.sort(sorted);
      delay = moving == 0 ? Double.NaN : (sorted[(moving - 1) / 2] + sorted[moving / 2]) / 2;
      positionWithoutDelay = moving == 0 ? Double.NaN : compare(source, kicks, delay, false);
    }

    private double compare(
        TrackerWatch.Source source, List<KnownKick> kicks, double late, boolean first) {
      double squares = 0;
      double velocities = 0;
      long n = 0;
      long told = 0;
      for (KnownKick kick : kicks) {
        if (!kick.trusted()) {
          continue;
        }
        for (int i = source.from(kick.start() + SETTLING);
            i < source.size() && source.time(i) < kick.end();
            i++) {
          BallState was = kick.path().stateAt(source.time(i) - late);
          double dx = was.x() - source.x(i);
          double dy = was.y() - source.y(i);
          squares += dx * dx + dy * dy;
          n++;
          if (first && was.groundSpeed() > MOVING) {
            double v2 = was.groundSpeed() * was.groundSpeed();
            lag((dx * was.vx() + dy * was.vy()) / v2);
          }
          if (first && !Double.isNaN(source.vx(i))) {
            double ux = was.vx() - source.vx(i);
            double uy = was.vy() - source.vy(i);
            velocities += ux * ux + uy * uy;
            told++;
          }
        }
      }
      if (first) {
        samples = n;
        velocity = Math.sqrt(velocities / told);
      }
      return Math.sqrt(squares / n);
    }

    private void lag(double lag) {
      if (moving == lags.length) {
        lags = Arrays.copyOf(lags, 2 * moving);
      }
      lags[moving++] = lag;
    }
  }

  /** The reports of kicks. */
  private static final class Kicks {
    private int matched;
    private int missed;
    private int invented;
    private final double bias;
    private final double scatter;
    private int stops;
    private double stopPosition;
    private double stopTime;

    Kicks(TrackerWatch.Source source, List<KnownKick> kicks) {
      double sum = 0;
      double squares = 0;
      for (KnownKick kick : kicks) {
        if (!kick.trusted()) {
          continue;
        }
        TrackerWatch.Report report = reportOf(source, kick);
        if (report == null) {
          int from = source.from(kick.start());
          boolean there = from < source.size() && source.time(from) < kick.start() + SAME_TIME;
          missed += there ? 1 : 0;
          continue;
        }
        matched++;
        double off = report.kick().speed() - kick.speed();
        sum += off;
        squares += off * off;
        stop(kick, report);
      }
      bias = sum / matched;
      scatter =
          matched < 2
              ? Double.NaN
              : Math.sqrt(Math.max(0, squares - matched * bias * bias) / (matched - 1));
      stopPosition = Math.sqrt(stopPosition / stops);
      stopTime = Math.sqrt(stopTime / stops);
      for (TrackerWatch.Report report : source.reports()) {
        boolean real =
            kicks.stream().anyMatch(k -> Math.abs(k.start() - report.kick().start()) < SAME_TIME);
        invented += real ? 0 : 1;
      }
    }

    private static TrackerWatch.Report reportOf(TrackerWatch.Source source, KnownKick kick) {
      TrackerWatch.Report best = null;
      double nearest = SAME_TIME;
      for (TrackerWatch.Report report : source.reports()) {
        double apart = Math.abs(report.kick().start() - kick.start());
        double distance = Math.hypot(report.kick().x() - kick.x(), report.kick().y() - kick.y());
        if (apart < nearest && distance < SAME_PLACE) {
          nearest = apart;
          best = report;
        }
      }
      return best;
    }

    private void stop(KnownKick kick, TrackerWatch.Report report) {
      boolean told =
          report.early() != null
              && Double.isFinite(
                  report.early().stop() + report.early().stopX() + report.early().stopY());
      if (!kick.stopped() || !told) {
        return;
      }
      double rest = kick.path().restTime();
      BallState there = kick.path().stateAt(rest);
      double dx = report.early().stopX() - there.x();
      double dy = report.early().stopY() - there.y();
      double late = report.early().stop() - rest;
      stops++;
      stopPosition += dx * dx + dy * dy;
      stopTime += late * late;
    }
  }
}
