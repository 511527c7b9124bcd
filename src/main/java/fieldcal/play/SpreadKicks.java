package fieldcal.play;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Random;
import java.util.function.Predicate;

/** Kicks with evenly spread speeds in a random order, half along one line and half along the other. Where the ball lies so that not every kick can be made without carrying it, those that can be made come first. A kick that was not good is made again, nearer to a speed that was good: repeated at the same speed, it would again determine too little. Which speeds are good depends on the field; where the ball slides for only a tenth of a second, it is the fast ones. As long as no kick was good, the middle of the range counts as good. Once a ball has left the images of all cameras, kicks are slower than that one was. Not thread-safe. */
public final class SpreadKicks implements KickChooser {
  /** How far towards the middle of the range a kick goes when it is made again, while none was good; and towards its slow end when the ball left the images. */
  private static final double INWARDS = 0.3;

  /** How far towards the nearest speed that was good a kick goes when it is made again. */
  private static final double BETWEEN = 0.5;

  /** A slower ball is no kick, m/s. */
  private static final double WEAKEST = 0.7;

  private final Deque<PlannedKick> waiting = new ArrayDeque<>();
  private final List<Double> good = new ArrayList<>();
  private final List<Double> repeated = new ArrayList<>();
  private final PlannedKick spare;
  private final double slowest;

  /** A ball as fast left the images of all cameras, m/s. */
  private double tooFast = Double.POSITIVE_INFINITY;

  /**
   * Spreads kicks over a range of speeds.
   *
   * @param count how many, at least 1
   * @param slowest m/s
   * @param fastest m/s
   * @param elevation rad, 0 = flat
   * @param seed of the order
   * @throws IllegalArgumentException when the count is below 1 or a speed out of range
   */
  public SpreadKicks(int count, double slowest, double fastest, double elevation, long seed) {
    if (count < 1 || !(fastest >= slowest)) {
      throw new IllegalArgumentException(
          count + " kicks from " + slowest + " to " + fastest + " m/s cannot be spread");
    }
    this.slowest = slowest;
    Random random = new Random(seed);
    int first = count - count / 2;
    for (int block = 0; block < 2; block++) {
      int n = block == 0 ? first : count - first;
      List<PlannedKick> kicks = new ArrayList<>();
      for (int i = 0; i < n; i++) {
        double share = n == 1 ? 0.5 : (double) i / (n - 1);
        double speed = slowest + share * (fastest - slowest);
        kicks.add(new PlannedKick(speed, elevation, block == 1));
      }
      Collections.shuffle(kicks, random);
      waiting.addAll(kicks);
    }
    spare = new PlannedKick(0.5 * (slowest + fastest), elevation, true);
  }

  @Override
  public PlannedKick next(double ballX, double ballY) {
    return next();
  }

  /** Chooses the first kick on the line that is due that can be made from where the ball lies, or else the first one. {@inheritDoc} */
  @Override
  public PlannedKick next(double ballX, double ballY, Predicate<PlannedKick> fromHere) {
    Iterator<PlannedKick> each = waiting.iterator();
    while (each.hasNext()) {
      PlannedKick kick = each.next();
      if (kick.otherLine() == waiting.getFirst().otherLine() && fromHere.test(kick)) {
        each.remove();
        return inView(kick);
      }
    }
    return next();
  }

  /**
   * The next kick, wherever the ball is.
   *
   * @return what is wanted
   */
  public PlannedKick next() {
    return inView(waiting.isEmpty() ? spare : waiting.removeFirst());
  }

  /**
   * What becomes of a kick when a ball as fast has left the images of all cameras: it is made slower, so that a chip also flies less high. Where even the slowest left them, no kick of the range is of
   * use, and it is made slower than the range.
   *
   * @param kick one that is planned
   * @return the same, or a slower one
   */
  public PlannedKick inView(PlannedKick kick) {
    if (kick.speed() < tooFast) {
      return kick;
    }
    double least = tooFast > slowest ? slowest : 0;
    double slower = Math.max(WEAKEST, tooFast + INWARDS * (least - tooFast));
    return new PlannedKick(slower, kick.elevation(), kick.otherLine());
  }

  @Override
  public void outOfView(PlannedKick kick) {
    tooFast = Math.min(tooFast, kick.speed());
    done(kick, false);
  }

  @Override
  public void done(PlannedKick kick, boolean counts) {
    double speed = kick.speed();
    if (counts) {
      good.add(speed);
      return;
    }
    // A kick may turn out bad later.
    good.remove(speed);
    double next = again(speed);
    repeated.add(next);
    PlannedKick again = new PlannedKick(next, kick.elevation(), kick.otherLine());
    if (good.isEmpty()) {
      // Nobody knows yet which speeds are good: the others on this line first.
      insertAfterLine(again);
    } else {
      // At once: the robots are still on the right line.
      waiting.addFirst(again);
    }
  }

  private void insertAfterLine(PlannedKick kick) {
    Deque<PlannedKick> others = new ArrayDeque<>();
    while (!waiting.isEmpty() && waiting.getLast().otherLine() != kick.otherLine()) {
      others.addFirst(waiting.removeLast());
    }
    waiting.addLast(kick);
    waiting.addAll(others);
  }

  /** The speed in place of one that failed. A first failure may be chance. When the repeat fails, too, the nearest good speed may have been good by chance, and the median of the good ones is taken. */
  private double again(double speed) {
    if (good.isEmpty()) {
      return speed + INWARDS * (spare.speed() - speed);
    }
    if (repeated.contains(speed)) {
      return good.stream().sorted().toList().get(good.size() / 2);
    }
    Comparator<Double> nearest = Comparator.comparingDouble(g -> Math.abs(g - speed));
    return speed + BETWEEN * (Collections.min(good, nearest) - speed);
  }
}
