package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.hidden.Answer.Fit;
import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.diagnosis.hidden.Answer.Term;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Outcome;
import fieldcal.effect.Effect;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.WornRegion;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.truth.Truth;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Hand-made diagnoses and what the judge makes of them. */
class JudgeTest {
  private static final Visibility CLEAR = new Visibility(3, 3, 12);
  private static final Visibility OFFSET_ONLY = new Visibility(3, 0.1, 12);
  private static final Visibility INVISIBLE = new Visibility(0.1, 0.1, 12);

  private static final String UNEXPLAINED = "unexplained_structure";

  private static Truth truth(int cameras, String... effects) {
    return Simulation.of(settings(cameras, effects)).run(packet -> {});
  }

  private static SimulationSettings settings(int cameras, String... effects) {
    return SimulationSettings.DEFAULT
        .withScenario(ScenarioKind.FLAT, 3)
        .withCameras(CameraSettings.DEFAULT.withCount(cameras))
        .withEffects(effects);
  }

  private static HiddenCase hidden(Category category, int cameras, String... effects) {
    return new HiddenCase(
        1,
        category,
        settings(cameras, effects),
        Arrays.stream(effects).map(EffectSetting::parse).toList(),
        false,
        List.of());
  }

  private static Named cause(Effect effect, double error, String... ties) {
    Map<String, Double> errors = new HashMap<>();
    effect.parameters().stream()
        .filter(p -> p.estimated())
        .forEach(p -> errors.put(p.name(), error));
    return new Named(effect, errors, 0, 20, 0.5, List.of(ties));
  }

  private static Answer diagnosis(String verdict, Named... causes) {
    return learned(verdict, List.of(), causes);
  }

  private static Answer learned(String verdict, List<Term> terms, Named... causes) {
    Fit fit = new Fit(1, 2);
    return new Answer(verdict, List.of(causes), terms, List.of(), fit, fit, List.of());
  }

  private static Judgement judge(HiddenCase hidden, Visibility visibility, Answer diagnosis) {
    String[] effects = hidden.hidden().stream().map(EffectSetting::toString).toArray(String[]::new);
    return Judge.judge(
        hidden,
        hidden.hidden().stream().map(e -> visibility).toList(),
        truth(hidden.settings().cameras().count(), effects),
        diagnosis);
  }

  private static Judgement judge(HiddenCase hidden, Named... causes) {
    String verdict = causes.length == 0 ? Answer.ADEQUATE : Answer.EXPLAINED;
    return judge(hidden, CLEAR, diagnosis(verdict, causes));
  }

