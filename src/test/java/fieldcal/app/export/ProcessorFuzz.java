package fieldcal.app.export;

import fieldcal.app.export.format.Setting;
import fieldcal.app.hardening.ParserFuzz;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What a vision answers to an export, for {@link ParserFuzz}: bytes on a socket, so that HTTP itself may be broken, too. */
public final class ProcessorFuzz implements ParserFuzz.Parser, Closeable {
  /** Between the answers to one request after the other. */
  private static final String NEXT = "\n%%\n";

  private static final List<Setting> SETTINGS = settings();

  private final ServerSocket server;
  private final ProcessorHost host;
  private volatile List<byte[]> answers = List.of();
  private volatile int asked;

  /**
   * Begins to listen.
   *
   * @throws IOException when no port can be opened
   */
  public ProcessorFuzz() throws IOException {
    server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    host = new ProcessorHost("http://127.0.0.1:" + server.getLocalPort());
    Thread thread = new Thread(this::serve, "vision");
    thread.setDaemon(true);
    thread.start();
  }

  private static List<Setting> settings() {
    try {
      ExportModel model = ExportModel.read(TargetsTest.file("calibration.json"));
      return new Exporter(
              Target.of("ssl-vision-processor"), model, Optional.empty(), Optional.empty())
          .settings();
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Good answers.
   *
   * @return to the requests of one export
   */
  public static List<byte[]> good() {
    String config =
        """
        {"document": {"version": 1, "models": {"straight_two_phase": {"acc_slide": -3.4, "acc_roll": -0.45}}}, "state": {"revision": 7}}\
        """;
    String known = answer("200 OK", config);
    String taken = answer("200 OK", "{\"revision\":8}");
    String stale = answer("409 Conflict", "{\"error\":\"stale\",\"message\":\"stale revision\"}");
    return List.of(
        (known + NEXT + taken + NEXT + answer("204 No Content", ""))
            .getBytes(StandardCharsets.UTF_8),
        (known + NEXT + stale).getBytes(StandardCharsets.UTF_8),
        (known + NEXT + answer("400 Bad Request", "version: want 1, got 0"))
            .getBytes(StandardCharsets.UTF_8));
  }

  private static String answer(String status, String body) {
    return "HTTP/1.1 "
        + status
        + "\r\nContent-Type: application/json\r\n"
        + (body.isEmpty() ? "" : "Content-Length: " + body.length() + "\r\n")
        + "\r\n"
        + body;
  }

  private void serve() {
    while (!server.isClosed()) {
      try (Socket socket = server.accept()) {
        request(socket.getInputStream());
        List<byte[]> all = answers;
        socket.getOutputStream().write(all.get(Math.min(asked++, all.size() - 1)));
        socket.shutdownOutput();
      } catch (IOException e) {
        // Closed here or there: the other side says so.
      }
    }
  }

  /** Reads a request, since who closes a connection with something unread cuts off the answer. */
  private static void request(InputStream in) throws IOException {
    StringBuilder head = new StringBuilder();
    while (head.indexOf("\r\n\r\n") < 0) {
      int next = in.read();
      if (next < 0) {
        return;
      }
      head.append((char) next);
    }
    int length = head.indexOf("Content-Length: ");
    if (length >= 0) {
      int from = length + "Content-Length: ".length();
      in.readNBytes(Integer.parseInt(head.substring(from, head.indexOf("\r", from))));
    }
  }

  @Override
  public void read(byte[] input) throws IOException {
    List<byte[]> parts = new ArrayList<>();
    for (String part : new String(input, StandardCharsets.ISO_8859_1).split(NEXT, -1)) {
      parts.add(part.getBytes(StandardCharsets.ISO_8859_1));
    }
    answers = parts;
    asked = 0;
    List<byte[]> before = new ArrayList<>();
    host.apply(SETTINGS, changes -> changes.forEach(ProcessorHost::words), before::add);
    asked = 0;
    host.restore(before.get(0));
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
