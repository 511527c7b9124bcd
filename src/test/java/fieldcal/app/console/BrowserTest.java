package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.cli.EditedLog;
import fieldcal.app.recording.LogOpener;
import fieldcal.camera.CameraCalibration;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;

/** A person's whole session in a browser. */
class BrowserTest {
  /** Answers when the page has drawn twice. */
  private static final String DRAWN =
      "const done = arguments[arguments.length - 1];"
          + " requestAnimationFrame(() => requestAnimationFrame(() => done(true)))";

  /** Notes of a session whose diagnosis wants more kicks. */
  private static final String UNDECIDED =
      """
      {"schema": "fieldcal.console/1", "acceptance": "OPEN", "published": [], "diagnosis": {
        "verdict": "explained", "headline": "Air drag, or lift.", "lines": [], "dropped": [],
        "logs": ["practice.log.gz"], "causes": [{"effect": "air_drag", "name": "Air drag",
          "what": "Fast balls lose speed.", "advice": "Take it out.", "strength": "cd 0.5",
          "rivals": ["magnus"], "next": "Chips tell them apart."}]}}
      """;

  @TempDir private static Path folder;
  private static Path log;
  private static Browser browser;

  @BeforeAll
  static void start() {
    log = SampleSession.full();
    browser = new Browser();
  }

  @AfterAll
  static void stop() {
    if (browser != null) {
      browser.close();
    }
  }

  @Test
  void aWholeSession() throws IOException {
    Path session = folder.resolve("session");
    SampleSession.copy(log, session);
    int port;
    try (RunningConsole console = RunningConsole.start(session)) {
      port = console.port();
      browser.open(console.url());
      look();
      mark();
      drop();
      twoSigma();
      beside(console.url());
      diagnose();
      publish();
      browser.assertNoComplaints();
    }
    browser.awaitText("#link", "connection lost");
    ConsoleSettings again = ConsoleSettings.local(session, port);
    try (RunningConsole console = RunningConsole.start(again)) {
      browser.awaitText("#link", "● connected");
      console.settled();
      stillThere();
    }
    assertThat(Files.readString(session.resolve("report.html"))).contains("by hand: a foot");
  }

  private static void look() {
    browser.await(
        "all kicks are listed",
        d -> browser.count("#kicks tr[data-kick]") == SampleSession.KICKS ? true : null);
    browser.click("#kicks tr[data-kick='5']");
    browser.find("#kick[data-shown='5']");
    assertThat(browser.text("#kick-title")).startsWith("Kick 5 — flat, ");
    // Path, speed, residuals along and across; the three parameters.
    assertThat(browser.count("#kick-charts canvas")).isEqualTo(4);
    assertThat(browser.count("#parameters canvas")).isEqualTo(3);
    browser.press("j");
    browser.find("#kick[data-shown='6']");
    browser.press("k");
    browser.find("#kick[data-shown='5']");
    browser.press("t");
    assertThat(browser.find("html").getAttribute("data-theme")).isEqualTo("dark");
    browser.press("t");
    assertThat(browser.find("html").getAttribute("data-theme")).isEqualTo("light");
  }

  private static void mark() {
    browser.drag("#parameters figure[data-parameter='kSwitch'] .chart", 0.3, 0.12, 0.95, 0.7);
    browser.awaitText("#marked", "marked");
    assertThat(browser.count("#kicks input:checked")).isPositive();
    browser.press("\uE00C"); // Escape
    browser.awaitGone("#drop-marked");
    assertThat(browser.count("#kicks input:checked")).isZero();
  }

  private static void drop() {
    String before = browser.text("#parameters figure[data-parameter='accRoll'] .mean");
    browser.click("#no-two-sigma");
    browser.awaitText("#rule-words", "not applied");
    String all = browser.text("#parameters figure[data-parameter='accRoll'] .mean");
    assertThat(all).isNotEqualTo(before);
    browser.click("#kicks tr[data-kick='5']");
    browser.press("f");
    browser.pressHere("a foot");
    browser.pressHere(Keys.ENTER);
    browser.awaitText("#kicks", "by hand: a foot");
    assertThat(browser.text("#parameters figure[data-parameter='accRoll'] .mean"))
        .isNotEqualTo(all);
    browser.awaitText("#undo", "dropping kick 5");
    // By click, and back.
    browser.click("#kicks tr[data-kick='7'] button.use");
    browser.awaitText("#undo", "dropping kick 7");
    browser.click("#kicks tr[data-kick='7'] button.use");
    browser.awaitText("#undo", "restoring kick 7");
    assertThat(browser.text("#kicks")).contains("by hand: a foot").doesNotContain("no reason");
  }

