package fieldcal.app.monitor;

import fieldcal.app.wording.Harmless;
import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.time.ZoneId;
import java.util.List;

/** The state of a match on a terminal, redrawn in place on a screen of its own, so that what was there before comes back. */
public final class ScreenDisplay implements MatchDisplay {
  private static final String ENTER = "\u001b[?1049h\u001b[?25l\u001b[?7l";
  private static final String LEAVE = "\u001b[?7h\u001b[?25h\u001b[?1049l";
  private static final String HOME = "\u001b[H";
  private static final String CLEAR_LINE = "\u001b[K";
  private static final String CLEAR_REST = "\u001b[J";

  /** Redrawn so often, ms: calm to look at. */
  private static final long PERIOD = 500;

  /** How often a terminal's size is asked for. */
  private static final int SHOWS_PER_SIZE = 10;

  private static final Size USUAL = new Size(40, 100);
  private static final Size SMALLEST = new Size(10, 40);

  private final PrintWriter out;
  private final MatchText text;
  private boolean entered;
  private long last;
  private Size size;
  private int shows;

  /** Of a terminal, in characters. */
  private record Size(int rows, int columns) {}

  /**
   * A display.
   *
   * @param out a terminal that understands ANSI; names of others are made harmless here
   * @param zone of the times of day
   */
  public ScreenDisplay(PrintWriter out, ZoneId zone) {
    this.out = out;
    text = new MatchText(zone);
  }

  @Override
  public void show(MatchStatus status) {
    long now = System.nanoTime() / 1_000_000;
    if (entered && now - last < PERIOD) {
      return;
    }
    last = now;
    StringBuilder page = new StringBuilder();
    page.append(entered ? HOME : ENTER + HOME);
    entered = true;
    for (String line : fitting(status)) {
      page.append(line).append(CLEAR_LINE).append('\n');
    }
    page.append("Ctrl-C ends").append(CLEAR_LINE).append(CLEAR_REST);
    out.print(page);
    out.flush();
  }

  /** A line more than the terminal has would push the first ones out, and the first ones are warnings. */
  private List<String> fitting(MatchStatus status) {
    if (size == null || ++shows % SHOWS_PER_SIZE == 0) {
      size = size();
    }
    List<String> kept = text.lines(status, size.columns() - 1);
    if (kept.size() >= size.rows()) {
      kept = kept.stream().filter(line -> !line.isBlank()).toList();
    }
    return kept.subList(0, Math.min(kept.size(), size.rows() - 1)).stream()
        .map(line -> cut(Harmless.text(line)))
        .toList();
  }

  /** One column stays free: in the last one, the end of the line would be wiped with what stood there before. */
  private String cut(String line) {
    int most = size.columns() - 1;
    return line.length() <= most ? line : line.substring(0, most - 1) + "…";
  }

  /** As the terminal itself says; Java does not know. */
  private static Size size() {
    try {
      Process stty =
          new ProcessBuilder("stty", "size")
              .redirectInput(new File("/dev/tty"))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      String said = new String(stty.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
      String[] numbers = said.strip().split(" ");
      int rows = Integer.parseInt(numbers[0]);
      int columns = Integer.parseInt(numbers[1]);
      // Some terminals do not know their size and say 0.
      return rows == 0 || columns == 0
          ? USUAL
          : new Size(Math.max(SMALLEST.rows(), rows), Math.max(SMALLEST.columns(), columns));
    } catch (IOException | NumberFormatException | ArrayIndexOutOfBoundsException e) {
      return USUAL;
    }
  }

  @Override
  public void summary(MatchStatus status) {
    close();
    text.summary(status, size == null ? USUAL.columns() : size.columns())
        .forEach(line -> out.println(Harmless.text(line)));
    out.flush();
  }

  @Override
  public void close() {
    if (entered) {
      out.print(LEAVE);
      out.flush();
      entered = false;
    }
  }
}
