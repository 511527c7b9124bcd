package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.recording.LogOpener;
import java.io.IOException;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Optional;
import java.util.function.Predicate;

/** A console under test, and how a client talks to it: bytes on a socket, so that nothing is made right on the way. */
final class RunningConsole implements AutoCloseable {
  /** The time that is noted. */
  static final Instant NOW = Instant.parse("2026-11-21T10:00:00Z");

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final Duration PATIENCE = Duration.ofSeconds(120);

  private final String url;
  private final Runnable end;
  private final int port;

  private RunningConsole(String url, Runnable end) {
    this.url = url;
    this.end = end;
    port = URI.create(url).getPort();
  }

  /** One that runs elsewhere. */
  static RunningConsole at(String url, Runnable end) {
    return new RunningConsole(url, end);
  }

  static RunningConsole start(Path directory) throws IOException {
    return start(ConsoleSettings.local(directory, 0));
  }

  static RunningConsole start(ConsoleSettings settings) throws IOException {
    Console console = Console.start(settings, Clock.fixed(NOW, ZoneOffset.UTC));
    return new RunningConsole(console.url(), console::close);
  }

  static ConsoleSettings withToken(Path directory, String address, String token) {
    return new ConsoleSettings(
        directory, address, 0, Optional.of(token), Optional.empty(), 20260101, LogOpener.USUAL);
  }

  /**
   * What came back.
   *
   * @param status of HTTP; 0 when the connection was closed without an answer
   * @param head status line and headers
   * @param body the rest
   */
  record Answer(int status, String head, String body) {
    JsonNode json() throws IOException {
      return MAPPER.readTree(body);
    }

    /** The sentence of an error. */
    String error() throws IOException {
      return json().path("error").asText();
    }
  }

  int port() {
    return port;
  }

  String url() {
    return url;
  }

  String host() {
    return "localhost:" + port;
  }

  Answer get(String path, String... headers) throws IOException {
    return send(request("GET", path, "", headers));
  }

  /** As the page does it. */
  Answer post(String path, String body, String... more) throws IOException {
    String[] headers = new String[more.length + 2];
    headers[0] = "Content-Type: application/json";
    headers[1] = "X-Fieldcal-Console: 1";
    System.arraycopy(more, 0, headers, 2, more.length);
    return send(request("POST", path, body, headers));
  }

  JsonNode decide(String body) throws IOException {
    Answer answer = post("/api/decisions", body);
    assertThat(answer.status()).as(answer.body()).isEqualTo(200);
    return answer.json();
  }

  String request(String method, String path, String body, String... headers) {
    StringBuilder text = new StringBuilder(method + " " + path + " HTTP/1.1\r\n");
    boolean named = false;
    for (String header : headers) {
      named |= header.startsWith("Host:");
      text.append(header).append("\r\n");
    }
    if (!named) {
      text.append("Host: ").append(host()).append("\r\n");
    }
    int length = body.getBytes(StandardCharsets.UTF_8).length;
    text.append("Connection: close\r\nContent-Length: ").append(length).append("\r\n\r\n");
    return text.append(body).toString();
  }

  /** Sends bytes as they are, and reads until the server closes. */
  Answer send(String request) throws IOException {
    try (Socket socket = new Socket("127.0.0.1", port)) {
      socket.setSoTimeout(60_000);
      byte[] bytes;
      try {
        socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
        socket.getOutputStream().flush();
      } catch (IOException e) {
        // The server answered before it had everything, and closed; the answer is there to be read.
      }
      bytes = socket.getInputStream().readAllBytes();
      String text = new String(bytes, StandardCharsets.UTF_8);
      int end = text.indexOf("\r\n\r\n");
      if (end < 0) {
        return new Answer(0, text, "");
      }
      int status = Integer.parseInt(text.substring(9, 12));
      return new Answer(status, text.substring(0, end), text.substring(end + 4));
    }
  }

  JsonNode state() throws IOException {
    Answer answer = get("/api/state");
    assertThat(answer.status()).as(answer.body()).isEqualTo(200);
    return answer.json();
  }

  /** Waits until the state is as wanted. */
  JsonNode await(String what, Predicate<JsonNode> wanted) throws IOException {
    Instant end = Instant.now().plus(PATIENCE);
    JsonNode state = state();
    while (!wanted.test(state)) {
      assertThat(Instant.now()).as("%s; last state: %.2000s", what, state).isBefore(end);
      try {
        Thread.sleep(50);
      } catch (InterruptedException e) {
        throw new IOException(e);
      }
      state = state();
    }
    return state;
  }

  /** Waits until everything that was begun is done. */
  JsonNode settled() throws IOException {
    return await(
        "settled",
        state ->
            !state.path("work").has("title")
                && (state.path("settled").asBoolean() || state.hasNonNull("failure")));
  }

  @Override
  public void close() {
    end.run();
  }
}
