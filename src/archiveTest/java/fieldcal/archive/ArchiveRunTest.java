package fieldcal.archive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.archive.ArchiveOutcome;
import fieldcal.app.archive.ArchiveRequest;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.archive.match.MatchTables;
import fieldcal.archive.table.ParquetFile;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
import fieldcal.gamelog.GameLogException;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whole runs on a few short logs: every table, damage, resumption, order, threads, and what is refused. */
class ArchiveRunTest {
  private static final int KICKS = 4;

  @TempDir private static Path folder;
  private static Path logs;
  private static Path whole;
  private static ArchiveOutcome outcome;

  @BeforeAll
  static void archiveOnce() throws IOException {
    logs = folder.resolve("logs");
    for (int seed = 1; seed <= 3; seed++) {
      simulate(ScenarioSettings.of(ScenarioKind.FLAT, KICKS), seed, "cup/flat-" + seed + ".log.gz");
    }
    simulate(ScenarioSettings.of(ScenarioKind.MATCH, 0).withMatch(3, 0.4), 7, "open/match.log");
    Path open = logs.resolve("open");
    simulate(ScenarioSettings.of(ScenarioKind.FLAT, KICKS), 4, "../flat-4.log.gz");
    half(folder.resolve("flat-4.log.gz"), open.resolve("cut.log.gz"));
    half(logs.resolve("cup/flat-1.log.gz"), open.resolve("part.log.gz"));
    try (InputStream packed =
        new GZIPInputStream(Files.newInputStream(logs.resolve("cup/flat-3.log.gz")))) {
      Files.copy(packed, open.resolve("unpacked.log"));
    }
    Files.writeString(open.resolve("nonsense.log"), "this is no game log, whatever its name says");
    Files.createFile(open.resolve("empty.log"));
    Files.copy(logs.resolve("cup/flat-2.log.gz"), open.resolve("the-same.log.gz"));
    whole = folder.resolve("whole");
    outcome = run(whole, "local[2,4]", false, logs);
  }

  private static void simulate(ScenarioSettings scenario, long seed, String name)
      throws IOException {
    Path log = logs.resolve(name);
    Files.createDirectories(log.getParent());
    RecordingFiles.besides(log)
        .write(SimulationSettings.DEFAULT.withSeed(seed).withScenario(scenario), share -> {});
  }

  private static void half(Path log, Path to) throws IOException {
    byte[] all = Files.readAllBytes(log);
    Files.createDirectories(to.getParent());
    Files.write(to, Arrays.copyOf(all, all.length / 2));
  }

  private static ArchiveOutcome run(Path out, String master, boolean resume, Path... paths)
      throws IOException {
    return run(out, master, resume, new AtomicInteger(), paths);
  }

  private static ArchiveOutcome run(
      Path out, String master, boolean resume, AtomicInteger read, Path... paths)
      throws IOException {
    return new SparkArchive()
        .run(
            new ArchiveRequest(List.of(paths), out, Optional.of(master), resume, LogOpener.USUAL),
            progress -> read.set(progress.logsDone()));
  }

