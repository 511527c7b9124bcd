package fieldcal.app.limits;

import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.recording.DifferentRecordings;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.movement.MovementStatistics;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Recordings in, limits and their files out. */
public final class LimitsSession {

  /** Is called with how far the reading is, from several threads, one after the other. */
  public interface Progress {
    /**
     * Some more was read.
     *
     * @param bytesRead of all recordings
     * @param totalBytes of all recordings
     */
    void read(long bytesRead, long totalBytes);
  }

  private final int threads;
  private final LogOpener opener;

  /**
   * A session.
   *
   * @param threads how many recordings are read at the same time; the result does not depend on it
   * @param opener opens the recordings
   * @throws IllegalArgumentException when less than 1
   */
  public LimitsSession(int threads, LogOpener opener) {
    if (threads < 1) {
      throw new IllegalArgumentException("at least one thread must read, not " + threads);
    }
    this.threads = threads;
    this.opener = opener;
  }

  /**
   * Reads recordings and estimates the limits from all of them together.
   *
   * @param logs at least one; what several of them hold counts once
   * @param progress is called with how far it is
   * @return the outcome
   * @throws IOException when a recording cannot be read; one line for the operator
   */
  public LimitsOutcome run(List<Path> logs, Progress progress) throws IOException {
    List<DataProblem> problems = new ArrayList<>();
    List<Path> once = DifferentRecordings.once(logs, problems);
    for (Path log : once) {
      // What cannot be read at all is reported at once, not after minutes of reading the others.
      opener.recording(log).close();
    }
    List<RecordedMovement> read = readAll(once, progress);
    DifferentRecordings divided =
        DifferentRecordings.among(read.stream().map(RecordedMovement::facts).toList());
    divided.repeated().forEach(repeated -> problems.add(repeated.problem()));
    MovementStatistics all = new MovementStatistics();
    List<Double> noises = new ArrayList<>();
    Map<Team, String> names = new EnumMap<>(Team.class);
    double begin = Double.NaN;
    double duration = 0;
    for (RecordedMovement one : read) {
      if (divided.repetition(one.facts()).isPresent()) {
        continue;
      }
      all.merge(one.observer().statistics());
      problems.addAll(one.problems());
      compare(one, names, problems);
      if (one.observer().noiseKnown()) {
        noises.add(1000 * one.observer().noise());
      }
      if (Double.isFinite(one.summary().duration())) {
        duration += one.summary().duration();
        double first = one.summary().epoch().unixSeconds(one.summary().firstTime());
        begin = begin <= first ? begin : first;
      }
    }
    noises.sort(null);
    double noise = noises.isEmpty() ? Double.NaN : noises.get(noises.size() / 2);
    List<Path> different = divided.different().stream().map(RecordingFacts::log).toList();
    return LimitsOutcome.of(different, names, begin, duration, all, noise, problems);
  }

  /** Colours change hands from match to match: two teams under one colour have no common limit. */
  private static void compare(
      RecordedMovement one, Map<Team, String> names, List<DataProblem> problems) {
    one.names()
        .forEach(
            (team, name) -> {
              String before = names.putIfAbsent(team, name);
              if (before != null && !before.equals(name)) {
                problems.add(
                    new DataProblem(
                        one.facts().log().toString(),
                        team.label() + " is '" + name + "' here, '" + before + "' before",
                        1,
                        "limits of different teams are mixed; measure each pairing on its own"));
              }
            });
  }

  private List<RecordedMovement> readAll(List<Path> logs, Progress progress) throws IOException {
    Sum sum = new Sum(logs, progress);
    ExecutorService pool = Executors.newFixedThreadPool(Math.min(threads, logs.size()));
    try {
      List<Future<RecordedMovement>> running = new ArrayList<>();
      for (int i = 0; i < logs.size(); i++) {
        int index = i;
        running.add(
            pool.submit(
                () ->
                    RecordedMovement.read(logs.get(index), opener, bytes -> sum.at(index, bytes))));
      }
      List<RecordedMovement> done = new ArrayList<>();
      for (Future<RecordedMovement> one : running) {
        done.add(one.get());
      }
      return done;
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException failure) {
        throw failure;
      }
      throw new IllegalStateException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while reading");
    } finally {
      pool.shutdownNow();
    }
  }

  /** Adds up how far the single recordings are. */
  private static final class Sum {
    private final long[] read;
    private final long total;
    private final Progress progress;

    Sum(List<Path> logs, Progress progress) throws IOException {
      read = new long[logs.size()];
      this.progress = progress;
      long bytes = 0;
      for (Path log : logs) {
        bytes += Files.exists(log) ? Files.size(log) : 0;
      }
      total = bytes;
    }

    synchronized void at(int index, long bytes) {
      read[index] = bytes;
      long sum = 0;
      for (long one : read) {
        sum += one;
      }
      progress.read(sum, total);
    }
  }

  /**
   * Writes {@code limits.json} alone.
   *
   * @param outcome what to write
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void writeJson(LimitsOutcome outcome, Path file) throws IOException {
    JsonFiles.write(new LimitsJson(outcome).build(), file);
  }

  /**
   * Writes {@code limits.json} and {@code limits.html}.
   *
   * @param outcome what to write
   * @param directory made if needed
   * @throws IOException when a file cannot be written
   */
  public static void writeAll(LimitsOutcome outcome, Path directory) throws IOException {
    Files.createDirectories(directory);
    writeJson(outcome, directory.resolve("limits.json"));
    JsonFiles.write(LimitsPage.of(outcome), directory.resolve("limits.html"));
  }
}
