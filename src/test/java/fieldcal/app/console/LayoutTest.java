package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Nothing is cut off, on a small laptop, a large screen and a phone: the console's pages, the report, and what the mouse shows. */
class LayoutTest {
  /** What hides a part of a badge, a button or a number: an edge of the window, or of a box that clips; a box that scrolls does so only on a wide screen. */
  private static final String CUT_OFF =
      """
      const narrow = innerWidth < 700, cut = [];
      for (const node of document.querySelectorAll('.badge, button, input, select, td.big, h2, .legend span')) {
        const box = node.getBoundingClientRect();
        if (box.width === 0) continue;
        let scrolls = false;
        for (let above = node.parentElement; above && above !== document.body; above = above.parentElement) {
          const style = getComputedStyle(above);
          if (style.overflowX === 'visible') continue;
          if (style.overflowX === 'auto' || style.overflowX === 'scroll') { scrolls = true; if (narrow) continue; }
          const edge = above.getBoundingClientRect();
          if (box.right > edge.right + 1 || box.left < edge.left - 1) cut.push(node.textContent.trim() + ' in ' + (above.id || above.className));
        }
        if (!(scrolls && narrow) && (box.right > innerWidth + 1 || box.left < -1)) cut.push(node.textContent.trim() + ' in the window');
      }
      for (const table of document.querySelectorAll('table')) {
        const box = table.getBoundingClientRect();
        if (narrow && box.width > 0 && box.right > innerWidth + 1) cut.push('a table that ends at ' + Math.round(box.right) + ' px in ' + (table.closest('[id]') || table).id + ': ' + table.textContent.trim().slice(0, 60));
      }
      for (const cell of document.querySelectorAll('td')) {
        const box = cell.getBoundingClientRect();
        if (box.height > 260 && !cell.querySelector('canvas, table, pre')) cut.push('a cell of ' + Math.round(box.height) + ' px height: ' + cell.textContent.trim());
      }
      if (document.documentElement.scrollWidth > innerWidth + 1) cut.push('the page is ' + document.documentElement.scrollWidth + ' px wide');
      return cut;
      """;

  /** Headings and buttons that lie over each other: the boxes of a heading's words and of a button. A question lies over its page on purpose. */
  private static final String OVERLAP =
      """
      const over = [];
      for (const heading of document.querySelectorAll('h2, h3')) {
        const words = document.createRange();
        words.selectNodeContents(heading);
        for (const line of words.getClientRects()) {
          for (const button of heading.closest('dialog, section, main, body').querySelectorAll('button')) {
            const box = button.getBoundingClientRect();
            if (box.width > 0 && box.left < line.right - 1 && box.right > line.left + 1 && box.top < line.bottom - 1 && box.bottom > line.top + 1) over.push(heading.textContent + ' and ' + button.textContent);
          }
        }
      }
      return over;
      """;

  /** Where the points of the parameters' plots are in the window. */
  private static final String POINTS =
      """
      return [...document.querySelectorAll('#parameters .chart')].flatMap(box => {
        const chart = Frame.charts.get(box), edge = box.getBoundingClientRect();
        return chart.getOption().series.filter(s => s.type === 'scatter' && !s.silent).flatMap(s => s.data).map(point => {
          const [x, y] = chart.convertToPixel({xAxisIndex: 0, yAxisIndex: 0}, point.value);
          return [edge.left + x + point.symbolOffset[0], edge.top + y + point.symbolOffset[1]];
        });
      });
      """;

  /** Corners of the tip that is shown which something lies over, or which are outside the window; null when none is shown. */
  private static final String HIDDEN_CORNERS =
      """
      const tip = [...document.querySelectorAll('.tip')].find(node => getComputedStyle(node.parentElement).visibility !== 'hidden' && node.parentElement.style.opacity !== '0');
      if (!tip) return null;
      tip.parentElement.style.pointerEvents = 'auto';
      const at = tip.getBoundingClientRect(), hidden = [];
      for (const [x, y] of [[at.left + 2, at.top + 2], [at.right - 2, at.top + 2], [at.left + 2, at.bottom - 2], [at.right - 2, at.bottom - 2]]) {
        if (!tip.contains(document.elementFromPoint(x, y))) hidden.push(x + ', ' + y + ' of ' + tip.textContent);
      }
      tip.parentElement.style.pointerEvents = 'none';
      return hidden;
      """;

  @TempDir private static Path folder;
  private static RunningConsole console;
  private static Browser browser;

  @BeforeAll
  static void start() throws IOException {
    Path session = folder.resolve("session");
    SampleSession.copy(SampleSession.small(), session);
    SampleSession.recordMatch(session);
    console = RunningConsole.start(session);
    console.settled();
    browser = new Browser();
  }

  @AfterAll
  static void stop() {
    if (browser != null) {
      browser.close();
    }
    if (console != null) {
      console.close();
    }
  }

