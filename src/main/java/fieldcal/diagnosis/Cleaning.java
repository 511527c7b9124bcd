package fieldcal.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Leaves out what is no free ball although it was taken for one: the first moments of a rest when the ball was still being placed, the last ones of a flight when a robot had touched it already, a kick
 * whose ball hit something. They stand out only where everything else is explained.
 */
final class Cleaning {
  /** A block at a kick's begin or end that far off, in variances of noise, while the kick's others are not, is none of its flight. */
  private static final double OFF = 30;

  /** What half of a kick's blocks must stay below. */
  private static final double FINE = 4;

  /** A kick that many times worse than its fellows has another ball, or one that hit something. */
  private static final double WORSE = 3;

  /** At most that share of the kicks is left out: more would be a finding. */
  private static final double MOST = 0.1;

  /** The others count as explained below that many variances of noise. */
  private static final double EXPLAINED = 1.6;

  /** No robot touches a ball for longer before the kick is seen to end; and for so long a ball rests at least before it is kicked, s. */
  private static final double LONGEST = 0.2;

  /** The blocks of a kick's flight that are together farther off than that, in standard deviations of noise, are not explained. */
  private static final double FLIGHT_EXPLAINED = 3;

  private Cleaning() {}

  /**
   * The kicks without what is no free flight at their ends; the same list when it is the same detections as before. What was left out in the light of a worse explanation comes back: a ball that
   * curves, for one whose model is straight, seems to rest elsewhere than it does.
   */
  static List<KickData> ends(HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    boolean[] pushed = pushed(fitter, at, state);
    List<KickData> kept = new ArrayList<>();
    boolean changed = false;
    for (int k = 0; k < fitter.kicks.size(); k++) {
      KickData data = fitter.kicks.get(k);
      // One that was cut is fitted as a whole again, or what was left out would look wrong because
      // it was.
      boolean cut = data.usedCount < data.whole.usedCount;
      double[] residuals = residuals(fitter, at, state, k, data.whole, cut);
      boolean[] dropped = ends(data.whole, residuals, lastUsed(data));
      if (pushed[k]) {
        drop(data, Double.NEGATIVE_INFINITY, data.kick.time(), dropped);
      }
      KickData now = data.whole.without(dropped);
      boolean same = Arrays.equals(now.used, data.used);
      changed |= !same;
      kept.add(same ? data : now);
    }
    return changed ? kept : fitter.kicks;
  }

  /**
   * The few kicks whose ball was moved between its rest and the kick, most often by the robot that then kicked it: the flight alone is explained, but does not lead from where the ball lay. If they are more, that is
   * what is to be explained: with place and time of the kick free, its spin would be hidden.
   */
  private static boolean[] pushed(HypothesisFitter fitter, FittedHypothesis at, SharedState state) {
    boolean[] pushed = new boolean[fitter.kicks.size()];
    int count = 0;
    for (int k = 0; k < pushed.length; k++) {
      pushed[k] = fitter.kicks.get(k).whole.fromRest && wasPushed(fitter, at, state, k);
      count += pushed[k] ? 1 : 0;
    }
    return count <= Math.max(1, MOST * pushed.length) ? pushed : new boolean[pushed.length];
  }

  private static boolean wasPushed(
      HypothesisFitter fitter, FittedHypothesis at, SharedState state, int k) {
    KickData data = fitter.kicks.get(k);
    boolean[] dropped = new boolean[data.size];
    drop(data, Math.nextUp(lastUsed(data)), Double.POSITIVE_INFINITY, dropped);
    // One that was found to be pushed before is looked at with its rest again.
    KickData rested = data.fromRest ? data : data.whole.without(dropped);
    double[] off = off(rested, residuals(fitter, at, state, k, rested, !data.fromRest));
    if (Arrays.stream(off).max().orElse(0) < OFF) {
      return false;
    }
    drop(data, Double.NEGATIVE_INFINITY, data.kick.time(), dropped);
    KickData flight = data.whole.without(dropped);
    double[] inFlight = off(flight, residuals(fitter, at, state, k, flight, true));
    // Of noise alone the sum of two squares less two has a standard deviation of two.
    return Arrays.stream(inFlight).sum() < FLIGHT_EXPLAINED * 2 * Math.sqrt(inFlight.length);
  }

  private static double[] off(KickData data, double[] residuals) {
    return Structure.blocks(data).stream().mapToDouble(b -> off(b, residuals)).toArray();
  }

  /** Whether two looks are at the same kicks, of the same kinds, whatever detections of them count. */
  static boolean sameKicks(List<KickData> a, List<KickData> b) {
    boolean same = a.size() == b.size();
    for (int k = 0; same && k < a.size(); k++) {
      same = a.get(k).isSame(b.get(k));
    }
    return same;
  }