  /** Everything but the lock and Spark's messages, by its place. */
  private static Map<String, byte[]> content(Path archive) throws IOException {
    Map<String, byte[]> content = new TreeMap<>();
    try (Stream<Path> files = Files.walk(archive)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        String name = archive.relativize(file).toString();
        if (!name.equals("lock") && !name.equals("spark-messages.txt")) {
          content.put(name, Files.readAllBytes(file));
        }
      }
    }
    return content;
  }

  private static void assertSame(Path archive) throws IOException {
    Map<String, byte[]> expected = content(whole);
    Map<String, byte[]> found = content(archive);
    assertThat(found.keySet()).isEqualTo(expected.keySet());
    expected.forEach((name, bytes) -> assertThat(found.get(name)).as(name).isEqualTo(bytes));
  }

  private static List<Row> rows(Table table) throws IOException {
    List<Row> rows = new ArrayList<>();
    try (Stream<Path> files = Files.walk(whole.resolve(table.name()))) {
      for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
        rows.addAll(ParquetFile.read(table, file));
      }
    }
    return rows;
  }

  @Test
  void everyLogIsInTheTables() throws IOException {
    assertThat(outcome.logs()).isEqualTo(7);
    assertThat(outcome.broken()).isEqualTo(2);
    assertThat(outcome.findings())
        .anyMatch(line -> line.contains("the-same.log.gz: has the same content as"))
        .anyMatch(line -> line.matches(".*part.log.gz: a part of .*flat-1.log.gz; left out"))
        .anyMatch(line -> line.matches(".*unpacked.log: a copy of .*flat-3.log.gz; left out"));
    assertThat(rows(Tables.MATCHES))
        .extracting(row -> row.text("file"))
        .containsExactly(
            "flat-1.log.gz", "flat-2.log.gz", "flat-3.log.gz", "cut.log.gz", "match.log");
    String first = rows(Tables.MATCHES).get(0).text("log");
    assertThat(rows(Tables.KICKS))
        .hasSize((int) outcome.kicks())
        .filteredOn(row -> row.text("log").equals(first))
        .hasSizeBetween(KICKS - 1, KICKS)
        .allSatisfy(
            row -> {
              assertThat(row.text("kind")).isEqualTo("flat");
              assertThat(row.number("acc_slide")).isBetween(-3.5, -2.7);
            });
    assertThat(rows(Tables.CAMERAS)).hasSize(5 * 4);
    assertThat(rows(Tables.ROBOTS)).extracting(row -> row.text("quantity")).contains("braking_max");
    assertThat(rows(Tables.LIMITS_HISTOGRAMS)).isNotEmpty();
  }

  @Test
  void whatFollowsFromAllIsThereToo() throws IOException {
    assertThat(rows(Tables.CARPETS))
        .filteredOn(row -> row.text("parameter").equals("acc_slide"))
        .hasSize(5) // four fields, and the match's
        .allSatisfy(row -> assertThat(row.number("value")).isBetween(-3.5, -2.7));
    assertThat(rows(Tables.MATCHES)).allMatch(row -> row.text("venue") != null);
    assertThat(rows(Tables.TEAMS)).extracting(row -> row.text("team")).contains("Yellow", "Blue");
    String page = Files.readString(whole.resolve("archive.html"));
    assertThat(page.contains("nonsense.log")).isTrue();
    // What scripts hold are the libraries' own words; a page that needs a network would say so
    // outside of them.
    String markup = page.replaceAll("(?s)<script>.*?</script>|<script type=.*?</script>", "");
    assertThat(markup)
        .contains("archive")
        .doesNotContain("{{", "<script", "src=", "href=", "@import");
  }

  @Test
  void aBrokenLogIsOneRowAmongTheProblems() throws IOException {
    List<Row> fatal =
        rows(Tables.PROBLEMS).stream().filter(row -> (Boolean) row.get("fatal")).toList();
    assertThat(fatal)
        .extracting(row -> row.text("file"))
        .containsExactlyInAnyOrder("empty.log", "nonsense.log");
    assertThat(fatal).allSatisfy(row -> assertThat(row.text("what")).isNotBlank());
    assertThat(rows(Tables.PROBLEMS))
        .anyMatch(
            row ->
                row.text("file").equals("cut.log.gz") && row.text("what").contains("ends early"));
  }

  @Test
  void theOrderOfTheFilesAndTheNumberOfThreadsDoNotMatter() throws IOException {
    Path other = folder.resolve("other");
    List<Path> single = new ArrayList<>();
    try (Stream<Path> files = Files.walk(logs)) {
      files.filter(file -> file.toString().contains(".log")).forEach(single::add);
    }
    single.sort(Comparator.reverseOrder());
    run(other, "local[1]", false, single.toArray(Path[]::new));
    assertSame(other);
  }

  @Test
  void whatIsMissingOrDamagedIsReadAgainAndNothingElse() throws IOException {
    Path resumed = folder.resolve("resumed");
    for (Map.Entry<String, byte[]> file : content(whole).entrySet()) {
      Path to = resumed.resolve(file.getKey());
      Files.createDirectories(to.getParent());
      Files.write(to, file.getValue());
    }
    // As a run that was killed leaves it: one log not recorded, one file half, and things put
    // aside.
    List<Path> kicks;
    try (Stream<Path> files = Files.walk(resumed.resolve("kicks"))) {
      kicks = files.filter(Files::isRegularFile).sorted().toList();
    }
    Files.write(kicks.get(0), new byte[100]);
    String unrecorded = kicks.get(1).getFileName().toString().replace(".parquet", ".done");
    Files.delete(resumed.resolve("state").resolve(unrecorded));
    Files.createDirectories(resumed.resolve("state/unfinished-1/x"));

    assertThatThrownBy(() -> run(resumed, "local[2,4]", false, logs))
        .hasMessageContaining("there is an archive already; --resume continues it");
    AtomicInteger read = new AtomicInteger();
    ArchiveOutcome again = run(resumed, "local[2,4]", true, read, logs);
    assertThat(read).hasValue(2);
    assertThat(again.skipped()).isEqualTo(5);
    assertSame(resumed);

    assertThatThrownBy(() -> run(resumed, "local[2,4]", true, logs.resolve("cup")))
        .hasMessageContaining("contains 6 logs that are not among those named");
    assertSame(resumed);
  }

  /** Whatever was there first: the tables are those of all logs together. */
  @Test
  void aPartGivesWayToTheWholeLog() throws IOException {
    Path out = folder.resolve("grown");
    Path part = logs.resolve("open/part.log.gz");
    assertThat(run(out, "local[1]", false, part).logs()).isEqualTo(1);
    ArchiveOutcome both = run(out, "local[1]", true, part, logs.resolve("cup/flat-1.log.gz"));
    assertThat(both.logs()).isEqualTo(1);
    assertThat(both.skipped()).isZero();
  }

  @Test
  void aLogThatHasGrownTakesThePlaceOfTheOldOne() throws IOException {
    Path log = folder.resolve("growing/cup/now.log.gz");
    half(logs.resolve("cup/flat-1.log.gz"), log);
    LogFile before = LogTask.identify(LogFinder.find(List.of(log)).get(0));
    Path out = folder.resolve("of-growing");
    ArchiveFolder archive = new ArchiveFolder(out.toString());
    archive.prepare();
    LogTask.run(before, archive, LogOpener.USUAL, "1");
    assertThatThrownBy(() -> SparkArchive.requireAllOf(archive, List.of(), out))
        .hasMessageContaining("contains 1 log that is not among those named")
        .hasMessageContaining("now.log.gz of cup");

    Files.copy(logs.resolve("cup/flat-1.log.gz"), log, StandardCopyOption.REPLACE_EXISTING);
    LogFile after = LogTask.identify(LogFinder.find(List.of(log)).get(0));
    SparkArchive.requireAllOf(archive, List.of(after), out);
    assertThat(archive.done()).isEmpty();
    assertThat(archive.file(Tables.KICKS, before)).doesNotExist();
  }

  @Test
  void whatTheDiskFailedToGiveIsTriedAgain() throws IOException {
    Path log = Path.of("log.gz");
    assertThat(LogTask.isOfTheContent(new GameLogException(log, "is empty"))).isTrue();
    assertThat(LogTask.isOfTheContent(new GameLogException(log, "is cut off", new EOFException())))
        .isTrue();
    assertThat(
            LogTask.isOfTheContent(new GameLogException(log, "", new IOException("stale handle"))))
        .isFalse();
    assertThat(LogTask.isOfTheContent(new IOException("Input/output error"))).isFalse();

    // Cannot be opened for reading, whoever asks.
    ArchiveFolder archive = new ArchiveFolder(folder.resolve("of-failing").toString());
    archive.prepare();
    LogFile gone = new LogFile("/nowhere/cup/a.log", "a.log", "cup", 1, 0, "0".repeat(16), null);
    assertThat(LogTask.run(gone, archive, LogOpener.USUAL, "1").log().unreadable())
        .endsWith("--resume tries again");
    assertThat(archive.done()).isEmpty();
  }

  @Test
  void logsThatCannotBeOpenedHaveRowsOfTheirOwn() {
    LogFile packed = new LogFile("/a/cup/x.log.gz", "x.log.gz", "cup", 1, 0, null, "no");
    LogFile plain = new LogFile("/a/cup/x.log", "x.log", "cup", 1, 0, null, "no");
    ArchiveFolder archive = new ArchiveFolder(folder.toString());
    assertThat(archive.file(Tables.PROBLEMS, packed))
        .isNotEqualTo(archive.file(Tables.PROBLEMS, plain));
  }

  @Test
  void whatIsWrittenWhileItIsReadIsLeftForTheNextRun() throws IOException {
    Path recorded = folder.resolve("recorded/cup/now.log.gz");
    Files.createDirectories(recorded.getParent());
    byte[] all = Files.readAllBytes(logs.resolve("cup/flat-1.log.gz"));
    Files.write(recorded, Arrays.copyOf(all, all.length / 2));
    LogFile before = LogTask.identify(LogFinder.find(List.of(recorded)).get(0));
    Files.write(recorded, all);
    Files.setLastModifiedTime(recorded, FileTime.fromMillis(before.modified() + 1000));
    ArchiveFolder archive = new ArchiveFolder(folder.resolve("of-recorded").toString());
    archive.prepare();
    LogFile after = LogTask.run(before, archive, LogOpener.USUAL, "1").log();
    assertThat(after.log()).isNull();
    assertThat(after.unreadable()).contains("changed while it was read");
    assertThat(archive.done()).isEmpty();

    LogFile again = LogTask.identify(after);
    assertThat(LogTask.run(again, archive, LogOpener.USUAL, "2").log().log())
        .isEqualTo(again.log());
    assertThat(archive.done()).containsExactly(again.log());
  }

  @Test
  void whatTheLimitOfPackingRefusedIsTriedAgainWithAnotherOne() throws IOException {
    LogFile log =
        LogTask.identify(LogFinder.find(List.of(logs.resolve("cup/flat-1.log.gz"))).get(0));
    ArchiveFolder archive = new ArchiveFolder(folder.resolve("of-packed").toString());
    archive.prepare();
    LogOpener tight = new LogOpener(1);
    Row problem = MatchTables.broken(log.log(), Path.of(log.path()), "unpacks to too much");
    archive.commitUnread(log, problem, tight, "1");
    assertThat(archive.isDone(log, tight)).isTrue();
    assertThat(archive.isDone(log, LogOpener.USUAL)).isFalse();

    LogTask.run(log, archive, LogOpener.USUAL, "2");
    assertThat(archive.isDone(log, LogOpener.USUAL)).isTrue();
    assertThat(archive.isDone(log, tight)).isTrue();
  }

  /** Tries to take a lock as another program would. */
  static final class Other {
    private Other() {}

    public static void main(String[] args) throws IOException {
      ArchiveLock.take(Path.of(args[0])).close();
    }
  }

  private static int other(Path archive) throws IOException, InterruptedException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            Other.class.getName(),
            archive.toString())
        .start()
        .waitFor();
  }

  @Test
  void twoRunsOnOneArchiveRefuseEachOther() throws IOException, InterruptedException {
    Path busy = folder.resolve("busy");
    ArchiveLock lock = ArchiveLock.take(busy);
    try {
      assertThatThrownBy(() -> run(busy, "local[1]", true, logs))
          .hasMessageContaining("another run is working on this archive (process ");
      // The refused run has not released the lock of this one.
      assertThat(other(busy)).isEqualTo(1);
    } finally {
      lock.close();
    }
    assertThat(other(busy)).isZero();
    ArchiveLock.take(busy).close();
  }

  /** A folder of logs may be called as a table is. */
  @Test
  void nothingThatSomebodyElsePutThereIsRemoved() throws IOException {
    Path out = Files.createDirectories(folder.resolve("of-somebody"));
    Path log = out.resolve("matches/flat.log.gz");
    Files.createDirectories(log.getParent());
    Files.copy(logs.resolve("cup/flat-1.log.gz"), log);
    assertThatThrownBy(() -> run(out, "local[1]", false, log.getParent()))
        .hasMessageContaining("lies where the archive has its table matches");
    assertThatThrownBy(() -> run(out, "local[1]", false, logs.resolve("cup")))
        .hasMessageContaining("matches: is there already, and is not of an archive");

    ArchiveFolder archive = new ArchiveFolder(out.toString());
    Path stale = out.resolve("matches/tournament=cup/match=old/old.parquet");
    Files.createDirectories(stale.getParent());
    Files.createFile(stale);
    archive.keepOnly(Tables.MATCHES, List.of());
    assertThat(log).exists();
    assertThat(out.resolve("matches/tournament=cup")).doesNotExist();
  }

  @Test
  void whatIsNotThereIsNamed() {
    assertThatThrownBy(() -> run(folder.resolve("x"), "local[1]", false, folder.resolve("nowhere")))
        .hasMessageContaining("nowhere: no such file or folder");
    assertThatThrownBy(() -> run(folder.resolve("x"), "local[1]", false, whole.resolve("kicks")))
        .hasMessageContaining("there is no game log");
    assertThatThrownBy(() -> run(folder.resolve("x"), "nonsense", false, logs))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("Spark does not start on 'nonsense'");
  }
}
