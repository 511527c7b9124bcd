package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.Verdict;
import fieldcal.kick.KickKind;
import fieldcal.verdict.FieldSize;
import fieldcal.verdict.PublishDecision;
import fieldcal.verdict.PublishVerdict;
import fieldcal.verdict.Reason;
import fieldcal.verdict.VisionFault;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The verdict on a model in words that are read once. */
class PublishWordsTest {
  private static Reason few(String parameter, int used) {
    return new Reason.FewKicks(KickKind.FLAT, parameter, used, 5, 8);
  }

  @Test
  void parametersWithAsManyKicksShareThem() {
    PublishWords words =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.RECORD_MORE,
                List.of(few("accSlide", 3), few("accRoll", 0), few("kSwitch", 3)),
                false));
    assertThat(words.reasons())
        .containsExactly(
            "The flat model has 3 of 8 kicks for the sliding deceleration (acc_slide) and the"
                + " switch to rolling (k_switch); no kick for the rolling deceleration"
                + " (acc_roll). Each parameter needs at least 5 kicks.");
    assertThat(words.headline())
        .isEqualTo(
            "Verdict: record more. Record fast flat kicks (4 to 6.5 m/s), flat kicks that roll"
                + " until they stop (2 to 4 m/s) and flat kicks that roll for two metres or more.");
  }

  @Test
  void modelsThatAreJudgedDifferentlyAreNamedFirst() {
    PublishVerdict verdict =
        new PublishVerdict(
            PublishDecision.RECORD_MORE,
            List.of(
                new Reason.FewKicks(KickKind.CHIP, "dampingZ", 2, 5, 2),
                new Reason.NothingPublished(KickKind.FLAT)),
            false);
    assertThat(PublishWords.of(verdict).reasons().get(0))
        .isEqualTo("Flat model: publish. Chip model: record more.");
    assertThat(PublishWords.of(verdict).headline())
        .isEqualTo(
            "Verdict: record more. Record at least twelve chips, among them chips that bounce three"
                + " times or more.");
  }

  @Test
  void anOffsetThatIsTakenOutChangesNothing() {
    PublishWords words =
        after(
            new Reason.Diagnosed(
                Verdict.EXPLAINED, List.of("camera_offset"), PublishDecision.PUBLISH));
    assertThat(words.headline()).startsWith("Verdict: publish.");
    assertThat(words.notes())
        .containsExactly(
            "The diagnosis explains what is wrong: offset of a camera. The calibration allows for"
                + " this, so the ball model needs no change.");
  }

  /** Nobody can correct the air. */
  @Test
  void onlyWhatCanBeMendedIsToBeMended() {
    assertThat(advice("air_drag"))
        .isEqualTo(
            "Let your AI load extended_model.json, which contains what the diagnosis found;"
                + " vision's ball model cannot hold it.");
    assertThat(advice("camera_time_offset", "air_drag"))
        .isEqualTo(
            "Correct the wrong time stamps and record again. Air drag remains: let your AI load"
                + " extended_model.json.");
  }

  private static String advice(String... causes) {
    return after(
            new Reason.Diagnosed(Verdict.EXPLAINED, List.of(causes), PublishDecision.CHECK_FIRST))
        .toDo()
        .get(0);
  }

  private static PublishWords after(Reason.Diagnosed diagnosed) {
    return PublishWords.of(new PublishVerdict(diagnosed.decision(), List.of(diagnosed), false));
  }

  @Test
  void aModelThatDoesNotHoldForAllKicksIsNamedWithItsResidual() {
    PublishVerdict verdict =
        new PublishVerdict(
            PublishDecision.CHECK_FIRST, List.of(new Reason.KicksDiffer(2.5, 0.99, 2.6, 1)), true);
    assertThat(PublishWords.of(verdict).reasons())
        .containsExactly(
            "One model for all kicks misses the detections by 2.6 mm, 2.5 times the noise of the"
                + " cameras; a separate model for each kick misses them by 1.0 mm. No single value"
                + " describes all kicks.");
  }

  /** Who rehearses must not carry the rehearsal's numbers to the field. */
  @Test
  void aRehearsalIsNotForSslVision() {
    List<Reason> real = List.of(new Reason.NothingPublished(KickKind.FLAT));
    List<Reason> rehearsed =
        List.of(
            new Reason.NothingPublished(KickKind.FLAT),
            new Reason.SimulatedField(2, 2, List.of("a.log", "b.log")));
    assertThat(headline(real)).contains("SSL-Vision");
    assertThat(headline(rehearsed))
        .isEqualTo(
            "Verdict: publish. Use the numbers on this simulated field only; for a real one, record"
                + " kicks there.");
  }

  @Test
  void parametersWithManyExcludedKicksShareASentence() {
    PublishWords words =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.CHECK_FIRST,
                List.of(
                    new Reason.ManyExcluded(KickKind.FLAT, "accSlide", 7, 16),
                    new Reason.ManyExcluded(KickKind.FLAT, "kSwitch", 6, 17)),
                true));
    assertThat(words.reasons())
        .containsExactly(
            "The 2σ rule excludes many flat kicks: 7 of 16 for the sliding deceleration"
                + " (acc_slide), 6 of 17 for the switch to rolling (k_switch). No single value"
                + " describes all kicks.");
    assertThat(words.headline())
        .isEqualTo(
            "Verdict: check first. Run diagnose on these recordings: it looks for the cause.");
  }

  @Test
  void aSentenceIsSaidOnceWithAllItsParameters() {
    PublishWords words =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.CHECK_FIRST,
                List.of(
                    new Reason.MeanAgainstJoint(
                        KickKind.FLAT, "accSlide", -3.38, -0.9, 4.2, 73, false),
                    new Reason.MeanAgainstJoint(
                        KickKind.CHIP, "dampingZ", 0.55, 0.6, 5.1, 9, false),
                    new Reason.ManyExcluded(KickKind.FLAT, "kSwitch", 6, 17),
                    new Reason.Imprecise(KickKind.FLAT, "accSlide", 12.3, 10),
                    new Reason.Imprecise(KickKind.CHIP, "dampingZ", 23.1, 10)),
                true));
    assertThat(words.reasons())
        .containsExactly(
            "The mean of the kicks and the joint fit disagree: the sliding deceleration (acc_slide)"
                + " is −3.380 m/s² as the mean, but −0.900 m/s² in the joint fit (73 % and 4.2"
                + " standard errors apart); the vertical damping (damping_z) is 0.550 as the mean,"
                + " but 0.600 in the joint fit (9 % and 5.1 standard errors apart). No single value"
                + " describes all kicks.",
            "The 2σ rule excludes many flat kicks: 6 of 17 for the switch to rolling (k_switch).",
            "Some errors are above the 10 % that is allowed: 12 % for the sliding deceleration"
                + " (acc_slide), 23 % for the vertical damping (damping_z).");
  }

  /** What kicks of several fields lack nobody knows before they are apart. */
  @Test
  void recordingsThatDoNotBelongTogetherAreSeparatedFirst() {
    Reason fields =
        new Reason.SeveralFields(
            List.of(new FieldSize(12, 9), new FieldSize(10.4, 7.4)),
            List.of(List.of("a.log", "b.log"), List.of("c.log")));
    Reason noise = new Reason.ResidualAboveNoise(3.8, 1.9, PublishDecision.CHECK_FIRST);
    PublishWords words =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.DO_NOT_PUBLISH, List.of(fields, noise, few("accRoll", 1)), true));
    assertThat(words.reasons())
        .hasSize(3)
        .contains(
            "The fields differ in size: 12.00 × 9.00 m (a.log and b.log), 10.40 × 7.40 m (c.log). A"
                + " ball model holds for one carpet.");
    assertThat(words.toDo())
        .containsExactly("Calibrate each field on its own, then read the new verdict.");
    assertThat(
            PublishWords.of(
                    new PublishVerdict(
                        PublishDecision.DO_NOT_PUBLISH,
                        List.of(
                            new Reason.SimulatedField(1, 2, List.of("sim.log")), few("accRoll", 1)),
                        false))
                .toDo())
        .containsExactly("Leave the simulated recordings out, then read the new verdict.");
  }

  @Test
  void camerasThatShareNothingAreSeparatedFirst() {
    Reason noise = new Reason.ResidualAboveNoise(3.8, 1.9, PublishDecision.CHECK_FIRST);
    Reason cameras = new Reason.OtherCameras(List.of(List.of("a.log"), List.of("b.log")));
    assertThat(
            PublishWords.of(
                    new PublishVerdict(
                        PublishDecision.CHECK_FIRST,
                        List.of(noise, cameras, few("accRoll", 1)),
                        true))
                .headline())
        .isEqualTo(
            "Verdict: check first. Calibrate each field on its own, then read the new verdict.");
  }

  @Test
  void whoMayPublishDiagnosesFirst() {
    Reason changes = new Reason.NothingPublished(KickKind.FLAT);
    PublishVerdict open =
        new PublishVerdict(
            PublishDecision.PUBLISH, List.of(changes, new Reason.NotDiagnosed()), false);
    assertThat(PublishWords.of(open).headline())
        .isEqualTo(
            "Verdict: publish. Run diagnose, which may change this verdict; then enter the numbers"
                + " in SSL-Vision, or send them from the console.");
  }

  @Test
  void aFieldThatOnlyVisionPublishesMixesNoKicks() {
    Reason elsewhere =
        new Reason.SeveralFields(
            List.of(new FieldSize(12, 9), new FieldSize(10.4, 7.4)),
            List.of(List.of("a.log"), List.of()));
    PublishVerdict verdict =
        new PublishVerdict(PublishDecision.DO_NOT_PUBLISH, List.of(elsewhere), false);
    assertThat(PublishWords.of(verdict).reasons())
        .containsExactly(
            "The fields differ in size: 12.00 × 9.00 m (a.log), 10.40 × 7.40 m (as vision publishes"
                + " it). A ball model holds for one carpet.");
    assertThat(PublishWords.of(verdict).toDo())
        .containsExactly("Use recordings of the field that vision publishes now.");
    assertThat(PublishWords.mixture(verdict)).isEmpty();
  }

  @Test
  void recordingsThatAReasonConcernsAreNamed() {
    assertThat(reason(new Reason.SimulatedField(1, 2, List.of("sim.log.gz"))))
        .isEqualTo("1 of the 2 recordings is from a simulated field: sim.log.gz.");
    assertThat(reason(new Reason.SimulatedField(5, 9, List.of("a", "b", "c", "d", "e"))))
        .isEqualTo("5 of the 9 recordings are from a simulated field: a, b, c and 2 others.");
    assertThat(
            reason(
                new Reason.FaultyVision(
                    new VisionFault.MixedUp(List.of(1), false), List.of("b.log"))))
        .isEqualTo("In b.log: Camera 1 is rotated by 180°.");
    assertThat(
            reason(new Reason.OtherCameras(List.of(List.of("a.log", "c.log"), List.of("b.log")))))
        .endsWith(
            "a.log and c.log; b.log. Either all cameras were calibrated again, or the fields"
                + " differ.");
  }

  /** 0.8 standard errors apart is agreement, though 16 % is more than may be uncertain. */
  @Test
  void aParameterThatMayBeEitherValueIsNotDetermined() {
    Reason switching =
        new Reason.MeanAgainstJoint(KickKind.FLAT, "kSwitch", 0.61, 0.71, 0.8, 16, false);
    PublishWords words =
        PublishWords.of(new PublishVerdict(PublishDecision.CHECK_FIRST, List.of(switching), true));
    assertThat(words.reasons())
        .containsExactly(
            "The kicks do not determine the switch to rolling (k_switch): it is 0.610 as the mean"
                + " of the kicks and 0.710 in the joint fit. They differ by 16 %, 0.8 standard"
                + " errors; up to 3 may be chance.");
    assertThat(words.toDo())
        .containsExactly(
            "Run diagnose on these recordings: it looks for the cause.",
            "Record flat kicks that roll for two metres or more.");
    Reason slide =
        new Reason.MeanAgainstJoint(KickKind.FLAT, "accSlide", -3.38, -2.9, 1.2, 14, false);
    Reason damping =
        new Reason.MeanAgainstJoint(KickKind.CHIP, "dampingZ", 0.55, 0.6, 5.1, 9, false);
    PublishWords several =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.CHECK_FIRST, List.of(switching, damping, slide), true));
    assertThat(several.toDo())
        .as("kicks that contradict one model are not more of one mind when there are more")
        .containsExactly("Run diagnose on these recordings: it looks for the cause.");
    assertThat(several.reasons())
        .containsExactly(
            "The kicks do not determine some parameters. The mean of the kicks and the joint fit"
                + " differ by no more than their errors allow: the switch to rolling (k_switch) is"
                + " 0.610 as the mean, but 0.710 in the joint fit (16 % and 0.8 standard errors"
                + " apart); the sliding deceleration (acc_slide) is −3.380 m/s² as the mean, but"
                + " −2.900 m/s² in the joint fit (14 % and 1.2 standard errors apart).",
            "The vertical damping (damping_z) is 0.550 as the mean of the kicks, but 0.600 in the"
                + " joint fit: 9 % and 5.1 standard errors apart. No single value describes all"
                + " kicks.");
  }

  /** 2.98 is within the limit of 3, and must not read as the limit itself. */
  @Test
  void aDistanceBesideTheLimitHasDigitsEnough() {
    assertThat(slide(2.98, false))
        .endsWith("They differ by 15 %, 2.98 standard errors; up to 3 may be chance.");
    assertThat(slide(2.998, false)).contains(", 2.99 standard errors;");
    assertThat(slide(3, false)).contains(", 2.99 standard errors;");
    assertThat(slide(3.001, false)).contains(" and 3.01 standard errors apart.");
  }

  /** The table beside the reasons shows ± 0.4661 m/s², from which a reader computes one standard error. */
  @Test
  void aSmallerErrorThanTheOneShownIsExplained() {
    String explained =
        " The standard error shown beside the mean is larger, since it also allows for the"
            + " excluded kicks.";
    assertThat(slide(2.98, true)).endsWith("may be chance." + explained);
    assertThat(slide(4.2, true)).contains("apart." + explained + " No single value");
  }

  private static String slide(double standardErrors, boolean withoutExcluded) {
    return reason(
        new Reason.MeanAgainstJoint(
            KickKind.FLAT, "accSlide", -3.102, -2.628, standardErrors, 15, withoutExcluded));
  }

  private static String reason(Reason reason) {
    PublishWords words =
        PublishWords.of(new PublishVerdict(reason.decision(), List.of(reason), false));
    return words.reasons().get(0);
  }

  private static String headline(List<Reason> reasons) {
    return PublishWords.of(new PublishVerdict(PublishDecision.PUBLISH, reasons, false)).headline();
  }
}
