package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.console.SessionNotes.Publication;
import fieldcal.vision.BallModels;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.UnknownHostException;
import java.time.Clock;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Gives the model away: as files of the session, and as packets to an address, over and over as vision does it. Thread-safe. */
final class PublishDesk {
  /** Hops that a packet to many may make: a venue's network has routers between vision and the teams' computers at times. */
  private static final int HOPS = 4;

  private static final int LONGEST_ADDRESS = 200;

  /** Vision publishes its geometry every few seconds; who begins to listen later has the model within one, ms. */
  private static final long EVERY_MS = 1000;

  private static final long PATIENCE_MS = 2000;

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final NotesDesk notes;
  private final VisionDesk vision;
  private final Clock clock;
  private final Runnable changed;
  private final LiveSession live;
  private volatile Sending sending;
  private long written = -1;

  PublishDesk(
      SessionDirectory directory,
      KickDesk kicks,
      NotesDesk notes,
      VisionDesk vision,
      Clock clock,
      Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.notes = notes;
    this.vision = vision;
    this.clock = clock;
    this.changed = changed;
    live = new LiveSession("sending of the model", changed);
  }

  /** What sort of packet is sent. */
  enum Format {
    /** {@code SSL_WrapperPacket}, as vision sends it: its geometry, or else that of the recordings, with the new models in it. */
    WRAPPER,
    /** {@code SSL_GeometryModels} alone. */
    MODELS
  }

  /**
   * Writes the files of {@code calibrate} into the session, unless they are those of the present decisions already.
   *
   * @throws IOException when one cannot be written; the old ones are as they were
   */
  synchronized void write() throws IOException {
    KickDesk.View view = requireSettled();
    if (written != view.version()) {
      CalibrationSession.writeAll(kicks.calibrated(), directory.path());
      written = view.version();
    }
  }

  private KickDesk.View requireSettled() {
    kicks.calibrated();
    KickDesk.View view = kicks.view();
    if (!view.settled()) {
      throw ApiException.conflict(
          "The joint fit is being refined after the last decision; try again in a moment.");
    }
    return view;
  }

  /**
   * Sends the model, and goes on with that one until it is stopped or another one is sent.
   *
   * @throws ApiException when the address is none, the model is not the one that the operator confirmed, or nothing can be sent there
   */
  synchronized Publication send(JsonNode body) {
    Format format = Requests.oneOf(body, "format", Format.values());
    String host = Requests.text(body, "address", LONGEST_ADDRESS).strip();
    long port = Requests.number(body, "port").orElse(-1);
    if (host.isEmpty() || port < 1 || port > 65535) {
      throw ApiException.badRequest("an address and a port from 1 to 65535 are needed");
    }
    requireSettled();
    CalibrationOutcome outcome = kicks.calibrated();
    BallModels models = outcome.models();
    if (models.equals(BallModels.NONE)) {
      throw ApiException.conflict("there is no complete model to publish: record more kicks");
    }
    if (!models.toText().equals(Requests.text(body, "confirmed", 10_000))) {
      throw ApiException.conflict(
          "The model changed since you looked at it. Look at the numbers again, then confirm.");
    }
    byte[] packet = bytes(format, outcome);
    // What cannot be sent at all is told to who asked for it.
    send(packet, host, (int) port);
    Publication publication =
        new Publication(
            clock.millis() / 1000.0, host + ":" + port, Requests.name(format), models.toText());
    notes.change(n -> n.with(publication));
    stop();
    live.join(PATIENCE_MS);
    Sending next = new Sending(packet, host, (int) port, publication);
    sending = next;
    live.start(next::run);
    return publication;
  }

  /** Ends the sending. */
  void stop() {
    Sending now = sending;
    if (now != null) {
      now.end();
    }
  }

  void close() {
    stop();
    live.join(PATIENCE_MS);
  }

  /** What is being sent. */
  ObjectNode state() {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("running", live.running());
    node.put("failure", live.failure().orElse(null));
    Sending now = sending;
    if (now != null) {
      node.put("to", now.publication.to()).put("text", now.publication.text());
      node.put("everySeconds", EVERY_MS / 1000.0);
    }
    return node;
  }

  /** One model on its way to one address. */
  private static final class Sending {
    private final byte[] packet;
    private final String host;
    private final int port;
    private final Publication publication;
    private final CountDownLatch ended = new CountDownLatch(1);

    Sending(byte[] packet, String host, int port, Publication publication) {
      this.packet = packet;
      this.host = host;
      this.port = port;
      this.publication = publication;
    }

    void run() {
      try {
        while (!ended.await(EVERY_MS, TimeUnit.MILLISECONDS)) {
          PublishDesk.send(packet, host, port);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    void end() {
      ended.countDown();
    }
  }

  private byte[] bytes(Format format, CalibrationOutcome outcome) {
    BallModels models = outcome.models();
    if (format == Format.MODELS) {
      return models.toBytes();
    }
    // Everybody takes over the whole packet: an old field must not come with the new models.
    FieldGeometry geometry =
        vision
            .heard()
            .flatMap(VisionDesk.Heard::geometry)
            .or(() -> outcome.data().geometry())
            .orElseThrow(
                () ->
                    ApiException.conflict(
                        "the recordings have no geometry, which such a packet must carry; listen to"
                            + " vision, or send the models alone"));
    FieldGeometry field = geometry.withModels(models.flat(), models.chip());
    return new VisionEncoder(outcome.data().epoch()).encode(VisionPacket.of(field));
  }

  private static void send(byte[] bytes, String host, int port) {
    try (MulticastSocket socket = new MulticastSocket()) {
      InetAddress address = InetAddress.getByName(host);
      socket.setTimeToLive(HOPS);
      socket.send(new DatagramPacket(bytes, bytes.length, new InetSocketAddress(address, port)));
    } catch (UnknownHostException e) {
      throw ApiException.badRequest("there is no address " + host);
    } catch (IOException e) {
      throw new ApiException(502, "cannot send to " + host + ":" + port + ": " + e.getMessage());
    }
  }
}
