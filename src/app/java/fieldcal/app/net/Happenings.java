package fieldcal.app.net;

import java.util.ArrayList;
import java.util.List;

/** What an operator is told as it happens: as much of it as anybody reads, and how often it happened. Not thread-safe. */
public final class Happenings {
  /** What happens more often is only counted. */
  private static final int MOST = 10;

  private final List<String> told = new ArrayList<>();
  private final String onlyCounted;
  private int count;

  /**
   * Nothing has happened yet.
   *
   * @param onlyCounted what is said when it happens so often that from then on it is only counted
   */
  public Happenings(String onlyCounted) {
    this.onlyCounted = onlyCounted;
  }

  /**
   * It happened.
   *
   * @param sentence that no other happening has
   */
  public void add(String sentence) {
    count++;
    if (count <= MOST) {
      told.add(sentence);
    } else if (count == MOST + 1) {
      told.add(onlyCounted);
    }
  }

  /**
   * How often it happened.
   *
   * @return 0 or more
   */
  public int count() {
    return count;
  }

  /**
   * What was told.
   *
   * @return a sentence each, in order; none ever changes or goes away
   */
  public List<String> told() {
    return List.copyOf(told);
  }
}
