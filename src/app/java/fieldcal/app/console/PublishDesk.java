package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.console.SessionNotes.Publication;
import fieldcal.app.export.ExportModel;
import fieldcal.app.history.History;
import fieldcal.app.history.HistoryEntry;
import fieldcal.app.history.HistoryEntry.Action;
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
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Gives the model away: as files of the session, and as packets to an address, over and over as vision does it. Thread-safe. */
final class PublishDesk {
  /** Hops that a packet to many may make: a venue's network has routers between vision and the teams' computers at times. */
  private static final int HOPS = 4;

  private static final int LONGEST_ADDRESS = 200;

  /** Vision publishes its geometry every few seconds; who begins to listen later has the model within one, ms. */
  private static final long EVERY_MS = 1000;

  private static final long PATIENCE_MS = 2000;

  /** Before the kind of packet, the target of an entry of the history. */
  private static final String PACKET = "packet:";

  private static final Logger LOG = LoggerFactory.getLogger(PublishDesk.class);

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final NotesDesk notes;
  private final VisionDesk vision;
  private final History history;
  private final Clock clock;
  private final LiveSession live;
  private volatile Sending sending;
  private long written = -1;

  PublishDesk(
      SessionDirectory directory,
      KickDesk kicks,
      NotesDesk notes,
      VisionDesk vision,
      History history,
      Clock clock,
      Runnable changed) {
    this.directory = directory;
    this.kicks = kicks;
    this.notes = notes;
    this.vision = vision;
    this.history = history;
    this.clock = clock;
    live = new LiveSession("sending of the model", changed);
  }

  /** What kind of packet is sent. */
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
    Publication publication = begin(format, host, (int) port, models);
    remember(publication);
    return publication;
  }

  /** Sends once, so that what cannot be sent at all is told to who asked for it, and goes on in the background. */
  private Publication begin(Format format, String host, int port, BallModels models) {
    byte[] packet = bytes(format, models);
    send(packet, host, port);
    Publication publication =
        new Publication(
            clock.millis() / 1000.0, host + ":" + port, Requests.name(format), models.toText());
    notes.change(n -> n.with(publication));
    stop();
    live.join(PATIENCE_MS);
    Sending next = new Sending(packet, host, port, publication);
    sending = next;
    live.start(next::run);
    return publication;
  }

  /** What was sent is sent; that a full disk does not keep it is said of the notes already. */
  private void remember(Publication sent) {
    try {
      write();
      ExportModel model = ExportModel.read(directory.resolve("calibration.json"));
      history.add(
          model.departure(Action.PUBLISHED, PACKET + sent.format(), sent.to(), sent.unix()),
          Optional.empty());
    } catch (IOException | ApiException e) {
      LOG.warn("the history was not kept: {}", e.getMessage());
    }
  }

  /**
   * Sends an earlier model again to where it went, and goes on with that one.
   *
   * @param entry of the history, of a packet
   * @param models of the entry
   */
  synchronized void again(HistoryEntry entry, BallModels models) throws IOException {
    int colon = entry.place().lastIndexOf(':');
    Format format =
        entry.target().equals(PACKET + Requests.name(Format.MODELS))
            ? Format.MODELS
            : Format.WRAPPER;
    int port = Integer.parseInt(entry.place().substring(colon + 1));
    Publication publication = begin(format, entry.place().substring(0, colon), port, models);
    history.add(entry.again(publication.unix()), Optional.empty());
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

  private byte[] bytes(Format format, BallModels models) {
    CalibrationOutcome outcome = kicks.calibrated();
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
