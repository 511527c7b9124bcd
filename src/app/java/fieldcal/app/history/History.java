package fieldcal.app.history;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.files.WholeFile;
import fieldcal.app.history.HistoryEntry.Action;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The history of a session's folder. Lines are only ever added, under a lock, so that a console and a command line may write at the same time; a line that a crash cut off is
 * passed over.
 */
public final class History {
  private static final String FILE = "history.jsonl";
  private static final String BEFORE = "history";

  /** Never opened but to be locked: when a process closes a file, the system releases all locks that it has on it, also those of another channel. */
  private static final String LOCK = "history.lock";

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final Path directory;

  /**
   * The history of a folder.
   *
   * @param directory the session's folder
   */
  public History(Path directory) {
    this.directory = directory;
  }

  /**
   * All entries.
   *
   * @return the oldest first; empty when nothing was published yet
   * @throws IOException when the file cannot be read
   */
  public List<HistoryEntry> entries() throws IOException {
    Path file = directory.resolve(FILE);
    if (!Files.exists(file)) {
      return List.of();
    }
    List<HistoryEntry> entries = new ArrayList<>();
    for (String line :
        new String(Files.readAllBytes(file), StandardCharsets.UTF_8).lines().toList()) {
      try {
        HistoryEntry entry = MAPPER.readValue(line, HistoryEntry.class);
        if (entry != null && HistoryEntry.SCHEMA.equals(entry.schema()) && entry.action() != null) {
          entries.add(entry.numbered(entries.size() + 1));
        }
      } catch (JsonProcessingException e) {
        // Cut off by a crash or of a later version: the others are still true.
      }
    }
    return List.copyOf(entries);
  }

  /**
   * Adds an entry.
   *
   * @param entry its number is given here
   * @param before what was there before, to be kept; empty when there was nothing
   * @return the entry as it is in the file
   * @throws IOException when it cannot be written
   */
  public synchronized HistoryEntry add(HistoryEntry entry, Optional<byte[]> before)
      throws IOException {
    Files.createDirectories(directory);
    try (FileChannel lock =
            FileChannel.open(
                directory.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileChannel channel =
            FileChannel.open(
                directory.resolve(FILE),
                StandardOpenOption.CREATE,
                StandardOpenOption.READ,
                StandardOpenOption.WRITE)) {
      // Released when its channel is closed, which is last.
      lock.lock();
      int number = entries().size() + 1;
      String kept = null;
      if (before.isPresent()) {
        kept = free(number);
        WholeFile.write(before.get(), directory.resolve(kept));
      }
      HistoryEntry written =
          new HistoryEntry(
              HistoryEntry.SCHEMA,
              number,
              entry.unix(),
              entry.action(),
              entry.target(),
              entry.place(),
              entry.verdict(),
              entry.sources(),
              entry.kicks(),
              entry.model(),
              entry.text(),
              kept,
              entry.undoes());
      append(channel, MAPPER.writeValueAsString(written));
      return written;
    }
  }

  /** A name that no other line has; those of a later version are not among the entries, but count on. */
  private String free(int number) {
    int free = number;
    while (Files.exists(directory.resolve(BEFORE + "/" + free + ".before"))) {
      free++;
    }
    return BEFORE + "/" + free + ".before";
  }

  private static void append(FileChannel channel, String line) throws IOException {
    long end = channel.size();
    // A line that was cut off must not take this one with it.
    ByteBuffer last = ByteBuffer.allocate(1);
    boolean whole = end == 0 || channel.read(last, end - 1) == 1 && last.get(0) == '\n';
    byte[] bytes = ((whole ? "" : "\n") + line + "\n").getBytes(StandardCharsets.UTF_8);
    ByteBuffer buffer = ByteBuffer.wrap(bytes);
    while (buffer.hasRemaining()) {
      end += channel.write(buffer, end);
    }
  }

  /**
   * What was there before an entry.
   *
   * @param entry with something before
   * @return the bytes
   * @throws IOException when they cannot be read, or the entry names a file that is not in {@code history/}
   */
  public byte[] before(HistoryEntry entry) throws IOException {
    Path folder = directory.resolve(BEFORE).normalize();
    Path kept;
    try {
      kept = directory.resolve(entry.before()).normalize();
    } catch (InvalidPathException e) {
      throw new IOException(directory.resolve(FILE) + ": names no file: " + entry.before(), e);
    }
    if (!folder.equals(kept.getParent())) {
      throw new IOException(kept + ": is not in the history, " + folder);
    }
    return Files.readAllBytes(kept);
  }

  /**
   * The latest entry at a place that can be put back and was not yet.
   *
   * @param place the file, address or URL
   * @return empty when there is none
   * @throws IOException when the history cannot be read
   */
  public Optional<HistoryEntry> toUndo(String place) throws IOException {
    List<HistoryEntry> all = entries();
    Set<Integer> undone =
        all.stream()
            .filter(e -> e.undoes() != null)
            .map(HistoryEntry::undoes)
            .collect(Collectors.toSet());
    return all.stream()
        .filter(e -> e.place() != null && e.place().equals(place) && e.before() != null)
        .filter(e -> e.action() == Action.APPLIED || e.action() == Action.EXPORTED)
        .filter(e -> !undone.contains(e.id()))
        .reduce((first, second) -> second);
  }
}
