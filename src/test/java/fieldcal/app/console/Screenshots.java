package fieldcal.app.console;

import fieldcal.app.net.LoopbackSender;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.FlatModel;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Takes the pictures of the console in {@code docs/} again, from a simulated session: {@code ./gradlew screenshots}. */
public final class Screenshots {
  private static final int PORT = 10006;

  private Screenshots() {}

  /**
   * Makes them.
   *
   * @param args the directory for the pictures
   * @throws IOException when one cannot be written
   */
  public static void main(String[] args) throws IOException {
    Path docs = Files.createDirectories(Path.of(args[0]));
    Path folder = Files.createTempDirectory("");
    Path session = Files.createDirectory(folder.resolve("session"));
    try {
      SampleSession.recordForPictures(session);
      try (RunningConsole console = RunningConsole.start(session);
          Browser browser = new Browser()) {
        console.settled();
        Path log = session.resolve("practice.log.gz");
        FieldGeometry geometry =
            new KickCollector((l, read, total) -> {})
                .collect(List.of(log))
                .geometry()
                .orElseThrow();
        new Screenshots().take(browser, console, geometry, docs);
      }
    } finally {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  /** A vision whose model is not the one of the recordings, heard on the loopback interface. */
  private static void hear(Browser browser, FieldGeometry geometry) throws IOException {
    FlatModel theirs = new FlatModel(-3.2, -0.28, 0.66);
    byte[] published =
        new VisionEncoder(new Epoch(0))
            .encode(VisionPacket.of(geometry.withModels(Optional.of(theirs), geometry.chip())));
    try (LoopbackSender vision = new LoopbackSender(PORT)) {
      browser.type("#vision-place", LoopbackSender.GROUP + ":" + PORT);
      browser.click("#vision-listen");
      browser.await(
          "vision is heard",
          d -> {
            try {
              vision.send(published);
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
            return browser.count("#vision tr[data-parameter='accRoll']") == 1 ? true : null;
          });
    }
  }

  private void take(Browser browser, RunningConsole console, FieldGeometry geometry, Path docs)
      throws IOException {
    browser.open(console.url() + "?theme=light#kicks/3");
    browser.find("#kick[data-shown]");
    browser.type("#reason", "touched by a foot");
    browser.press("d");
    browser.awaitText("#kicks", "touched by a foot");
    console.settled();
    browser.awaitGone("#refining");
    browser.screenshot(docs.resolve("console-kicks.png"));
    browser.script("document.querySelector('.desk').scrollTop = 420");
    browser.press("t");
    browser.screenshot(docs.resolve("console-kick-dark.png"));
    browser.press("t");
    browser.press("3");
    browser.click("#diagnose-run");
    browser.find("#headline");
    console.settled();
    // The report within draws itself after it is loaded.
    browser.await(
        "the report is drawn",
        d ->
            Boolean.TRUE.equals(
                    browser.script(
                        "const report ="
                            + " document.getElementById('diagnosis-report').contentDocument; return"
                            + " report.querySelectorAll('canvas').length > 3"))
                ? true
                : null);
    browser.screenshot(docs.resolve("console-diagnosis.png"));
    browser.press("4");
    browser.find("#verdict p");
    hear(browser, geometry);
    browser.screenshot(docs.resolve("console-publish.png"));
    browser.press("5");
    browser.script(
        "const s = document.getElementById('watch-source'); s.value = 'recording';"
            + " s.dispatchEvent(new Event('change'))");
    browser.click("#watch-start");
    browser.awaitText("#watch-line", "ended");
    browser.screenshot(docs.resolve("console-match.png"));
    browser.press("2");
    browser.find("#play-field canvas");
    browser.click("#play-start");
    browser.await(
        "some kicks are made", d -> browser.count("#play-kicks tbody tr") > 4 ? true : null);
    browser.screenshot(docs.resolve("console-play.png"));
    browser.click("#play-abort");
    browser.click("#confirm");
    browser.awaitGone("#play-abort");
  }
}
