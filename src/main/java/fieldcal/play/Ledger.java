package fieldcal.play;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import java.util.stream.Collectors;

/** Counts the kicks, and asks for the next one when the last has been made. */
final class Ledger {
  /** Time to charge the kicker after a failed kick, s; longer after several. Other failures need no pause. */
  private static final double CHARGE = 1;

  private static final int MOST_CHARGES = 4;

  /** So many kicks in a row that a robot was commanded and that did not happen are told. */
  private static final int TOLD_MISFIRES = 2;

  private final int wanted;
  private boolean concluded;
  private final KickChooser chooser;
  private final Consumer<PlayedKick> listener;
  private final int maxAttempts;
  private final Map<Integer, PlannedKick> unjudged = new HashMap<>();
  private final Map<Integer, Judged> judged = new HashMap<>();
  private PlannedKick next;
  private int made;
  private int good;
  private int bad;
  private int failures;
  private final List<Misfires> misfires = List.of(new Misfires(), new Misfires());
  private final Set<String> remarks = new LinkedHashSet<>();
  private int notFetched;
  private final int[] losses = new int[2];
  private final int[] pushedLosses = new int[2];
  private int carrier = -1;
  private String lastFailure = "";
  private String lastReason = "";

  /** Kicks of one robot that were commanded and did not happen, since its last one that did. */
  private static final class Misfires {
    private int count;
    private double last = Double.NEGATIVE_INFINITY;
    private String reason = "";
  }

  /** A kick and whether it counts, so far. */
  private record Judged(PlannedKick kick, boolean counts, String reason) {}

  Ledger(PlayPlan plan, KickChooser chooser, Consumer<PlayedKick> listener) {
    wanted = plan.kicks();
    maxAttempts = plan.limits().maxAttempts();
    this.chooser = chooser;
    this.listener = listener;
  }

  /** No more kicks are wanted. */
  void conclude() {
    concluded = true;
  }

  /** Whether enough kicks are made, if those that are being fitted turn out well. */
  boolean enough() {
    return concluded || good + unjudged.size() >= wanted;
  }

  boolean complete() {
    return concluded || good >= wanted;
  }

  /** The kick that is due; preferably one that can be made from where the ball lies. */
  PlannedKick next(Situation s) {
    if (next == null) {
      BallMemory ball = s.ball();
      double x = ball.x();
      double y = ball.y();
      next =
          ball.known()
              ? chooser.next(
                  x, y, kick -> Decider.withoutCarrying(s, kick, x, y, pushing(s)).isPresent())
              : chooser.next(Double.NaN, Double.NaN);
    }
    return next;
  }

  Optional<PlannedKick> pending() {
    return Optional.ofNullable(next);
  }

  /** The number of a kick that a robot has just made. */
  int takeNumber(int kicker) {
    made++;
    failures = 0;
    misfires.get(kicker).count = 0;
    notFetched = 0;
    lastReason = "";
    return made;
  }

  /** The ball of a kick is no longer left alone. */
  void made(PlayedKick kick) {
    unjudged.put(kick.number(), kick.planned());
    next = null;
    listener.accept(kick);
  }

  /** Whether a kick counts; one that does not, perhaps because its ball left the images of all cameras. */
  void judge(int number, boolean counts, String reason, boolean outOfView) {
    PlannedKick kick = unjudged.remove(number);
    if (kick != null) {
      count(counts, 1);
      judged.put(number, new Judged(kick, counts, reason));
      tellChooser(kick, counts, outOfView);
      return;
    }
    Judged before = judged.get(number);
    if (before == null) {
      return;
    }
    judged.put(number, new Judged(before.kick(), counts, reason));
    if (before.counts() != counts) {
      count(!counts, -1);
      count(counts, 1);
      if (!counts) {
        tellChooser(before.kick(), false, outOfView);
      }
    }
  }

  private void tellChooser(PlannedKick kick, boolean counts, boolean outOfView) {
    if (!counts && outOfView) {
      chooser.outOfView(kick);
    } else {
      chooser.done(kick, counts);
    }
  }

  private void count(boolean counts, int by) {
    good += counts ? by : 0;
    bad += counts ? 0 : by;
  }

