package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What is proposed to record when causes cannot be told apart. */
class NextKicksTest {
  private static final String GENERAL = "Record five or more kicks of each kind";
  private static final String UNKNOWN = "kicks of different speeds, places";

  static Stream<List<String>> pairs() {
    List<String> ids = EffectCatalogue.all().stream().map(Effect::id).toList();
    return ids.stream()
        .flatMap(a -> ids.stream().filter(b -> a.compareTo(b) < 0).map(b -> List.of(a, b)));
  }

  @ParameterizedTest
  @MethodSource("pairs")
  void anyTwoCausesHaveAText(List<String> pair) {
    String text = NextKicks.toTellApart(pair.get(0), List.of(pair.get(1)));
    assertThat(text).isNotBlank().doesNotContain("_").doesNotContain(UNKNOWN).endsWith(".");
    assertThat(text.split("[.:] ").length).as("sentences of: %s", text).isLessThanOrEqualTo(3);
    assertThat(NextKicks.toTellApart(pair.get(1), List.of(pair.get(0)))).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource({
    "air_drag,magnus,chips of 4–6 m/s",
    "air_drag,speed_dependent_roll,at 2 and at 6 m/s",
    "magnus,speed_dependent_roll,chips of 4–6 m/s",
    "ball_height_error,camera_offset,With only two cameras, no kick",
    "ball_height_error,lens_distortion_error,in proportion to its distance",
    "camera_pose_error,lens_distortion_error,in proportion to its distance",
    "camera_pose_error,ball_height_error,compare the drawn field lines",
    "camera_offset,camera_pose_error,No more kicks are needed",
    "camera_time_offset,clock_skew,at the end of a session",
    "camera_time_offset,rolling_shutter,along the rows",
    "clock_skew,rolling_shutter,along the rows",
    "camera_offset,camera_time_offset,Let a ball rest",
    "carpet_nap,field_slope,bends the path",
    "carpet_nap,worn_region,in both halves",
    "drift,worn_region,in both halves",
    "kick_spin,robot_kick_bias,how far the ball slides",
    "bounce_spin_coupling,speed_dependent_restitution,dribbler off"
  })
  void lookAlikesHaveTheirOwn(String a, String b, String words) {
    assertThat(NextKicks.toTellApart(a, List.of(b))).contains(words).doesNotContain(GENERAL);
  }

  @Test
  void otherPairsSayWhereEachShows() {
    assertThat(NextKicks.toTellApart("drift", List.of("air_drag")))
        .startsWith(GENERAL)
        .contains("air drag shows in flat kicks and chips of 5–6 m/s")
        .contains("at the end of the session");
  }

  @Test
  void withoutRivalsNothingIsToBeRecorded() {
    assertThat(NextKicks.toTellApart("air_drag", List.of())).isEmpty();
    assertThat(NextKicks.toTellApart("air_drag", List.of("air_drag"))).isEmpty();
  }

  @Test
  void betweenTwoCamerasNoKickMayDecide() {
    assertThat(NextKicks.toTellApart("camera_offset", List.of("camera_offset of camera 1")))
        .startsWith("No kick shows which")
        .contains("lay a ball on a mark");
    assertThat(NextKicks.toTellApart("camera_pose_error", List.of("camera_pose_error of camera 2")))
        .startsWith("Record four flat kicks");
    assertThat(NextKicks.toTellApart("ball_height_error", List.of("camera_offset of camera 1")))
        .isEqualTo(NextKicks.toTellApart("ball_height_error", List.of("camera_offset")));
  }

  @Test
  void whatServesTwoRivalsIsSaidOnce() {
    String both = NextKicks.toTellApart("air_drag", List.of("magnus", "speed_dependent_roll"));
    assertThat(both).isEqualTo(NextKicks.toTellApart("air_drag", List.of("magnus")));
    assertThat(NextKicks.toTellApart("air_drag", List.of("magnus", "drift")))
        .startsWith(both)
        .contains(GENERAL);
  }

  @Test
  void aCauseWithoutWordsOfItsOwnIsNoError() {
    assertThat(NextKicks.toTellApart("air_drag", List.of("new_effect")))
        .contains("new effect")
        .contains(UNKNOWN);
  }

  @ParameterizedTest
  @CsvSource({
    "camera_offset,camera_offset of camera 1,false",
    "camera_offset,camera_pose_error of camera 1,false",
    "camera_pose_error,camera_offset,false",
    "camera_offset,ball_height_error,false",
    "camera_time_offset,camera_time_offset of camera 0,false",
    "camera_pose_error,camera_pose_error of camera 2,true",
    "carpet_nap,field_slope,true",
    "drift,air_drag,true"
  })
  void onlySomeCausesAreToldApartByKicks(String cause, String rival, boolean byKicks) {
    assertThat(NextKicks.canTellApart(cause, rival)).isEqualTo(byKicks);
  }
}