  private static void twoSigma() {
    browser.click("#two-sigma");
    browser.awaitText("#rule-words", "1 round,");
    browser.press("s");
    browser.awaitText("#rule-words", "2 rounds,");
    browser.click("#undo");
    browser.awaitText("#rule-words", "1 round,");
    browser.press("U");
    browser.awaitText("#rule-words", "2 rounds,");
    browser.press("u");
    browser.awaitText("#rule-words", "1 round,");
  }

  private static void beside(String url) {
    String first = browser.openBeside(url);
    browser.awaitText("#rule-words", "1 round,");
    browser.click("#kicks tr[data-kick='9'] button.use");
    browser.awaitText("#undo", "dropping kick 9");
    String second = browser.window();
    browser.switchTo(first);
    browser.awaitText("#undo", "dropping kick 9");
    browser.click("#undo");
    browser.switchTo(second);
    browser.awaitText("#redo", "dropping kick 9");
    browser.switchTo(first);
  }

  private static void diagnose() {
    browser.press("3");
    // A diagnosis of few kicks may be over before anybody looks.
    browser.script(
        "window.cancelSeen = false; new MutationObserver(() => { window.cancelSeen ||="
            + " Boolean(document.getElementById('diagnose-cancel')); })"
            + ".observe(document.getElementById('diagnose-actions'), {childList: true, subtree:"
            + " true})");
    browser.click("#diagnose-run");
    browser.awaitText("#headline", "air drag");
    assertThat(browser.script("return window.cancelSeen")).isEqualTo(true);
    browser.click("#accept");
    browser.awaitText("#diagnose-state", "✔ accepted");
    browser.press("1");
    browser.awaitText("#advice", "air drag");
    browser.press("3");
    browser.click("#refuse-model");
    browser.awaitText("#diagnose-state", "The model on the other pages is the calibrated one");
    assertThat(browser.find("#diagnosis-report").isDisplayed()).isTrue();
  }

  private static void publish() throws IOException {
    browser.press("4");
    browser.await(
        "the joint fit is up to date", d -> browser.find("#send-button").isEnabled() ? true : null);
    try (DatagramSocket vision = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      vision.setSoTimeout(20_000);
      browser.type("#send-address", "127.0.0.1");
      browser.type("#send-port", Integer.toString(vision.getLocalPort()));
      browser.click("#send-button");
      browser.awaitText("#dialog", "acc_slide");
      browser.click("#refuse");
      browser.click("#send-button");
      browser.click("#confirm");
      DatagramPacket packet = new DatagramPacket(new byte[65536], 65536);
      vision.receive(packet);
      assertThat(packet.getLength()).isGreaterThan(50);
      browser.awaitText("#published", "this model");
      assertThat(browser.count("#published tbody tr")).isEqualTo(1);
      listen(vision, Arrays.copyOf(packet.getData(), packet.getLength()));
    }
    assertThat(browser.text("#snippet")).contains("acc_slide");
    browser.click("#write-results");
    browser.awaitText("#files", "written at");
    browser.awaitGone("#notices .notice.bad");
  }