  void failed(String reason) {
    failures++;
    lastFailure = reason;
    lastReason = reason;
  }

  /** A kicker fired, but the ball was not kicked. Once may be chance; what happens again the operator must hear of. */
  void misfired(int kicker, String reason, double time) {
    failed(reason);
    Misfires its = misfires.get(kicker);
    its.count++;
    its.last = time;
    its.reason = reason;
    if (its.count == TOLD_MISFIRES) {
      remarks.add(reason + ", twice in a row: check its kicker");
    }
  }

  /** What the operator must hear of at once, in the order in which it came up. */
  List<String> remarks() {
    return List.copyOf(remarks);
  }

  /** A robot failed to take the ball. */
  void notFetched() {
    notFetched++;
  }

  /** The ball moved away before a robot reached it. */
  void movedAway(String reason) {
    notFetched++;
    lastReason = reason;
  }

  /** A robot had the ball and lost it on the way; perhaps while it pushed it straight ahead. */
  void lost(int robot, boolean pushed, String reason) {
    losses[robot]++;
    pushedLosses[robot] += pushed ? 1 : 0;
    notFetched++;
    lastReason = reason;
  }

  /** A robot has the ball at its dribbler, where it may hide it; -1 when none has. */
  void carries(int robot) {
    carrier = robot;
  }

  /** The robot that had the ball when it was seen last; -1 when none had. */
  int carrier() {
    return carrier;
  }

  /** How a robot is to drive with the ball. What happened to one robot will happen to the other, too: robots that play together are mostly of the same design. */
  Grip grip(int robot, boolean pushes, PlayLimits limits) {
    int known = Math.max(losses[robot], Math.min(1, losses[1 - robot]));
    return Grip.after(known, pushes ? pushedLosses[robot] : known, limits);
  }

  /** How each robot is to push the ball, by its index. */
  IntFunction<Grip> pushing(Situation s) {
    return i -> grip(i, true, s.limits());
  }

  /** Remembers why something failed that was not a kick. */
  void remember(String reason) {
    lastReason = reason;
  }

  /** Why the last attempt failed; empty when nothing has failed since the last kick. */
  String lastReason() {
    return lastReason;
  }

  /** The ball was placed somewhere else. */
  void helped() {
    notFetched = 0;
  }

  /** How often the ball could not be taken since the last kick, or since somebody placed it. */
  int timesNotFetched() {
    return notFetched;
  }

  /** Why it makes no sense to go on, if so. */
  Optional<String> hopeless() {
    if (failures >= maxAttempts) {
      return Optional.of(failures + " failed kicks in a row; the last: " + lastFailure);
    }
    if (bad > 2 * wanted + maxAttempts) {
      return Optional.of(
          String.format(
              Locale.ROOT,
              "only %d of %d kicks could be used%s",
              good,
              good + bad,
              mostFrequentReason()));
    }
    return Optional.empty();
  }

  /** The most frequent reason why kicks do not count, and how many have it; empty when no reason was given. */
  private String mostFrequentReason() {
    Map<String, Long> reasons =
        judged.values().stream()
            .filter(j -> !j.counts() && !j.reason().isEmpty())
            .collect(Collectors.groupingBy(Judged::reason, TreeMap::new, Collectors.counting()));
    return reasons.entrySet().stream()
        .max(Map.Entry.comparingByValue())
        .map(
            e ->
                String.format(
                    Locale.ROOT,
                    "; the most frequent reason, %d times: %s",
                    e.getValue(),
                    e.getKey()))
        .orElse("");
  }

  /** Why a robot may still be charging its kicker: it fired without a kick. It charges while other things are done. Empty when it is ready. */
  Optional<String> charges(int kicker, double time) {
    Misfires its = misfires.get(kicker);
    boolean charges = time - its.last < CHARGE * Math.min(MOST_CHARGES, its.count);
    return charges ? Optional.of(its.reason) : Optional.empty();
  }

  int good() {
    return good;
  }

  int made() {
    return made;
  }

  int unjudged() {
    return unjudged.size();
  }

  /** How many kicks are to count; once no more are wanted, those that do. */
  int wanted() {
    return concluded ? good : wanted;
  }
}
