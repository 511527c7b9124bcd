package fieldcal.verdict;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Sample;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitStatistics;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The one rule that decides whether a model may be published.
 *
 * <p>The residual has two parts, and each is compared with the noise. What is left when every kick may have values of its own about the model's ({@link fieldcal.fit.JointFitter}) shows a law that is wrong within a kick ({@link Reason.ResidualAboveNoise}). By how much that grows when one model has to describe all kicks shows that
 * kicks differ from each other ({@link Reason.KicksDiffer}). Both are judged however few kicks there are: more kicks do not mend a model that is wrong.
 *
 * <p>A diagnosis ({@link Evidence#finding}) overrules the residual when it finds nothing wrong, and holds a model back when it names a cause that changes it, or finds an error without explaining any of it. What a calibration allows for, as offsets of cameras and the bias of a kicker, does not change the model. What a diagnosis describes without naming a cause is part of the residual, and is judged with it.
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
   * Residuals of more than this many times the noise on the resting ball are far above it, within a kick as well as from kick to kick. Good fits reach 1.9: ten matches of 2026 have 0.7 mm on the resting ball and 1.3 mm RMS
   * (Immortals-Robotics/Simulator, docs/calibration). From kick to kick, seven recordings with nothing wrong in them reach 0.1, those of a rigid-body simulator with a fixed loss (erforce) 1.4, and bounces that build up spin (ode-chip) 2.3.
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
    Surroundings from = evidence.surroundings();
    from.faults().forEach(f -> reasons.add(new Reason.FaultyVision(f, from.showing(f))));
    boolean fitted = false;
    for (KickKind kind : KickKind.values()) {
      if (calibration.tells(kind)) {
        fitted |= judge(kind);
      }
    }
    if (calibration.kicks().stream().noneMatch(CalibratedKick::trusted)) {
      reasons.add(new Reason.NoKicks(calibration.kicks().size()));
      fitted = false;
    }
    recordings();
    if (fitted) {
      fit();
    }
    boolean suspicious = reasons.stream().anyMatch(VerdictRule::doubtsTheModel);
    diagnosis(reasons.stream().anyMatch(r -> doubtsTheModel(r) && holdsBack(r)));
    if (reasons.stream().anyMatch(r -> r.decision() == PublishDecision.DO_NOT_PUBLISH)) {
      // What must not be used agrees with nothing.
      reasons.removeIf(r -> r instanceof Reason.AgreesWithPublished);
    }
    boolean diagnosed = evidence.finding().isPresent() || !evidence.effects().isEmpty();
    if (!diagnosed
        && evidence.forced().isEmpty()
        && reasons.stream().noneMatch(VerdictRule::holdsBack)) {
      reasons.add(new Reason.NotDiagnosed());
    }
    boolean misled = reasons.stream().anyMatch(r -> r instanceof Reason.ForcedKind);
    return PublishVerdict.of(reasons, suspicious && !diagnosed && !misled);
  }

  private static boolean holdsBack(Reason reason) {
    return reason.decision() != PublishDecision.PUBLISH;
  }

  /** Whether a reason says that the kicks do not follow one model; a diagnosis finds out why. */
  private static boolean doubtsTheModel(Reason reason) {
    return reason instanceof Reason.MeanAgainstJoint
        || reason instanceof Reason.ManyExcluded
        || reason instanceof Reason.ResidualAboveNoise
        || reason instanceof Reason.KicksDiffer;
  }

  /** Judges one model; false when its kicks were fitted as what they are not. */
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
    boolean known = true;
    for (Map.Entry<String, Average> entry : averages.entrySet()) {
      Average mean = entry.getValue();
      known &= judge(kind, entry.getKey(), mean);
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
    } else if (!differs && known) {
      reasons.add(new Reason.AgreesWithPublished(kind));
    }
    return true;
  }

  /** Judges one parameter; false when so little is known of it that it agrees with any published value. */
  private boolean judge(KickKind kind, String parameter, Average mean) {
    if (mean.n() < FEWEST_KICKS) {
      int kicks = calibration.kicks(kind).size();
      reasons.add(new Reason.FewKicks(kind, parameter, mean.n(), FEWEST_KICKS, kicks));
      return false;
    }
    double percent = 100 * Math.abs(byChance(kind, parameter, mean) / mean.mean());
    boolean known = percent <= LARGEST_ERROR_PERCENT;
    if (!known) {
      reasons.add(new Reason.Imprecise(kind, parameter, percent, LARGEST_ERROR_PERCENT));
    }
    calibration
        .joint(kind, parameter)
        .filter(Estimate::usable)
        .ifPresent(joint -> compare(kind, parameter, mean, joint));
    return known;
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
    double byChance = byChance(kind, parameter, mean);
    double sigmas = apart / Math.hypot(byChance, joint.standardError());
    double percent = 100 * apart / Math.abs(mean.mean());
    boolean significant = sigmas > APART_SIGMAS && percent > APART_PERCENT;
    if (significant || percent > LARGEST_ERROR_PERCENT) {
      reasons.add(
          new Reason.MeanAgainstJoint(
              kind,
              parameter,
              mean.mean(),
              joint.value(),
              sigmas,
              percent,
              byChance < mean.standardError()));
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
    List<Surroundings.Field> fields = from.fields();
    if (fields.size() > 1) {
      reasons.add(
          new Reason.SeveralFields(
              fields.stream().map(Surroundings.Field::size).toList(),
              fields.stream().map(Surroundings.Field::recordings).toList()));
    } else if (from.byCameras().size() > 1) {
      reasons.add(new Reason.OtherCameras(from.byCameras()));
    }
    List<String> simulated = from.simulated();
    if (!simulated.isEmpty()) {
      reasons.add(new Reason.SimulatedField(simulated.size(), from.recordings().size(), simulated));
    }
  }

  /** Adds what a diagnosis found. Its learned terms describe the same residual that the calibration shows, so that is what decides about them. */
  private void diagnosis(boolean inDoubt) {
    if (!evidence.effects().isEmpty()) {
      reasons.add(new Reason.ExtendedModelOnly(evidence.effects()));
      return;
    }
    evidence
        .finding()
        .ifPresent(
            f ->
                reasons.add(
                    new Reason.Diagnosed(
                        f.verdict(),
                        f.causes(),
                        changesTheModel(f) || inDoubt && f.verdict() != Verdict.MODEL_ADEQUATE
                            ? PublishDecision.CHECK_FIRST
                            : PublishDecision.PUBLISH)));
  }

  private static boolean changesTheModel(Finding finding) {
    return finding.verdict() == Verdict.UNEXPLAINED_STRUCTURE
        || finding.causes().stream().anyMatch(id -> !isAllowedFor(id));
  }

  private static boolean isAllowedFor(String effect) {
    return EffectCatalogue.find(effect).map(Effect::isAllowedForByCalibration).orElse(false);
  }

  /** Whether a diagnosis found nothing wrong, which counts for more than the residual. */
  private boolean isFoundAdequate() {
    return evidence.effects().isEmpty()
        && evidence.finding().map(f -> f.verdict() == Verdict.MODEL_ADEQUATE).orElse(false);
  }

  /** Whether the model describes the kicks. */
  private void fit() {
    calibration.joint().ifPresent(this::fit);
  }

  private void fit(JointFit joint) {
    double own = Math.sqrt(joint.reducedChiSquare());
    double one = Math.sqrt(joint.oneModel().reducedChiSquare());
    double between = Math.sqrt(Math.max(0, one * one - own * own));
    boolean adequate = isFoundAdequate();
    boolean within = own > FAR_ABOVE_NOISE && !adequate;
    boolean differ = between > FAR_ABOVE_NOISE && !adequate;
    if (within || differ) {
      evidence.forced().ifPresent(kind -> reasons.add(new Reason.ForcedKind(kind)));
    }
    if (own > FitStatistics.EXPLAINED_SCALE) {
      reasons.add(
          new Reason.ResidualAboveNoise(
              own, joint.rmsMm(), within ? PublishDecision.CHECK_FIRST : PublishDecision.PUBLISH));
    }
    if (differ) {
      reasons.add(new Reason.KicksDiffer(one, own, joint.oneModel().rmsMm(), joint.rmsMm()));
    }
    if (!joint.converged()) {
      reasons.add(new Reason.NotConverged());
    }
  }
}