  /** First to nobody, then to a vision that took over the model that was sent. */
  private static void listen(DatagramSocket sender, byte[] published) throws IOException {
    int port;
    try (DatagramSocket free = new DatagramSocket(0, sender.getLocalAddress())) {
      port = free.getLocalPort();
    }
    browser.find("#vision-unknown");
    browser.type("#vision-place", "127.0.0.1:" + port);
    browser.type("#vision-seconds", "1");
    browser.click("#vision-listen");
    browser.awaitText("#vision-lacks", "Vision is silent");
    browser.type("#vision-seconds", "60");
    browser.click("#vision-listen");
    DatagramPacket packet =
        new DatagramPacket(published, published.length, sender.getLocalAddress(), port);
    browser.await(
        "the model comes back from vision",
        d -> {
          try {
            sender.send(packet);
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
          return browser.count("#vision tr[data-parameter='accRoll']") == 1 ? true : null;
        });
    assertThat(browser.text("#vision tr[data-parameter='accRoll']")).contains("= the same");
    assertThat(browser.text("#vision"))
        .contains("s ago at 127.0.0.1:" + port)
        .contains("Field and cameras are those of the recordings")
        .doesNotContain("⚠");
  }

  private static void stillThere() {
    browser.awaitText("#published", "127.0.0.1");
    browser.press("3");
    browser.awaitText("#headline", "air drag");
    browser.press("1");
    browser.awaitText("#kicks", "by hand: a foot");
    browser.awaitText("#rule-words", "1 round,");
  }

  @Test
  void aPlayFromTheFirstPlanToItsKicks() throws IOException {
    Path session = Files.createDirectory(folder.resolve("play"));
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#play");
      browser.find("#play-field canvas");
      browser.type("#order-slowest", "9");
      browser.find("#plan-failure");
      browser.type("#order-slowest", "3");
      browser.awaitGone("#plan-failure");
      browser.type("#order-kicks", "3");
      browser.click("#play-start");
      browser.find("#play-pause");
      browser.press("p");
      browser.awaitText("#play-phase", "paused");
      browser.click("#play-resume");
      browser.await("a kick is made", d -> browser.count("#play-kicks tbody tr") > 0 ? true : null);
      browser.click("#play-abort");
      browser.click("#refuse");
      browser.awaitText("#play-line", "3 of 3 kicks");
      browser.awaitText("#play-state", "part of the session");
      browser.press("1");
      browser.await(
          "the kicks are calibrated",
          d -> browser.count("#kicks tr[data-kick]") >= 3 ? true : null);
      browser.assertNoComplaints();
      assertThat(session.resolve("session-flat.log")).exists();
      assertThat(session.resolve("session-flat.commands.csv")).exists();
      browser.press("2");
      browser.click("#play-start");
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
      browser.awaitText("#play-state", "the operator ended it");
    }
  }

  @Test
  void whatThePlayWaitsForIsDrawnOnTheField() throws IOException {
    Path session = Files.createDirectory(folder.resolve("waiting"));
    try (ServedKicks field = new ServedKicks();
        RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#play");
      browser.find("#play-field canvas");
      browser.choose("#order-field", "simulator");
      browser.type("#order-port", Integer.toString(field.port()));
      browser.type("#order-vision", field.vision());
      browser.click("#play-start");
      browser.awaitText("#play-line", "0 of 12");
      field.setPresent(1, false);
      browser.awaitText("#play-waiting", "yellow 1 is not seen");
      assertThat(waitedFor()).isEqualTo(List.of("yellow 1 is not seen"));
      field.setPresent(1, true);
      browser.awaitGone("#play-waiting");
      assertThat(waitedFor()).isEmpty();
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
      browser.awaitText("#play-waiting", "the operator ended it");
      // What the simulator complains of is shown, too.
      browser.type("#order-second", "blue9");
      browser.click("#play-start");
      browser.awaitText("#play-complaints", "simulator: there is no robot blue 9");
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
    }
  }

  /** The served field takes robot commands and answers them, as a team's bridge does. */
  @Test
  void robotsBehindABridgeArePlayedWith() throws IOException {
    Path session = Files.createDirectory(folder.resolve("robots"));
    try (ServedKicks field = new ServedKicks();
        RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#play");
      browser.find("#play-field canvas");
      browser.choose("#order-field", "robots");
      // Nobody listens there.
      browser.type("#order-bridge", "127.0.0.1:1");
      browser.type("#order-vision", field.vision());
      browser.click("#play-start");
      browser.awaitText("#play-waiting", "does not answer");
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
      browser.type("#order-bridge", "127.0.0.1:" + (field.port() + 2));
      browser.click("#play-start");
      browser.awaitText("#play-phase", "moving into position");
      browser.awaitGone("#play-waiting");
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
    }
  }

  /** The words beside each ring that is drawn. */
  private static List<?> waitedFor() {
    return (List<?>)
        browser.script(
            "const chart = Frame.charts.get(document.querySelector('#play-field .chart')); return"
                + " chart.getOption().series.find(s => s.id === 'waiting').data.map(d => d.label"
                + " && d.label.formatter)");
  }

