package fieldcal.archive;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.files.WholeFile;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.recording.VisionContent;
import fieldcal.archive.match.Fingerprint;
import fieldcal.archive.table.ParquetFile;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
import fieldcal.gamelog.RecordingOrigin;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.Serializable;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * An archive on the disk: {@code TABLE/tournament=T/match=M/LOG.parquet} for each table, and {@code state/} with one record for each log that is done. A log's files are written aside and
 * moved into place, its record comes last; so a run that was killed leaves whole logs, and whatever it leaves of another one is replaced by the same bytes.
 *
 * @param root of the archive, absolute; the same on every machine that works on it
 */
record ArchiveFolder(String root) implements Serializable {
  /** Grows when the tables change: what another release wrote is written again. */
  private static final int FORMAT = 5;

  private static final String STATE = "state";
  private static final String DONE = ".done";

  /** Ends the head of the record of a log whose frames another log holds, too. */
  private static final String REPEATS = "\tleft out: another log holds its frames";

  private static final String UNFINISHED = "unfinished-";
  private static final String TOURNAMENT = "tournament=";
  private static final String MATCH = "match=";

  private Path state() {
    return Path.of(root, STATE);
  }

  /** Whether somebody began an archive here. */
  boolean begun() {
    return Files.isDirectory(state());
  }

  /** Makes what is missing, and clears away what a killed run left aside. Only for the one who holds the lock. */
  void prepare() throws IOException {
    Files.createDirectories(state());
    for (Path left : list(state(), UNFINISHED)) {
      delete(left);
    }
  }