  /** Whether two looks at the same kicks left the same detections. */
  static boolean sameDetections(List<KickData> a, List<KickData> b) {
    for (int k = 0; k < a.size(); k++) {
      if (!Arrays.equals(a.get(k).used, b.get(k).used)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Residuals of a kick, or of what is looked at of it.
   *
   * @param some of its detections
   * @param anew whether its own unknowns are fitted to these first; else they stay as they are
   */
  private static double[] residuals(
      HypothesisFitter fitter,
      FittedHypothesis at,
      SharedState state,
      int k,
      KickData some,
      boolean anew) {
    KickModel model = new KickModel(some, at.hypothesis().random().size(), fitter.sessionStart);
    model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
    if (anew) {
      new OwnFit(model, state, at.scatter()).minimize();
    }
    double[] residuals = new double[2 * some.size];
    model.residuals(state, model.path(state, model.own), residuals);
    return residuals;
  }

  /** Variance of a kick's residuals under a fit, in variances of noise. */
  static double variance(HypothesisFitter fitter, FittedHypothesis at, SharedState state, int k) {
    KickData data = fitter.kicks.get(k);
    double[] r = residuals(fitter, at, state, k, data, false);
    return KickNormal.dot(r, r) / (2.0 * data.usedCount);
  }

  /** The kicks without those that stand out while the others are explained; the same list when there are none. */
  static List<KickData> kicks(HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    int n = fitter.kicks.size();
    double[] reduced = new double[n];
    for (int k = 0; k < n; k++) {
      reduced[k] = variance(fitter, at, state, k);
    }
    double[] sorted = reduced.clone();
    Arrays.sort(sorted);
    double median = sorted[n / 2];
    List<KickData> good = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      if (reduced[k] <= WORSE * Math.max(1, median)) {
        good.add(fitter.kicks.get(k));
      }
    }
    boolean few = n - good.size() <= Math.max(1, MOST * n);
    return good.size() < n && few && median < EXPLAINED ? good : fitter.kicks;
  }

  private static double lastUsed(KickData data) {
    int i = data.size - 1;
    while (i > 0 && !data.used[i]) {
      i--;
    }
    return data.time[i];
  }

  private static boolean[] ends(KickData data, double[] r, double end) {
    boolean[] dropped = new boolean[data.size];
    List<int[]> blocks = new ArrayList<>(Structure.blocks(data));
    blocks.sort((a, b) -> Double.compare(data.time[a[0]], data.time[b[0]]));
    double[] off = blocks.stream().mapToDouble(b -> off(b, r)).toArray();
    double[] sorted = off.clone();
    Arrays.sort(sorted);
    if (sorted.length < 6 || sorted[sorted.length / 2] > FINE) {
      return dropped;
    }
    // Blocks of several cameras lie side by side: two in a row that are fine end the search.
    dropTouched(data, blocks, off, end, dropped);
    for (int[] block : blocks) {
      if (wasPlaced(data, block, r)) {
        drop(data, Double.NEGATIVE_INFINITY, data.time[block[block.length - 1]], dropped);
      }
    }
    return dropped;
  }

  /** Whether the ball lay elsewhere then than just before the kick. The resting ball alone tells, since a wrong model of the flight makes a good rest look wrong. */
  private static boolean wasPlaced(KickData data, int[] block, double[] r) {
    double kickTime = data.kick.time();
    double[] rest = new double[2];
    int n = 0;
    for (int i = 0; i < data.size; i++) {
      if (data.used[i]
          && data.camera[i] == data.camera[block[0]]
          && data.time[i] < kickTime
          && data.time[i] > kickTime - LONGEST) {
        rest[0] += r[2 * i];
        rest[1] += r[2 * i + 1];
        n++;
      }
    }
    if (n < KickData.LEAST_REST || data.time[block[block.length - 1]] > kickTime - LONGEST) {
      return false;
    }
    double s1 = 0;
    double s2 = 0;
    for (int i : block) {
      s1 += r[2 * i] - rest[0] / n;
      s2 += r[2 * i + 1] - rest[1] / n;
    }
    return (s1 * s1 + s2 * s2) / block.length / (1 + block.length / (double) n) - 2 > OFF;
  }

  private static void drop(KickData data, double from, double to, boolean[] dropped) {
    for (int i = 0; i < data.size; i++) {
      dropped[i] |= data.time[i] >= from && data.time[i] <= to;
    }
  }

  /**
   * @param end of what was free flight so far, s: an earlier look may have cut some, and seen through that there is more
   */
  private static void dropTouched(
      KickData data, List<int[]> blocks, double[] off, double end, boolean[] dropped) {
    int fine = 0;
    int last = -1;
    for (int b = off.length - 1; b >= off.length * 2 / 3 && fine < 3; b--) {
      if (data.time[blocks.get(b)[0]] < end - LONGEST) {
        break;
      }
      if (off[b] > OFF) {
        last = b;
        fine = 0;
      } else {
        fine++;
      }
    }
    if (last >= 0) {
      drop(data, data.time[blocks.get(last)[0]], Double.POSITIVE_INFINITY, dropped);
    }
  }

  private static double off(int[] block, double[] r) {
    double s1 = 0;
    double s2 = 0;
    for (int i : block) {
      s1 += r[2 * i];
      s2 += r[2 * i + 1];
    }
    return (s1 * s1 + s2 * s2) / block.length - 2;
  }
}
