package fieldcal.app.cli;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.Export;
import fieldcal.app.export.ExportModel;
import fieldcal.app.export.ExportModel.ModelVerdict;
import fieldcal.app.export.Exporter;
import fieldcal.app.export.ProcessorHost;
import fieldcal.app.export.Target;
import fieldcal.app.export.format.BaseFile;
import fieldcal.app.export.format.Editor.Change;
import fieldcal.app.files.WholeFile;
import fieldcal.app.history.History;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal export}: a model in the form that another program reads. */
@Command(
    name = "export",
    mixinStandardHelpOptions = true,
    description =
        "Writes a calibrated model in the form that a simulator, vision or a team's software"
            + " reads, and says what that form cannot carry and what it costs.")
final class ExportCommand implements Callable<Integer> {
  /** The one target that can be written while it runs. */
  private static final String PROCESSOR = "ssl-vision-processor";

  private static final Clock CLOCK = Clock.systemUTC();

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "MODEL",
      description =
          "calibration.json, extended_model.json, geometry_models.pb, limits.json for robots, or"
              + " twin.json for cameras")
  private Path file;

  @Option(
      names = "--to",
      required = true,
      paramLabel = "TARGET",
      description =
          "ssl-vision-processor, ssl-vision, geometry-text, sumatra, erforce-tracker,"
              + " erforce-realism, immortals, grsim or robot-specs")
  private String to;

  @Option(
      names = "--base",
      paramLabel = "FILE",
      description = "the target's current file: everything but the exported values stays as it is")
  private Path base;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "the file to write; without it, the file goes to standard output")
  private Path out;

  @Option(names = "--overwrite", description = "--out may replace a file, for example the base")
  private boolean overwrite;

  @Option(
      names = "--extended",
      paramLabel = "FILE",
      description =
          "extended_model.json of the same field: says what MODEL leaves out and what that costs")
  private Path extended;

  @Option(
      names = "--limits",
      paramLabel = "FILE",
      description = "limits.json, for a target that keeps ball and robots in one file")
  private Path limits;

  @Option(
      names = "--team",
      paramLabel = "yellow|blue",
      description =
          "the team whose limits are exported, if the target's file holds those of one team only")
  private String team;

  @Option(
      names = "--entry",
      paramLabel = "NAME",
      description =
          "the entry in the target's file that gets the values: a team in robot-specs, a robot type"
              + " or an environment in Sumatra")
  private String entry;

  @Option(
      names = "--apply",
      paramLabel = "URL",
      description =
          "writes into a running ssl-vision-processor, for example http://192.168.0.10:8085, and"
              + " saves")
  private String url;

  @Option(
      names = "--rollback",
      description =
          "puts back what was there before the last export to --out, or the last --apply to URL")
  private boolean rollback;

  @Option(
      names = "--force",
      description = "exports the model even if its verdict is: do not publish")
  private boolean force;

  @Override
  public Integer call() throws IOException {
    checkUsage();
    if (rollback) {
      rollBack();
      return 0;
    }
    ExportModel model = model();
    requireVerdict(model);
    Exporter exporter =
        new Exporter(Target.of(to), model, Optional.ofNullable(team), Optional.ofNullable(entry));
    if (url != null) {
      apply(model, exporter);
    } else {
      write(model, exporter);
    }
    return 0;
  }

  private void checkUsage() {
    require(
        Target.names().contains(to),
        "there is no target '" + to + "'; targets are " + String.join(", ", Target.names()));
    require(
        team == null || team.equals("yellow") || team.equals("blue"),
        "--team must be yellow or blue, not '" + team + "'");
    require(url == null || to.equals(PROCESSOR), "--apply needs --to " + PROCESSOR);
    require(
        url == null || base == null && out == null,
        "--apply writes no file: leave out --base and --out");
    require(!rollback || url != null || out != null, "--rollback needs --apply URL or --out FILE");
    require(!overwrite || out != null, "--overwrite needs --out FILE");
  }

  private void require(boolean holds, String message) {
    if (!holds) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  private ExportModel model() throws IOException {
    ExportModel model = ExportModel.read(file);
    if (extended != null) {
      ExportModel beside = ExportModel.read(extended);
      if (beside.extended().isEmpty()) {
        throw new InputException(extended + ": is not an extended_model.json");
      }
      model = model.beside(beside);
    }
    if (limits != null) {
      ExportModel beside = ExportModel.read(limits);
      if (beside.limits().isEmpty()) {
        throw new InputException(limits + ": is not a limits.json");
      }
      model = model.beside(beside);
    }
    return model;
  }

  private void requireVerdict(ExportModel model) throws InputException {
    Optional<ModelVerdict> verdict = model.provenance().verdict();
    if (verdict.isPresent() && verdict.get().forbids() && !force) {
      throw new InputException(
          file + ": " + verdict.get().headline() + " --force exports it all the same.");
    }
  }

  private void write(ExportModel model, Exporter exporter) throws IOException {
    if (out != null && Files.isDirectory(out)) {
      throw new InputException(out + ": is a directory; --out needs a file");
    }
    if (out != null && Files.exists(out) && !overwrite) {
      throw new InputException(out + ": exists; --overwrite replaces it");
    }
    BaseFile present = base == null ? null : BaseFile.read(base);
    Export export = present == null ? exporter.fresh() : exporter.into(present);
    if (out == null) {
      if (present != null && present.charset() != StandardCharsets.UTF_8) {
        throw new InputException(base + ": is not UTF-8; name a file with --out");
      }
      PrintWriter text = spec.commandLine().getOut();
      text.print(new String(export.bytes(), StandardCharsets.UTF_8));
      text.flush();
      explain(spec.commandLine().getErr(), model, export);
      return;
    }
    Optional<byte[]> before =
        Files.exists(out) ? Optional.of(Files.readAllBytes(out)) : Optional.empty();
    WholeFile.write(export.bytes(), out);
    PrintWriter text = spec.commandLine().getOut();
    explain(text, model, export);
    text.println();
    text.println(
        out
            + (present == null
                ? " is written."
                : " is written; everything else is as in " + base + "."));
    remember(model.departure(Action.EXPORTED, to, place(out), now()), before, text);
    text.flush();
  }

  private static String place(Path out) {
    return out.toAbsolutePath().normalize().toString();
  }

  private static double now() {
    return CLOCK.millis() / 1000.0;
  }

  private void explain(PrintWriter text, ExportModel model, Export export) {
    text.println(export.target().title() + ", " + export.file().file());
    verdict(text, model);
    export.changes().forEach(change -> text.println("  " + ProcessorHost.words(change)));
    notes(text, export.notes());
    text.flush();
  }

  private void verdict(PrintWriter text, ExportModel model) {
    model
        .provenance()
        .verdict()
        .ifPresent(
            v -> {
              text.println(v.headline());
              v.because().forEach(reason -> text.println("  " + reason));
            });
  }

  private static void notes(PrintWriter text, List<String> notes) {
    notes.forEach(note -> text.println("- " + note));
  }

  /** A folder that cannot be written costs the history, not the export. */
  private void remember(HistoryEntry entry, Optional<byte[]> before, PrintWriter text) {
    try {
      history().add(entry, before);
    } catch (IOException e) {
      text.println("The history of " + folder() + " was not kept: " + e.getMessage());
    }
  }

  private Path folder() {
    Path parent = file.toAbsolutePath().normalize().getParent();
    return parent == null ? Path.of("/") : parent;
  }

  private History history() {
    return new History(folder());
  }

  private void apply(ExportModel model, Exporter exporter) throws IOException {
    PrintWriter text = spec.commandLine().getOut();
    ProcessorHost host = new ProcessorHost(url);
    text.println(url);
    verdict(text, model);
    HistoryEntry entry = model.departure(Action.APPLIED, to, ProcessorHost.address(url), now());
    host.apply(
        exporter.settings(),
        changes -> show(text, changes),
        before -> remember(entry, Optional.of(before), text));
    notes(text, exporter.notes());
    text.println();
    text.println("Written and saved. --rollback puts back what was there.");
    text.flush();
  }

  private static void show(PrintWriter text, List<Change> changes) {
    changes.forEach(change -> text.println("  " + ProcessorHost.words(change)));
    text.flush();
  }

  private void rollBack() throws IOException {
    String place = url != null ? ProcessorHost.address(url) : place(out);
    History history = history();
    HistoryEntry entry =
        history
            .toUndo(place)
            .orElseThrow(
                () ->
                    new InputException(
                        folder() + ": the history has nothing to put back at " + place));
    byte[] before = history.before(entry);
    byte[] present;
    if (url != null) {
      present = new ProcessorHost(url).restore(before);
    } else {
      present = Files.exists(out) ? Files.readAllBytes(out) : new byte[0];
      WholeFile.write(before, out);
    }
    history.add(entry.undone(now()), Optional.of(present));
    PrintWriter text = spec.commandLine().getOut();
    text.println(place + " is as it was before export " + entry.id() + " of the history.");
    text.flush();
  }
}
