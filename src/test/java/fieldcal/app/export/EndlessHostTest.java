package fieldcal.app.export;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A vision whose answer never ends: an export gives up. */
class EndlessHostTest {
  private static final String HEAD = "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n";

  private ServerSocket server;
  private ProcessorHost host;

  private interface Answer {
    void to(Socket socket) throws IOException;
  }

  @BeforeEach
  void listen() throws IOException {
    server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    host = new ProcessorHost("http://127.0.0.1:" + server.getLocalPort(), Duration.ofMillis(500));
  }

  @AfterEach
  void close() throws IOException {
    server.close();
  }

  private void answers(Answer answer) {
    Thread thread =
        new Thread(
            () -> {
              try (Socket socket = server.accept()) {
                answer.to(socket);
              } catch (IOException e) {
                // The other side has given up.
              }
            });
    thread.setDaemon(true);
    thread.start();
  }

  @Test
  void anAnswerThatStopsInTheMiddleIsNotWaitedFor() {
    answers(
        socket -> {
          socket.getOutputStream().write(text(HEAD + "Content-Length: 1000\r\n\r\n{\"docu"));
          while (socket.getInputStream().read() >= 0) {
            // Until the other side closes.
          }
        });
    assertThatThrownBy(() -> host.difference(List.of()))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("does not end its answer");
  }

  @Test
  void anAnswerWithoutEndDoesNotFillTheMemory() {
    answers(
        socket -> {
          OutputStream out = socket.getOutputStream();
          out.write(text(HEAD + "\r\n"));
          byte[] spaces = text(" ".repeat(1 << 16));
          while (true) {
            out.write(spaces);
          }
        });
    assertThatThrownBy(() -> host.difference(List.of()))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("longer than " + LimitedText.LONGEST + " bytes");
  }

  private static byte[] text(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }
}
