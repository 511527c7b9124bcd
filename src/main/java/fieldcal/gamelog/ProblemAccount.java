package fieldcal.gamelog;

import fieldcal.vision.ProblemKind;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * What was wrong with one recording: each kind is counted, the first few occurrences are kept with their place in the file.
 *
 * <p>Offsets count the bytes of the log itself; in a compressed file that is after decompression. Not thread-safe.
 */
public final class ProblemAccount {
  /** Occurrences of each kind that are kept; more would help nobody, and memory stays bounded. */
  public static final int KEPT = 3;

  private final Path file;
  private final Map<ProblemKind, Entry> entries = new LinkedHashMap<>();

  /**
   * Starts an empty account.
   *
   * @param file the file the problems are in
   */
  public ProblemAccount(Path file) {
    this.file = Objects.requireNonNull(file, "file");
  }

  /**
   * One place where something was wrong.
   *
   * @param offset in the log, bytes
   * @param detail what exactly; may be empty
   */
  public record Occurrence(long offset, String detail) {}

  /**
   * Counts a problem.
   *
   * @param kind what it is
   * @param offset where in the log, bytes
   * @param detail what exactly, asked for only if the occurrence is kept: a recording may hold a problem a million times
   */
  public void add(ProblemKind kind, long offset, Supplier<String> detail) {
    Entry entry = entries.computeIfAbsent(kind, key -> new Entry());
    entry.count++;
    if (entry.first.size() < KEPT) {
      entry.first.add(new Occurrence(offset, detail.get()));
    }
  }

  /**
   * The file.
   *
   * @return as given
   */
  public Path file() {
    return file;
  }

  /**
   * A place for people.
   *
   * @param offset in the log, bytes
   * @return for example "byte 16", of a compressed file "byte 16 of the unpacked log": such a place may lie beyond the end of the file
   */
  public String place(long offset) {
    return "byte " + offset + (file.toString().endsWith(".gz") ? " of the unpacked log" : "");
  }

  /**
   * How often a problem occurred.
   *
   * @param kind which
   * @return its count
   */
  public long count(ProblemKind kind) {
    Entry entry = entries.get(kind);
    return entry == null ? 0 : entry.count;
  }

  /**
   * The first occurrences of a problem.
   *
   * @param kind which
   * @return at most {@value #KEPT}
   */
  public List<Occurrence> first(ProblemKind kind) {
    Entry entry = entries.get(kind);
    return entry == null ? List.of() : List.copyOf(entry.first);
  }

  /**
   * What occurred at all.
   *
   * @return the kinds, in the order of their first occurrence
   */
  public List<ProblemKind> kinds() {
    return List.copyOf(entries.keySet());
  }

  /**
   * The account for people.
   *
   * @return one line per kind: how often, what, and where it was first
   */
  public List<String> lines() {
    return entries.entrySet().stream()
        .map(
            entry -> {
              Occurrence first = entry.getValue().first.get(0);
              String detail = first.detail().isEmpty() ? "" : " (" + first.detail() + ")";
              return String.format(
                  Locale.ROOT,
                  "%d × %s; first at %s%s",
                  entry.getValue().count,
                  entry.getKey().text(),
                  place(first.offset()),
                  detail);
            })
        .toList();
  }

  private static final class Entry {
    private long count;
    private final List<Occurrence> first = new ArrayList<>(KEPT);
  }
}