  private static void assertWhole(String what) {
    browser.awaitGone("[data-waiting]");
    assertThat((List<?>) browser.script(CUT_OFF)).as(what).isEmpty();
    assertThat((List<?>) browser.script(OVERLAP)).as(what).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"1280,720", "1920,1080", "390,844"})
  void nothingIsCutOff(int width, int height) {
    browser.resize(width, height);
    browser.open(console.url() + "#kicks/1");
    browser.find("#kick[data-shown='1']");
    for (String page : List.of("kicks", "play", "diagnosis", "publish", "match", "recordings")) {
      browser.script("location.hash = arguments[0]", page);
      browser.find("#page-" + page + ":not([hidden])");
      assertWhole(page);
    }
    browser.script("location.hash = 'publish'");
    browser.type("#send-address", "127.0.0.1");
    browser.type("#send-port", "10006");
    browser.click("#send-button");
    browser.awaitText("#dialog", "acc_slide");
    assertWhole("the question before sending");
    assertThat(
            browser.script(
                "const box = document.getElementById('dialog'); return box.scrollWidth <="
                    + " box.clientWidth"))
        .isEqualTo(true);
    browser.open(console.url() + "files/report.html");
    browser.find("#kick-charts canvas");
    assertWhole("report");
    // No number of the model is cut off at the side of its card.
    assertThat(
            browser.script(
                "const model = document.getElementById('model'), right ="
                    + " model.getBoundingClientRect().right; return"
                    + " [...model.querySelectorAll('td')].filter(cell =>"
                    + " cell.getBoundingClientRect().right > right || cell.scrollWidth >"
                    + " cell.clientWidth + 1).map(cell => cell.textContent)"))
        .isEqualTo(List.of());
    browser.assertNoComplaints();
  }

  @Test
  void whatWasSentIsWholeOnAPhone() throws IOException {
    browser.resize(390, 844);
    browser.open(console.url() + "#publish");
    try (DatagramSocket team = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      browser.type("#send-address", "127.0.0.1");
      browser.type("#send-port", Integer.toString(team.getLocalPort()));
      browser.click("#send-button");
      browser.click("#confirm");
      browser.awaitText("#published", "this model");
      assertWhole("what was sent");
      browser.click("#send-end");
      browser.awaitGone("#send-end");
    }
    browser.assertNoComplaints();
  }

  @Test
  void aMatchIsWholeOnAPhone() {
    browser.resize(390, 844);
    browser.open(console.url() + "#match");
    browser.choose("#watch-source", "recording");
    browser.click("#watch-start");
    browser.awaitText("#watch-line", "ended");
    browser.find("#last-kicks tbody tr");
    browser.find("#teams tbody tr");
    assertWhole("match");
    browser.assertNoComplaints();
  }

  @Test
  void theReportsOfOtherCommandsAreWhole() throws IOException {
    Path match = folder.resolve("match");
    SampleSession.run(
        "limits", folder.resolve("session/matches/match.log.gz").toString(), "--out=" + match);
    Path kicks = folder.resolve("kicks");
    SampleSession.run("diagnose", SampleSession.small().toString(), "--out=" + kicks);
    for (int width : new int[] {390, 1280, 1920}) {
      browser.resize(width, 844);
      for (Path page : List.of(match.resolve("limits.html"), kicks.resolve("diagnosis.html"))) {
        browser.open(page.toUri().toString());
        browser.find("canvas");
        assertWhole(page.getFileName() + " at " + width + " px");
      }
      // The last one is the diagnosis: all columns of its tables are seen.
      assertThat(
              browser.script(
                  "return [...document.querySelectorAll('.scroll')].filter(box => box.scrollWidth >"
                      + " box.clientWidth + 1).map(box => box.parentElement.parentElement.id)"))
          .isEqualTo(List.of());
    }
    browser.assertNoComplaints();
  }

  /** A tooltip is higher than the plot of a parameter; all of it must be seen. */
  @Test
  void whatTheMouseShowsIsWhole() {
    browser.resize(1280, 720);
    browser.open(console.url() + "#kicks/1");
    browser.find("#kick[data-shown='1']");
    browser.awaitGone("[data-waiting]");
    List<?> points = (List<?>) browser.script(POINTS);
    assertThat(points).hasSizeGreaterThan(SampleSession.KICKS);
    for (Object point : points) {
      List<?> place = (List<?>) point;
      browser.command(
          "Input.dispatchMouseEvent",
          Map.of("type", "mouseMoved", "x", place.get(0), "y", place.get(1)));
      browser.await("a tip at " + place, d -> browser.script(HIDDEN_CORNERS) == null ? null : true);
      assertThat((List<?>) browser.script(HIDDEN_CORNERS)).as("at %s", place).isEmpty();
    }
  }
}
