package fieldcal.app.monitor;

import java.io.PrintWriter;
import java.time.ZoneId;
import java.util.List;

/** The state of a match on a terminal, redrawn in place on a screen of its own, so that what was there before comes back. */
public final class ScreenDisplay implements MatchDisplay {
  private static final String ENTER = "\u001b[?1049h\u001b[?25l";
  private static final String LEAVE = "\u001b[?25h\u001b[?1049l";
  private static final String HOME = "\u001b[H";
  private static final String CLEAR_LINE = "\u001b[K";
  private static final String CLEAR_REST = "\u001b[J";

  /** Redrawn so often, ms: calm to look at. */
  private static final long PERIOD = 500;

  private final PrintWriter out;
  private final MatchText text;
  private boolean entered;
  private long last;

  /**
   * A display.
   *
   * @param out a terminal that understands ANSI
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
    List<String> lines = text.lines(status);
    for (String line : lines) {
      page.append(line).append(CLEAR_LINE).append('\n');
    }
    page.append("Ctrl-C ends").append(CLEAR_LINE).append(CLEAR_REST);
    out.print(page);
    out.flush();
  }

  @Override
  public void summary(MatchStatus status) {
    close();
    text.lines(status).forEach(out::println);
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
