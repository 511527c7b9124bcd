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

  /** No robot touches a ball for longer before the kick is seen to end, and no placing lasts longer into what looks like rest, s. */
  private static final double LONGEST = 0.2;

  private Cleaning() {}

  /** The kicks without what is no free flight at their ends; the same list when there is nothing of that kind. */
  static List<KickData> ends(HypothesisFitter fitter, FittedHypothesis at) {
    List<KickData> kept = new ArrayList<>();
    boolean changed = false;
    double[][] residuals = residuals(fitter, at);
    for (int k = 0; k < residuals.length; k++) {
      KickData data = fitter.kicks.get(k);
      boolean[] dropped = ends(data, residuals[k]);
      boolean any = false;
      for (boolean d : dropped) {
        any |= d;
      }
      changed |= any;
      kept.add(any ? data.without(dropped) : data);
    }
    return changed ? kept : fitter.kicks;
  }

  /** The kicks without those that stand out while the others are explained; the same list when there are none. */
  static List<KickData> kicks(HypothesisFitter fitter, FittedHypothesis at) {
    double[][] residuals = residuals(fitter, at);
    int n = residuals.length;
    double[] reduced = new double[n];
    for (int k = 0; k < n; k++) {
      reduced[k] =
          KickNormal.dot(residuals[k], residuals[k]) / (2.0 * fitter.kicks.get(k).usedCount);
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

  private static double[][] residuals(HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    double[][] all = new double[fitter.kicks.size()][];
    for (int k = 0; k < all.length; k++) {
      KickData data = fitter.kicks.get(k);
      KickModel model = new KickModel(data, at.hypothesis().random().size(), fitter.sessionStart);
      model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
      all[k] = new double[2 * data.size];
      model.residuals(state, model.path(state, model.own), all[k]);
    }
    return all;
  }

  private static boolean[] ends(KickData data, double[] r) {
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
    drop(data, blocks, off, dropped, true);
    drop(data, blocks, off, dropped, false);
    return dropped;
  }

  private static void drop(
      KickData data, List<int[]> blocks, double[] off, boolean[] dropped, boolean fromEnd) {
    int fine = 0;
    int last = -1;
    double begin = data.time[blocks.get(0)[0]];
    int[] latest = blocks.get(off.length - 1);
    double end = data.time[latest[latest.length - 1]];
    for (int j = 0; j < off.length / 3 && fine < 3; j++) {
      int b = fromEnd ? off.length - 1 - j : j;
      double at = data.time[blocks.get(b)[0]];
      if (fromEnd ? at < end - LONGEST : at > begin + LONGEST) {
        break;
      }
      if (off[b] > OFF) {
        last = b;
        fine = 0;
      } else {
        fine++;
      }
    }
    if (last < 0) {
      return;
    }
    int[] block = blocks.get(last);
    double edge = fromEnd ? data.time[block[0]] : data.time[block[block.length - 1]];
    for (int i = 0; i < data.size; i++) {
      dropped[i] |= fromEnd ? data.time[i] >= edge : data.time[i] <= edge;
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
