package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.gamelog.GameLogReader;
import fieldcal.proto.SSL_WrapperPacket;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * The way of an operator from an empty folder to a model that is sent, in a browser beside a network with vision: record, look, read the verdict, send. The steps take their times, and pictures where somebody wants
 * them.
 */
final class OperatorWalk {
  /** Commanded speeds of the flat kicks, m/s; each is left alone until it has rolled for a while. */
  private static final double[] FLAT = {2.2, 4.5, 3.1, 5.4, 2.7, 4.0, 3.5};

  private static final double FLAT_SECONDS = 1.5;

  /** A busy machine may lose the frames of a kick or two; a model needs five. */
  private static final int ENOUGH = FLAT.length - 2;

  private final Browser browser;
  private final ServedKicks field;
  private final Path session;
  private final List<String> times = new ArrayList<>();
  private Camera camera = name -> {};
  private long since = System.nanoTime();

  /** Takes a picture of a step. */
  interface Camera {
    void take(String step) throws IOException;
  }

  OperatorWalk(Browser browser, ServedKicks field, Path session) {
    this.browser = browser;
    this.field = field;
    this.session = session;
  }

  OperatorWalk withCamera(Camera camera) {
    this.camera = camera;
    return this;
  }

  /** How long each step took, in its order. */
  List<String> times() {
    return List.copyOf(times);
  }

  private void done(String step) {
    double seconds = (System.nanoTime() - since) * 1e-9;
    times.add(String.format(Locale.ROOT, "%-34s %5.1f s", step, seconds));
    since = System.nanoTime();
  }

  /** Taking it is no part of the step. */
  private void picture(String name) throws IOException {
    long before = System.nanoTime();
    camera.take(name);
    since += System.nanoTime() - before;
  }

  /** All of it. */
  void walk(String url) throws IOException, InterruptedException {
    since = System.nanoTime();
    browser.open(url);
    browser.awaitText("#empty-title", "No recording yet");
    browser.type("#record-vision", field.vision());
    done("the empty console is open");
    picture("1-empty");
    record();
    look();
    read();
    send();
  }

  private void record() throws IOException, InterruptedException {
    browser.click("#record-start");
    browser.awaitText(".record-line", "cameras");
    for (int i = 0; i < FLAT.length; i++) {
      double side = i % 2 == 0 ? 1 : -1;
      field.kick(-4 * side, 2 - 0.7 * i, side > 0 ? 0 : Math.PI, FLAT[i], 0, FLAT_SECONDS);
      if (i == 2) {
        picture("2-recording");
      }
    }
    browser.click("#record-end");
    done("kicks are recorded");
  }

  private void look() throws IOException {
    browser.press("1");
    browser.await(
        "the kicks are listed", d -> browser.count("#kicks tr[data-kick]") >= ENOUGH ? true : null);
    browser.awaitGone("#refining");
    browser.find("#kick[data-shown]");
    assertThat(browser.count("#parameters canvas")).isEqualTo(3);
    done("kicks are calibrated and shown");
    picture("3-kicks");
  }

  /** The same verdict beside the parameters and above the model, with what to do. */
  private void read() throws IOException {
    browser.awaitText("#advice", "publish");
    browser.press("4");
    browser.awaitText("#verdict .decision", "Publish");
    browser.awaitText("#model", "acc_slide");
    done("the verdict is read");
    picture("4-verdict");
  }

  private void send() throws IOException {
    try (DatagramSocket team = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      team.setSoTimeout(20_000);
      browser.type("#send-address", "127.0.0.1");
      browser.type("#send-port", Integer.toString(team.getLocalPort()));
      browser.click("#send-button");
      browser.awaitText("#dialog", "acc_slide");
      picture("5-question");
      browser.click("#confirm");
      // It goes on as vision does: a program that starts later hears it, too.
      for (int i = 0; i < 2; i++) {
        assertThat(received(team).getGeometry().getModels().hasStraightTwoPhase()).isTrue();
      }
      browser.awaitText("#published", "this model");
      browser.awaitText("#published", "SSL_WrapperPacket with geometry");
      browser.awaitText("#history-table", "SSL_WrapperPacket with geometry");
      browser.awaitText("#sends", "sending to 127.0.0.1:" + team.getLocalPort());
      done("the model is sent");
      picture("6-sent");
      browser.click("#send-end");
      browser.awaitGone("#send-end");
    }
    try (var files = Files.list(session);
        GameLogReader log =
            GameLogReader.open(
                files
                    .filter(file -> file.getFileName().toString().endsWith(".log.gz"))
                    .findFirst()
                    .orElseThrow())) {
      assertThat(log.next()).isTrue();
    }
  }

  private static SSL_WrapperPacket received(DatagramSocket team) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[65536], 65536);
    team.receive(packet);
    return SSL_WrapperPacket.parseFrom(Arrays.copyOf(packet.getData(), packet.getLength()));
  }
}
