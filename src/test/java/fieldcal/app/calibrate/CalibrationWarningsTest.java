package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.fit.Agreement;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class CalibrationWarningsTest {
  /** Four cameras over one field. */
  private static final Map<Integer, Set<Integer>> FOUR =
      Stream.of(0, 1, 2, 3).collect(Collectors.toMap(id -> id, id -> Set.of(0, 1, 2, 3)));

  @Test
  void camerasThatNoKickLinksAreNamed() {
    assertThat(
            CalibrationWarnings.uncompared(
                List.of(new int[] {2}, new int[] {0, 1}, new int[] {1}, new int[] {2, 3}), FOUR))
        .singleElement()
        .satisfies(text -> assertThat(text).contains("(0 and 1; 2 and 3)"));
    assertThat(CalibrationWarnings.uncompared(List.of(new int[] {0, 1, 2}, new int[] {3}), FOUR))
        .singleElement()
        .satisfies(text -> assertThat(text).contains("(0, 1 and 2; 3)"));
  }

  /** Nobody can kick from a field into another one, or into the view that a camera had before it was calibrated again. */
  @Test
  void camerasOfDifferentFieldsAreNotCompared() {
    Map<Integer, Set<Integer>> twoFields = new HashMap<>(FOUR);
    Set.of(100, 101).forEach(id -> twoFields.put(id, Set.of(100, 101)));
    assertThat(
            CalibrationWarnings.uncompared(
                List.of(new int[] {0, 1, 2, 3}, new int[] {100, 101}), twoFields))
        .isEmpty();
    assertThat(
            CalibrationWarnings.uncompared(
                List.of(new int[] {0, 1, 2, 3}, new int[] {100}, new int[] {101}), twoFields))
        .singleElement()
        .satisfies(text -> assertThat(text).contains("(100; 101)"));
  }

  @Test
  void oneSentenceNamesEveryCameraThatIsOff() {
    assertThat(CalibrationWarnings.offsets(Map.of(0, 4.9, 1, 26.4)))
        .hasValue(
            "Camera 1 reports everything 26 mm off from the mean of all cameras. This offset is"
                + " taken out here, but not in a match: calibrate the camera again.");
    assertThat(CalibrationWarnings.offsets(Map.of(0, 9.6, 1, 26.4, 3, 10.1)))
        .hasValueSatisfying(
            text ->
                assertThat(text)
                    .startsWith("Cameras 0, 1 and 3 report everything 10, 26 and 10 mm off from")
                    .contains("These offsets are")
                    .endsWith("calibrate the cameras again."));
    assertThat(CalibrationWarnings.offsets(Map.of(0, 20.2, 1, 20.2)).orElseThrow())
        .startsWith("Cameras 0 and 1 report everything 20 mm off from");
    assertThat(CalibrationWarnings.offsets(Map.of(0, 1.0))).isEmpty();
  }

  @Test
  void whyFarValuesAreUsedIsSaid() {
    assertThat(CalibrationWarnings.medians(List.of())).isEmpty();
    assertThat(CalibrationWarnings.medians(List.of("switch to rolling (k_switch)")))
        .hasValueSatisfying(
            text ->
                assertThat(text)
                    .contains("about the mean of the switch to rolling (k_switch). Some of")
                    .contains("The median is given"));
  }

  /** Half a per cent apart is nothing that anybody plays by. */
  @Test
  void groupsThatLieCloseTogetherAreNotNamed() {
    assertThat(CalibrationWarnings.matters(new Agreement(0.7128, 0.53, 0.7094, false))).isFalse();
    assertThat(CalibrationWarnings.matters(new Agreement(-0.3, 0.33, -0.25, false))).isTrue();
  }

  @Test
  void whatKicksAgreeOnIsSaid() {
    Agreement agreement = new Agreement(0.6878, 0.33, 0.6639, false);
    assertThat(CalibrationWarnings.agreement("kSwitch", agreement, 12))
        .startsWith("The kicks are of two kinds: 4 of 12 agree on a switch to rolling (k_switch)")
        .contains("of 0.6878, the others have 0.6639 on average");
    assertThat(
            CalibrationWarnings.agreement("accRoll", new Agreement(-0.3, 0.33, -0.25, false), 12))
        .contains("of −0.3000 m/s², the others have −0.2500 m/s² on average");
  }

  @Test
  void linksGoOnFromKickToKick() {
    List<int[]> kicks = List.of(new int[] {0, 1}, new int[] {2, 3}, new int[] {3, 0});
    assertThat(CalibrationWarnings.uncompared(kicks, FOUR)).isEmpty();
    assertThat(CalibrationWarnings.uncompared(List.of(), FOUR)).isEmpty();
  }
}
