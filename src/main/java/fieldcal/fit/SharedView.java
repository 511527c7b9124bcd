package fieldcal.fit;

import fieldcal.camera.Camera;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What two cameras saw of the ball of one kick at once: by how much the second reports it off from the first, and where the ball's height does not cause that. */
final class SharedView {
  /** The ball certainly does not move until this long before the kick, s: the time of a kick is known to a few milliseconds. */
  private static final double BEFORE_KICK = 0.02;

  /** Positions of a camera that are further apart in time are not interpolated, s: two frames at 60 Hz, one of them lost. */
  private static final double GAP = 0.035;

  /** Fewer comparisons do not determine a scatter. */
  private static final int FEWEST = 5;

  /** Length of the stretches in which a moving ball is compared, s: cameras that overlap by a metre share it for that long up to 5 m/s. */
  private static final double STRETCH = 0.2;

  /** A stretch must be filled to this part, or it is too short to distinguish flying from rolling. */
  private static final double FILLED = 0.7;

  /**
   * {@link #scatter} of the height over a stretch around the top of a flight, m; every other part of a flight scatters more. The height spans g·T²/8 there, the median distance from its median is 0.217
   * of that.
   */
  private static final double SCATTER_IN_FLIGHT =
      0.217 * 9.81 * STRETCH * STRETCH / 8 / Math.sqrt(2 * Math.log(2));

  /** By how much two cameras report a ball apart per metre of height when nobody knows where they hang (chosen: 3 m apart, 6 m high). */
  private static final double USUAL_PARALLAX = 0.5;

  /** By how much the time stamps of two cameras contradict each other, s: each jitters by up to 1.3 ms (ten real matches of 2026). */
  private static final double CLOCKS = 0.0013 * Math.sqrt(2);

  private final List<Comparison> comparisons = new ArrayList<>();
  private final CameraView first;
  private final CameraView second;
  private final Kick kick;

  /** Stretches of the moving ball. */
  private final List<Stretch> stretches = new ArrayList<>();

  private Optional<Difference> atRest = Optional.empty();

  /** Between two positions of the first camera; x and y are the first's. */
  private record Comparison(double from, double to, double x, double y, double dx, double dy) {}

  /** Medians of the differences of a stretch, m, and their standard deviation per axis, m, as {@link RobustScale}. */
  private record Spread(double x, double y, double scatter) {}

  /**
   * A part of a kick.
   *
   * @param difference of the two cameras in it
   * @param scatter of this difference, m
   * @param flight half of what it would scatter if the ball flew, m
   */
  private record Stretch(Difference difference, double scatter, double flight) {}

  /**
   * A difference of two cameras.
   *
   * @param x of the second camera's position from the first's, m
   * @param y m
   * @param sigma its standard error, m, positive
   */
  record Difference(double x, double y, double sigma) {
    double weight() {
      return 1 / (sigma * sigma);
    }
  }

  private SharedView(Kick kick, CameraView first, CameraView second) {
    this.kick = kick;
    this.first = first;
    this.second = second;
  }

  /** Offsets and noise of the cameras do not matter. */
  static SharedView of(Kick kick, CameraView first, CameraView second) {
    SharedView shared = new SharedView(kick, first, second);
    Observations seen = kick.observations();
    int before = -1;
    for (int i = 0; i < seen.size(); i++) {
      if (seen.camera(i) == first.id()) {
        before = i;
      } else if (seen.camera(i) == second.id() && before >= 0) {
        int after = i + 1;
        while (after < seen.size() && seen.camera(after) != first.id()) {
          after++;
        }
        if (after < seen.size() && seen.time(after) - seen.time(before) < GAP) {
          shared.compare(seen, before, i, after);
        }
      }
    }
    shared.findRest();
    shared.findStretches();
    return shared;
  }

  private void compare(Observations seen, int before, int i, int after) {
    double span = seen.time(after) - seen.time(before);
    double f = span > 0 ? (seen.time(i) - seen.time(before)) / span : 0;
    double x = seen.x(before) + f * (seen.x(after) - seen.x(before));
    double y = seen.y(before) + f * (seen.y(after) - seen.y(before));
    comparisons.add(
        new Comparison(seen.time(before), seen.time(after), x, y, seen.x(i) - x, seen.y(i) - y));
  }

