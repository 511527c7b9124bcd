package fieldcal.diagnosis.validation;

import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.fit.CameraNoise;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import org.apache.commons.math3.stat.StatUtils;

/**
 * How much of the residuals is not noise. Noise changes from one detection to the next; the error of a wrong model does not. So the sums over blocks of successive detections of one camera are compared with those of independent
 * residuals whose successive differences are as large. This needs no model of what is wrong, nor of the noise, whose tails may be heavier than those of a normal distribution.
 *
 * @param systematic mean square of the systematic part, in variances of the noise; may be negative by chance
 * @param deviation the same in standard deviations of what noise alone gives
 * @param chiSquare the systematic part of the sum of all squares, in variances of the noise
 * @param negligible largest systematic part that does not matter, in variances of the noise
 */
public record Leftover(double systematic, double deviation, double chiSquare, double negligible) {
  /** Detections of a block: a tenth of a second. Longer blocks would miss what changes fast; shorter ones are less sensitive to what changes slowly. */
  private static final int BLOCK = 8;

  /** Detections of the shortest block: a camera that vibrates at 10 Hz swings back within a tenth of a second, so that the sums over longer blocks do not show it. */
  private static final int PAIR = 2;

  /** Longest gap within a block, s. */
  private static final double GAP = 0.1;

  /** A larger deviation, in standard deviations, is not due to chance. */
  private static final double SIGNIFICANT = 6;

  /** A systematic part below this share of the noise's variance, a fifth of the noise, does not matter; nor does one that is smaller than the error of any model, {@link CameraNoise#FLOOR}. */
  private static final double MATTERS = 0.04;

  /** The noise of each camera is known to about a per cent, its variance to two. */
  private static final double TOLERANCE = 0.02;

  /**
   * Measures.
   *
   * @param model fitted to all kicks
   * @return what it leaves
   */
  public static Leftover of(FittedModel model) {
    return of(model, model.solution().reducedChiSquare(), record -> record);
  }

  /**
   * Measures against the noise of the cameras, also where the kicks were given more.
   *
   * @param model fitted to all kicks
   * @return what it leaves
   */
  public static Leftover ofSeen(FittedModel model) {
    return of(model, model.reducedAsSeen(), KickRecord::asSeen);
  }

  /**
   * What the noise that kicks were given beyond that of the cameras conceals, if they all conceal as much as most of them do: a few kicks that something happened to
   * conceal nothing that a model lacks.
   *
   * @param model fitted to all kicks
   * @return the part of the sum of all squares, in the units in which the model was fitted; 0 where most kicks have the noise of the cameras alone
   */
  public static double concealed(FittedModel model) {
    int kicks = model.kickCount();
    double[] of = new double[kicks];
    for (int k = 0; k < kicks; k++) {
      double times = model.kick(k).record().timesNoise();
      double noise = model.kick(k).rows() / (times * times);
      of[k] = times > 1 ? Math.max(0, model.solution().chiSquare(k) - noise) : 0;
    }
    return kicks == 0 ? 0 : kicks * StatUtils.percentile(of, 50);
  }

  private static Leftover of(FittedModel model, double reduced, UnaryOperator<KickRecord> noisy) {
    ModelState state = model.solution().state();
    double unknowns = model.model().globals().stream().filter(p -> p.estimated()).count();
    Sums slow = new Sums(BLOCK);
    Sums fast = new Sums(PAIR);
    for (int k = 0; k < model.kickCount(); k++) {
      EffectKick term = model.kick(k);
      KickRecord record = term.record();
      double[] own = model.solution().own(k);
      unknowns += own.length;
      double[] rx = new double[record.size()];
      double[] ry = new double[record.size()];
      term.plainResiduals(own, state, rx, ry);
      KickRecord against = noisy.apply(record);
      slow.add(against, rx, ry);
      fast.add(against, rx, ry);
    }
    // The systematic part of the blocks is at most all that is left beyond the noise. If nothing
    // is, neighbours are only alike.
    double noise = fast.noise();
    double all = Math.max(0, reduced - noise + TOLERANCE);
    Leftover ofBlocks = slow.leftover(unknowns, noise, all);
    Leftover ofPairs = fast.leftover(unknowns, noise, all);
    return ofPairs.deviation > ofBlocks.deviation ? ofPairs : ofBlocks;
  }

  /** Sums over blocks of one length. */
  private static final class Sums {
    private final int length;
    private final double[] r = new double[2];
    private double sum;
    private double floor;

    /** Sum of squared differences of successive residuals, each divided by its variance. */
    private double differences;

    private int differing;
    private int blocks;
    private int residuals;

    Sums(int length) {
      this.length = length;
    }

    void add(KickRecord record, double[] rx, double[] ry) {
      for (int[] block : blocks(record, length)) {
        double s1 = 0;
        double s2 = 0;
        double last1 = Double.NaN;
        double last2 = Double.NaN;
        for (int i : block) {
          record.whiten(i, rx[i], ry[i], r);
          s1 += r[0];
          s2 += r[1];
          if (!Double.isNaN(last1)) {
            double d1 = r[0] - last1;
            double d2 = r[1] - last2;
            differences += (d1 * d1 + d2 * d2) / record.varianceOfDifference();
            differing += 2;
          }
          last1 = r[0];
          last2 = r[1];
          record.whiten(i, CameraNoise.FLOOR, 0, r);
          floor += r[0] * r[0] + r[1] * r[1];
          record.whiten(i, 0, CameraNoise.FLOOR, r);
          floor += r[0] * r[0] + r[1] * r[1];
        }
        double root = record.rootOfSum(block.length);
        sum += (s1 * s1 + s2 * s2) / (root * root);
        blocks += 2;
        residuals += 2 * block.length;
      }
    }

    /** The variance of the noise, tails included, relative to the robust estimate of it, which does not include tails; at least 1. */
    double noise() {
      return Math.max(1, differences / Math.max(1, differing));
    }

    /**
     * What the sums show.
     *
     * @param unknowns how many numbers were fitted
     * @param noise variance of the noise, in units of what it is taken for
     * @param most largest systematic part, in variances of the noise
     */
    Leftover leftover(double unknowns, double noise, double most) {
      double lost = Math.min(unknowns, 0.5 * blocks);
      double excess = sum - noise * (blocks - lost);
      double spread = noise * Math.sqrt(2 * Math.max(1, blocks - lost));
      double share = Math.min(excess / Math.max(1, residuals), most);
      double negligible = Math.max(MATTERS, floor / Math.max(1, residuals));
      return new Leftover(share, excess / spread, share * residuals, negligible);
    }
  }

  /** Indices of successive detections of one camera. */
  private static List<int[]> blocks(KickRecord record, int length) {
    List<int[]> found = new ArrayList<>();
    boolean[] used = record.used();
    for (int camera : record.kick().observations().cameras()) {
      int[] block = new int[length];
      int n = 0;
      for (int i = 0; i < used.length; i++) {
        if (!used[i] || record.camera(i) != camera) {
          continue;
        }
        if (n == length || n > 0 && record.time(i) - record.time(block[n - 1]) > GAP) {
          add(found, block, n);
          n = 0;
        }
        block[n++] = i;
      }
      add(found, block, n);
    }
    return found;
  }

  private static void add(List<int[]> found, int[] block, int n) {
    if (n > 1 && n >= block.length / 2) {
      found.add(Arrays.copyOf(block, n));
    }
  }

  /**
   * Whether something is left that is not due to chance and that matters.
   *
   * @return true when it is
   */
  public boolean isSignificant() {
    return deviation > SIGNIFICANT && systematic > negligible;
  }
}
