package fieldcal.app.cli;

import java.io.PrintWriter;

/** Prints sentences in lines of a hundred columns at most, broken at spaces. */
final class WrappedText {
  /** Two less than a hundred, for terminals that break early. */
  static final int WIDTH = 98;

  private final PrintWriter out;

  WrappedText(PrintWriter out) {
    this.out = out;
  }

  /** Prints a text; the first line and the others begin with what is given. */
  void print(String first, String others, String text) {
    StringBuilder row = new StringBuilder(first);
    boolean empty = true;
    for (String word : text.split(" ")) {
      if (!empty && row.length() + 1 + word.length() > WIDTH) {
        out.println(row);
        row = new StringBuilder(others);
        empty = true;
      }
      row.append(empty ? "" : " ").append(word);
      empty = false;
    }
    out.println(row);
  }
}
