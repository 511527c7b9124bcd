package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.Verdict;
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

  private static Cause cause(Effect effect, double error, String... ties) {
    Map<String, Double> errors = new HashMap<>();
    effect.parameters().stream()
        .filter(p -> p.estimated())
        .forEach(p -> errors.put(p.name(), error));
    return new Cause(effect, errors, 0, 20, new Gain(1, 30, 0.5, 1.5), List.of(ties), "");
  }

  private static Diagnosis diagnosis(Verdict verdict, Cause... causes) {
    Quality quality = new Quality(2, 1, 2, Map.of());
    return new Diagnosis(
        verdict,
        quality,
        quality,
        List.of(causes),
        List.of(),
        new Unexplained(false, 0, 0, List.of()),
        List.of(),
        List.of(),
        List.of(),
        null,
        null,
        1);
  }

  private static Judgement judge(HiddenCase hidden, Visibility visibility, Diagnosis diagnosis) {
    String[] effects = hidden.hidden().stream().map(EffectSetting::toString).toArray(String[]::new);
    return Judge.judge(
        hidden,
        hidden.hidden().stream().map(e -> visibility).toList(),
        truth(hidden.settings().cameras().count(), effects),
        diagnosis);
  }

  private static Judgement judge(HiddenCase hidden, Cause... causes) {
    Verdict verdict = causes.length == 0 ? Verdict.MODEL_ADEQUATE : Verdict.EXPLAINED;
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
    assertThat(judge(drag, CLEAR, diagnosis(Verdict.UNEXPLAINED_STRUCTURE)).outcome())
        .isEqualTo(Outcome.UNEXPLAINED);
    Judgement more = judge(drag, cause(new AirDrag(0.5), 0.01), cause(new KickSpin(0.1), 0.01));
    assertThat(more.outcome()).isEqualTo(Outcome.WRONG);
    assertThat(more.wrong()).hasSize(1);
  }

  @Test
  void nothingIsThere() {
    HiddenCase none = hidden(Category.NULL, 4);
    assertThat(judge(none).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(none, cause(new AirDrag(0.5), 0.1)).outcome()).isEqualTo(Outcome.WRONG);
    assertThat(judge(none, CLEAR, diagnosis(Verdict.UNEXPLAINED_STRUCTURE)).outcome())
        .isEqualTo(Outcome.UNEXPLAINED);
  }

  @Test
  void anUnknownEffectHasNoName() {
    HiddenCase waves = hidden(Category.UNKNOWN, 4, "carpet_waves:amplitude=0.3");
    assertThat(judge(waves, CLEAR, diagnosis(Verdict.UNEXPLAINED_STRUCTURE)).outcome())
        .isEqualTo(Outcome.RIGHT);
    assertThat(judge(waves).outcome()).isEqualTo(Outcome.MISSED);
    assertThat(judge(waves, INVISIBLE, diagnosis(Verdict.MODEL_ADEQUATE)).outcome())
        .isEqualTo(Outcome.RIGHT);
    assertThat(judge(waves, cause(new FieldSlope(0.1, 0), 0.01)).outcome())
        .isEqualTo(Outcome.WRONG);
  }

  @Test
  void bothOfAPairMustBeFound() {
    HiddenCase pair =
        hidden(Category.PAIR, 4, "air_drag:cd=0.5", "camera_time_offset:ms=3,camera=1");
    Cause drag = cause(new AirDrag(0.5), 0.01);
    Cause time = cause(new CameraTimeOffset(3, 1), 0.1);
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

  private static Diagnosis explained(Effect effect) {
    return diagnosis(Verdict.EXPLAINED, cause(effect, 0.1));
  }

  @Test
  void withTwoCamerasAHeightIsAnOffset() {
    HiddenCase height = hidden(Category.SINGLE, 2, "ball_height_error:mm=8");
    Diagnosis offset = explained(new CameraOffset(5, 0, 1));
    assertThat(judge(height, OFFSET_ONLY, offset).outcome()).isEqualTo(Outcome.RIGHT);
    assertThat(judge(height, CLEAR, offset).outcome()).isEqualTo(Outcome.WRONG);
    HiddenCase along = hidden(Category.SINGLE, 2, "camera_offset:x_mm=5,camera=0");
    Diagnosis raised = explained(new BallHeightError(8));
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
