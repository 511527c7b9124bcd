package fieldcal.app.report;

import static fieldcal.app.report.PageChecks.HOSTILE;
import static fieldcal.app.report.PageChecks.data;
import static fieldcal.app.report.PageChecks.found;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.report.CalibrationReport.Kick;
import fieldcal.app.report.CalibrationReport.Kind;
import fieldcal.app.report.CalibrationReport.Model;
import fieldcal.app.report.CalibrationReport.ModelParameter;
import fieldcal.app.wording.PublishWords;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class CalibrationReportWriterTest {
  /** ECharts, charts, frame, plots, views, page. */
  private static final int SCRIPTS = 6;

  private static final long SEED = 20251121;
  @TempDir Path directory;

  @Test
  void aSessionOfSixtyKicksStaysSmall() throws IOException {
    CalibrationReport report = SampleReport.session(SEED);
    String page = write(report);
    assertThat(page.length()).isLessThan(8_000_000);
    JsonNode data = data(page);
    assertThat(data.at("/report/kicks")).hasSize(60);
    assertThat(data.at("/report/models/0/parameters/1/name").asText()).isEqualTo("accRoll");
    assertThat(data.at("/report/models/0/parameters/1/differs").asBoolean()).isTrue();
    // Kept for a look at it.
    Path kept =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "build", "sample-report.html");
    Files.createDirectories(kept.getParent());
    Files.writeString(kept, page);
  }

  @Test
  void loadsNothingFromOutside() throws IOException {
    PageChecks.assertSelfContained(write(SampleReport.session(SEED)), SCRIPTS);
  }

  @Test
  void textsFromTheRecordingAreNeverMarkup() throws IOException {
    CalibrationReport report =
        new CalibrationReport(
            new Provenance(List.of(HOSTILE), HOSTILE, 1, 0, 0),
            List.of(),
            List.of(),
            Optional.empty(),
            List.of(),
            new PublishWords("publish", HOSTILE, List.of(HOSTILE), List.of(), List.of(HOSTILE)),
            List.of(HOSTILE),
            List.of(new Problem(HOSTILE, HOSTILE, 1, HOSTILE)));
    String page = write(report);
    PageChecks.assertScriptsAreWhole(page, SCRIPTS);
    assertThat(data(page).at("/report/provenance/sources/0").asText()).isEqualTo(HOSTILE);
    assertThat(data(page).at("/report/problems/0/advice").asText()).isEqualTo(HOSTILE);
  }

  @Test
  void scriptsBuildNoMarkupFromText() throws IOException {
    PageChecks.assertScriptsBuildNoMarkup(write(SampleReport.session(SEED)));
  }

  @Test
  void theSameReportGivesTheSameBytes() throws IOException {
    String page = write(SampleReport.session(SEED));
    assertThat(page.equals(write(SampleReport.session(SEED)))).isTrue();
  }

  static Map<String, CalibrationReport> sparse() {
    CalibrationReport all = SampleReport.session(SEED);
    List<Kick> flat = all.kicks().stream().filter(k -> k.kind() == Kind.FLAT).toList();
    List<Model> flatModel = List.of(all.models().get(0));
    List<Model> unpublished =
        List.of(
            new Model(
                Kind.FLAT,
                flatModel.get(0).parameters().stream()
                    .map(CalibrationReportWriterTest::unpublished)
                    .toList(),
                Double.NaN,
                ""));
    Map<String, CalibrationReport> reports = new TreeMap<>();
    reports.put("no-kicks", SampleReport.of(List.of(), List.of(), Optional.empty()));
    reports.put("no-chips", SampleReport.of(flatModel, flat, Optional.of(SampleReport.FIELD)));
    reports.put(
        "no-published", SampleReport.of(unpublished, flat, Optional.of(SampleReport.FIELD)));
    reports.put("no-geometry", SampleReport.of(all.models(), all.kicks(), Optional.empty()));
    reports.put("one-kick", SampleReport.of(List.of(), flat.subList(0, 1), Optional.empty()));
    reports.put(
        "no-fit", SampleReport.of(List.of(), List.of(withoutFit(flat.get(0))), Optional.empty()));
    return reports;
  }

  static List<String> sparseNames() {
    return List.copyOf(sparse().keySet());
  }

  @ParameterizedTest
  @MethodSource("sparseNames")
  void whatIsMissingIsLeftOut(String name) throws IOException {
    CalibrationReport report = sparse().get(name);
    String page = write(report);
    JsonNode data = data(page);
    assertThat(data.at("/report/kicks")).hasSize(report.kicks().size());
    assertThat(data.at("/report/field").isNull()).isEqualTo(report.field().isEmpty());
    assertThat(data.at("/report/verdict/toDo")).isNotEmpty();
    assertThat(
            found(
                ReportJson.of(new CalibrationReportWriter.Contents(report)),
                "[:,\\[](NaN|-?Infinity)"))
        .isEmpty();
    // Kept for a look at it.
    Path kept =
        Path.of(
            System.getProperty("fieldcal.projectDir", "."), "build", "sample-" + name + ".html");
    Files.writeString(kept, page);
  }

  @Test
  void numbersAreRoundedAndUnknownOnesAreNull() throws IOException {
    CalibrationReport report = SampleReport.session(SEED);
    FittedPath path =
        new FittedPath(
            new double[] {-0.12344, 0, Double.NaN},
            new double[] {2.00004, -1.99996, 1e300},
            new double[3],
            new double[3],
            new double[] {1, Double.POSITIVE_INFINITY, 0.00006});
    Kick kick = withPath(report.kicks().get(0), path);
    String json = ReportJson.of(SampleReport.of(List.of(), List.of(kick), Optional.empty()));
    assertThat(json)
        .contains("\"t\":[-0.1234,0,null]")
        .contains("\"x\":[2,-2,1.0E300]")
        .contains("\"speed\":[1,null,1.0E-4]");
  }

  @Test
  void columnsOfDifferentLengthAreRefused() {
    double[] two = new double[2];
    double[] three = new double[3];
    assertThatThrownBy(() -> new FittedPath(two, two, three, two, two))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("column y has 3 values, t has 2");
    assertThatThrownBy(() -> new Observations(0, two, two, two, two, two, three, new boolean[2]))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("height");
  }

  private static ModelParameter unpublished(ModelParameter p) {
    return new ModelParameter(
        p.name(),
        p.unit(),
        p.mean(),
        p.standardError(),
        p.n(),
        p.sigma(),
        Double.NaN,
        Double.NaN,
        Double.NaN,
        "");
  }

  private static Kick withoutFit(Kick k) {
    double[] unknown = new double[k.seen().get(0).size()];
    java.util.Arrays.fill(unknown, Double.NaN);
    Observations seen = k.seen().get(0);
    return new Kick(
        k.id(),
        k.kind(),
        k.source(),
        k.unix(),
        "",
        -1,
        "lost",
        seen.size(),
        0,
        Double.NaN,
        k.x(),
        k.y(),
        k.vx(),
        k.vy(),
        0,
        List.of(),
        false,
        "too few observations",
        List.of(
            new Observations(
                seen.camera(),
                seen.t(),
                seen.x(),
                seen.y(),
                unknown,
                unknown,
                new double[0],
                seen.used())),
        FittedPath.NONE,
        List.of());
  }

  private static Kick withPath(Kick k, FittedPath path) {
    return new Kick(
        k.id(),
        k.kind(),
        k.source(),
        k.unix(),
        k.team(),
        k.robot(),
        k.end(),
        k.observations(),
        k.rejected(),
        k.rmsMm(),
        k.x(),
        k.y(),
        k.vx(),
        k.vy(),
        k.vz(),
        k.parameters(),
        k.selected(),
        k.rejectedBecause(),
        List.of(),
        path,
        List.of());
  }

  private String write(CalibrationReport report) throws IOException {
    Path file = directory.resolve("report.html");
    new CalibrationReportWriter().write(report, file);
    return Files.readString(file);
  }
}
