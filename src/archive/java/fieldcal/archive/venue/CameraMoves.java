package fieldcal.archive.venue;

import fieldcal.app.wording.Amount;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.CombinatoricsUtils;

/**
 * Finds cameras that report everything elsewhere from some match on, among matches with the same calibrations.
 *
 * <p>The offsets of a match are relative to the mean of the cameras that share kicks in it. So when one of n cameras moves by d, its offset changes by d (n − 1)/n, and those of all others by −d/n;
 * and when one has no kicks in a match, the others seem to move. Therefore only cameras are compared that are known before and after, each with the mean of the others. Those moved that leave the others
 * in agreement, if they are fewer than half; else it is not known which.
 */
final class CameraMoves {
  /** A camera that was knocked: 5 standard errors, which one of a million comparisons reaches by chance … */
  private static final double CERTAIN = 5;

  /** … and more than good cameras disagree anyway, m. */
  private static final double SMALLEST_MOVE = 0.002;

  /** A camera is named when any other explanation is worse by so much in chi-square: the square of 3 standard errors. */
  private static final double CLEARLY_WORSE = 9;

  /** From match to match an offset differs by at least that much, m: a fifteenth of a good camera's noise. */
  private static final double SAME_OFFSET = 1e-4;

  /**
   * A camera that moved, or several of which it is not known which.
   *
   * @param last match before
   * @param next match after
   * @param camera id; empty when it is not known which
   * @param what in words
   * @param sigmas how many standard errors the move is
   */
  record Move(MatchFacts last, MatchFacts next, OptionalInt camera, String what, double sigmas) {}

  /** By how much a camera's offset changed from one stretch to the next; each axis with the error that it has if cameras err on their own. */
  private record Jump(int camera, Measured x, Measured y) {}

  /** The same relative to some other cameras, m. */
  private record Shift(int camera, double x, double y, double sigmas) {
    double length() {
      return Math.hypot(x, y);
    }

    boolean isCertain() {
      return length() > SMALLEST_MOVE && sigmas > CERTAIN;
    }
  }

  /** Which cameras may have moved, and the chi-square that is left if the others did not. */
  private record Explanation(List<Jump> moved, List<Jump> others, double disagreement) {}

  private final List<MatchFacts> matches;
  private final double[] days;
  private final List<Move> moves = new ArrayList<>();

  private CameraMoves(List<MatchFacts> matches) {
    this.matches = matches;
    days = VenueStudy.days(matches);
  }

  /**
   * Finds the moves.
   *
   * @param all matches with the same calibrations, by their start
   * @return by time
   */
  static List<Move> among(List<MatchFacts> all) {
    CameraMoves found =
        new CameraMoves(all.stream().filter(match -> known(match).size() > 1).toList());
    found.find();
    return found.moves;
  }

  private static List<Integer> known(MatchFacts match) {
    return match.cameras().stream()
        .filter(c -> c.offsetX().known() && c.offsetY().known())
        .map(CameraFacts::id)
        .sorted()
        .toList();
  }

  private void find() {
    List<Integer> ids =
        matches.stream().flatMap(match -> known(match).stream()).distinct().sorted().toList();
    List<Integer> always =
        ids.stream()
            .filter(id -> matches.stream().allMatch(match -> known(match).contains(id)))
            .toList();
    // Where hardly one camera is always there, a cut may come from who is missing: it shows no move
    // below.
    ChangeFinder finder = finder(ids, always.size() > 1 ? always : List.of());
    List<Integer> cuts = matches.isEmpty() ? List.of() : finder.find();
    for (int k = 0; k < cuts.size(); k++) {
      int begin = k == 0 ? 0 : cuts.get(k - 1);
      int end = k + 1 < cuts.size() ? cuts.get(k + 1) : matches.size();
      compare(begin, cuts.get(k), end);
    }
  }

