package fieldcal.app.console;

import fieldcal.app.hardening.ParserFuzz;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** What the console reads: requests, and the notes of an earlier run, for {@link ParserFuzz}. */
public final class ConsoleFuzz implements ParserFuzz.Parser, AutoCloseable {
  /** So often a good request must be answered. */
  private static final int BETWEEN_CHECKS = 200;

  /** A request that is over is answered in milliseconds; longer is a hang, ms. */
  private static final int PATIENCE = 30_000;

  private final RunningConsole console;
  private int requests;

  /**
   * A console of an empty session.
   *
   * @param scratch a folder
   * @throws IOException when it cannot be started
   */
  public ConsoleFuzz(Path scratch) throws IOException {
    console = RunningConsole.start(Files.createDirectories(scratch.resolve("session")));
  }

  @Override
  public void read(byte[] request) throws IOException {
    String said;
    try (Socket socket = new Socket("127.0.0.1", console.port())) {
      socket.setSoTimeout(PATIENCE);
      try {
        socket.getOutputStream().write(request);
        socket.shutdownOutput();
      } catch (SocketException e) {
        // Refused before all of it was there.
      }
      try {
        said = new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
      } catch (SocketException e) {
        said = ""; // closed without an answer
      }
    }
    if (said.startsWith("HTTP/1.1 500")) {
      throw new IllegalStateException("the console broke: " + said);
    }
    if (++requests % BETWEEN_CHECKS == 0 && console.get("/api/state").status() != 200) {
      throw new IllegalStateException("the console does not answer any more");
    }
  }

  /**
   * The notes of an earlier run.
   *
   * @param scratch a folder
   * @return takes {@code console.json}
   */
  public static ParserFuzz.Parser notes(Path scratch) {
    return bytes -> {
      ParserFuzz.replace(scratch.resolve(SessionNotes.FILE), bytes);
      SessionNotes.read(scratch);
    };
  }

  @Override
  public void close() {
    console.close();
  }
}
