package fieldcal.app.recording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.RecordingChoice.Apart;
import fieldcal.app.recording.RecordingChoice.Entry;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.vision.FieldGeometry;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class RecordingChoiceTest {
  private static final RecordingFacts REAL = facts("real", RecordingOrigin.FIELD, 0, 12, 4, 100);
  private static final RecordingFacts AGAIN = facts("again", RecordingOrigin.FIELD, 0, 12, 4, 200);
  private static final RecordingFacts MATCH =
      facts("match", RecordingOrigin.FIELD, 300, 12, 4, 900);
  private static final RecordingFacts REHEARSAL =
      facts("rehearsal", RecordingOrigin.SIMULATION, 0, 12, 5, 800);
  private static final RecordingFacts ELSEWHERE =
      facts("elsewhere", RecordingOrigin.FIELD, 0, 9, 4, 50);
  private static final RecordingFacts TWIN = facts("twin", RecordingOrigin.FIELD, 0, 12, 6, 60);

  private static final VisionContent WHOLE = VisionContentTest.messages(0, 2000);

  @Test
  void whatIsNoCalibrationOfThisFieldIsKeptApart() {
    RecordingChoice choice =
        RecordingChoice.of(List.of(AGAIN, ELSEWHERE, MATCH, REAL, REHEARSAL, TWIN), Map.of());
    assertThat(apart(choice))
        .isEqualTo(
            Map.of(
                "again", Apart.NO,
                "elsewhere", Apart.OTHER_FIELD,
                "match", Apart.MATCH,
                "real", Apart.NO,
                "rehearsal", Apart.SIMULATED,
                "twin", Apart.OTHER_CAMERAS));
    assertThat(choice.entries()).allMatch(e -> e.used() == (e.apart() == Apart.NO));
    assertThat(words(choice, "elsewhere")).isEqualTo("from another field (9.00 × 9.00 m)");
  }

  @Test
  void aRehearsalAloneIsUsed() {
    assertThat(apart(RecordingChoice.of(List.of(REHEARSAL), Map.of())))
        .containsEntry("rehearsal", Apart.NO);
    assertThat(apart(RecordingChoice.of(List.of(MATCH, REHEARSAL), Map.of())))
        .isEqualTo(Map.of("match", Apart.NO, "rehearsal", Apart.SIMULATED));
  }

  @Test
  void somebodysDecisionOverridesTheRule() {
    RecordingChoice choice =
        RecordingChoice.of(List.of(REAL, REHEARSAL), Map.of("real", false, "rehearsal", true));
    assertThat(choice.entries()).extracting(Entry::used).containsExactly(false, true);
    assertThat(words(choice, "real")).isEqualTo("left out by hand");
    assertThat(words(choice, "rehearsal")).isEqualTo("used by hand, though from a simulated field");
  }

  /** That a file is cut off is said whatever else is said of it. */
  @Test
  void aFileThatIsCutOffIsNamed() {
    RecordingChoice choice =
        RecordingChoice.of(List.of(cut(REAL), cut(ELSEWHERE), AGAIN), Map.of());
    assertThat(words(choice, "real"))
        .isEqualTo("the file is cut off: its end is missing or damaged");
    assertThat(words(choice, "elsewhere"))
        .isEqualTo(
            "from another field (9.00 × 9.00 m); the file is cut off: its end is missing or"
                + " damaged");
    assertThat(words(choice, "again")).isEmpty();
  }

  /** A reason that concerns some recordings names them as the operator knows them. */
  @Test
  void recordingsOfOneNameAreToldApartByTheirPaths() {
    List<RecordingFacts> all =
        List.of(
            facts("friday/a.log", RecordingOrigin.SIMULATION, 0, 12, 4, 1),
            facts("sunday/a.log", RecordingOrigin.SIMULATION, 0, 12, 4, 2),
            facts("sunday/b.log", RecordingOrigin.SIMULATION, 0, 12, 4, 3));
    assertThat(RecordingFacts.surroundings(all).simulated())
        .containsExactly("friday/a.log", "sunday/a.log", "b.log");
  }

  /** A second file with the same frames does not count twice, and does not decide which field is the newest. */
  @Test
  void aCopyIsKeptApart() {
    RecordingFacts original = holding(REAL, WHOLE);
    RecordingFacts copy = holding(AGAIN, WHOLE);
    RecordingChoice choice = RecordingChoice.of(List.of(original, copy), Map.of());
    assertThat(choice.entries()).extracting(Entry::used).containsExactly(true, false);
    assertThat(choice.entries()).extracting(Entry::apart).containsExactly(Apart.NO, Apart.COPY);
    assertThat(words(choice, "again")).isEqualTo("a copy of real");
    assertThat(choice.copies()).singleElement().asString().contains("again: a copy of real");
    Map<String, Boolean> other = Map.of("real", false, "again", true);
    assertThat(RecordingChoice.of(List.of(original, copy), other).copies()).isEmpty();
    // Two recordings in which vision sent nothing are not the same.
    assertThat(apart(RecordingChoice.of(List.of(REAL, AGAIN), Map.of())).values())
        .containsOnly(Apart.NO);
  }

  /** A recording that is cut off, or that another machine began later, holds the same kicks. */
  @Test
  void aPartIsKeptApart() {
    RecordingFacts part = holding(REAL, VisionContentTest.messages(500, 1500));
    RecordingFacts whole = holding(AGAIN, WHOLE);
    RecordingFacts later = holding(MATCH, VisionContentTest.messages(600, 2400));
    RecordingChoice choice = RecordingChoice.of(List.of(cut(part), whole, later), Map.of());
    assertThat(choice.entries()).extracting(Entry::used).containsExactly(false, true, false);
    assertThat(words(choice, "real"))
        .isEqualTo("a part of again; the file is cut off: its end is missing or damaged");
    assertThat(words(choice, "match")).matches("7\\d % of its frames are in again");
    assertThat(choice.copies()).hasSize(2);
    RecordingFacts next = holding(MATCH, VisionContentTest.messages(1500, 3000));
    assertThat(RecordingChoice.of(List.of(whole, next), Map.of()).copies()).isEmpty();
  }

  /** A recording that is known to be simulated is not left out for one that does not say it. */
  @Test
  void aMarkedPartIsNoPartOfWhatIsNotMarked() {
    RecordingFacts marked = holding(REHEARSAL, VisionContentTest.messages(500, 1500));
    RecordingChoice choice = RecordingChoice.of(List.of(holding(REAL, WHOLE), marked), Map.of());
    assertThat(choice.entries())
        .extracting(Entry::apart)
        .containsExactly(Apart.NO, Apart.SIMULATED);
  }

  /** Only the file beside it says that it is simulated, and the copy has none. */
  @Test
  void aCopyOfASimulatedRecordingIsSimulated() {
    RecordingFacts copy = holding(REAL, WHOLE);
    RecordingFacts original = holding(REHEARSAL, WHOLE);
    RecordingChoice choice = RecordingChoice.of(List.of(copy, original, AGAIN), Map.of());
    assertThat(choice.entries())
        .extracting(Entry::apart)
        .containsExactly(Apart.COPY, Apart.SIMULATED, Apart.NO);
  }

  @Test
  void thoseLikeOneComeFromTheSamePlace() {
    List<RecordingFacts> all = List.of(AGAIN, ELSEWHERE, MATCH, REAL, REHEARSAL, TWIN);
    assertThat(RecordingChoice.alike(all, REAL)).containsExactly(AGAIN, MATCH, REAL);
    assertThat(RecordingChoice.alike(all, REHEARSAL)).containsExactly(REHEARSAL);
  }

  private static Map<String, Apart> apart(RecordingChoice choice) {
    return choice.entries().stream().collect(Collectors.toMap(Entry::name, Entry::apart));
  }

  private static String words(RecordingChoice choice, String name) {
    return choice.entries().stream()
        .filter(e -> e.name().equals(name))
        .findFirst()
        .orElseThrow()
        .words();
  }

  private static RecordingFacts facts(
      String name, RecordingOrigin origin, double playing, double length, double height, long s) {
    CameraCalibration camera =
        new CameraCalibration(
            0, 500, 390, 290, 0.1, 1, 0, 0, 0, 0, 0, 1000 * height, 0, 0, height, 780, 580);
    FieldGeometry field = FieldGeometry.of(length, 9, 1.8, 0.18, 0.3, List.of(camera));
    return new RecordingFacts(
        Path.of(name),
        origin,
        playing,
        Optional.of(field),
        s * 1_000_000_000L,
        1000,
        false,
        VisionContent.NONE,
        List.of());
  }

  private static RecordingFacts with(RecordingFacts f, boolean cut, VisionContent content) {
    return new RecordingFacts(
        f.log(),
        f.origin(),
        f.playing(),
        f.geometry(),
        f.startUnixNanos(),
        f.bytes(),
        cut,
        content,
        f.faults());
  }

  private static RecordingFacts holding(RecordingFacts f, VisionContent content) {
    return with(f, f.cut(), content);
  }

  private static RecordingFacts cut(RecordingFacts f) {
    return with(f, true, f.content());
  }
}
