package fieldcal.diagnosis;

import fieldcal.kick.KickKind;
import java.util.List;

/**
 * How much of the residuals is no noise. Noise differs from one detection to the next, what a wrong model makes of them does not: so the sums over blocks of successive detections of one
 * camera are compared with what independent residuals would give. Needs no model of what is wrong.
 *
 * @param systematic mean square of the systematic part, in variances of the noise; may be negative by chance
 * @param deviation the same in standard deviations of what noise alone gives
 * @param blocks how many sums were compared
 */
record Structure(double systematic, double deviation, int blocks) {
  /** Detections of a block: a tenth of a second. Longer blocks would miss what changes fast, shorter ones see less of what does not. */
  static final int BLOCK = 8;

  /** More of that, in standard deviations, is no chance. */
  static final double SIGNIFICANT = 6;

  /** Less of that leaves nothing to be explained. */
  private static final double NOTHING = 3;

  static Structure of(HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    double sum = 0;
    int blocks = 0;
    int residuals = 0;
    double unknowns = 0;
    for (boolean f : fitter.unknowns(at.hypothesis()).free) {
      unknowns += f ? 1 : 0;
    }
    for (int k = 0; k < fitter.kicks.size(); k++) {
      KickData data = fitter.kicks.get(k);
      KickModel model = new KickModel(data, at.hypothesis().random().size(), fitter.sessionStart);
      model.startFrom(at.own().get(k), at.flights()[k], new double[0]);
      double[] r = new double[2 * data.size];
      model.residuals(state, model.path(state, model.own), r);
      unknowns += KickData.ownSize(data.kind) + at.hypothesis().random().size();
      for (int[] block : blocks(data)) {
        double s1 = 0;
        double s2 = 0;
        for (int i : block) {
          s1 += r[2 * i];
          s2 += r[2 * i + 1];
        }
        sum += (s1 * s1 + s2 * s2) / block.length - 2;
        blocks += 2;
        residuals += 2 * block.length;
      }
    }
    double excess = sum + Math.min(unknowns, 0.5 * blocks);
    double spread = Math.sqrt(2 * Math.max(1, blocks - Math.min(unknowns, 0.5 * blocks)));
    return new Structure(excess / Math.max(1, residuals), excess / spread, blocks);
  }

  /** How much of what is no noise the kicks of one kind have, 0 to 1; 0 when theirs may be chance. */
  static double shareOf(KickKind kind, HypothesisFitter fitter, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), fitter.observers);
    double theirs = 0;
    double all = 0;
    double residuals = 0;
    for (int k = 0; k < fitter.kicks.size(); k++) {
      KickData data = fitter.kicks.get(k);
      double excess = 2.0 * data.usedCount * (Cleaning.variance(fitter, at, state, k) - 1);
      all += excess;
      if (data.kind == kind) {
        theirs += excess;
        residuals += 2.0 * data.usedCount;
      }
    }
    boolean chance = theirs <= SIGNIFICANT * Math.sqrt(2 * residuals);
    return chance ? 0 : Math.min(1, theirs / Math.max(theirs, all));
  }

  /** Indices of successive detections of one camera, rest and flight apart. */
  static List<int[]> blocks(KickData data) {
    List<int[]> found = new java.util.ArrayList<>();
    int[] cameras = data.kick.observations().cameras();
    for (int camera : cameras) {
      int[] block = new int[BLOCK];
      int n = 0;
      for (int i = 0; i < data.size; i++) {
        if (!data.used[i] || data.camera[i] != camera) {
          continue;
        }
        boolean breaks = n > 0 && data.time[i] - data.time[block[n - 1]] > 0.1;
        if (breaks) {
          add(found, block, n);
          n = 0;
        }
        block[n++] = i;
        if (n == BLOCK) {
          add(found, block, n);
          n = 0;
        }
      }
      add(found, block, n);
    }
    return found;
  }

  private static void add(List<int[]> found, int[] block, int n) {
    if (n >= BLOCK / 2) {
      found.add(java.util.Arrays.copyOf(block, n));
    }
  }

  /** Whether what is left is no more than noise would leave by chance, so that nothing need be looked for. */
  boolean isNothing() {
    return deviation < NOTHING;
  }

  boolean isSignificant() {
    return deviation > SIGNIFICANT;
  }
}
