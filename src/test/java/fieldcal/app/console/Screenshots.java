package fieldcal.app.console;

import fieldcal.app.net.LoopbackSender;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.FlatModel;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionPacket;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** Takes the pictures of the console in {@code docs/} again, from simulated sessions: {@code ./gradlew screenshots}. */
public final class Screenshots {
  private static final int PORT = 10006;

  private final String theme;
  private final Path docs;
  private final Path folder;

  private Screenshots(String theme, Path docs, Path folder) {
    this.theme = theme;
    this.docs = docs;
    this.folder = folder;
  }

  /**
   * Makes them.
   *
   * @param args the directory for the pictures; then, if wanted, width and height of the window in pixels, and light or dark
   * @throws IOException when one cannot be written
   * @throws InterruptedException when it is told to end
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    Path docs = Files.createDirectories(Path.of(args[0]));
    int width = args.length > 1 ? Integer.parseInt(args[1]) : 1280;
    int height = args.length > 2 ? Integer.parseInt(args[2]) : 720;
    Path folder = Files.createTempDirectory("");
    Screenshots pictures = new Screenshots(args.length > 3 ? args[3] : "light", docs, folder);
    try {
      try (Browser browser = new Browser(width, height)) {
        pictures.walk(browser, Files.createDirectory(folder.resolve("session")));
        pictures.waiting(browser, Files.createDirectory(folder.resolve("saturday")));
        pictures.pages(browser, Files.createDirectory(folder.resolve("friday")));
      }
    } finally {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  /** The way from an empty folder to a model that is sent. */
  private void walk(Browser browser, Path session) throws IOException, InterruptedException {
    try (ServedKicks field = new ServedKicks();
        RunningConsole console = RunningConsole.start(session)) {
      OperatorWalk walk =
          new OperatorWalk(browser, field, session)
              .withCamera(step -> picture(browser, "walk-" + step));
      walk.walk(console.url() + "?theme=" + theme);
      walk.times().forEach(System.out::println);
    }
  }

  /** A play that waits for a robot that was taken off. */
  private void waiting(Browser browser, Path session) throws IOException {
    try (ServedKicks field = new ServedKicks();
        RunningConsole console = RunningConsole.start(session)) {
      browser.open(console.url() + "?theme=" + theme + "#play");
      browser.find("#play-field canvas");
      browser.choose("#order-field", "simulator");
      browser.type("#order-port", Integer.toString(field.port()));
      browser.type("#order-vision", field.vision());
      browser.click("#play-start");
      browser.await("it kicks", d -> browser.count("#play-kicks tbody tr") > 0 ? true : null);
      field.setPresent(1, false);
      browser.awaitText("#play-waiting", "yellow 1 is not seen");
      picture(browser, "console-play-waiting");
      browser.click("#play-abort");
      browser.click("#confirm");
      browser.awaitGone("#play-abort");
    }
  }

  /** Each page, from a session with kicks of both kinds. */
  private void pages(Browser browser, Path session) throws IOException {
    SampleSession.recordForPictures(session);
    try (RunningConsole console = RunningConsole.start(session)) {
      console.settled();
      Path log = session.resolve("practice.log.gz");
      FieldGeometry geometry =
          new KickCollector((l, read, total) -> {}).collect(List.of(log)).geometry().orElseThrow();
      take(browser, console, geometry);
    }
  }

  /** A picture on which the session is not called after the temporary directory that it lies in. */
  private void picture(Browser browser, String name) throws IOException {
    browser.script(
        """
        const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (texts.nextNode()) texts.currentNode.data = texts.currentNode.data.replaceAll(arguments[0], '');
        """,
        folder + "/");
    Path file = docs.resolve(name + ".png");
    browser.screenshot(file);
    makeSmall(file);
  }

  /** Rounds the colours to five bits each, which nobody sees, and packs them well: half the bytes that the browser writes. */
  private static void makeSmall(Path file) throws IOException {
    BufferedImage picture = ImageIO.read(file.toFile());
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        int colour = picture.getRGB(x, y);
        // The low bits repeat the high ones, so that white stays white.
        picture.setRGB(x, y, 0xff000000 | colour & 0xf8f8f8 | (colour & 0xe0e0e0) >> 5);
      }
    }
    Files.delete(file);
    ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    ImageWriteParam packing = writer.getDefaultWriteParam();
    packing.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    packing.setCompressionQuality(0);
    try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(picture, null, null), packing);
    } finally {
      writer.dispose();
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

  private void take(Browser browser, RunningConsole console, FieldGeometry geometry)
      throws IOException {
    browser.open(console.url() + "?theme=" + theme + "#kicks/3");
    browser.find("#kick[data-shown]");
    browser.type("#reason", "touched by a foot");
    browser.press("d");
    browser.awaitText("#kicks", "touched by a foot");
    console.settled();
    browser.awaitGone("#refining");
    picture(browser, "console-kicks");
    browser.script("document.querySelector('.desk').scrollTop = 420");
    browser.press("t");
    picture(browser, "console-kick-dark");
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
    picture(browser, "console-diagnosis");
    browser.press("4");
    browser.find("#verdict p");
    hear(browser, geometry);
    browser.script("document.getElementById('page-publish').scrollTop = 0");
    picture(browser, "console-publish");
    browser.press("5");
    browser.choose("#watch-source", "recording");
    browser.click("#watch-start");
    browser.awaitText("#watch-line", "ended");
    picture(browser, "console-match");
    browser.press("2");
    browser.find("#play-field canvas");
    browser.click("#play-start");
    browser.await(
        "some kicks are made", d -> browser.count("#play-kicks tbody tr") > 4 ? true : null);
    picture(browser, "console-play");
    browser.click("#play-abort");
    browser.click("#confirm");
    browser.awaitGone("#play-abort");
  }
}