  /** Fingerprints of all logs that have a record. */
  List<String> done() throws IOException {
    List<String> logs = new ArrayList<>();
    try (Stream<Path> files = Files.list(state())) {
      files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(DONE))
          .map(name -> name.substring(0, name.length() - DONE.length()))
          .sorted()
          .forEach(logs::add);
    }
    return logs;
  }

  /**
   * Whether a log is done: by this release, under this name, a log that could not be read with the same limit of packing, and every file that its record names is there as it was written. Otherwise what is there of it is removed.
   */
  boolean isDone(LogFile log, LogOpener opener) throws IOException {
    List<String> lines = record(log.log());
    if (lines.isEmpty()) {
      return false;
    }
    boolean good = isHead(lines.get(0), log, opener);
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.split("\t");
      Path file = Path.of(root, cells[0]);
      good = good && Files.exists(file) && Fingerprint.of(file).equals(cells[1]);
    }
    if (!good) {
      forget(log.log());
    }
    return good;
  }

  /** Lines of a log's record; of an empty one a line that is no head; none without a record. */
  private List<String> record(String log) throws IOException {
    Path record = state().resolve(log + DONE);
    if (!Files.exists(record)) {
      return List.of();
    }
    List<String> lines = Files.readAllLines(record);
    return lines.isEmpty() ? List.of("") : lines;
  }

  /** Whether a log has a record. */
  boolean isRecorded(String log) {
    return Files.exists(state().resolve(log + DONE));
  }

  /** Removes a log: its files, then its record. */
  void forget(String log) throws IOException {
    List<String> lines = record(log);
    for (String line : lines.subList(Math.min(1, lines.size()), lines.size())) {
      Files.deleteIfExists(Path.of(root, line.split("\t")[0]));
    }
    Files.deleteIfExists(state().resolve(log + DONE));
  }

  /**
   * A log as its record names it.
   *
   * @param tournament folder of the log
   * @param name of the file alone
   */
  record Named(String tournament, String name) {}

  /** How a log is named that has a record; empty when another release wrote it otherwise. */
  Optional<Named> named(String log) throws IOException {
    String[] cells = record(log).get(0).split("\t");
    return cells.length < 5 ? Optional.empty() : Optional.of(new Named(cells[2], cells[4]));
  }

  /** Leaves out a log that is done, since another one holds its frames, too: its rows are no longer expected among the tables, and what it holds stays known. */
  void leaveOut(LogFile log) throws IOException {
    if (!isLeftOut(log)) {
      WholeFile.write(
          head(log) + REPEATS + "\n" + line(content(log), content(log)),
          state().resolve(log.log() + DONE));
    }
    Files.deleteIfExists(summary(log));
  }

  /** Whether a log that is done is left out: then the archive has no rows of it. */
  boolean isLeftOut(LogFile log) throws IOException {
    return record(log.log()).contains(head(log) + REPEATS);
  }

  private static String head(LogFile log) {
    String version = ArchiveFolder.class.getPackage().getImplementationVersion();
    return String.join(
        "\t",
        "fieldcal.archive/" + FORMAT,
        version == null ? "development" : version,
        log.tournament(),
        log.match(),
        log.name());
  }

  private static boolean isHead(String line, LogFile log, LogOpener opener) {
    return List.of(head(log), head(log) + unread(opener), head(log) + REPEATS).contains(line);
  }

  /** With another limit of packing the log might be readable. */
  private static String unread(LogOpener opener) {
    return "\tnot read with --unpack-limit " + opener.largestRatio();
  }

  /**
   * Writes the row of a log that could not be read.
   *
   * @param log with fingerprint
   * @param problem its row
   * @param opener that tried to read it
   * @param attempt a name that no other attempt has
   */
  void commitUnread(LogFile log, Row problem, LogOpener opener, String attempt) throws IOException {
    commit(
        log,
        Map.of(Tables.PROBLEMS, List.of(problem)),
        Optional.empty(),
        head(log) + unread(opener),
        attempt);
  }

  /** Where the rows of a table are that come from one log. */
  Path file(Table table, LogFile log) {
    return folder(table)
        .resolve(TOURNAMENT + log.tournament())
        .resolve(MATCH + log.match())
        .resolve((log.log() == null ? "unreadable" : log.log()) + ".parquet");
  }

  /** Row of the table matches as the log alone knows it. */
  private Path summary(LogFile log) {
    return state().resolve(log.log() + ".match.parquet");
  }

  /** What shows whether another log holds the same frames. */
  private Path content(LogFile log) {
    return state().resolve(log.log() + ".content");
  }

  /** What a log that is done holds, as far as it takes to compare it with others; empty for one that could not be read. */
  Optional<RecordingFacts> facts(LogFile log) throws IOException {
    if (!Files.exists(content(log))) {
      return Optional.empty();
    }
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(Files.newInputStream(content(log))))) {
      RecordingOrigin origin =
          in.readBoolean() ? RecordingOrigin.SIMULATION : RecordingOrigin.FIELD;
      VisionContent content = VisionContent.readFrom(in);
      return Optional.of(
          new RecordingFacts(
              Path.of(log.path()),
              origin,
              0,
              Optional.empty(),
              0,
              log.bytes(),
              false,
              content,
              List.of()));
    }
  }

  private static void write(RecordingFacts facts, Path file) throws IOException {
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
      out.writeBoolean(facts.isSimulated());
      facts.content().writeTo(out);
    }
  }

  /**
   * Writes all rows of a log.
   *
   * @param log with fingerprint
   * @param rows of each table; tables without rows get no file
   * @param facts of the log
   * @param attempt a name that no other attempt has
   */
  void commit(LogFile log, Map<Table, List<Row>> rows, RecordingFacts facts, String attempt)
      throws IOException {
    commit(log, rows, Optional.of(facts), head(log), attempt);
  }

  private void commit(
      LogFile log,
      Map<Table, List<Row>> rows,
      Optional<RecordingFacts> facts,
      String head,
      String attempt)
      throws IOException {
    Path aside = Files.createDirectories(state().resolve(UNFINISHED + attempt));
    Map<Path, Path> moves = new LinkedHashMap<>();
    StringBuilder record = new StringBuilder(head).append('\n');
    for (Map.Entry<Table, List<Row>> entry : rows.entrySet()) {
      Table table = entry.getKey();
      if (entry.getValue().isEmpty()) {
        continue;
      }
      Path written = aside.resolve(table.name() + ".parquet");
      ParquetFile.write(table, entry.getValue(), written);
      Path target = table == Tables.MATCHES ? summary(log) : file(table, log);
      moves.put(written, target);
      record.append(line(target, written));
    }
    if (facts.isPresent()) {
      Path written = aside.resolve("content");
      write(facts.get(), written);
      moves.put(written, content(log));
      record.append(line(content(log), written));
    }
    for (Map.Entry<Path, Path> move : moves.entrySet()) {
      Files.createDirectories(move.getValue().getParent());
      move(move.getKey(), move.getValue());
    }
    delete(aside);
    WholeFile.write(record.toString(), state().resolve(log.log() + DONE));
  }

  /** A record's line of a file, by the bytes that it has or will have. */
  private String line(Path target, Path written) throws IOException {
    return Path.of(root).relativize(target) + "\t" + Fingerprint.of(written) + "\n";
  }

  /** Replaces a file of the archive in one step. */
  static void replace(Table table, List<Row> rows, Path target) throws IOException {
    Files.createDirectories(target.getParent());
    Path written = target.resolveSibling(target.getFileName() + ".part");
    ParquetFile.write(table, rows, written);
    move(written, target);
  }

  /** Replaces the only file of a table that is of all matches together. */
  void replace(Table table, List<Row> rows) throws IOException {
    replace(table, rows, Path.of(root, table.name(), table.name() + ".parquet"));
  }

  private static void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** The match of a log that is done. */
  Optional<Row> match(LogFile log) throws IOException {
    Path file = summary(log);
    return Files.exists(file)
        ? Optional.of(ParquetFile.read(Tables.MATCHES, file).get(0))
        : Optional.empty();
  }

  /** All rows of a table that come from one log. */
  List<Row> rows(Table table, LogFile log) throws IOException {
    Path file = file(table, log);
    return Files.exists(file) ? ParquetFile.read(table, file) : List.of();
  }

  /** Removes a table's files whose logs are not among those given, and folders of matches that are empty. Whatever else lies there is somebody else's and stays. */
  void keepOnly(Table table, List<LogFile> logs) throws IOException {
    Set<Path> expected = new HashSet<>();
    logs.forEach(log -> expected.add(file(table, log)));
    Path folder = folder(table);
    if (!Files.isDirectory(folder)) {
      return;
    }
    List<Path> all;
    try (Stream<Path> files = Files.walk(folder)) {
      all = files.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path path : all) {
      Path place = folder.relativize(path);
      boolean stale = isFileOfALog(place) && Files.isRegularFile(path) && !expected.contains(path);
      boolean left = isFolderOfLogs(place) && Files.isDirectory(path) && list(path, "").isEmpty();
      if (stale || left) {
        Files.delete(path);
      }
    }
  }

  private Path folder(Table table) {
    return Path.of(root, table.name());
  }

  private static boolean isFileOfALog(Path place) {
    return place.getNameCount() == 3
        && isFolderOfLogs(place.getParent())
        && place.getFileName().toString().matches(".*\\.parquet(\\.part)?");
  }

  /** Of a tournament, or of one of its matches. */
  private static boolean isFolderOfLogs(Path place) {
    return place.getNameCount() <= 2
        && place.getName(0).toString().startsWith(TOURNAMENT)
        && (place.getNameCount() == 1 || place.getName(1).toString().startsWith(MATCH));
  }

  /**
   * Makes sure that nothing of somebody else's lies where the tables go.
   *
   * @param out the archive, as the operator named it
   * @param logs that are to be read
   * @throws InputException when a log lies there, or when there is no archive yet but one of the folders is not empty
   */
  void requireOwnFolders(Path out, List<LogFile> logs) throws IOException {
    for (Table table : Tables.ALL) {
      Path folder = folder(table);
      if (!Files.exists(folder)) {
        continue;
      }
      Path real = folder.toRealPath();
      for (LogFile log : logs) {
        Path path = Path.of(log.path());
        if (path.startsWith(folder) || path.toRealPath().startsWith(real)) {
          throw new InputException(
              log.path()
                  + ": lies where the archive has its table "
                  + table.name()
                  + "; name another directory with --out");
        }
      }
      if (!begun() && !(Files.isDirectory(folder) && list(folder, "").isEmpty())) {
        throw new InputException(
            out.resolve(table.name())
                + ": is there already, and is not of an archive; name another directory with"
                + " --out");
      }
    }
  }

  private static List<Path> list(Path folder, String prefix) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.getFileName().toString().startsWith(prefix)).toList();
    }
  }

  private static void delete(Path path) throws IOException {
    List<Path> all;
    try (Stream<Path> files = Files.walk(path)) {
      all = files.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path one : all) {
      Files.deleteIfExists(one);
    }
  }
}
