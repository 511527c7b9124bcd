package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.console.RunningConsole.Answer;
import fieldcal.app.recording.LogOpener;
import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the console refuses, and how it says so. Needs no kicks. */
class WebServerTest {
  private static final String[] PAGE = {"Content-Type: application/json", "X-Fieldcal-Console: 1"};

  @TempDir private static Path folder;

  private static Path session;
  private static RunningConsole console;

  @BeforeAll
  static void start() throws IOException {
    session = Files.createDirectory(folder.resolve("session"));
    Files.writeString(session.resolve("secret.txt"), "nobody's business");
    Files.writeString(folder.resolve("outside.json"), "nobody's business");
    Files.createSymbolicLink(session.resolve("diagnosis.json"), folder.resolve("outside.json"));
    console = RunningConsole.start(session);
    console.settled();
  }

  @AfterAll
  static void stop() {
    console.close();
  }

  private static void assertRefused(Answer answer, int status) throws IOException {
    assertThat(answer.status()).as(answer.toString()).isEqualTo(status);
    assertThat(answer.error()).isNotEmpty().doesNotContain("Exception").doesNotContain("defect");
    assertThat(answer.body()).doesNotContain("nobody's business");
  }

  @Test
  void anEmptySessionSaysWhatToDoAndWhere() throws IOException {
    assertThat(console.state().path("recordings")).isEmpty();
    assertThat(console.state().hasNonNull("failure")).isFalse();
    assertThat(console.state().path("directory").asText()).isEqualTo(session.toString());
    assertThat(console.get("/").body()).contains("<title>fieldcal console</title>");
  }

  @Test
  void pagesLoadNothingFromElsewhere() throws IOException {
    Answer page = console.get("/");
    assertThat(page.head())
        .contains("Content-Security-Policy: default-src 'self'")
        .contains("X-Content-Type-Options: nosniff")
        .contains("Cache-Control: no-store");
    assertThat(page.body()).doesNotContain("http://").doesNotContain("https://");
    for (String asset : List.of("app.js", "kicks.js", "console.css", "frame.css", "token.js")) {
      assertThat(console.get("/assets/" + asset).body())
          .doesNotContain("https://")
          .doesNotContain("innerHTML");
    }
  }