  @Test
  void aCameraThatIsNotUsedIsNamedOnceOnThePageOfAMatch() throws IOException {
    Path session = Files.createDirectory(folder.resolve("broken-camera"));
    SampleSession.recordMatch(session);
    Path sound =
        Files.move(session.resolve("matches/match.log.gz"), folder.resolve("sound.log.gz"));
    EditedLog.copy(
        sound,
        session.resolve("matches/broken.log"),
        p -> new VisionPacket(p.frame(), p.geometry().map(g -> g.withCameras(broken(g)))));
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#match");
      browser.choose("#watch-source", "recording");
      browser.click("#watch-start");
      browser.awaitText("#watch-line", "ended");
      assertThat(browser.count("#health .camera-fault")).isEqualTo(1);
      assertThat(browser.text("#health .camera-fault"))
          .startsWith("⚠ Camera 2: no usable position: ")
          .endsWith(".");
    }
  }

  /** Camera 2 hangs 200 m above the field. */
  private static List<CameraCalibration> broken(FieldGeometry geometry) {
    return geometry.cameras().stream()
        .map(
            c ->
                c.id() == 2
                    ? c.withPosition(new double[] {0, 0, 200}, new double[] {0, 0, 200})
                    : c)
        .toList();
  }

  @Test
  void aMatchIsWatched() throws IOException {
    Path session = Files.createDirectory(folder.resolve("match"));
    SampleSession.recordMatch(session);
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#match");
      browser.choose("#watch-source", "recording");
      browser.type("#watch-yellow", "9, 9");
      browser.click("#watch-start");
      browser.awaitText("#notices", "The limits of yellow must be");
      browser.type("#watch-yellow", "9, 9, 9");
      browser.click("#watch-start");
      browser.awaitText("#watch-line", "ended");
      browser.awaitText("#watch-state", "less than the configured 9.00");
      assertThat(browser.text("#watch-line")).contains("kicks");
      assertThat(browser.count("#medians canvas")).isGreaterThanOrEqualTo(3);
      assertThat(browser.text("#teams")).contains("yellow").contains("blue");
      assertThat(browser.count("#health tbody tr")).isEqualTo(4);
      assertThat(browser.count("#last-kicks tbody tr")).isPositive();
      assertThat(browser.text("#health tbody tr:nth-child(2)"))
          .containsPattern("⚠ 1: 2[0-4] mm from camera [023]");
      assertThat(browser.count("#health .badge.good")).isZero();
      for (int camera = 1; camera <= 4; camera++) {
        String noise = browser.text("#health tbody tr:nth-child(" + camera + ") td:nth-child(3)");
        assertThat(noise).matches("[1-4]\\.\\d\\d");
      }
      List<?> numbers =
          (List<?>)
              browser.script(
                  "return [...document.querySelectorAll('#last-kicks tbody td:first-child')].map(d"
                      + " => -Number(d.textContent))");
      assertThat(numbers.stream().map(n -> ((Number) n).intValue()).toList()).isSorted();
      // Ticks of the first minute: hours first, and the axis is that of the kicks.
      List<?> axis =
          (List<?>)
              browser.script(
                  "const option = Frame.charts.get(document.querySelector('#medians"
                      + " .chart')).getOption(); const x = option.xAxis[0], first ="
                      + " option.series[1].data[0][0]; return [x.axisLabel.formatter(first), new"
                      + " Date(1000 * first).toISOString().slice(11, 19), x.min === first, x.max -"
                      + " x.min]");
      assertThat(axis.get(0)).isEqualTo(axis.get(1));
      assertThat(axis.get(2)).isEqualTo(true);
      assertThat(((Number) axis.get(3)).doubleValue()).isBetween(60.0, 90.0);
      browser.assertNoComplaints();
    }
  }

  /** Nobody has to take the mouse: what is pressed keeps the focus, or hands it on to what can be pressed next. */
  @Test
  void theKeyboardIsEnough() throws IOException {
    Path session = folder.resolve("keys");
    SampleSession.copy(SampleSession.small(), session);
    Files.writeString(session.resolve("console.json"), UNDECIDED);
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#kicks/1");
      browser.find("#kick[data-shown='1']");
      browser.tabTo("tr[data-kick='1']");
      browser.pressHere(Keys.SHIFT, Keys.ARROW_DOWN);
      browser.awaitText("#marked", "2 kicks marked");
      browser.pressHere("d");
      browser.awaitGone("#drop-marked");
      browser.awaitFocus("tr[data-kick='2']");
      browser.tabToAndEnter("#undo");
      browser.awaitText("#redo", "dropping");
      browser.pressHere("3");
      browser.tabToAndEnter("#to-play");
      browser.tabToAndEnter("#next-kicks button + button");
      browser.tabTo("#order-kind");
      assertThat(browser.script("return document.activeElement.value")).isEqualTo("chip");
      browser.tabTo("#order-field");
      browser.pressHere(Keys.ARROW_DOWN);
      browser.find("#order-host");
      browser.awaitFocus("#order-field");
      browser.pressHere(Keys.ARROW_UP);
      browser.tabToAndEnter("#play-start");
      browser.awaitFocus("#play-pause");
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#play-resume");
      browser.tabToAndEnter("#play-abort");
      browser.awaitFocus("#refuse");
      browser.pressHere(Keys.SHIFT, Keys.TAB);
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#play-start");
      browser.pressHere("5");
      browser.tabTo("#watch-source");
      browser.pressHere(Keys.ARROW_DOWN);
      browser.awaitFocus("#watch-source");
      browser.tabToAndEnter("#watch-start");
      browser.awaitText("#watch-line", "ended");
      browser.awaitFocus("#watch-start");
      browser.assertNoComplaints();
    }
  }

  /** What a question was asked from may be drawn again while it is answered; the keyboard goes on there all the same. */
  @Test
  void aQuestionGivesTheFocusBack() throws IOException {
    Path session = folder.resolve("question");
    SampleSession.copy(SampleSession.small(), session);
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#play");
      browser.find("#play-start");
      browser.tabToAndEnter("#play-start");
      browser.awaitFocus("#play-pause");
      browser.tabToAndEnter("#play-abort");
      browser.awaitFocus("#refuse");
      // Somebody in another window pauses the play.
      browser.script(
          "import('/assets/server.js').then(server => server.act('play/word', {word: 'pause'}))");
      browser.find("#play-resume");
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#play-abort");
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#refuse");
      browser.pressHere(Keys.ESCAPE);
      browser.awaitFocus("#play-abort");
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#refuse");
      browser.pressHere(Keys.SHIFT, Keys.TAB);
      browser.pressHere(Keys.ENTER);
      browser.awaitFocus("#play-start");
      browser.assertNoComplaints();
    }
  }

  /** A window may be made larger while another page is shown. */
  @Test
  void thePlaysFieldFitsAfterTheWindowHasChanged() throws IOException {
    Path session = folder.resolve("window");
    SampleSession.copy(SampleSession.small(), session);
    try (RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "#play");
      browser.find("#play-field canvas");
      browser.pressHere("6");
      browser.find("#recordings-list table");
      browser.resize(1600, 900);
      browser.scriptThatAnswers(DRAWN, "");
      browser.pressHere("2");
      browser.find("#play-start");
      browser.scriptThatAnswers(DRAWN, "");
      assertThat(
              browser.script(
                  "const box = document.querySelector('#play-field .chart');"
                      + " return box.querySelector('canvas').clientWidth === box.clientWidth"))
          .isEqualTo(true);
    } finally {
      browser.resize(1280, 720);
    }
  }

  @Test
  void theTokenIsAskedFor() throws IOException {
    Path session = Files.createDirectory(folder.resolve("guarded"));
    String token = "a-token-of-the-field";
    ConsoleSettings settings =
        new ConsoleSettings(
            session,
            "127.0.0.1",
            0,
            Optional.of(token),
            Optional.empty(),
            20260101,
            LogOpener.USUAL);
    try (RunningConsole console = RunningConsole.start(settings)) {
      browser.open("http://" + console.host() + "/");
      browser.type("#token", "not-this-one");
      browser.click("button[type='submit']");
      browser.awaitText("#answer", "token is wrong");
      browser.type("#token", token);
      browser.click("button[type='submit']");
      browser.awaitText("#empty-title", "No recording yet");
    }
  }
}
