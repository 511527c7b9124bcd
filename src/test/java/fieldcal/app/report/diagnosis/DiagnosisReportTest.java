package fieldcal.app.report.diagnosis;

import static fieldcal.app.report.PageChecks.HOSTILE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.report.PageChecks;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.fit.CameraViews;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DiagnosisReportTest {
  /** ECharts, charts, frame, plots, page. */
  private static final int SCRIPTS = 5;

  private static final Path LOOK =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "build", "sample-diagnosis");

  @TempDir Path directory;

  @Test
  void theBuilderKeepsTheNumbers() {
    Diagnosis d = SampleDiagnosis.explained(8);
    DiagnosisReport report = report(d, "session.log.gz", true);
    assertThat(report.verdict().id()).isEqualTo("explained");
    assertThat(report.causes())
        .extracting(DiagnosisReport.CauseRow::id)
        .containsExactly("camera_offset", "air_drag");
    DiagnosisReport.CauseRow offset = report.causes().get(0);
    assertThat(offset.gainMm()).isEqualTo(12.1);
    assertThat(offset.gainLowMm()).isEqualTo(11.6);
    assertThat(offset.parameters().get(0))
        .isEqualTo(new DiagnosisReport.EffectParameter("x_mm", "mm", 21.2, 0.12));
    assertThat(offset.parameters().get(2).error()).as("which camera").isNaN();
    assertThat(offset.rivals())
        .startsWith("These kicks do not show whether camera 0 or camera 1 is shifted.")
        .contains("wrong ball height in vision");
    assertThat(offset.certainty()).isEqualTo("certain");
    assertThat(report.verdict().headline()).startsWith("The calibrated model is off by 38 mm");
    assertThat(report.before().horizons()).containsExactly(0.5, 1, 2);
    assertThat(report.after().typicalErrorMm()).containsExactly(5.1, 12.4, 29.0);
    assertThat(report.candidates()).hasSize(d.candidates().size());
    assertThat(report.parameters()).hasSize(7);
    assertThat(report.cameras()).containsExactly(0, 1);
    assertThat(report.problems().get(0).count()).isEqualTo(3);
    assertThat(report.field().orElseThrow().length()).isEqualTo(12);
  }

  @Test
  void theVariableWithTheLargestDropIsShownFirst() {
    DiagnosisReport report = report(SampleDiagnosis.explained(8), "a", true);
    double most =
        report.profiles().stream()
            .mapToDouble(p -> p.before().deviation() - p.after().deviation())
            .max()
            .orElseThrow();
    ProfilePicture shown =
        report.profiles().stream()
            .filter(p -> p.variable().equals(report.shown()))
            .findFirst()
            .orElseThrow();
    assertThat(shown.before().deviation() - shown.after().deviation()).isEqualTo(most);
    assertThat(report(SampleDiagnosis.unexplained(8), "a", true).shown())
        .isEqualTo("time_since_kick");
  }

  @Test
  void residualsAreTurnedIntoThePath() {
    Diagnosis d = SampleDiagnosis.explained(4);
    KickResiduals kick = d.kicks().get(0);
    KickPicture picture = report(d, "a", true).kicks().get(0);
    double angle = Math.atan2(kick.kick().vy(), kick.kick().vx());
    assertThat(Math.toRadians(picture.direction())).isCloseTo(angle, within(1e-6));
    double t = picture.seen().t()[20] + kick.after().kickTime();
    int i = 0;
    while (Math.abs(kick.kick().observations().time(i) - t) > 1e-9) {
      i++;
    }
    double along = kick.xBefore()[i] * Math.cos(angle) + kick.yBefore()[i] * Math.sin(angle);
    double across = kick.yBefore()[i] * Math.cos(angle) - kick.xBefore()[i] * Math.sin(angle);
    assertThat(picture.seen().beforeAlong()[20]).isCloseTo(1000 * along, within(1e-6));
    assertThat(picture.seen().beforeAcross()[20]).isCloseTo(1000 * across, within(1e-6));
    assertThat(picture.seen().camera()[20]).isEqualTo(kick.kick().observations().camera(i));
    assertThat(picture.rejected()).isPositive();
  }

  @Test
  void theMapTellsTheCamerasApart() {
    ResidualMap map = report(SampleDiagnosis.explained(24), "a", true).map();
    double[] sums = new double[2];
    int[] cells = new int[2];
    for (int i = 0; i < map.x().length; i++) {
      assertThat(Math.abs(map.afterX()[i])).isLessThan(4);
      assertThat(map.count()[i]).isGreaterThanOrEqualTo(4);
      if (Math.abs(map.x()[i]) < 0.5) {
        sums[map.camera()[i]] += map.beforeX()[i];
        cells[map.camera()[i]]++;
      }
    }
    assertThat(sums[1] / cells[1] - sums[0] / cells[0]).isCloseTo(42, within(8.0));
    assertThat(Arrays.stream(map.camera()).distinct().count()).isEqualTo(2);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 24, 200})
  void pagesOfAnyNumberOfKicksStaySmall(int kicks) throws IOException {
    DiagnosisReport report = report(SampleDiagnosis.explained(kicks), "session.log.gz", true);
    String page = write(report);
    assertThat(page.length()).isLessThan(3_000_000);
    assertThat(PageChecks.data(page).at("/kicks")).hasSize(kicks);
    report
        .kicks()
        .forEach(k -> assertThat(Arrays.stream(k.seen().camera()).distinct().count()).isPositive());
    keep("explained-" + kicks, page);
  }

  @Test
  void loadsNothingFromOutsideAndBuildsNoMarkup() throws IOException {
    String page = write(report(SampleDiagnosis.explained(8), "session.log.gz", true));
    PageChecks.assertSelfContained(page, SCRIPTS);
    PageChecks.assertScriptsBuildNoMarkup(page);
  }

  @Test
  void namesAreNeverMarkup() throws IOException {
    String page = write(report(SampleDiagnosis.adequate(2), HOSTILE, false));
    PageChecks.assertScriptsAreWhole(page, SCRIPTS);
    JsonNode data = PageChecks.data(page);
    assertThat(data.at("/provenance/sources/0").asText()).isEqualTo(HOSTILE);
    assertThat(data.at("/kicks/0/source").asText()).isEqualTo(HOSTILE);
    assertThat(data.at("/problems/0/where").asText()).isEqualTo(HOSTILE);
    assertThat(data.at("/field").isNull()).isTrue();
  }

  @Test
  void theSameReportGivesTheSameBytes() throws IOException {
    String page = write(report(SampleDiagnosis.explained(4), "a", true));
    assertThat(page.equals(write(report(SampleDiagnosis.explained(4), "a", true)))).isTrue();
  }

  @Test
  void otherVerdictsSayTheirOwn() throws IOException {
    DiagnosisReport adequate = report(SampleDiagnosis.adequate(24), "session.log.gz", true);
    assertThat(adequate.causes()).isEmpty();
    assertThat(adequate.remains().words()).isEmpty();
    keep("adequate", write(adequate));
    DiagnosisReport unexplained = report(SampleDiagnosis.unexplained(24), "session.log.gz", true);
    assertThat(unexplained.remains().significant()).isTrue();
    assertThat(unexplained.remains().words()).contains("the time since the kick");
    assertThat(unexplained.remains().dependsOn()).containsExactly("time_since_kick", "speed");
    keep("unexplained", write(unexplained));
    DiagnosisReport partly = report(SampleDiagnosis.partly(24), "session.log.gz", true);
    assertThat(partly.verdict().id()).isEqualTo("partly_explained");
    assertThat(partly.learned()).hasSize(5);
    assertThat(partly.learned().get(0).kind()).isEqualTo("law");
    assertThat(partly.learned().get(1).curves()).hasSize(1);
    assertThat(partly.learned().get(1).curves().get(0).axes()).containsExactly("speed");
    assertThat(partly.learned().get(2).curves().get(0).axes()).containsExactly("x", "y");
    assertThat(partly.learned().get(3).curves()).hasSize(2);
    assertThat(partly.learned().get(4).kind()).isEqualTo("scatter");
    assertThat(partly.learned().get(4).curves()).isEmpty();
    keep("partly", write(partly));
    assertThat(PageChecks.found(write(unexplained), "NaN|Infinity\\b(?!;)").size())
        .as("of the scripts only")
        .isEqualTo(PageChecks.found(write(adequate), "NaN|Infinity\\b(?!;)").size());
  }

  private static DiagnosisReport report(Diagnosis diagnosis, String source, boolean geometry) {
    Map<Integer, String> sources = new HashMap<>();
    diagnosis.kicks().forEach(k -> sources.put(k.kick().id(), source));
    CollectedKicks data =
        new CollectedKicks(
            new Epoch(1_795_254_402_000_000_000L),
            diagnosis.kicks().stream().map(KickResiduals::kick).toList(),
            sources,
            CameraViews.of(List.of()),
            SampleDiagnosis.observers(),
            Map.of(),
            geometry
                ? Optional.of(FieldGeometry.of(12, 9, 1.8, 0.18, 0.3, List.of()))
                : Optional.empty(),
            BallModels.NONE,
            List.of(new DataProblem(source, "detection without finite coordinates", 3, "skipped")),
            0.25,
            List.of(),
            347.2,
            Map.of());
    return new DiagnosisReportBuilder(diagnosis, data, List.of(source), List.of()).build();
  }

  private String write(DiagnosisReport report) throws IOException {
    Path file = directory.resolve("diagnosis.html");
    new DiagnosisReportWriter().write(report, file);
    return Files.readString(file);
  }

  /** Kept for a look at it. */
  private static void keep(String name, String page) throws IOException {
    Files.createDirectories(LOOK);
    Files.writeString(LOOK.resolve(name + ".html"), page);
  }
}
