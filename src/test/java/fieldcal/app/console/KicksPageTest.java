package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;
import org.openqa.selenium.support.ui.Select;

/** What helps to look at kicks: lists of some of them, several in one drawing, a kick once more, another session beside this one, and copies. */
class KicksPageTest {
  private static final String SPEEDS =
      "return [...document.querySelectorAll('#kicks tr[data-kick]')].map(row =>"
          + " Number(row.cells[3].textContent))";

  @TempDir private static Path folder;
  private static Path session;
  private static RunningConsole console;
  private static Browser browser;

  @BeforeAll
  static void start() throws IOException {
    session = folder.resolve("session");
    SampleSession.copy(SampleSession.small(), session);
    Files.copy(SampleSession.full(), session.resolve("earlier.log.gz"));
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

  @BeforeEach
  void kicksAreListed() {
    browser.open("about:blank");
    browser.open(console.url() + "#kicks/1");
    browser.find("#kick[data-shown='1']");
  }

  private static int listed() {
    return browser.count("#kicks tr[data-kick]");
  }

  @Test
  void kicksOfOneRobotOneRecordingOrSomeSpeedsAreListedAndDrawn() {
    int all = listed();
    Select robots = new Select(browser.find("#pick-robot"));
    robots.selectByIndex(1);
    String robot = robots.getFirstSelectedOption().getText();
    assertThat(listed()).isBetween(1, all - 1);
    assertThat(
            browser.script(
                "return [...document.querySelectorAll('#kicks tr[data-kick]')].every(row =>"
                    + " row.textContent.includes(arguments[0]))",
                robot))
        .isEqualTo(true);
    int ofTheRobot = listed();
    // Every point stands for a kick that is listed.
    browser.awaitGone("[data-waiting]");
    assertThat(((Number) browser.script(POINTS)).intValue()).isEqualTo(ofTheRobot);
    browser.click("#pick-all");
    assertThat(listed()).isEqualTo(all);

    new Select(browser.find("#pick-recording")).selectByVisibleText("earlier.log.gz");
    int earlier = listed();
    assertThat(earlier).isBetween(1, all - 1);
    new Select(browser.find("#pick-recording")).selectByVisibleText("practice.log.gz");
    assertThat(listed()).isEqualTo(all - earlier);
    browser.click("#pick-all");

    browser.type("#pick-slowest", "3");
    browser.type("#pick-fastest", "5");
    List<?> speeds = (List<?>) browser.script(SPEEDS);
    assertThat(speeds).isNotEmpty().hasSizeLessThan(all);
    assertThat(speeds)
        .allMatch(
            speed ->
                ((Number) speed).doubleValue() >= 2.995 && ((Number) speed).doubleValue() <= 5.005);
    browser.click("#pick-all");
    assertThat(listed()).isEqualTo(all);
    browser.assertNoComplaints();
  }

  /** How many kicks the first plot of a parameter shows. */
  private static final String POINTS =
      "const box = document.querySelector('#parameters .chart');return new"
          + " Set(Frame.charts.get(box).getOption().series.filter(s => s.type === 'scatter' &&"
          + " !s.silent).flatMap(s => s.data).map(item => item.kick)).size";

  @Test
  void markedKicksAreDrawnBesideTheSelectedOne() {
    browser.click("#kicks tr[data-kick='2'] input");
    browser.click("#kicks tr[data-kick='3'] input");
    browser.find("#kick[data-beside='2 3']");
    browser.awaitText("#kick-legend", "marked: 2, 3");
    for (String plot : List.of("path", "speed", "along", "across")) {
      assertThat(
              browser.script(
                  "return Frame.charts.get(document.querySelector('[data-plot=' + arguments[0] +"
                      + " ']')).getOption().series.filter(s => s.name &&"
                      + " s.name.startsWith('beside')).map(s => s.name).join()",
                  plot))
          .as(plot)
          .isEqualTo("beside 2,beside 3");
    }
    browser.press("\uE00C"); // Escape
    browser.find("#kick[data-beside='']");
    assertThat(browser.text("#kick-legend")).doesNotContain("marked");
    browser.assertNoComplaints();
  }

  @Test
  void aKickIsReplayed() {
    browser.script(
        "const s = document.getElementById('replay-time'); s.value = 0.5;"
            + " s.dispatchEvent(new Event('input'))");
    browser.awaitText("#replay-words", "0.50 s");
    String early = ballAt();
    browser.press("p");
    browser.await("the ball moves on", d -> ballAt().equals(early) ? null : true);
    browser.awaitText("#replay", "Replay");
    assertThat(
            browser.script(
                "const s = document.getElementById('replay-time'); return Number(s.max) -"
                    + " Number(s.value) < 0.02"))
        .as("it ends with the kick")
        .isEqualTo(true);
    // The same moment in speed and residuals.
    assertThat(browser.count("#kick-charts .moment")).isEqualTo(3);
    browser.press("j");
    browser.find("#kick[data-shown='2']");
    assertThat(browser.count("#kick-charts .ball, #kick-charts .moment")).isZero();
    browser.assertNoComplaints();
  }

  private static String ballAt() {
    return browser.script("return document.querySelector('.ball').style.cssText").toString();
  }

  @Test
  void anotherSessionStandsBesideThisOne() throws IOException {
    console.post("/api/results", "{}");
    ObjectMapper mapper = new ObjectMapper();
    ObjectNode other = (ObjectNode) mapper.readTree(session.resolve("calibration.json").toFile());
    ObjectNode roll = (ObjectNode) other.at("/flat/acc_roll");
    roll.put("mean", 2 * roll.path("mean").asDouble());
    Path file = folder.resolve("yesterday.json");
    mapper.writeValue(file.toFile(), other);
    browser.press("4");
    browser.find("#sessions-file").sendKeys(file.toString());
    browser.awaitText("#sessions tr[data-parameter='accRoll']", "they differ");
    assertThat(browser.text("#sessions tr[data-parameter='accRoll']")).contains("−50.0 %");
    assertThat(browser.text("#sessions tr[data-parameter='kSwitch']"))
        .contains("they agree: 0.0")
        .contains("switch to rolling (k_switch)");
    Path none = Files.writeString(folder.resolve("none.json"), "{}");
    browser.find("#sessions-file").sendKeys(none.toString());
    browser.awaitText("#sessions", "none.json is not a calibration of fieldcal");
    browser.assertNoComplaints();
  }

  @Test
  void theKeysOfOtherProgramsUndoAndRestore() throws IOException {
    Object kick =
        browser.script(
            "return document.querySelector('#kicks tr[data-kick]:not(.dropped)').dataset.kick");
    browser.click("#kicks tr[data-kick='" + kick + "'] button.use");
    browser.awaitText("#undo", "dropping kick " + kick);
    browser.pressHere(Keys.CONTROL, "z");
    browser.awaitText("#redo", "dropping kick " + kick);
    browser.pressHere(Keys.CONTROL, "y");
    browser.awaitText("#undo", "dropping kick " + kick);
    browser.pressHere(Keys.CONTROL, "z");
    browser.awaitText("#redo", "dropping kick " + kick);
    console.settled();
    browser.assertNoComplaints();
  }

  /** A list of one kind has the plots of that kind; grey paths of other kicks have their name. */
  @Test
  void oneKindHasItsOwnPlotsAndEveryPathItsLegend() throws IOException {
    Path mixed = Files.createDirectory(folder.resolve("mixed"));
    SampleSession.run(
        "simulate", "--scenario=mixed", "--kicks=4", "--seed=3", "--out=" + mixed.resolve("m.log"));
    try (RunningConsole other = RunningConsole.start(mixed)) {
      other.settled();
      browser.open(other.url());
      browser.find("#kick[data-shown]");
      assertThat(browser.text("#kick-legend")).contains("other kicks").contains("fitted");
      browser.click("#kick-filter button:nth-child(3)"); // chips
      browser.find("#parameters figure[data-parameter='dampingZ']");
      assertThat(browser.count("#parameters figure[data-parameter='accSlide']")).isZero();
      browser.click("#kick-filter button:nth-child(2)"); // flat kicks
      browser.find("#parameters figure[data-parameter='accSlide']");
      assertThat(browser.count("#parameters figure[data-parameter='dampingZ']")).isZero();
      browser.assertNoComplaints();
    }
  }

  @Test
  void theListedKicksAreSavedAsATable() {
    browser.type("#pick-slowest", "3");
    int some = listed();
    browser.script("URL.createObjectURL = blob => { window.saved = blob; return '#kicks/1'; }");
    browser.click("#kicks-csv");
    String table = browser.scriptThatAnswers("window.saved.text().then(arguments[0])").toString();
    List<String> lines = table.lines().toList();
    assertThat(lines).hasSize(1 + some);
    assertThat(lines.get(0))
        .startsWith("id,kind,source,t_unix,team,robot,speed_mps,end,observations,rms_mm,used")
        .contains("acc_slide,");
    int columns = lines.get(0).split(",", -1).length;
    assertThat(lines).allMatch(line -> line.split(",", -1).length == columns);
  }

  @Test
  void verdictAndModelAreCopied() {
    browser.command(
        "Browser.grantPermissions",
        Map.of("permissions", List.of("clipboardReadWrite", "clipboardSanitizedWrite")));
    browser.press("4");
    browser.click("#verdict .copy");
    browser.awaitText("#verdict .copy", "copied");
    assertThat(clipboard()).startsWith("Verdict: ").contains(browser.text("#verdict .reason"));
    browser.click("#model .copy");
    browser.awaitText("#model .copy", "copied");
    assertThat(clipboard().lines().toList().get(0))
        .startsWith("parameter\tunit\tmean\tstandard_error\tn");
    assertThat(clipboard().lines().toList())
        .anyMatch(line -> line.startsWith("acc_roll\tm/s²\t-0."));
    browser.assertNoComplaints();
  }

  private static String clipboard() {
    return browser
        .scriptThatAnswers(
            "navigator.clipboard.readText().then(arguments[0], e => arguments[0]('' + e))")
        .toString();
  }
}
