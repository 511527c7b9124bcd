package fieldcal.verdict;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Sample;
import fieldcal.diagnosis.Verdict;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitStatistics;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The one rule that decides whether a model may be published.
 *
 * <p>The residual that it compares with the noise is that of the joint fit, in which every kick may have values of its own about the model's ({@link fieldcal.fit.JointFitter}). It shows a law that is wrong within a kick. That kicks differ from each other shows in {@link Reason.MeanAgainstJoint} and {@link Reason.ManyExcluded}, and
 * is part of the standard errors; it alone holds no model back. Whether a single model follows all kicks, the diagnosis finds out, and its verdict ({@link Evidence#finding}) overrules a small residual.
 */
public final class VerdictRule {
  /** Fewest kicks for a mean: the scatter of fewer is known too badly to exclude values by it. */
  public static final int FEWEST_KICKS = 5;

  /** Largest standard error of a mean, percent of it; chosen, half of the difference that the live monitor warns of. */
  public static final double LARGEST_ERROR_PERCENT = 10;

  /** Mean and joint fit that are more standard errors apart than this differ by more than chance. */
  public static final double APART_SIGMAS = 3;

  /** A smaller difference between mean and joint fit does not matter, percent; chosen, a third of {@link #NOTABLE_PERCENT}. */
  public static final double APART_PERCENT = 1;

  /** Smaller differences from the published model are not worth changing it, percent; chosen: 3 % of accSlide moves a ball kicked at 6 m/s by less than the width of a robot. */
  public static final double NOTABLE_PERCENT = 3;

  /** A difference from the published model within this many standard errors of the mean may be chance. */
  private static final double NOTABLE_SIGMAS = 3;

  /**
   * Residuals of more than this many times the noise on the resting ball are far above it. Good fits reach 1.9: ten matches of 2026 have 0.7 mm on the resting ball and 1.3 mm RMS
   * (Immortals-Robotics/Simulator, docs/calibration).
   */
  public static final double FAR_ABOVE_NOISE = 2;

  /**
   * A larger share of excluded values is more than outliers. Of normally distributed values the 2σ rule excludes 5 to 8 %; with at least {@link #FEWEST_EXCLUDED} excluded, a larger share than
   * this is chance in less than one of a hundred parameters (simulated: 8,000 draws each of 10 to 40 values, excluded until none is; 0.0004 to 0.008).
   */
  private static final double MOST_EXCLUDED = 1 / 3.0;

  /** Fewer excluded values may be kicks that went wrong. */
  private static final int FEWEST_EXCLUDED = 4;

  /** A part of the chips that do not fly may be topped shots; from this share on the kicks are of the other kind. */
  private static final double MOST_FLAT_CHIPS = 0.5;

  private final Evidence evidence;
  private final Calibration calibration;
  private final List<Reason> reasons = new ArrayList<>();

  private VerdictRule(Evidence evidence) {
    this.evidence = evidence;
    calibration = evidence.calibration();
  }

  /**
   * Judges a calibration.
   *
   * @param evidence all that is known
   * @return the verdict with its reasons
   */
  public static PublishVerdict judge(Evidence evidence) {
    return new VerdictRule(evidence).judge();
  }

  /**
   * Whether a mean differs from a published value by more than chance, and by enough to matter.
   *
   * @param mean in the parameter's unit
   * @param standardError of the mean; NaN if unknown
   * @param published value in the same unit
   * @return false also when there is nothing to compare with
   */
  public static boolean differs(double mean, double standardError, double published) {
    double sigmas = Math.abs(mean - published) / standardError;
    return Math.abs(percent(mean, published)) >= NOTABLE_PERCENT && !(sigmas < NOTABLE_SIGMAS);
  }

  /** How far a mean is from a published value, percent of that; NaN if it is zero or unknown. */
  private static double percent(double mean, double published) {
    return published == 0 ? Double.NaN : (mean / published - 1) * 100;
  }

  private PublishVerdict judge() {
    // These come first, because they may cause what else is wrong.
    evidence.surroundings().faults().forEach(f -> reasons.add(new Reason.FaultyVision(f)));
    boolean enough = false;
    for (KickKind kind : KickKind.values()) {
      if (calibration.tells(kind)) {
        enough |= judge(kind);
      }
    }
    if (calibration.kicks().stream().noneMatch(CalibratedKick::selected)) {
      reasons.add(new Reason.NoKicks(calibration.kicks().size()));
      enough = false;
    }
    recordings();
    boolean explained = diagnosis();
    if (enough) {
      fit(explained);
    }
    boolean suspicious =
        reasons.stream()
            .anyMatch(
                r ->
                    r instanceof Reason.MeanAgainstJoint
                        || r instanceof Reason.ManyExcluded
                        || r instanceof Reason.ResidualAboveNoise);
    boolean diagnosed = evidence.finding().isPresent() || !evidence.effects().isEmpty();
    boolean misled = reasons.stream().anyMatch(r -> r instanceof Reason.ForcedKind);
    return PublishVerdict.of(reasons, suspicious && !diagnosed && !misled);
  }

  /** Judges one model; false when it has too few kicks to find out whether it holds for all of them. */
  private boolean judge(KickKind kind) {
    boolean flat = kind == KickKind.FLAT;
    if (!flat && areNoChips()) {
      return false;
    }
    List<Parameter> published =
        flat
            ? evidence.published().flat().map(FlatModel::parameters).orElse(List.of())
            : evidence.published().chip().map(ChipModel::parameters).orElse(List.of());
    Map<String, Average> averages = flat ? calibration.flat() : calibration.chip();
    boolean differs = false;
    boolean enough = false;
    for (Map.Entry<String, Average> entry : averages.entrySet()) {
      Average mean = entry.getValue();
      enough |= mean.n() >= FEWEST_KICKS;
      judge(kind, entry.getKey(), mean);
      excluded(kind, entry.getKey());
      for (Parameter p : published) {
        if (p.name().equals(entry.getKey())
            && differs(mean.mean(), mean.standardError(), p.value())) {
          differs = true;
          reasons.add(
              new Reason.DiffersFromPublished(kind, p.name(), percent(mean.mean(), p.value())));
        }
      }
    }
    if (published.isEmpty()) {
      reasons.add(new Reason.NothingPublished(kind));
    } else if (!differs && averages.values().stream().allMatch(a -> a.n() > 0)) {
      reasons.add(new Reason.AgreesWithPublished(kind));
    }
    return enough;
  }

  private void judge(KickKind kind, String parameter, Average mean) {
    if (mean.n() < FEWEST_KICKS) {
      int kicks = calibration.kicks(kind).size();
      reasons.add(new Reason.FewKicks(kind, parameter, mean.n(), FEWEST_KICKS, kicks));
      return;
    }
    double percent = 100 * Math.abs(byChance(kind, parameter, mean) / mean.mean());
    if (!(percent <= LARGEST_ERROR_PERCENT)) {
      reasons.add(new Reason.Imprecise(kind, parameter, percent, LARGEST_ERROR_PERCENT));
    }
    calibration
        .joint()
        .flatMap(j -> kind == KickKind.FLAT ? j.flat(parameter) : j.chip(parameter))
        .filter(Estimate::usable)
        .ifPresent(joint -> compare(kind, parameter, mean, joint));
  }

  /** Whether the 2σ rule leaves out so many kicks that those that remain do not speak for all. */
  private void excluded(KickKind kind, String parameter) {
    List<Sample> samples =
        samples(kind, parameter).stream()
            .filter(s -> s.dropped().isEmpty() || s.leftForItsValue())
            .toList();
    int excluded = (int) samples.stream().filter(Sample::leftForItsValue).count();
    if (excluded >= FEWEST_EXCLUDED && excluded > MOST_EXCLUDED * samples.size()) {
      reasons.add(new Reason.ManyExcluded(kind, parameter, excluded, samples.size()));
    }
  }

  private List<Sample> samples(KickKind kind, String parameter) {
    return calibration.kicks(kind).stream()
        .flatMap(k -> k.samples().stream())
        .filter(s -> s.parameter().equals(parameter))
        .toList();
  }

  /** The part of a mean's error that more kicks would make smaller. Where the 2σ rule excludes kicks, the reported error also reaches the mean of all kicks, and would hide that the joint fit, which uses all of them, lies there. */
  private double byChance(KickKind kind, String parameter, Average mean) {
    List<Sample> samples = samples(kind, parameter);
    return samples.stream().anyMatch(Sample::leftForItsValue)
        ? Math.min(mean.standardError(), Average.errorByChance(samples))
        : mean.standardError();
  }

  /** Both weigh the kicks differently; where the model holds for all of them, they agree within their errors, and within the precision that is asked of the mean. */
  private void compare(KickKind kind, String parameter, Average mean, Estimate joint) {
    double apart = Math.abs(mean.mean() - joint.value());
    double sigmas = apart / Math.hypot(byChance(kind, parameter, mean), joint.standardError());
    double percent = 100 * apart / Math.abs(mean.mean());
    boolean significant = sigmas > APART_SIGMAS && percent > APART_PERCENT;
    if (significant || percent > LARGEST_ERROR_PERCENT) {
      reasons.add(
          new Reason.MeanAgainstJoint(
              kind, parameter, mean.mean(), joint.value(), sigmas, percent));
    }
  }

  /** Whether most chips do not fly. Then this is the only reason that is given for the chip model; more chips of this kind would not help. Of a few kicks, one whose flight is hardly seen may be most. */
  private boolean areNoChips() {
    List<CalibratedKick> chips =
        calibration.kicks(KickKind.CHIP).stream().filter(CalibratedKick::trusted).toList();
    int flat = (int) chips.stream().filter(k -> !KickFitter.flies(k.fit())).count();
    boolean none = chips.size() >= FEWEST_KICKS && flat > MOST_FLAT_CHIPS * chips.size();
    if (none) {
      reasons.add(new Reason.NoChips(flat, chips.size()));
    }
    return none;
  }

  private void recordings() {
    Surroundings from = evidence.surroundings();
    if (from.fields().size() > 1) {
      reasons.add(new Reason.SeveralFields(from.fields()));
    } else if (from.camerasDiffer()) {
      reasons.add(new Reason.OtherCameras());
    }
    if (from.simulated() > 0) {
      reasons.add(new Reason.SimulatedField(from.simulated(), from.recordings().size()));
    }
  }

  /** Adds what a diagnosis found; true if it found the model adequate. */
  private boolean diagnosis() {
    if (!evidence.effects().isEmpty()) {
      reasons.add(new Reason.ExtendedModelOnly(evidence.effects()));
      return false;
    }
    Optional<Finding> finding = evidence.finding();
    finding.ifPresent(f -> reasons.add(new Reason.Diagnosed(f.verdict(), f.causes())));
    return finding.map(f -> f.verdict() == Verdict.MODEL_ADEQUATE).orElse(false);
  }

  /** Whether the model describes the kicks; a diagnosis that found nothing wrong counts for more than the residual. */
  private void fit(boolean explained) {
    Optional<JointFit> joint = calibration.joint();
    double ratio = Math.sqrt(joint.map(JointFit::reducedChiSquare).orElse(0.0));
    if (ratio > FitStatistics.EXPLAINED_SCALE) {
      boolean far = ratio > FAR_ABOVE_NOISE && !explained;
      if (far) {
        evidence.forced().ifPresent(kind -> reasons.add(new Reason.ForcedKind(kind)));
      }
      reasons.add(
          new Reason.ResidualAboveNoise(
              ratio, far ? PublishDecision.CHECK_FIRST : PublishDecision.PUBLISH));
    }
    if (joint.map(j -> !j.converged()).orElse(false)) {
      reasons.add(new Reason.NotConverged());
    }
  }
}
