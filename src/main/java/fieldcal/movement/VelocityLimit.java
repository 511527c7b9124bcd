package fieldcal.movement;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The limit of velocity, driven or turned: the highest speed at which robots cruise again and again. When they also drive clearly faster, without ever cruising there, the limit was not reached, and a speed that they certainly had is a
 * lower bound.
 */
final class VelocityLimit {
  /** Cruising robots keep their speed within this part of it. */
  private static final double WIDTH = 0.025;

  /** Calibrations and lenses make lengths too large or too small by up to this part. */
  private static final double ENLARGED = 0.001;

  /** Robots that creep up to their highest speed show this part less, measured in matches of another simulator. */
  private static final double CREEPING = 0.0003;

  /** Error of a plateau apart from noise, as a part of it. A value that may lie anywhere within a bound has the standard deviation bound/√3. */
  private static final double SYSTEMATIC = Math.hypot(ENLARGED / Math.sqrt(3), CREEPING);

  /** Least number of manoeuvres in a plateau … */
  private static final long FEWEST = 3;

  /** … and least part of all manoeuvres at constant speed. */
  private static final double SHARE = 0.02;

  /** Speeds at the ends of manoeuvres exceed the cap by errors of the knots, by this at most … */
  private static final double BEYOND = 1.08;

  /** … except for as many as this part of the plateau's manoeuvres, plus {@link #BEYOND_ANYWAY}. */
  private static final double BEYOND_SHARE = 0.3;

  private static final long BEYOND_ANYWAY = 3;

  /** The lower bound is the speed that this many manoeuvres exceed. */
  private static final int BOUND = 2;

  private static final long FEWEST_FOR_BOUND = 40;

  /** A robot's own cap lies below this part of the team's limit … */
  private static final double CAPPED = 0.93;

  /** … and holds at least this many of its manoeuvres. */
  private static final long CAP_SAMPLES = 10;

  private final SpeedTable speeds;
  private final String notReached;

  /**
   * A limit.
   *
   * @param speeds that were seen
   * @param notReached why there is only a lower bound, where it was not reached
   */
  VelocityLimit(SpeedTable speeds, String notReached) {
    this.speeds = speeds;
    this.notReached = notReached;
  }

  /** A speed, its error, and how many manoeuvres are there. */
  private record Plateau(double speed, double error, long samples) {}

  LimitEstimate estimate() {
    Histogram tops = speeds.tops();
    Histogram all = speeds.cruisingOfAll();
    Plateau plateau = highest(all, FEWEST);
    if (plateau != null) {
      long beyond = above(tops, BEYOND * plateau.speed());
      if (beyond <= BEYOND_ANYWAY + BEYOND_SHARE * plateau.samples()) {
        double error = Math.hypot(plateau.error(), SYSTEMATIC * plateau.speed());
        return new LimitEstimate(plateau.speed(), error, all.samples(), true, "");
      }
    }
    if (tops.samples() < FEWEST_FOR_BOUND) {
      return LimitEstimate.undetermined(
          tops.samples(), "needs " + FEWEST_FOR_BOUND + " manoeuvres");
    }
    Histogram sure = speeds.sure();
    return new LimitEstimate(
        exceededBy(sure, BOUND),
        2 * sure.width(),
        tops.samples(),
        false,
        notReached + ", so the limit may be higher");
  }

  /** Robots that never exceed a speed clearly below the team's limit. */
  List<SpeedCap> caps(LimitEstimate limit) {
    List<SpeedCap> caps = new ArrayList<>();
    for (Map.Entry<Integer, Histogram> robot : speeds.cruising().entrySet()) {
      Plateau own = highest(robot.getValue(), CAP_SAMPLES);
      if (limit.known()
          && own != null
          && own.speed() < CAPPED * limit.value()
          && above(robot.getValue(), (1 + 2 * WIDTH) * own.speed()) == 0) {
        caps.add(new SpeedCap(robot.getKey(), own.speed(), own.error(), own.samples()));
      }
    }
    return caps;
  }

  private Plateau highest(Histogram histogram, long fewest) {
    double slowest = speeds.scale().slowest();
    long moving = above(histogram, slowest);
    double needed = Math.max(fewest, SHARE * moving);
    for (int bin = histogram.bins() - 1; bin * histogram.width() > slowest; bin--) {
      double centre = (bin + 0.5) * histogram.width();
      if (histogram.count(bin) > 0 && within(histogram, centre).samples() >= needed) {
        // Down to where most are: the mean of a window, centred again.
        Plateau plateau = within(histogram, centre);
        for (int i = 0; i < 5; i++) {
          plateau = within(histogram, plateau.speed());
        }
        return plateau;
      }
    }
    return null;
  }

  private static Plateau within(Histogram speeds, double centre) {
    double sum = 0;
    double squares = 0;
    long n = 0;
    int from = (int) Math.max(0, (1 - WIDTH) * centre / speeds.width());
    int to = (int) Math.min(speeds.bins() - 1.0, (1 + WIDTH) * centre / speeds.width());
    for (int bin = from; bin <= to; bin++) {
      double speed = (bin + 0.5) * speeds.width();
      long count = speeds.count(bin);
      n += count;
      sum += count * (speed - centre);
      squares += count * (speed - centre) * (speed - centre);
    }
    double mean = n == 0 ? 0 : sum / n;
    double variance = n < 2 ? 0 : Math.max(0, squares - n * mean * mean) / (n - 1);
    double bin = speeds.width() * speeds.width() / 12;
    return new Plateau(centre + mean, Math.sqrt(Math.max(variance, bin) / Math.max(1, n)), n);
  }

  private static long above(Histogram speeds, double limit) {
    long n = speeds.beyond();
    for (int bin = speeds.bins() - 1; bin >= 0 && bin * speeds.width() >= limit; bin--) {
      n += speeds.count(bin);
    }
    return n;
  }

  private static double exceededBy(Histogram speeds, int number) {
    return speeds.percentile(1 - Math.min(1, (double) number / speeds.samples()));
  }
}
