package fieldcal.app.play;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.calibrate.RecordingFolder;
import fieldcal.app.calibrate.SelectionFile;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.ReadableRecordings;
import fieldcal.app.recording.RecordingChoice;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A session, and the calibration from it and from the sessions that were recorded in the same directory before. */
public final class PlayRun {
  private static final String LOGS = "session-.*\\.log";

  /** The folder of a rehearsal's results, where its recording lies among those of a real field. */
  private static final String REHEARSAL = "rehearsal";

  private PlayRun() {}

  /**
   * What it ended with.
   *
   * @param session how the play ended
   * @param calibration from all sessions of the directory; empty when no kick was made
   * @param strengths what the robots make of their commands
   * @param directory where the results belong
   */
  public record Result(
      PlaySession.Outcome session,
      Optional<CalibrationOutcome> calibration,
      List<KickStrength> strengths,
      Path directory) {

    /** Copies the list. {@inheritDoc} */
    public Result {
      strengths = List.copyOf(strengths);
    }
  }

  /**
   * Begins a session whose recording goes to the directory of its request.
   *
   * @param session not run yet
   * @param directory of its request
   * @param progress of the calibration
   * @return the result; also of a session that was stopped early
   * @throws IOException when the field is gone or a file cannot be written or read
   */
  public static Result run(
      PlaySession session, Path directory, CalibrationSession.Progress progress)
      throws IOException {
    PlaySession.Outcome outcome = session.run();
    if (outcome.last().kicks().isEmpty()) {
      return new Result(outcome, Optional.empty(), List.of(), directory);
    }
    Path log = outcome.log().orElseThrow();
    Path results = isKeptApart(directory, log) ? directory.resolve(REHEARSAL) : directory;
    CalibrationOutcome calibration =
        calibrate(results, readable(directory), log, session.seed(), progress);
    return new Result(outcome, Optional.of(calibration), KickStrength.of(calibration), results);
  }

  /** A rehearsal among recordings of a real field: the results beside these are theirs, and stay. */
  private static boolean isKeptApart(Path directory, Path session) throws IOException {
    ReadableRecordings readable =
        ReadableRecordings.of(RecordingFolder.logs(directory), LogOpener.USUAL);
    return RecordingFolder.choice(readable, directory).entries().stream()
        .filter(entry -> entry.facts().log().getFileName().equals(session.getFileName()))
        .anyMatch(entry -> entry.facts().isSimulated() && !entry.used());
  }

  /**
   * Calibrates from all sessions in a directory, with the commands beside them and the usual seed.
   *
   * @param directory with at least one session
   * @param progress told how far it is
   * @return the calibration
   * @throws IOException when a file cannot be read
   */
  public static CalibrationOutcome calibrate(Path directory, CalibrationSession.Progress progress)
      throws IOException {
    ReadableRecordings readable = readable(directory);
    Path newest = null;
    for (RecordingFacts facts : readable.facts()) {
      Path log = facts.log();
      newest =
          newest == null
                  || Files.getLastModifiedTime(log).compareTo(Files.getLastModifiedTime(newest)) > 0
              ? log
              : newest;
    }
    return calibrate(directory, readable, newest, FitSettings.defaults().seed(), progress);
  }

  private static CalibrationOutcome calibrate(
      Path results,
      ReadableRecordings readable,
      Path session,
      long seed,
      CalibrationSession.Progress progress)
      throws IOException {
    List<Path> logs = alike(readable, session);
    List<CommandFile.Command> told = new ArrayList<>();
    for (Path log : logs) {
      Path commands = commandsOf(log);
      // A full disk may have left an empty file.
      if (Files.exists(commands) && Files.size(commands) > 0) {
        told.addAll(CommandFile.read(commands));
      }
    }
    HandSelection byHand = SelectionFile.readOrFormer(null, results);
    CollectedKicks data =
        new KickCollector(progress).collect(logs).withProblems(readable.problems());
    return new CalibrationSession(FitSettings.defaults().withSeed(seed))
        .calibrate(data, CalibrationRequest.of(logs, byHand, told), progress);
  }

  /** The sessions that can be read: one that was killed before its first frame must not take all others away. */
  private static ReadableRecordings readable(Path directory) throws IOException {
    return ReadableRecordings.of(logs(directory), LogOpener.USUAL);
  }

  /** The sessions of the same field as one of them: a rehearsal and the real field are not calibrated together. */
  private static List<Path> alike(ReadableRecordings readable, Path session) throws IOException {
    RecordingFacts its = null;
    for (RecordingFacts facts : readable.facts()) {
      its = facts.log().equals(session) ? facts : its;
    }
    // One that cannot be read says why.
    its = its == null ? RecordingFacts.of(session, LogOpener.USUAL) : its;
    return RecordingChoice.alike(readable.facts(), its).stream().map(RecordingFacts::log).toList();
  }

  /**
   * The sessions in a directory that are not calibrated together with one of them.
   *
   * @param directory of the sessions
   * @param session one of them
   * @return which and why, a clause each: first those of another field, then those that cannot be read
   * @throws IOException when the one cannot be read
   */
  public static List<String> leftOut(Path directory, Path session) throws IOException {
    ReadableRecordings readable = readable(directory);
    List<Path> alike = alike(readable, session);
    List<String> others = new ArrayList<>();
    for (RecordingFacts facts : readable.facts()) {
      if (!alike.contains(facts.log()) && !facts.log().equals(session)) {
        others.add(facts.log() + " is of another field or seed");
      }
    }
    others.addAll(readable.broken().values());
    return others;
  }

  /**
   * The sessions that were recorded in a directory.
   *
   * @param directory may be missing
   * @return their game logs by name
   * @throws IOException when it cannot be listed
   */
  public static List<Path> logs(Path directory) throws IOException {
    if (!Files.isDirectory(directory)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(directory)) {
      return files.filter(f -> f.getFileName().toString().matches(LOGS)).sorted().toList();
    }
  }

  private static Path commandsOf(Path log) {
    String name = log.getFileName().toString();
    return log.resolveSibling(name.substring(0, name.length() - 4) + ".commands.csv");
  }

  /**
   * Writes the calibration's files and {@code play.json} to where they belong.
   *
   * @param result what to write
   * @param request what was wanted
   * @throws IOException when a file cannot be written
   */
  public static void write(Result result, SessionRequest request) throws IOException {
    if (result.calibration().isPresent()) {
      CalibrationSession.writeAll(result.calibration().get(), result.directory());
    }
    JsonFiles.write(new PlayJson(result, request).build(), result.directory().resolve("play.json"));
  }
}
