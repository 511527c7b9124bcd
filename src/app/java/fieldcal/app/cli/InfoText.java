package fieldcal.app.cli;

import fieldcal.app.wording.Amount;
import fieldcal.app.wording.Harmless;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.RefereeWords;
import fieldcal.ball.Parameter;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.CameraStatistics;
import fieldcal.gamelog.LogProblem;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeStatistics;
import fieldcal.gamelog.TrackerStatistics;
import fieldcal.vision.FieldGeometry;
import java.io.PrintWriter;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** {@link RecordingInfo} for people. */
final class InfoText {
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private final PrintWriter out;

  InfoText(PrintWriter out) {
    this.out = out;
  }

  void print(RecordingInfo info) {
    line("%s", Harmless.line(info.file().toString()));
    printRecording(info.summary());
    entry("origin", origin(info));
    info.summary()
        .geometry()
        .ifPresentOrElse(this::printGeometry, () -> entry("field", "no geometry"));
    printCameras(info);
    info.referee()
        .ifPresentOrElse(referee -> printReferee(info, referee), () -> entry("referee", "silent"));
    info.trackers().forEach(this::printTracker);
    printProblems(info.summary());
    out.flush();
  }

  private void printRecording(RecordingSummary summary) {
    String sizes =
        String.format(
            Locale.ROOT,
            "%.1f MB (%.1f MB on disk)",
            summary.logBytes() / 1e6,
            summary.fileBytes() / 1e6);
    if (summary.messages().isEmpty()) {
      entry("recorded", "no messages, " + sizes);
      return;
    }
    Instant start = Instant.ofEpochSecond(0, summary.epoch().unixNanosOf(summary.firstTime()));
    entry(
        "recorded",
        String.format(
            Locale.ROOT, "%s, %.1f s, %s", TIME.format(start), summary.duration(), sizes));
    entry(
        "messages",
        summary.messages().entrySet().stream()
            .map(type -> type.getKey() + " " + type.getValue())
            .collect(Collectors.joining(", ")));
  }

  /** Where it is from, and how that is known: the verdict on a model depends on it. */
  private static String origin(RecordingInfo info) {
    if (info.marked()) {
      return "simulated field: the recording is marked as such";
    }
    return info.simulated()
        ? "simulated field: "
            + Harmless.line(info.truth().getFileName().toString())
            + " is beside it"
        : "counts as a real field: nothing marks it as simulated";
  }

  private void printGeometry(FieldGeometry geometry) {
    entry(
        "field",
        String.format(
            Locale.ROOT,
            "%.2f × %.2f m, goals %.2f × %.2f m, boundary %.2f m, %d cameras",
            geometry.length(),
            geometry.width(),
            geometry.goalWidth(),
            geometry.goalDepth(),
            geometry.boundaryWidth(),
            geometry.cameras().size()));
    entry("flat model", geometry.flat().map(m -> describe(m.parameters())).orElse("not published"));
    entry(
        "chip model",
        geometry.chip().map(m -> describe(m.parameters().subList(0, 3))).orElse("not published"));
  }

  private static String describe(List<Parameter> parameters) {
    return parameters.stream()
        .map(p -> ParameterWords.withValue(p.name(), p.value()))
        .collect(Collectors.joining(", "));
  }

  private void printCameras(RecordingInfo info) {
    if (info.cameras().isEmpty()) {
      entry("cameras", "no frame of vision: record SSL-Vision's multicast, message type 4");
    } else {
      line("");
      line("  camera   frames      rate    lost  gaps  longest    jitter   latency  ball at rest");
    }
    for (CameraStatistics camera : info.cameras()) {
      line(
          "  %6d %8d %9s %6.2f%% %5d %8s %9s %9s  %s",
          camera.id(),
          camera.frames(),
          number(camera.rate(), "%.1f Hz"),
          100 * camera.loss(),
          camera.gaps(),
          camera.gaps() == 0 ? "–" : number(camera.longestGap(), "%.2f s"),
          number(1e3 * camera.jitter(), "%.2f ms"),
          number(1e3 * camera.latency(), "%.1f ms"),
          camera.restingBlocks() == 0
              ? "never"
              : String.format(
                  Locale.ROOT,
                  "± %.2f mm (%d %s)",
                  1e3 * camera.ballNoise(),
                  camera.restingBlocks(),
                  camera.restingBlocks() == 1 ? "stretch" : "stretches"));
    }
    new ClockNotes(info.cameras()).lines().forEach(note -> line("  %6s  %s", "clocks", note));
    List<CameraCalibration> published =
        info.summary().geometry().map(FieldGeometry::cameras).orElse(List.of());
    for (CameraCalibration calibration : published) {
      if (info.cameras().stream().noneMatch(camera -> camera.id() == calibration.id())) {
        line("  %6d  never sent a frame", calibration.id());
      }
      line("  %6d  %s", calibration.id(), info.note(calibration));
    }
    line("");
  }

  private void printReferee(RecordingInfo info, RefereeStatistics referee) {
    var last = referee.last();
    entry(
        "referee",
        String.format(
            Locale.ROOT,
            "%d messages, %s %d : %d %s",
            referee.messages(),
            nameOr(last.yellow().name(), "yellow"),
            last.yellow().score(),
            last.blue().score(),
            nameOr(last.blue().name(), "blue")));
    entry(
        "stages",
        referee.stages().stream()
            .map(
                start ->
                    String.format(
                        Locale.ROOT,
                        "%s at %.0f s",
                        RefereeWords.of(start.stage()),
                        // No negative zero.
                        Math.rint(start.time() - info.summary().firstTime()) + 0.0))
            .collect(Collectors.joining(", ")));
    entry(
        "commands",
        referee.commands().entrySet().stream()
            .map(command -> RefereeWords.of(command.getKey()) + " " + command.getValue())
            .collect(Collectors.joining(", ")));
  }

  private void printTracker(TrackerStatistics tracker) {
    entry(
        "tracker",
        String.format(
            Locale.ROOT,
            "%s: %d frames, %s, %s behind, a ball in %.0f %%, %d kicks",
            nameOr(tracker.source(), "without a name (" + tracker.uuid() + ")"),
            tracker.frames(),
            number(tracker.rate(), "%.1f Hz"),
            number(1e3 * tracker.delay(), "%.0f ms"),
            100 * tracker.ballShare(),
            tracker.kicks()));
  }

  private void printProblems(RecordingSummary summary) {
    entry("duplicates", Long.toString(summary.problems().count(LogProblem.DUPLICATE_FRAME)));
    List<String> problems = summary.problems().lines();
    entry("problems", problems.isEmpty() ? "none" : problems.get(0));
    problems.stream().skip(1).forEach(problem -> entry("", problem));
  }

  private static String nameOr(String name, String otherwise) {
    return name.isEmpty() ? otherwise : Harmless.line(name);
  }

  private static String number(double value, String format) {
    return Double.isNaN(value) ? "–" : Amount.minus(String.format(Locale.ROOT, format, value));
  }

  private void entry(String name, String value) {
    line("  %-11s %s", name, value);
  }

  private void line(String format, Object... values) {
    out.println(String.format(Locale.ROOT, format, values).stripTrailing());
  }
}