  /** Of the offsets of cameras along x and y in turn, relative to the mean of some of them. */
  private ChangeFinder finder(List<Integer> ids, List<Integer> to) {
    List<Measured[]> series = new ArrayList<>();
    for (int id : ids) {
      series.add(matches.stream().map(m -> offset(m, id, true, to)).toArray(Measured[]::new));
      series.add(matches.stream().map(m -> offset(m, id, false, to)).toArray(Measured[]::new));
    }
    double[] smallest = new double[series.size()];
    Arrays.fill(smallest, SAME_OFFSET);
    return new ChangeFinder(days, series, smallest);
  }

  /** Null where the camera, or one of those that it is compared with, is not known. */
  private static Measured offset(MatchFacts match, int id, boolean x, List<Integer> to) {
    if (!known(match).contains(id) || !known(match).containsAll(to)) {
      return null;
    }
    double mean = to.stream().mapToDouble(c -> offset(match, c, x).value()).average().orElse(0);
    Measured own = offset(match, id, x);
    return new Measured(own.value() - mean, own.error());
  }

  private static Measured offset(MatchFacts match, int id, boolean x) {
    CameraFacts camera =
        match.cameras().stream().filter(c -> c.id() == id).findFirst().orElseThrow();
    return x ? camera.offsetX() : camera.offsetY();
  }