  @Test
  void aNameIsRightWrongTiedOrMissing() {
    HiddenCase drag = hidden(Category.SINGLE, 4, "air_drag:cd=0.5");
    Judgement right = judge(drag, cause(new AirDrag(0.52), 0.01));
    assertThat(right.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(right.found().get(0).strength().get().sigmas()).isEqualTo(2, within(1e-9));
    assertThat(right.found().get(0).strength().get().percent()).isEqualTo(4, within(1e-9));
    assertThat(judge(drag, cause(new KickSpin(0.1), 0.01)).outcome()).isEqualTo(Outcome.WRONG);
    assertThat(judge(drag, cause(new KickSpin(0.1), 0.01, "air_drag")).outcome())
        .isEqualTo(Outcome.TIE);
    assertThat(judge(drag).outcome()).isEqualTo(Outcome.MISSED);
    assertThat(judge(drag, CLEAR, diagnosis(UNEXPLAINED)).outcome()).isEqualTo(Outcome.UNEXPLAINED);
    Judgement more = judge(drag, cause(new AirDrag(0.5), 0.01), cause(new KickSpin(0.1), 0.01));
    assertThat(more.outcome()).isEqualTo(Outcome.WRONG);
    assertThat(more.wrong()).hasSize(1);
  }

  @Test
  void nothingIsThere() {
    HiddenCase none = hidden(Category.NULL, 4);
    assertThat(judge(none).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(none, cause(new AirDrag(0.5), 0.1)).outcome()).isEqualTo(Outcome.WRONG);
    assertThat(judge(none, CLEAR, diagnosis(UNEXPLAINED)).outcome()).isEqualTo(Outcome.UNEXPLAINED);
  }

  @Test
  void anUnnamedCauseHasNoName() {
    HiddenCase waves = hidden(Category.UNNAMED, 4, "carpet_waves:amplitude=0.3");
    assertThat(judge(waves, CLEAR, diagnosis(UNEXPLAINED)).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(waves).outcome()).isEqualTo(Outcome.MISSED);
    assertThat(judge(waves, INVISIBLE, diagnosis(Answer.ADEQUATE)).outcome())
        .isEqualTo(Outcome.RIGHT);
    assertThat(judge(waves, cause(new FieldSlope(0.1, 0), 0.01)).outcome())
        .isEqualTo(Outcome.WRONG);
  }

  @Test
  void whatIsLearnedFirstOfAnUnnamedCauseIsJudged() {
    HiddenCase place = hidden(Category.UNNAMED, 4, "unnamed_ring:change=0.3");
    Judgement right =
        judge(
            place,
            CLEAR,
            learned("partly_explained", List.of(new Term("ground", List.of("x", "y")))));
    assertThat(right.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(right.rightVariable()).contains(true);
    Judgement speed =
        judge(
            place,
            CLEAR,
            learned("partly_explained", List.of(new Term("ground", List.of("speed")))));
    assertThat(speed.rightVariable()).contains(false);
    assertThat(judge(place).rightVariable()).isEmpty();
    assertThat(judge(place, cause(new AirDrag(0.2), 0.01)).outcome()).isEqualTo(Outcome.WRONG);
  }

  @Test
  void ofAMixtureEachIsCounted() {
    HiddenCase three =
        hidden(
            Category.MIXTURE,
            4,
            "air_drag:cd=0.5",
            "field_slope:percent=0.2,direction=1",
            "camera_time_offset:ms=3,camera=1");
    Named drag = cause(new AirDrag(0.5), 0.01);
    Named time = cause(new CameraTimeOffset(3, 1), 0.1);
    Judgement two = judge(three, drag, time);
    assertThat(two.outcome()).isEqualTo(Outcome.MISSED);
    assertThat(two.complete()).isFalse();
    assertThat(two.visible()).hasSize(3);
    assertThat(two.found()).filteredOn(f -> f.how() == How.NAMED).hasSize(2);
    Judgement all = judge(three, drag, time, cause(new FieldSlope(0.21, 1), 0.01));
    assertThat(all.complete()).isTrue();
    assertThat(judge(three, drag, time, cause(new KickSpin(0.1), 1)).wrong()).hasSize(1);
  }

  @Test
  void aNameThatIsSaidToBeATieIsNotWrong() {
    HiddenCase drag = hidden(Category.SINGLE, 4, "air_drag:cd=0.5");
    Judgement both =
        judge(drag, cause(new AirDrag(0.5), 0.01), cause(new KickSpin(0.1), 0.1, "air_drag"));
    assertThat(both.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(both.excused()).hasSize(1);
    HiddenCase offset = hidden(Category.SINGLE, 4, "camera_offset:x_mm=8,camera=1");
    Named other = cause(new CameraOffset(-8, 0, 0), 0.1, "camera_offset of camera 1");
    assertThat(judge(offset, other).outcome()).isEqualTo(Outcome.TIE);
    Named third = cause(new CameraOffset(-8, 0, 0), 0.1, "camera_offset of camera 2");
    assertThat(judge(offset, third).outcome()).isEqualTo(Outcome.WRONG);
  }

  @Test
  void aKnockedCameraMayAlsoBeSaidToBeOffset() {
    HiddenCase knocked =
        hidden(Category.PAIR, 4, "camera_moved:x_mm=8,at=9,camera=1", "air_drag:cd=0.5");
    Named drag = cause(new AirDrag(0.5), 0.01);
    Judgement half = judge(knocked, drag, cause(new CameraOffset(4, 0, 1), 0.1));
    assertThat(half.outcome()).isEqualTo(Outcome.MISSED);
    assertThat(half.wrong()).isEmpty();
    assertThat(judge(knocked, drag, cause(new CameraOffset(4, 0, 2), 0.1)).wrong()).hasSize(1);
  }

  @Test
  void bothOfAPairMustBeFound() {
    HiddenCase pair =
        hidden(Category.PAIR, 4, "air_drag:cd=0.5", "camera_time_offset:ms=3,camera=1");
    Named drag = cause(new AirDrag(0.5), 0.01);
    Named time = cause(new CameraTimeOffset(3, 1), 0.1);
    assertThat(judge(pair, time, drag).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(pair, drag).outcome()).isEqualTo(Outcome.MISSED);
    assertThat(judge(pair, drag, cause(new CameraTimeOffset(3, 2), 0.1)).outcome())
        .as("another camera")
        .isEqualTo(Outcome.WRONG);
    Judgement tie = judge(pair, drag, cause(new KickSpin(0.1), 0.1, "camera_time_offset"));
    assertThat(tie.outcome()).isEqualTo(Outcome.TIE);
    assertThat(tie.found()).extracting(f -> f.how()).containsExactly(How.NAMED, How.TIED);
  }

  @Test
  void ofTwoCamerasEitherMayBeNamed() {
    HiddenCase late = hidden(Category.SINGLE, 2, "camera_time_offset:ms=3,camera=1");
    Judgement other = judge(late, cause(new CameraTimeOffset(-3.1, 0), 0.1));
    assertThat(other.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(other.found().get(0).strength().get().sigmas()).isEqualTo(1, within(1e-6));
    assertThat(judge(late, cause(new CameraTimeOffset(3, 0), 0.1)).found().get(0).strength())
        .hasValueSatisfying(s -> assertThat(s.percent()).isGreaterThan(150));
  }

  @Test
  void aShiftedCameraIsAnOffset() {
    HiddenCase pose = hidden(Category.SINGLE, 4, "camera_pose_error:shift_x_mm=20,camera=1");
    Judgement offset = judge(pose, OFFSET_ONLY, explained(new CameraOffset(15, 0, 1)));
    assertThat(offset.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(offset.found().get(0).strength().get().percent()).isLessThan(1e-6);
    assertThat(judge(pose, OFFSET_ONLY, explained(new CameraOffset(15, 0, 2))).outcome())
        .isEqualTo(Outcome.WRONG);
    HiddenCase tilt = hidden(Category.SINGLE, 4, "camera_pose_error:tilt_mrad=4,axis=0.3,camera=1");
    assertThat(judge(tilt, CLEAR, explained(new CameraOffset(15, 0, 1))).outcome())
        .as("more than an offset can be seen")
        .isEqualTo(Outcome.WRONG);
    Judgement turned = judge(tilt, OFFSET_ONLY, explained(new CameraPoseError(4, 0.3, 0, 0, 0, 1)));
    assertThat(turned.found().get(0).strength().get().percent()).isLessThan(1e-6);
  }

  private static Answer explained(Effect effect) {
    return diagnosis(Answer.EXPLAINED, cause(effect, 0.1));
  }

  @Test
  void withTwoCamerasAHeightIsAnOffset() {
    HiddenCase height = hidden(Category.SINGLE, 2, "ball_height_error:mm=8");
    Answer offset = explained(new CameraOffset(5, 0, 1));
    assertThat(judge(height, OFFSET_ONLY, offset).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(height, CLEAR, offset).outcome()).isEqualTo(Outcome.WRONG);
    HiddenCase along = hidden(Category.SINGLE, 2, "camera_offset:x_mm=5,camera=0");
    Answer raised = explained(new BallHeightError(8));
    assertThat(judge(along, OFFSET_ONLY, raised).outcome()).isEqualTo(Outcome.RIGHT);
    HiddenCase across = hidden(Category.SINGLE, 2, "camera_offset:y_mm=5,camera=0");
    assertThat(judge(across, OFFSET_ONLY, raised).outcome()).isEqualTo(Outcome.WRONG);
  }

  @Test
  void directionsMayBeWrittenEitherWay() {
    HiddenCase slope = hidden(Category.SINGLE, 4, "field_slope:percent=0.5,direction=3.1");
    Judgement same = judge(slope, cause(new FieldSlope(-0.5, 3.1 - Math.PI), 0.01));
    assertThat(same.found().get(0).strength().get().percent()).isLessThan(1e-6);
    Judgement turned = judge(slope, cause(new FieldSlope(0.5, -3.1), 0.01));
    assertThat(turned.found().get(0).strength().get().percent())
        .isEqualTo(100 * 2 * Math.sin((Math.PI - 3.1)), within(0.1));
  }

  @Test
  void aWornRegionMayBeToldByTheRest() {
    HiddenCase half = hidden(Category.SINGLE, 4, "worn_region:change=0.25,region=[0,6.3,-4.8,4.8]");
    Judgement rest = judge(half, cause(new WornRegion(-0.2, -6.3, 0, -4.8, 4.8), 0.01));
    assertThat(rest.outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(rest.found().get(0).strength().get().percent()).isLessThan(1e-6);
    assertThat(judge(half, cause(new WornRegion(0.25, -6, 6, 1, 4), 0.01)).outcome())
        .isEqualTo(Outcome.WRONG);
  }

  @Test
  void spinIsMeasuredAgainstTheKicksThatWereMade() {
    HiddenCase spun = hidden(Category.SINGLE, 4, "kick_spin:fraction=-0.3,scatter=0");
    Judgement right = judge(spun, cause(new KickSpin(-0.27), 0.03));
    assertThat(right.found().get(0).strength().get().sigmas()).isEqualTo(1, within(1e-6));
    assertThat(right.found().get(0).strength().get().percent()).isEqualTo(10, within(1e-6));
  }
}
