package fieldcal.app.wording;

import java.util.List;

/** Several things in one sentence. */
public final class WordList {
  private WordList() {}

  /**
   * For example "a, b and c".
   *
   * @param items in order; may be empty
   * @return the items with commas, the last one with "and"
   */
  public static String of(List<String> items) {
    int last = items.size() - 1;
    return last < 1
        ? String.join("", items)
        : String.join(", ", items.subList(0, last)) + " and " + items.get(last);
  }
}
