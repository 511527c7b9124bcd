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
  private static final double WORSE = 6;

  /** At most that share of the kicks is left out: more would be a finding. */
  private static final double MOST = 0.1;

  private Cleaning() {}

  /** The cleaned kicks; the same list when nothing is to be cleaned. */
  static List<KickData> clean(HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    int n = fitter.kicks.size();
    double[] reduced = new double[n];
    List<KickData> kept = new ArrayList<>();
    boolean changed = false;
    for (int k = 0; k < n; k++) {
      KickData data = fitter.kicks.get(k);
      KickModel model = new KickModel(data, at.hypothesis().random().size(), fitter.sessionStart);
      model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
      double[] r = new double[2 * data.size];
      double sum = model.residuals(state, model.path(state, model.own), r);
      reduced[k] = sum / (2.0 * data.usedCount);
      boolean[] dropped = ends(data, r);
      boolean any = false;
      for (boolean d : dropped) {
        any |= d;
      }
      changed |= any;
      kept.add(any ? data.without(dropped) : data);
    }
    double[] sorted = reduced.clone();
    Arrays.sort(sorted);
    double limit = WORSE * Math.max(1, sorted[n / 2]);
    List<KickData> good = new ArrayList<>();
    for (int k = 0; k < n; k++) {
      if (reduced[k] <= limit || kept.get(k) != fitter.kicks.get(k)) {
        good.add(kept.get(k));
      }
    }
    if (n - good.size() > MOST * n) {
      good = kept;
    }
    return changed || good.size() < n ? good : fitter.kicks;
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
    for (int j = 0; j < off.length / 3 && fine < 3; j++) {
      int b = fromEnd ? off.length - 1 - j : j;
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
