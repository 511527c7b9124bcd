package fieldcal.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Sample;
import fieldcal.camera.CameraCalibration;
import fieldcal.diagnosis.Verdict;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.vision.BallModels;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VerdictRuleTest {
  private static final BallModels PUBLISHED =
      new BallModels(Optional.of(new FlatModel(-3.0, -0.26, 0.64)), Optional.empty());
  private static final Average ROLL = new Average(-0.26, 0.001, 0, 20);
  private static final Average SWITCH = new Average(0.64, 0.001, 0, 20);

  /** The same sample as the 2σ rule leaves it out. */
  private static Sample outlier(Sample s) {
    return new Sample(
        s.kickId(),
        s.parameter(),
        s.value(),
        s.standardError(),
        Optional.of("acc_slide is 4.2 σ from the mean"),
        Optional.of(Sample.Exclusion.VALUE));
  }

  @ParameterizedTest
  @CsvSource({
    // mean, error, n, joint, error, decision, reason
    "-3.00, 0.02, 20, -3.00, 0.02, PUBLISH, agrees_with_published",
    "-3.05, 0.001, 20, -3.05, 0.02, PUBLISH, agrees_with_published", // certain, but too small to
    // matter
    "-3.20, 0.10, 20, -3.20, 0.02, PUBLISH, agrees_with_published", // large, but may be chance
    "-3.20, 0.02, 20, -3.20, 0.02, PUBLISH, differs_from_published",
    "-3.20, 0.02, 4, -3.20, 0.02, RECORD_MORE, few_kicks",
    "NaN, NaN, 0, -3.20, 0.02, RECORD_MORE, few_kicks",
    "-3.20, 0.40, 20, -3.20, 0.02, RECORD_MORE, imprecise",
    "-3.38, 0.10, 20, -0.90, 0.10, CHECK_FIRST, mean_against_joint_fit", // found on a real field
    "-3.20, 0.01, 20, -3.30, 0.01, CHECK_FIRST, mean_against_joint_fit",
    "-3.20, 0.001, 20, -3.21, 0.001, PUBLISH, differs_from_published", // certain, but below 1 %
    "-3.10, 0.15, 20, -2.64, 0.11, CHECK_FIRST, mean_against_joint_fit", // 15 %, though within
    // errors
  })
  void oneParameterDecides(
      double mean,
      double error,
      int n,
      double joint,
      double jointError,
      PublishDecision decision,
      String reason) {
    PublishVerdict verdict =
        judge(calibration(new Average(mean, error, 0, n), joint, jointError, 1, 20));
    assertThat(verdict.decision()).isEqualTo(decision);
    assertThat(verdict.reasons().get(0).id()).isEqualTo(reason);
    assertThat(verdict.reasons().get(0).decision()).isEqualTo(decision);
    assertThat(verdict.decision(KickKind.FLAT)).contains(decision);
    assertThat(verdict.decision(KickKind.CHIP)).isEmpty();
    assertThat(verdict.diagnose()).isEqualTo(decision == PublishDecision.CHECK_FIRST);
  }

  @ParameterizedTest
  @CsvSource({
    "1.4, PUBLISH, false",
    "1.8, PUBLISH, true",
    "2.1, CHECK_FIRST, true",
    "7.0, CHECK_FIRST, true",
  })
  void residualsFarAboveTheNoiseAskForADiagnosis(
      double ratio, PublishDecision decision, boolean diagnose) {
    PublishVerdict verdict = judge(good(ratio));
    assertThat(verdict.decision()).isEqualTo(decision);
    assertThat(verdict.diagnose()).isEqualTo(diagnose);
    boolean told =
        verdict.reasons().stream()
            .anyMatch(
                r ->
                    r instanceof Reason.ResidualAboveNoise above
                        && Math.abs(above.ratio() - ratio) < 1e-9);
    assertThat(told).isEqualTo(diagnose);
  }

  @ParameterizedTest
  @CsvSource({
    // kicks, excluded, decision
    "20, 0, PUBLISH",
    "20, 6, PUBLISH", // outliers
    "20, 7, CHECK_FIRST",
    "9, 3, PUBLISH", // so few may have gone wrong
    "9, 4, CHECK_FIRST",
  })
  void manyExcludedKicksAreNoOutliers(int kicks, int excluded, PublishDecision decision) {
    Calibration good = good(1);
    List<CalibratedKick> all = new ArrayList<>();
    for (CalibratedKick kick : kicks(KickKind.FLAT, kicks)) {
      Sample sample = kick.samples().get(0);
      boolean out = kick.fit().kick().id() <= excluded;
      Sample judged = out ? outlier(sample) : sample;
      all.add(new CalibratedKick(kick.fit(), List.of(judged), Optional.empty()));
    }
    PublishVerdict verdict =
        judge(
            new Calibration(
                all, good.flat(), Map.of(), good.joint(), CameraViews.of(List.of()), 1));
    assertThat(verdict.decision()).isEqualTo(decision);
    Reason reason = new Reason.ManyExcluded(KickKind.FLAT, "accSlide", excluded, kicks);
    assertThat(verdict.reasons().contains(reason)).isEqualTo(decision != PublishDecision.PUBLISH);
    assertThat(verdict.diagnose()).isEqualTo(decision != PublishDecision.PUBLISH);
  }

  /** The error of a mean reaches what the 2σ rule excludes. It must not hide that the joint fit, which uses all kicks, is somewhere else. */
  @Test
  void aMeanThatIsWideSinceKicksAreExcludedIsStillComparedWithTheJointFit() {
    List<CalibratedKick> all = new ArrayList<>();
    List<Sample> samples = new ArrayList<>();
    for (CalibratedKick kick : kicks(KickKind.FLAT, 20)) {
      int id = kick.fit().kick().id();
      double value = id <= 6 ? -2.5 : -3 + 0.01 * (id % 3);
      samples.add(new Sample(id, "accSlide", value, 0.02, Optional.empty()));
    }
    List<Sample> judged = samples.stream().map(s -> s.kickId() <= 6 ? outlier(s) : s).toList();
    for (CalibratedKick kick : kicks(KickKind.FLAT, 20)) {
      Sample sample = judged.get(kick.fit().kick().id() - 1);
      all.add(new CalibratedKick(kick.fit(), List.of(sample), Optional.empty()));
    }
    Average mean = Average.of(judged).widened(judged);
    double joint = -2.79;
    assertThat(Math.abs(mean.mean() - joint)).isLessThan(2 * mean.standardError());
    PublishVerdict verdict =
        judge(
            new Calibration(
                all,
                Map.of("accSlide", mean),
                Map.of(),
                Optional.of(jointFit(joint, 0.01, 1)),
                CameraViews.of(List.of()),
                1));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.CHECK_FIRST);
    assertThat(verdict.reasons())
        .anyMatch(r -> r instanceof Reason.MeanAgainstJoint m && m.withoutExcluded());
  }

  @Test
  void aDiagnosisThatFoundNothingKnowsBetterThanTheResidual() {
    PublishVerdict verdict =
        VerdictRule.judge(
            evidence(List.of(), Optional.of(new Finding(Verdict.MODEL_ADEQUATE, List.of()))));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.PUBLISH);
    assertThat(verdict.diagnose()).isFalse();
  }

  @Test
  void whatADiagnosisFoundMustBeLookedAt() {
    Finding found = new Finding(Verdict.EXPLAINED, List.of("air_drag"));
    PublishVerdict verdict = VerdictRule.judge(evidence(List.of(), Optional.of(found)));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.CHECK_FIRST);
    assertThat(verdict.reasons())
        .contains(
            new Reason.Diagnosed(
                Verdict.EXPLAINED, List.of("air_drag"), PublishDecision.CHECK_FIRST));
    assertThat(verdict.diagnose()).as("it was diagnosed").isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    // residual, of one model, diagnosis, causes, decision
    "1.0, 1.5, EXPLAINED, camera_offset, PUBLISH", // calibration takes it out
    "1.0, 1.5, EXPLAINED, robot_kick_bias, PUBLISH", // each kick's own velocity is fitted
    "1.3, 1.6, PARTLY_EXPLAINED, camera_offset, PUBLISH", // the rest is small against the noise
    "1.0, 2.6, PARTLY_EXPLAINED, camera_offset, CHECK_FIRST",
    "1.0, 1.5, EXPLAINED, camera_offset air_drag, CHECK_FIRST",
    "1.0, 1.5, EXPLAINED, camera_time_offset, CHECK_FIRST", // the calibration does not know of it
    "1.0, 1.5, PARTLY_EXPLAINED, '', PUBLISH",
    "2.5, 2.5, PARTLY_EXPLAINED, '', CHECK_FIRST",
    "1.0, 1.0, UNEXPLAINED_STRUCTURE, '', CHECK_FIRST",
    "1.0, 1.0, EXPLAINED, of_a_later_version, CHECK_FIRST",
  })
  void onlyWhatChangesTheModelHoldsItBack(
      double own, double one, Verdict found, String causes, PublishDecision decision) {
    List<String> ids = causes.isEmpty() ? List.of() : List.of(causes.split(" "));
    PublishVerdict verdict =
        VerdictRule.judge(
            new Evidence(
                good(own, one),
                PUBLISHED,
                List.of(),
                Surroundings.UNKNOWN,
                Optional.empty(),
                Optional.of(new Finding(found, ids))));
    assertThat(verdict.decision()).isEqualTo(decision);
    assertThat(verdict.reasons()).contains(new Reason.Diagnosed(found, ids, decision));
  }

  /** With values of its own, each kick hides that no one model describes all of them. */
  @ParameterizedTest
  @CsvSource({
    // residual, of one model, decision
    "0.99, 2.55, CHECK_FIRST", // ode-chip
    "1.86, 2.32, PUBLISH", // erforce-chip
    "1.26, 1.55, PUBLISH", // erforce-flat
    "1.01, 11.5, CHECK_FIRST",
  })
  void oneModelHasToDescribeAllKicks(double own, double one, PublishDecision decision) {
    PublishVerdict verdict = judge(good(own, one));
    assertThat(verdict.decision()).isEqualTo(decision);
    boolean told = verdict.reasons().contains(new Reason.KicksDiffer(one, own, 2 * one, 2 * own));
    assertThat(told).isEqualTo(decision == PublishDecision.CHECK_FIRST);
  }

  @Test
  void aValueThatIsWideOpenOrMustNotBeUsedAgreesWithNothing() {
    Average wide = new Average(-2.2, 0.3, 0, 20);
    assertThat(judge(calibration(wide, -2.2, 0.3, 1, 20)).reasons())
        .anyMatch(r -> r instanceof Reason.Imprecise)
        .noneMatch(r -> r instanceof Reason.AgreesWithPublished);
    assertThat(judged(surroundings(geometry(12, 4), geometry(9, 4))).reasons())
        .noneMatch(r -> r instanceof Reason.AgreesWithPublished);
  }

  @Test
  void parametersOfAnExtendedModelAreNotPublished() {
    PublishVerdict verdict = VerdictRule.judge(evidence(List.of("air_drag"), Optional.empty()));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.DO_NOT_PUBLISH);
    assertThat(verdict.reasons().get(0))
        .isEqualTo(new Reason.ExtendedModelOnly(List.of("air_drag")));
  }

  @Test
  void aWrongModelComesBeforeTooFewKicks() {
    Calibration one = calibration(new Average(-3, 0.02, 0, 1), -3, 0.02, 9, 1);
    PublishVerdict verdict =
        VerdictRule.judge(
            Evidence.of(
                new Calibration(
                    one.kicks(),
                    Map.of("accSlide", new Average(-3, 0.02, 0, 1)),
                    Map.of(),
                    one.joint(),
                    one.cameras(),
                    1),
                PUBLISHED));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.CHECK_FIRST);
    assertThat(verdict.reasons())
        .containsExactly(
            new Reason.ResidualAboveNoise(
                9, one.joint().orElseThrow().rmsMm(), PublishDecision.CHECK_FIRST),
            new Reason.FewKicks(KickKind.FLAT, "accSlide", 1, 5, 1));
    assertThat(verdict.diagnose()).isTrue();
  }

  @Test
  void withoutKicksMoreAreNeeded() {
    Calibration none =
        new Calibration(
            List.of(), Map.of(), Map.of(), Optional.empty(), CameraViews.of(List.of()), 1);
    assertThat(VerdictRule.judge(Evidence.of(none, PUBLISHED)))
        .isEqualTo(
            new PublishVerdict(PublishDecision.RECORD_MORE, List.of(new Reason.NoKicks(0)), false));
  }

  @Test
  void chipsThatDoNotFlyAreNone() {
    // Kicks without a fit do not fly.
    Calibration chips =
        new Calibration(
            kicks(KickKind.CHIP, 6),
            Map.of(),
            Map.of("dampingZ", new Average(0.89, 0.004, 0, 6)),
            Optional.empty(),
            CameraViews.of(List.of()),
            1);
    BallModels published =
        new BallModels(Optional.empty(), Optional.of(new ChipModel(0.7, 0.9, 0.56, -0.3)));
    PublishVerdict verdict = VerdictRule.judge(Evidence.of(chips, published));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.DO_NOT_PUBLISH);
    assertThat(verdict.reasons())
        .as("nor is more of them asked for")
        .containsExactly(new Reason.NoChips(6, 6));
  }

  /** Of one chip, whose flight the fit does not show, nobody can tell that it stayed on the ground. */
  @Test
  void aFewChipsAreNotCalledFlat() {
    Calibration one =
        new Calibration(
            kicks(KickKind.CHIP, 1),
            Map.of(),
            Map.of("dampingZ", new Average(0.55, 0.02, 0, 1)),
            Optional.empty(),
            CameraViews.of(List.of()),
            1);
    PublishVerdict verdict =
        VerdictRule.judge(
            Evidence.of(
                one,
                new BallModels(
                    Optional.empty(), Optional.of(new ChipModel(0.7, 0.9, 0.56, -0.3)))));
    assertThat(verdict.decision()).isEqualTo(PublishDecision.RECORD_MORE);
    assertThat(verdict.reasons()).noneMatch(r -> r instanceof Reason.NoChips);
  }

  @Test
  void recordingsOfSeveralFieldsAreNotOneCarpet() {
    Surroundings two = surroundings(geometry(12, 4), geometry(9, 4));
    assertThat(judged(two).reasons().get(0))
        .isEqualTo(
            new Reason.SeveralFields(
                List.of(new FieldSize(12, 9), new FieldSize(9, 9)),
                List.of(List.of("0.log"), List.of("1.log"))));
    assertThat(judged(two).decision()).isEqualTo(PublishDecision.DO_NOT_PUBLISH);
    Surroundings elsewhere =
        new Surroundings(surroundings(geometry(12, 4)).recordings(), Optional.of(geometry(9, 4)));
    assertThat(judged(elsewhere).decision()).isEqualTo(PublishDecision.DO_NOT_PUBLISH);
    assertThat(((Reason.SeveralFields) judged(elsewhere).reasons().get(0)).recordings())
        .containsExactly(List.of("0.log"), List.of());
    assertThat(judged(surroundings(geometry(12, 4), geometry(12, 4))).decision())
        .isEqualTo(PublishDecision.PUBLISH);
    assertThat(judged(surroundings(geometry(12, 4), geometry(12, 5))).reasons().get(0))
        .isEqualTo(new Reason.OtherCameras(List.of(List.of("0.log"), List.of("1.log"))));
  }

  @Test
  void rehearsingIsNotCalibratingAField() {
    Surroundings mixed =
        new Surroundings(
            List.of(recorded("sim.log", true), recorded("real.log", false)), Optional.empty());
    assertThat(judged(mixed).reasons().get(0))
        .isEqualTo(new Reason.SimulatedField(1, 2, List.of("sim.log")));
    assertThat(judged(mixed).decision()).isEqualTo(PublishDecision.DO_NOT_PUBLISH);
    PublishVerdict rehearsal =
        judged(new Surroundings(List.of(recorded("sim.log", true)), Optional.empty()));
    assertThat(rehearsal.decision()).isEqualTo(PublishDecision.PUBLISH);
    assertThat(rehearsal.reasons()).contains(new Reason.SimulatedField(1, 1, List.of("sim.log")));
  }

  @Test
  void camerasThatAreNotWhatTheyAreTakenForAreCheckedFirst() {
    VisionFault clock = new VisionFault.ClockRate(List.of(0, 1), 0.99, false);
    VisionFault turned = new VisionFault.MixedUp(List.of(1), false);
    for (VisionFault fault : List.of(clock, turned)) {
      Surroundings faulty =
          new Surroundings(
              List.of(
                  new Surroundings.Recorded("a.log", false, Optional.empty(), List.of(fault)),
                  recorded("b.log", false)),
              Optional.empty());
      assertThat(judged(faulty).decision()).isEqualTo(PublishDecision.CHECK_FIRST);
      assertThat(judged(faulty).reasons().get(0))
          .isEqualTo(new Reason.FaultyVision(fault, List.of("a.log")));
    }
  }

  /** grSim's clock is 3.5 % slow when the machine is busy; its own time counts there. */
  @Test
  void theClockOfASimulatorIsARemark() {
    Reason remark =
        new Reason.FaultyVision(new VisionFault.ClockRate(List.of(0), 1.035, true), List.of());
    Surroundings simulator =
        new Surroundings(
            List.of(
                new Surroundings.Recorded(
                    "grsim.log",
                    false,
                    Optional.empty(),
                    List.of(((Reason.FaultyVision) remark).fault()))),
            Optional.empty());
    assertThat(judged(simulator).decision()).isEqualTo(PublishDecision.PUBLISH);
    assertThat(judged(simulator).reasons()).contains(remark);
  }

  private static Surroundings.Recorded recorded(String name, boolean simulated) {
    return new Surroundings.Recorded(name, simulated, Optional.empty());
  }

  private static Surroundings surroundings(FieldGeometry... geometries) {
    return new Surroundings(
        IntStream.range(0, geometries.length)
            .mapToObj(i -> new Surroundings.Recorded(i + ".log", false, Optional.of(geometries[i])))
            .toList(),
        Optional.empty());
  }

  private static FieldGeometry geometry(double length, double height) {
    return FieldGeometry.of(length, 9, 1.8, 0.18, 0.3, List.of(camera(height)));
  }

  private static CameraCalibration camera(double height) {
    return new CameraCalibration(
        0, 500, 390, 290, 0.1, 1, 0, 0, 0, 0, 0, 1000 * height, 0, 0, height, 780, 580);
  }

  private static PublishVerdict judge(Calibration calibration) {
    return VerdictRule.judge(Evidence.of(calibration, PUBLISHED));
  }

  private static PublishVerdict judged(Surroundings surroundings) {
    return VerdictRule.judge(
        new Evidence(
            good(1), PUBLISHED, List.of(), surroundings, Optional.empty(), Optional.empty()));
  }

  private static Evidence evidence(List<String> effects, Optional<Finding> finding) {
    return new Evidence(
        good(3), PUBLISHED, effects, Surroundings.UNKNOWN, Optional.empty(), finding);
  }

  /** Good residuals do not show small systematic errors, by which predictions are off. */
  @Test
  void whoHasNotDiagnosedIsToldOnceNothingElseHoldsTheModelBack() {
    Reason remark = new Reason.NotDiagnosed();
    assertThat(judge(good(1)).reasons()).contains(remark);
    assertThat(judge(good(1)).decision()).isEqualTo(PublishDecision.PUBLISH);
    assertThat(judge(good(1)).diagnose()).isFalse();
    assertThat(judge(good(3)).reasons()).doesNotContain(remark);
    assertThat(VerdictRule.judge(forced(1)).reasons()).doesNotContain(remark);
    Finding nothing = new Finding(Verdict.MODEL_ADEQUATE, List.of());
    assertThat(VerdictRule.judge(evidence(List.of(), Optional.of(nothing))).reasons())
        .doesNotContain(remark);
  }

  /** Before a cause is looked for, the kicks must be what they are taken for. */
  @Test
  void aKindThatWasGivenIsTheFirstSuspect() {
    PublishVerdict bad = VerdictRule.judge(forced(3));
    assertThat(bad.reasons().get(0)).isEqualTo(new Reason.ForcedKind(KickKind.FLAT));
    assertThat(bad.decision()).isEqualTo(PublishDecision.CHECK_FIRST);
    assertThat(bad.diagnose()).isFalse();
    assertThat(VerdictRule.judge(forced(1)).decision()).isEqualTo(PublishDecision.PUBLISH);
  }

  private static Evidence forced(double ratio) {
    return new Evidence(
        good(ratio),
        PUBLISHED,
        List.of(),
        Surroundings.UNKNOWN,
        Optional.of(KickKind.FLAT),
        Optional.empty());
  }

  private static Calibration good(double ratio) {
    return good(ratio, ratio);
  }

  private static Calibration good(double ratio, double oneRatio) {
    Calibration good = calibration(new Average(-3, 0.01, 0, 20), -3, 0.01, ratio, 20);
    return new Calibration(
        good.kicks(),
        good.flat(),
        good.chip(),
        Optional.of(jointFit(-3, 0.01, ratio, oneRatio)),
        good.cameras(),
        good.seed());
  }

  private static Calibration calibration(
      Average slide, double joint, double jointError, double ratio, int kicks) {
    Map<String, Average> flat = new LinkedHashMap<>();
    flat.put("accSlide", slide);
    flat.put("accRoll", ROLL);
    flat.put("kSwitch", SWITCH);
    return new Calibration(
        kicks(KickKind.FLAT, kicks),
        flat,
        Map.of(),
        Optional.of(jointFit(joint, jointError, ratio)),
        CameraViews.of(List.of()),
        1);
  }

  private static JointFit jointFit(double slide, double error, double ratio) {
    return jointFit(slide, error, ratio, ratio);
  }

  private static JointFit jointFit(double slide, double error, double ratio, double oneRatio) {
    Parameter parameter = FlatModel.typical().parameters().get(0).withValue(slide);
    return new JointFit(
        List.of(new Estimate(parameter, error, Optional.empty(), false)),
        List.of(),
        Map.of(),
        2 * ratio,
        2 * ratio,
        Double.NaN,
        1000,
        0,
        ratio * ratio,
        new JointFit.OneModel(2 * oneRatio, oneRatio * oneRatio),
        5,
        true);
  }

  /** Kicks that are used, of which nothing else is known. */
  private static List<CalibratedKick> kicks(KickKind kind, int count) {
    return IntStream.rangeClosed(1, count).mapToObj(id -> kick(id, kind)).toList();
  }

  private static CalibratedKick kick(int id, KickKind kind) {
    Kick kick =
        new Kick(
            id,
            id,
            0,
            0,
            1,
            0,
            Optional.empty(),
            true,
            KickEnd.STOPPED,
            id + 1,
            new Observations.Builder().build());
    KickFit none =
        new KickFitter(FitSettings.defaults())
            .fit(
                FitProblem.of(
                    kick, CameraViews.of(List.of()), FlatModel.typical(), ChipModel.typical()),
                kind);
    return new CalibratedKick(
        none, List.of(new Sample(id, "accSlide", -3, 0.1, Optional.empty())), Optional.empty());
  }
}
