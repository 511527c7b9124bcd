package fieldcal.app.wording;

import java.util.ArrayList;
import java.util.List;

/** The recordings that a sentence is about. */
public final class RecordingNames {
  /** More are counted; chosen, since three names fill a line of the terminal. */
  private static final int MOST_NAMED = 3;

  private RecordingNames() {}

  /**
   * In one line.
   *
   * @param names of the recordings
   * @return for example "a.log.gz, b.log.gz, c.log.gz and 5 others"
   */
  public static String of(List<String> names) {
    List<String> all = new ArrayList<>(names.stream().map(Harmless::line).toList());
    if (all.size() > MOST_NAMED + 1) {
      all.subList(MOST_NAMED, all.size()).clear();
      all.add((names.size() - MOST_NAMED) + " others");
    }
    return WordList.of(all);
  }
}