  private void compare(int begin, int cut, int end) {
    List<Integer> common = common(begin, cut, end);
    int n = common.size();
    if (n < 2) {
      return;
    }
    ChangeFinder finder = finder(common, common);
    // The error of an offset from the mean of n is smaller by this than that of the camera.
    double ownError = Math.sqrt(n / (n - 1.0));
    List<Jump> jumps = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      Measured[] axes = new Measured[2];
      for (int axis = 0; axis < 2; axis++) {
        Measured was = finder.line(2 * i + axis, begin, cut).at(finder.between(cut));
        Measured is = finder.line(2 * i + axis, cut, end).at(finder.between(cut));
        axes[axis] =
            new Measured(is.value() - was.value(), ownError * Math.hypot(was.error(), is.error()));
      }
      jumps.add(new Jump(common.get(i), axes[0], axes[1]));
    }
    judge(jumps, matches.get(cut - 1), matches.get(cut));
  }

  /** Cameras that are known in half of the matches on either side at least; fewer, where no match on a side knows all of these. */
  private List<Integer> common(int begin, int cut, int end) {
    List<Integer> common = new ArrayList<>();
    IntStream.range(begin, end)
        .boxed()
        .flatMap(i -> known(matches.get(i)).stream())
        .distinct()
        .sorted()
        .filter(id -> 2 * count(begin, cut, List.of(id)) >= cut - begin)
        .filter(id -> 2 * count(cut, end, List.of(id)) >= end - cut)
        .forEach(common::add);
    while (common.size() > 1 && (count(begin, cut, common) == 0 || count(cut, end, common) == 0)) {
      common.remove(
          common.stream()
              .min(Comparator.comparingLong((Integer id) -> count(begin, end, List.of(id))))
              .orElseThrow());
    }
    return common;
  }

  /** How many matches know all of some cameras. */
  private long count(int begin, int end, Collection<Integer> cameras) {
    return matches.subList(begin, end).stream()
        .filter(match -> known(match).containsAll(cameras))
        .count();
  }

  private void judge(List<Jump> jumps, MatchFacts last, MatchFacts next) {
    int n = jumps.size();
    if (agree(jumps)) {
      return;
    }
    for (int size = 1; 2 * size < n; size++) {
      List<Explanation> all = explanations(jumps, size);
      Explanation best = all.get(0);
      if (agree(best.others)) {
        double limit = best.disagreement + CLEARLY_WORSE;
        List<Explanation> likely = all.stream().filter(e -> e.disagreement <= limit).toList();
        if (likely.size() == 1) {
          best.moved.forEach(jump -> name(shift(jump, best.others), last, next));
        } else {
          List<Jump> possible =
              jumps.stream()
                  .filter(jump -> likely.stream().anyMatch(e -> e.moved.contains(jump)))
                  .toList();
          nameOneOf(possible, jumps, last, next);
        }
        return;
      }
    }
    List<Jump> differing =
        jumps.stream().filter(jump -> shift(jump, without(jumps, jump)).isCertain()).toList();
    nameOneOf(differing.size() > 1 ? differing : jumps, jumps, last, next);
  }

  /** All choices of so many cameras that moved, the one first that leaves the others most in agreement. */
  private static List<Explanation> explanations(List<Jump> jumps, int size) {
    List<Explanation> all = new ArrayList<>();
    CombinatoricsUtils.combinationsIterator(jumps.size(), size)
        .forEachRemaining(
            chosen -> {
              List<Jump> moved = Arrays.stream(chosen).mapToObj(jumps::get).toList();
              List<Jump> others = jumps.stream().filter(jump -> !moved.contains(jump)).toList();
              all.add(new Explanation(moved, others, disagreement(others)));
            });
    all.sort(Comparator.comparingDouble(Explanation::disagreement));
    return all;
  }

  private static List<Jump> without(List<Jump> jumps, Jump jump) {
    return jumps.stream().filter(other -> other != jump).toList();
  }

  /** Whether none of the cameras moved relative to the others. */
  private static boolean agree(List<Jump> jumps) {
    return jumps.stream().noneMatch(jump -> shift(jump, without(jumps, jump)).isCertain());
  }

  /** Chi-square of the hypothesis that all of them moved together, or not at all. */
  private static double disagreement(List<Jump> jumps) {
    return disagreementOf(jumps.stream().map(Jump::x).toList())
        + disagreementOf(jumps.stream().map(Jump::y).toList());
  }

  private static double disagreementOf(List<Measured> values) {
    Measured mean = mean(values);
    return values.stream()
        .mapToDouble(v -> Math.pow((v.value() - mean.value()) / v.error(), 2))
        .sum();
  }

  private static Measured mean(List<Measured> values) {
    double weights = values.stream().mapToDouble(v -> Math.pow(v.error(), -2)).sum();
    double sum = values.stream().mapToDouble(v -> v.value() * Math.pow(v.error(), -2)).sum();
    return new Measured(sum / weights, 1 / Math.sqrt(weights));
  }

  private static Shift shift(Jump jump, List<Jump> others) {
    Measured x = mean(others.stream().map(Jump::x).toList());
    Measured y = mean(others.stream().map(Jump::y).toList());
    double dx = jump.x().value() - x.value();
    double dy = jump.y().value() - y.value();
    double sigmas =
        Math.hypot(
            dx / Math.hypot(jump.x().error(), x.error()),
            dy / Math.hypot(jump.y().error(), y.error()));
    return new Shift(jump.camera(), dx, dy, sigmas);
  }

  private void name(Shift shift, MatchFacts last, MatchFacts next) {
    String what =
        String.format(
            Locale.ROOT,
            "camera %d reports everything shifted by %+.1f mm in x and %+.1f mm in y",
            shift.camera(),
            1000 * shift.x(),
            1000 * shift.y());
    moves.add(
        new Move(last, next, OptionalInt.of(shift.camera()), Amount.minus(what), shift.sigmas()));
  }

  private void nameOneOf(List<Jump> possible, List<Jump> all, MatchFacts last, MatchFacts next) {
    List<Shift> shifts = possible.stream().map(jump -> shift(jump, without(all, jump))).toList();
    Shift largest = shifts.stream().max(Comparator.comparingDouble(Shift::length)).orElseThrow();
    String cameras =
        possible.stream()
            .limit(possible.size() - 1)
            .map(jump -> Integer.toString(jump.camera()))
            .collect(Collectors.joining(", "));
    String what =
        String.format(
            Locale.ROOT,
            "one or more of the cameras %s and %d report everything shifted, by up to %.1f mm"
                + " relative to the others",
            cameras,
            possible.get(possible.size() - 1).camera(),
            1000 * largest.length());
    moves.add(new Move(last, next, OptionalInt.empty(), what, largest.sigmas()));
  }
}