  private void findRest() {
    List<Comparison> rest = upTo(0, kick.time() - BEFORE_KICK);
    if (rest.size() >= FEWEST) {
      atRest = Optional.of(difference(rest, spread(rest)));
    }
  }

  private void findStretches() {
    int begin = 0;
    for (double from = kick.time(); from < kick.endTime(); from += STRETCH / 2) {
      begin = firstFrom(begin, from);
      List<Comparison> stretch = upTo(begin, from + STRETCH);
      if (stretch.size() >= FEWEST && duration(stretch) > FILLED * STRETCH) {
        Spread spread = spread(stretch);
        Comparison middle = stretch.get(stretch.size() / 2);
        double flight = 0.5 * parallax(middle.x, middle.y) * SCATTER_IN_FLIGHT;
        stretches.add(new Stretch(difference(stretch, spread), spread.scatter, flight));
      }
    }
  }

  /** The difference while the ball rested before the kick. */
  Optional<Difference> atRest() {
    return atRest;
  }

  /**
   * The best known difference while the ball moved on the ground. Of a ball in the air two cameras report places whose distance changes with its height; where the distance is steady, the ball does not fly: then its scatter is nearer to that of the noise than to that of a flight.
   *
   * @param noise of both cameras together, m
   */
  Optional<Difference> onTheGround(double noise) {
    Difference best = null;
    for (Stretch stretch : stretches) {
      Difference d = stretch.difference;
      boolean steady = stretch.scatter < Math.hypot(stretch.flight, noise);
      best = steady && (best == null || d.sigma < best.sigma) ? d : best;
    }
    return Optional.ofNullable(best);
  }

  /** The first comparison, from one that is earlier on, that begins at a time or later. */
  private int firstFrom(int earlier, double time) {
    int i = earlier;
    while (i < comparisons.size() && comparisons.get(i).from < time) {
      i++;
    }
    return i;
  }

  /** The comparisons from one on that end at a time or before. */
  private List<Comparison> upTo(int begin, double time) {
    int end = begin;
    while (end < comparisons.size() && comparisons.get(end).to <= time) {
      end++;
    }
    return comparisons.subList(begin, end);
  }

  private static double duration(List<Comparison> stretch) {
    return stretch.get(stretch.size() - 1).to - stretch.get(0).from;
  }

  /** By how much farther apart the cameras report a ball at a place for each metre of its height (–). */
  private double parallax(double x, double y) {
    if (first.camera().isEmpty() || second.camera().isEmpty()) {
      return USUAL_PARALLAX;
    }
    Camera a = first.camera().get();
    Camera b = second.camera().get();
    double ha = a.heightAboveBallPlane();
    double hb = b.heightAboveBallPlane();
    return Math.hypot(
        (x - b.positionX()) / hb - (x - a.positionX()) / ha,
        (y - b.positionY()) / hb - (y - a.positionY()) / ha);
  }

  private static Difference difference(List<Comparison> stretch, Spread spread) {
    Comparison begin = stretch.get(0);
    Comparison end = stretch.get(stretch.size() - 1);
    double duration = duration(stretch);
    double speed = duration > 0 ? Math.hypot(end.x - begin.x, end.y - begin.y) / duration : 0;
    double sigma = Math.hypot(spread.scatter, speed * CLOCKS);
    return new Difference(spread.x, spread.y, Math.max(sigma, CameraNoise.FLOOR));
  }

  private static Spread spread(List<Comparison> stretch) {
    double x = median(stretch.stream().mapToDouble(c -> c.dx).toArray());
    double y = median(stretch.stream().mapToDouble(c -> c.dy).toArray());
    double scatter =
        RobustScale.ofSquaredDistances(
            stretch.stream()
                .mapToDouble(c -> (c.dx - x) * (c.dx - x) + (c.dy - y) * (c.dy - y))
                .toArray());
    return new Spread(x, y, scatter);
  }

  /** Sorts the values. */
  private static double median(double[] values) {
    Arrays.sort(values);
    return values[values.length / 2];
  }
}
