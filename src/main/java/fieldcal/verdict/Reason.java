package fieldcal.verdict;

import fieldcal.diagnosis.Verdict;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * One reason of a {@link PublishVerdict}, with the numbers it was decided by. A reason whose decision is {@link PublishDecision#PUBLISH} is
 * a remark: it does not speak against publishing.
 */
public sealed interface Reason {

  /**
   * What this reason alone asks for.
   *
   * @return the decision
   */
  PublishDecision decision();

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  String id();

  /**
   * The model it is about.
   *
   * @return empty when it is about both
   */
  default Optional<KickKind> model() {
    return Optional.empty();
  }

  /**
   * Whether kicks of different fields are put together: then no single model holds for all of them.
   *
   * @return false for most reasons
   */
  default boolean mixesFields() {
    return false;
  }

  /**
   * No kick to calibrate from.
   *
   * @param found kicks in the recordings; when there are some, none of them can be used
   */
  record NoKicks(int found) implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.RECORD_MORE;
    }

    @Override
    public String id() {
      return "no_kicks";
    }
  }

  /**
   * A parameter is determined by too few kicks.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @param used kicks in its mean, 0 or more
   * @param needed how many there should be
   * @param kicks of that kind in the recordings
   */
  record FewKicks(KickKind kind, String parameter, int used, int needed, int kicks)
      implements OfModel {
    @Override
    public PublishDecision decision() {
      return PublishDecision.RECORD_MORE;
    }

    @Override
    public String id() {
      return "few_kicks";
    }
  }

  /**
   * The mean of a parameter is too uncertain.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @param percent standard error of the mean, percent of the mean
   * @param limit largest standard error allowed, percent of the mean
   */
  record Imprecise(KickKind kind, String parameter, double percent, double limit)
      implements OfModel {
    @Override
    public PublishDecision decision() {
      return PublishDecision.RECORD_MORE;
    }

    @Override
    public String id() {
      return "imprecise";
    }
  }

  /**
   * The mean over the kicks and the joint fit of all kicks, which weighs them differently, disagree: no one value holds for all kicks, or these do not determine it.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @param mean over the kicks, in the parameter's unit
   * @param joint value from the joint fit, in the same unit
   * @param standardErrors how far apart they are, in units of their combined standard error
   * @param percent how far apart they are, percent of the mean
   * @param withoutExcluded whether the mean's standard error is smaller here than the reported one, because it leaves out the part that allows for excluded values
   */
  record MeanAgainstJoint(
      KickKind kind,
      String parameter,
      double mean,
      double joint,
      double standardErrors,
      double percent,
      boolean withoutExcluded)
      implements OfModel {
    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "mean_against_joint_fit";
    }

    /**
     * Whether they differ by more than chance. Otherwise the kicks do not determine the parameter well enough to tell.
     *
     * @return true when no one value holds for all kicks
     */
    public boolean beyondChance() {
      return standardErrors > VerdictRule.APART_SIGMAS;
    }
  }

  /**
   * The 2σ rule excludes so many values of a parameter that these are no outliers: no one value holds for all kicks.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @param excluded values that the 2σ rule excludes
   * @param kicks that determine the parameter, those with an excluded value among them
   */
  record ManyExcluded(KickKind kind, String parameter, int excluded, int kicks) implements OfModel {
    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "many_excluded";
    }
  }

  /**
   * The kicks lie further from their fitted paths than the cameras' noise explains.
   *
   * @param ratio residual of the joint fit over the noise on the resting ball (–)
   * @param rmsMm residual of the joint fit per axis, mm
   * @param decision to check first where the residual is far above the noise; otherwise to publish
   */
  record ResidualAboveNoise(double ratio, double rmsMm, PublishDecision decision)
      implements Reason {
    /**
     * Checks that the decision is there. {@inheritDoc}
     *
     * @throws NullPointerException when the decision is null
     */
    public ResidualAboveNoise {
      Objects.requireNonNull(decision, "decision");
    }

    @Override
    public String id() {
      return "residual_above_noise";
    }
  }

  /**
   * One model for all kicks leaves much larger residuals than values of each kick's own: no one value holds for all kicks.
   *
   * @param ratio residual of one model for all kicks over the noise on the resting ball (–)
   * @param ownRatio the same when every kick may have its own values
   * @param rmsMm residual of one model for all kicks per axis, mm
   * @param ownRmsMm the same when every kick may have its own values, mm
   */
  record KicksDiffer(double ratio, double ownRatio, double rmsMm, double ownRmsMm)
      implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "kicks_differ";
    }
  }

  /**
   * All kicks were taken to be of one kind, but do not all move like that: some may be of the other kind.
   *
   * @param kind that was asked for
   */
  record ForcedKind(KickKind kind) implements Reason {
    /**
     * Checks that the kind is there. {@inheritDoc}
     *
     * @throws NullPointerException when the kind is null
     */
    public ForcedKind {
      Objects.requireNonNull(kind, "kind");
    }

    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "forced_kind";
    }

    @Override
    public Optional<KickKind> model() {
      return Optional.of(kind);
    }
  }

  /** The joint fit did not converge. */
  record NotConverged() implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "not_converged";
    }
  }

  /**
   * Kicks that were taken to be chips do not fly.
   *
   * @param flat kicks that were fitted as chips, but were flat
   * @param kicks that were fitted as chips
   */
  record NoChips(int flat, int kicks) implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.DO_NOT_PUBLISH;
    }

    @Override
    public String id() {
      return "no_chips";
    }

    @Override
    public Optional<KickKind> model() {
      return Optional.of(KickKind.CHIP);
    }
  }

  /**
   * The recordings are from several fields, or from another field than the one that vision publishes.
   *
   * @param fields length and width of each, m
   * @param recordings names of those that are from each of them; none where only vision publishes a field
   */
  record SeveralFields(List<FieldSize> fields, List<List<String>> recordings) implements Reason {
    /**
     * Copies the lists. {@inheritDoc}
     *
     * @throws NullPointerException when a component is null
     * @throws IllegalArgumentException when there are not as many lists of recordings as fields
     */
    public SeveralFields {
      fields = List.copyOf(fields);
      recordings = recordings.stream().map(List::copyOf).toList();
      if (recordings.size() != fields.size()) {
        throw new IllegalArgumentException(
            fields.size() + " fields, but " + recordings.size() + " lists of recordings");
      }
    }

    @Override
    public PublishDecision decision() {
      return PublishDecision.DO_NOT_PUBLISH;
    }

    /** What vision publishes now is no recording. {@inheritDoc} */
    @Override
    public boolean mixesFields() {
      return recordings.stream().filter(names -> !names.isEmpty()).count() > 1;
    }

    @Override
    public String id() {
      return "several_fields";
    }
  }

  /**
   * The cameras are not what the fit takes them for.
   *
   * @param fault what the recording shows
   * @param recordings names of those that show it; empty when all of them do
   */
  record FaultyVision(VisionFault fault, List<String> recordings) implements Reason {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when a component is null
     */
    public FaultyVision {
      Objects.requireNonNull(fault, "fault");
      recordings = List.copyOf(recordings);
    }

    @Override
    public PublishDecision decision() {
      return fault instanceof VisionFault.ClockRate clock && clock.simulator()
          ? PublishDecision.PUBLISH
          : PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return fault instanceof VisionFault.ClockRate ? "clock_rate" : "mixed_up_cameras";
    }
  }

  /**
   * Between two recordings every camera has another calibration: another field of the same size, or vision was calibrated again.
   *
   * @param recordings names, those with the same cameras together
   */
  record OtherCameras(List<List<String>> recordings) implements Reason {
    /**
     * Copies the lists. {@inheritDoc}
     *
     * @throws NullPointerException when a list or an element is null
     */
    public OtherCameras {
      recordings = recordings.stream().map(List::copyOf).toList();
    }

    @Override
    public PublishDecision decision() {
      return PublishDecision.CHECK_FIRST;
    }

    @Override
    public String id() {
      return "other_cameras";
    }
  }

  /**
   * Kicks of a simulated field are among the kicks.
   *
   * @param simulated recordings of a simulated field
   * @param recordings all of them; with real ones among them the model is of neither field
   * @param names of the simulated ones
   */
  record SimulatedField(int simulated, int recordings, List<String> names) implements Reason {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when the list or an element is null
     */
    public SimulatedField {
      names = List.copyOf(names);
    }

    @Override
    public PublishDecision decision() {
      return mixesFields() ? PublishDecision.DO_NOT_PUBLISH : PublishDecision.PUBLISH;
    }

    @Override
    public boolean mixesFields() {
      return simulated < recordings;
    }

    @Override
    public String id() {
      return "simulated_field";
    }
  }

  /**
   * The parameters are valid only together with effects, for which the league's message has no field.
   *
   * @param effects ids
   */
  record ExtendedModelOnly(List<String> effects) implements Reason {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when a component is null
     */
    public ExtendedModelOnly {
      effects = List.copyOf(effects);
    }

    @Override
    public PublishDecision decision() {
      return PublishDecision.DO_NOT_PUBLISH;
    }

    @Override
    public String id() {
      return "extended_model_only";
    }
  }

  /**
   * What a diagnosis of these kicks found.
   *
   * @param verdict of the diagnosis
   * @param causes ids of the effects that it names
   * @param decision to publish where the model that can be published needs no change for it
   */
  record Diagnosed(Verdict verdict, List<String> causes, PublishDecision decision)
      implements Reason {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when a component is null
     */
    public Diagnosed {
      Objects.requireNonNull(verdict, "verdict");
      Objects.requireNonNull(decision, "decision");
      causes = List.copyOf(causes);
    }

    @Override
    public String id() {
      return "diagnosed";
    }
  }

  /** Nobody has looked yet for what the model gets wrong, beyond what the residuals show by themselves. */
  record NotDiagnosed() implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.PUBLISH;
    }

    @Override
    public String id() {
      return "not_diagnosed";
    }
  }

  /**
   * A parameter differs from the published one.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @param percent mean over published value minus one, percent
   */
  record DiffersFromPublished(KickKind kind, String parameter, double percent) implements OfModel {
    @Override
    public PublishDecision decision() {
      return PublishDecision.PUBLISH;
    }

    @Override
    public String id() {
      return "differs_from_published";
    }
  }

  /**
   * A model is the same as the published one.
   *
   * @param kind of the model
   */
  record AgreesWithPublished(KickKind kind) implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.PUBLISH;
    }

    @Override
    public String id() {
      return "agrees_with_published";
    }

    @Override
    public Optional<KickKind> model() {
      return Optional.of(kind);
    }
  }

  /**
   * No model of that kind is published.
   *
   * @param kind of the model
   */
  record NothingPublished(KickKind kind) implements Reason {
    @Override
    public PublishDecision decision() {
      return PublishDecision.PUBLISH;
    }

    @Override
    public String id() {
      return "nothing_published";
    }

    @Override
    public Optional<KickKind> model() {
      return Optional.of(kind);
    }
  }

  /** A reason about one parameter of one model. */
  sealed interface OfModel extends Reason {
    /**
     * The model's kind.
     *
     * @return flat or chip
     */
    KickKind kind();

    /**
     * The parameter's name as in the model's record.
     *
     * @return for example {@code accSlide}
     */
    String parameter();

    @Override
    default Optional<KickKind> model() {
      return Optional.of(kind());
    }
  }
}
