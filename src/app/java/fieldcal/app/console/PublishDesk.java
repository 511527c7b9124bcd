package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
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

/** Gives the model away: as files of the session, and as a packet to an address. Thread-safe. */
final class PublishDesk {
  /** Hops that a packet to many may make: a venue's network has routers between vision and the teams' computers at times. */
  private static final int HOPS = 4;

  private static final int LONGEST_ADDRESS = 200;

  private final SessionDirectory directory;
  private final KickDesk kicks;
  private final NotesDesk notes;
  private final VisionDesk vision;
  private final Clock clock;
  private final Runnable changed;
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
   * Sends the model.
   *
   * @throws ApiException when the address is none, the model is not the one that the operator confirmed, or nothing can be sent there
   */
  Publication send(JsonNode body) {
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
    send(bytes(format, outcome), host, (int) port);
    Publication publication =
        new Publication(
            clock.millis() / 1000.0, host + ":" + port, Requests.name(format), models.toText());
    notes.change(n -> n.with(publication));
    changed.run();
    return publication;
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