  @Test
  void whatTheBrowserHasIsNotSentAgain() throws IOException {
    Answer first = console.get("/assets/app.js");
    String tag = first.head().replaceFirst("(?s).*ETag: (\\S+).*", "$1");
    Answer again = console.get("/assets/app.js", "If-None-Match: " + tag);
    assertThat(again.status()).isEqualTo(304);
    assertThat(again.body()).isEmpty();
    assertThat(console.get("/assets/app.js", "If-None-Match: \"other\"").status()).isEqualTo(200);
    Answer packed = console.get("/assets/app.js", "Accept-Encoding: gzip, br");
    assertThat(packed.head()).contains("Content-Encoding: gzip");
    assertThat(packed.body().length()).isLessThan(first.body().length());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/nothing",
        "/assets/nothing.js",
        "/assets/Console.class",
        "/files/secret.txt",
        "/files/nothing",
        "/files/diagnosis.json", // a link that leads out
        "/files/console.json",
        "/files/practice.log.gz",
        "/files/.",
        "/api/nothing"
      })
  void unknownFilesAreNotThere(String path) throws IOException {
    assertRefused(console.get(path), 404);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "/../outside.json",
        "/files/../outside.json",
        "/files/..%2foutside.json",
        "/files/%2e%2e/outside.json",
        "/files/..%5coutside.json",
        "/files//etc/passwd",
        "/files/%2fetc%2fpasswd",
        "/assets/../../../../etc/passwd",
        "/assets/..%2f..%2fetc%2fpasswd",
        "/files/diagnosis.json%00.html"
      })
  void pathsOutsideTheSessionAreNotThere(String path) throws IOException {
    Answer answer = console.get(path);
    assertThat(answer.status()).as(answer.toString()).isIn(400, 404);
    assertThat(answer.body()).doesNotContain("nobody's business").doesNotContain("root:");
  }

  @ParameterizedTest
  @ValueSource(strings = {"evil.example", "evil.example:80", "localhost.evil.example", "0"})
  void anotherNameIsRefused(String host) throws IOException {
    assertRefused(console.get("/api/state", "Host: " + host), 403);
  }

  @Test
  void requestsFromOtherSitesAreRefused() throws IOException {
    assertRefused(console.get("/api/state", "Origin: http://evil.example"), 403);
    assertRefused(console.get("/api/state", "Origin: null"), 403);
    assertRefused(console.get("/api/state", "Sec-Fetch-Site: cross-site"), 403);
    // Another port of this machine is another site.
    assertRefused(console.get("/api/state", "Sec-Fetch-Site: same-site"), 403);
    assertRefused(console.post("/api/read", "{}", "Origin: http://localhost:1"), 403);
    assertRefused(
        console.get("/assets/app.js", "Sec-Fetch-Site: cross-site", "Sec-Fetch-Mode: no-cors"),
        403);
    // A link from elsewhere may open the page, which then asks for itself.
    String visit = "Sec-Fetch-Mode: navigate";
    assertThat(console.get("/", "Sec-Fetch-Site: cross-site", visit).status()).isEqualTo(200);
    assertThat(console.get("/api/state", "Origin: http://" + console.host()).status())
        .isEqualTo(200);
  }

  @Test
  void changesNeedTheHeaderOfThePage() throws IOException {
    String json = "Content-Type: application/json";
    assertRefused(console.send(console.request("POST", "/api/read", "{}", json)), 403);
    String own = "X-Fieldcal-Console: 1";
    assertRefused(console.send(console.request("POST", "/api/read", "{}", own)), 415);
    String form = "Content-Type: application/x-www-form-urlencoded";
    assertRefused(console.send(console.request("POST", "/api/read", "a=b", own, form)), 415);
    assertRefused(console.send(console.request("DELETE", "/api/state", "", own, json)), 405);
    assertRefused(console.send(console.request("PUT", "/api/read", "{}", own, json)), 405);
    assertThat(console.get("/api/read").status()).isEqualTo(404);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "{", "[]", "null", "7", "\"drop\"", "{\"action\":", "\u0000"})
  void whatIsNoJsonObjectIsRefused(String body) throws IOException {
    assertRefused(console.post("/api/decisions", body), 400);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{}",
        "{\"action\":\"explode\"}",
        "{\"action\":[]}",
        "{\"action\":\"drop\"}",
        "{\"action\":\"drop\",\"kicks\":[]}",
        "{\"action\":\"drop\",\"kicks\":7}",
        "{\"action\":\"drop\",\"kicks\":[\"7\"]}",
        "{\"action\":\"drop\",\"kicks\":[1.5]}",
        "{\"action\":\"drop\",\"kicks\":[99999999999]}",
        "{\"action\":\"drop\",\"kicks\":[1],\"reason\":7}",
        "{\"action\":\"undo\",\"seen\":\"now\"}"
      })
  void decisionsThatAreNoneAreRefusedWithTheField(String body) throws IOException {
    Answer answer = console.post("/api/decisions", body);
    assertRefused(answer, 400);
    assertThat(answer.error()).containsAnyOf("action", "kicks", "reason", "seen");
  }

  @Test
  void bodiesThatAreTooLargeAreRefused() throws IOException {
    String padding = " ".repeat(Requests.LARGEST_BODY + 1);
    Answer declared = console.post("/api/decisions", "{\"action\":\"undo\"" + padding + "}");
    assertRefused(declared, 413);
    // Without a length beforehand, in chunks.
    String chunk = "10000\r\n" + " ".repeat(0x10000) + "\r\n";
    Answer chunked =
        console.send(
            "POST /api/decisions HTTP/1.1\r\nHost: "
                + console.host()
                + "\r\nConnection: close\r\nX-Fieldcal-Console: 1\r\n"
                + "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n"
                + chunk.repeat(20)
                + "0\r\n\r\n");
    assertRefused(chunked, 413);
    String deep = "{\"action\":" + "[".repeat(100_000);
    assertRefused(console.post("/api/decisions", deep), 400);
    assertThat(console.state().path("version").isNumber()).isTrue();
  }

  @Test
  void whatIsNoHttpEndsTheConnectionOnly() throws IOException {
    assertThat(console.send("\u0016\u0003\u0001 hello\r\n\r\n").status()).isIn(0, 400, 505);
    assertThat(console.get("/api/state", "Host: ").status()).isEqualTo(400);
    assertThat(console.send("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n").status()).isIn(0, 400);
    assertThat(console.get("/api/state").status()).isEqualTo(200);
  }

  @Test
  void withoutKicksNothingCanBeDecidedOrPublished() throws IOException {
    for (String path :
        List.of("/api/decisions", "/api/results", "/api/diagnosis", "/api/save", "/api/publish")) {
      String body =
          "{\"action\":\"two_sigma\",\"format\":\"models\",\"address\":\"127.0.0.1\",\"port\":9}";
      assertRefused(console.post(path, body), 409);
    }
    assertRefused(console.get("/api/kicks/1"), 409);
    assertRefused(console.get("/api/kicks/one"), 400);
    assertRefused(console.get("/files/report.html"), 409);
    assertRefused(console.post("/api/diagnosis/acceptance", "{\"acceptance\":\"accepted\"}"), 409);
    assertRefused(console.post("/api/diagnosis/acceptance", "{\"acceptance\":\"maybe\"}"), 400);
  }

  @Test
  void matchesAndPlaysThatAreNoneAreRefused() throws IOException {
    String[] matches = {
      "{}",
      "{\"source\":\"network\"}",
      "{\"source\":\"network\",\"vision\":\"nowhere\"}",
      "{\"source\":\"network\",\"vision\":\"224.5.23.2:99999\"}",
      "{\"source\":\"network\",\"vision\":\"127.0.0.1:0\",\"referee\":\"x\"}",
    };
    for (String match : matches) {
      assertRefused(console.post("/api/match", match), 400);
    }
    String outside = "{\"source\":\"recording\",\"recording\":\"../outside.json\"}";
    assertRefused(console.post("/api/match", outside), 404);
    String order =
        "{\"field\":\"simulated\",\"kind\":\"flat\",\"half\":\"whole\",\"first\":\"yellow0\",\"second\":\"yellow1\"%s}";
    String[] wrong = {
      ",\"kicks\":0",
      ",\"kicks\":\"many\"",
      ",\"slowest\":5,\"fastest\":3",
      ",\"fastest\":60",
      ",\"slowest\":\"slow\"",
      ",\"second\":\"yellow0\"",
      ",\"second\":\"robot\"",
      ",\"half\":\"both\"",
      ",\"choice\":\"lucky\"",
      ",\"kind\":\"chip\",\"across\":50",
      ",\"pace\":-1",
      ",\"field\":\"moon\"",
      ",\"field\":\"simulator\"",
      ",\"field\":\"simulator\",\"host\":\"localhost\",\"vision\":\"nowhere\"",
      ",\"field\":\"simulator\",\"host\":\"localhost\",\"vision\":\"224.5.23.2:1\",\"port\":0",
      ",\"field\":\"robots\",\"bridge\":\"127.0.0.1:10400\",\"vision\":\"nowhere\"",
      ",\"driveSpeed\":0"
    };
    for (String more : wrong) {
      assertRefused(console.post("/api/play/plan", order.formatted(more)), 400);
      assertRefused(console.post("/api/play", order.formatted(more)), 400);
    }
    String nowhere = ",\"field\":\"robots\",\"bridge\":\"nowhere\",\"vision\":\"127.0.0.1:0\"";
    assertRefused(console.post("/api/play", order.formatted(nowhere)), 400);
    assertRefused(console.post("/api/play/word", "{\"word\":\"pause\"}"), 409);
    assertRefused(console.post("/api/play/word", "{\"word\":\"dance\"}"), 400);
    Answer plan =
        console.post("/api/play/plan", order.formatted(",\"kicks\":5,\"choice\":\"adaptive\""));
    assertThat(plan.status()).isEqualTo(200);
    assertThat(plan.json().path("kicks")).hasSize(5);
    assertThat(plan.json().path("lines")).hasSize(2);
    assertThat(console.state().at("/play/running").asBoolean()).isFalse();
  }

  @Test
  void withATokenNobodyGetsAnythingWithoutIt() throws IOException {
    String token = "a-token-of-the-field";
    ConsoleSettings settings = RunningConsole.withToken(session, "0.0.0.0", token);
    try (RunningConsole guarded = RunningConsole.start(settings)) {
      Answer door = guarded.get("/", "Host: field.example");
      assertThat(door.status()).isEqualTo(401);
      assertThat(door.body()).contains("Token").doesNotContain("page-kicks");
      assertRefused(guarded.get("/api/state"), 401);
      assertRefused(guarded.get("/api/events", "Accept: text/event-stream"), 401);
      assertRefused(guarded.get("/files/report.html"), 401);
      assertRefused(guarded.post("/api/read", "{}"), 401);
      assertThat(guarded.get("/?token=wrong").status()).isEqualTo(401);
      String name = "fieldcal-" + guarded.port();
      assertRefused(guarded.get("/api/state", "Cookie: " + name + "=wrong"), 401);
      assertRefused(guarded.post("/api/token", "{\"token\":\"wrong\"}"), 401);
      Answer entered = guarded.post("/api/token", "{\"token\":\"" + token + "\"}");
      assertThat(entered.status()).isEqualTo(200);
      assertThat(entered.head()).contains("HttpOnly").contains("SameSite=Strict");
      String cookie = entered.head().replaceFirst("(?s).*Set-Cookie: ([^;]*);.*", "$1");
      assertThat(guarded.get("/api/state", "Cookie: " + cookie).status()).isEqualTo(200);
      // The token does not help a page of another site.
      assertRefused(
          guarded.get("/api/state", "Cookie: " + cookie, "Origin: http://evil.example"), 403);
    }
  }

  /** More connections than the server has threads, each sending a byte now and then. */
  @Test
  void slowBodiesKeepNobodyOut() throws IOException {
    List<Socket> slow = new ArrayList<>();
    try {
      for (int i = 0; i < 300; i++) {
        Socket socket = new Socket("127.0.0.1", console.port());
        slow.add(socket);
        String request = console.request("POST", "/api/decisions", "x".repeat(1000), PAGE);
        String begin = request.substring(0, request.length() - 999);
        socket.getOutputStream().write(begin.getBytes(StandardCharsets.UTF_8));
        socket.getOutputStream().flush();
      }
      for (Socket socket : slow) {
        socket.getOutputStream().write('x');
        socket.getOutputStream().flush();
      }
      assertThat(console.get("/api/state").status()).isEqualTo(200);
      assertThat(console.post("/api/decisions", "{}").status()).isNotZero();
    } finally {
      for (Socket socket : slow) {
        socket.close();
      }
    }
  }

  @Test
  void thePrintedAddressWorksOnce() throws IOException {
    String token = "a-token-of-the-field";
    ConsoleSettings settings = RunningConsole.withToken(session, "0.0.0.0", token);
    try (RunningConsole guarded = RunningConsole.start(settings)) {
      assertThat(guarded.get("/?token=" + token).status()).isEqualTo(302);
      assertThat(guarded.get("/?token=" + token).status()).isEqualTo(401);
      assertThat(guarded.post("/api/token", "{\"token\":\"" + token + "\"}").status())
          .isEqualTo(200);
    }
  }

  @Test
  void tokensCannotBeTriedOverAndOver() throws IOException {
    String token = "a-token-of-the-field";
    ConsoleSettings settings = RunningConsole.withToken(session, "0.0.0.0", token);
    try (RunningConsole guarded = RunningConsole.start(settings)) {
      for (int i = 0; i < 10; i++) {
        assertRefused(guarded.post("/api/token", "{\"token\":\"wrong\"}"), 401);
      }
      assertRefused(guarded.post("/api/token", "{\"token\":\"" + token + "\"}"), 429);
      assertThat(guarded.get("/?token=" + token).status()).isEqualTo(401);
    }
  }

  @Test
  void aConsoleThatOthersReachNeedsAToken() {
    assertThatThrownBy(
            () ->
                new ConsoleSettings(
                    session,
                    "0.0.0.0",
                    0,
                    java.util.Optional.empty(),
                    java.util.Optional.empty(),
                    1,
                    LogOpener.USUAL))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("token");
    assertThatThrownBy(() -> RunningConsole.withToken(session, "0.0.0.0", "short"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("12");
    assertThatThrownBy(() -> RunningConsole.withToken(session, "0.0.0.0", "with spaces & more"))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aPortThatIsTakenIsOneLine() {
    assertThatThrownBy(
            () ->
                Console.start(
                    ConsoleSettings.local(session, console.port()), java.time.Clock.systemUTC()))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(Integer.toString(console.port()))
        .hasMessageContaining("--port");
  }

  @Test
  void aDirectoryThatCannotBeUsedIsOneLine() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "no directory");
    assertThatThrownBy(() -> RunningConsole.start(file))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(file.toString());
    assertThatThrownBy(() -> RunningConsole.start(folder.resolve("no/such")))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("no such directory");
    Path strange = Files.createDirectory(folder.resolve("strange"));
    Files.writeString(strange.resolve("console.json"), "{\"schema\":\"something else\"}");
    assertThatThrownBy(() -> RunningConsole.start(strange))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("console.json");
  }
}
