package fieldcal.app.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.console.SessionNotes.Acceptance;
import io.javalin.Javalin;
import io.javalin.compression.CompressionStrategy;
import io.javalin.config.JavalinConfig;
import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.HttpResponseException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.jetty.server.handler.EagerContentHandler;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Addresses of the console and what is done for each; every error is a sentence in JSON. */
final class WebServer {
  private static final Logger LOG = LoggerFactory.getLogger(WebServer.class);
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String JSON = "application/json";

  private static final String NOTHING = "there is nothing at this address";

  /** The page may load nothing from elsewhere and run no script that is not a file of ours. */
  private static final String PAGE_POLICY =
      "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; object-src"
          + " 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'self'";

  /** A report carries its scripts and styles inside, and needs nothing else. */
  private static final String REPORT_POLICY =
      "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:;"
          + " base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

  /** Files that are written for the decisions as they are when somebody asks for them. */
  private static final List<String> CURRENT =
      List.of(
          "report.html",
          "calibration.json",
          "geometry_models.pb",
          "geometry_models.txt",
          SessionDirectory.SELECTION);

  private final Desks desks;
  private final RequestGuard guard;
  private final Guesses guesses = new Guesses(System::nanoTime);

  /** The address with the token, as it is printed, works once: it may be found in the history of a terminal or a browser later. The form takes the token as often as wanted. */
  private final AtomicBoolean linkUsed = new AtomicBoolean();

  private final Assets assets;
  private final Javalin javalin;

  WebServer(ConsoleSettings settings, Desks desks) throws IOException {
    this.desks = desks;
    guard = new RequestGuard(settings);
    assets = new Assets();
    javalin = Javalin.create(config -> configure(config, settings));
  }

  void start() {
    javalin.start();
  }

  int port() {
    return javalin.port();
  }

  void stop() {
    javalin.stop();
  }

  private void configure(JavalinConfig config, ConsoleSettings settings) {
    config.startup.showJavalinBanner = false;
    config.startup.showOldJavalinVersionWarning = false;
    config.startup.startupWatcherEnabled = false;
    config.http.maxRequestSize = Requests.LARGEST_BODY;
    // The network is this machine or a hall; and an event must not wait for a full buffer.
    config.http.compressionStrategy = CompressionStrategy.NONE;
    config.jetty.host = settings.address();
    config.jetty.port = settings.port();
    config.jetty.modifyHttpConfiguration(http -> http.setSendServerVersion(false));
    // A body is read as it comes, without a thread that waits for it: only then a request is worked
    // on. So senders of a byte a second do not keep everybody else out.
    config.jetty.modifyServletContextHandler(
        handler ->
            handler.insertHandler(
                new EagerContentHandler(
                    new EagerContentHandler.RetainedContentLoaderFactory(
                        Requests.LARGEST_BODY + 1L, 0, false))));
    RoutesConfig routes = config.routes;
    routes.before(this::guard);
    routes.get("/", this::page);
    routes.get("/assets/{name}", this::asset);
    routes.get("/files/{name}", this::file);
    routes.get("/api/state", this::state);
    routes.get("/api/kicks/{id}", request -> json(request, desks.json().kick(number(request))));
    routes.get("/api/events", desks.events()::serve);
    routes.post("/api/token", this::token);
    actions(routes);
    errors(routes);
  }

  private void actions(RoutesConfig routes) {
    action(routes, "/api/decisions", body -> desks.kicks().decide(Decision.of(body)));
    action(routes, "/api/read", body -> desks.kicks().read());
    action(routes, "/api/recordings", body -> desks.kicks().choose(body));
    action(routes, "/api/record", body -> desks.record().start(body));
    action(routes, "/api/record/end", body -> desks.record().stop());
    action(routes, "/api/save", body -> desks.save());
    action(routes, "/api/results", body -> desks.publish().write());
    action(routes, "/api/cancel", body -> desks.work().cancel());
    action(routes, "/api/diagnosis", body -> desks.diagnosis().run());
    action(
        routes,
        "/api/diagnosis/acceptance",
        body -> desks.diagnosis().decide(Requests.oneOf(body, "acceptance", Acceptance.values())));
    action(routes, "/api/match", body -> desks.match().start(body));
    action(routes, "/api/match/end", body -> desks.match().stop());
    action(routes, "/api/play", body -> desks.play().start(PlayOrder.of(body)));
    action(routes, "/api/play/word", body -> desks.play().say(body));
    routes.post(
        "/api/play/plan",
        r -> json(r, desks.play().plan(PlayOrder.of(Requests.body(r))).toString()));
    action(routes, "/api/vision", body -> desks.vision().start(body));
    action(routes, "/api/vision/end", body -> desks.vision().stop());
    routes.post("/api/export", r -> json(r, desks.export().export(Requests.body(r)).toString()));
    routes.post(
        "/api/export/difference",
        r -> json(r, desks.export().difference(Requests.body(r)).toString()));
    action(routes, "/api/export/apply", body -> desks.export().apply(body));
    action(routes, "/api/history/rollback", body -> desks.export().rollBack(body));
    action(routes, "/api/publish", body -> desks.publish().send(body));
    action(routes, "/api/publish/end", body -> desks.publish().stop());
  }

  /** What a page may ask to be done. */
  private interface Action {
    void run(JsonNode body) throws IOException;
  }

  /** Every action is answered with the state after it, so that the page shows it without asking again. */
  private void action(RoutesConfig routes, String path, Action action) {
    routes.post(
        path,
        request -> {
          action.run(Requests.body(request));
          state(request);
        });
  }

  private void guard(Context request) {
    request.header("X-Content-Type-Options", "nosniff");
    request.header("Referrer-Policy", "no-referrer");
    request.header("Cross-Origin-Resource-Policy", "same-origin");
    request.header("Cross-Origin-Opener-Policy", "same-origin");
    request.header("Content-Security-Policy", PAGE_POLICY);
    request.header("Cache-Control", "no-store");
    guard.check(request);
    boolean open =
        request.path().equals("/")
            || request.path().equals("/api/token")
            || request.path().startsWith("/assets/");
    if (!open && !guard.isKnown(request)) {
      throw new ApiException(401, "the token is missing or wrong: reload the console's page");
    }
  }

  private void page(Context request) {
    String shown = request.queryParam("token");
    if (shown != null && !linkUsed.get() && guesses.mayTry()) {
      if (guard.isToken(shown) && linkUsed.compareAndSet(false, true)) {
        guard.welcome(request);
        request.redirect("/");
        return;
      }
      guesses.wrong();
    }
    boolean known = guard.isKnown(request);
    request.status(known ? 200 : 401);
    send(request, known ? "index.html" : "token.html");
  }

  private void token(Context request) throws IOException {
    String shown = Requests.text(Requests.body(request), "token", 1000);
    if (!guesses.mayTry()) {
      throw new ApiException(429, "too many wrong tokens: wait a minute and try again");
    }
    if (!guard.isToken(shown)) {
      guesses.wrong();
      throw new ApiException(401, "this token is wrong");
    }
    guard.welcome(request);
    json(request, "{}");
  }

  private void asset(Context request) {
    Assets.Asset asset = find(request.pathParam("name"));
    // Kept by the browser, which asks each time whether it is still the same.
    request.header("Cache-Control", "no-cache").header("ETag", asset.tag());
    request.header("Vary", "Accept-Encoding");
    if (asset.tag().equals(request.header("If-None-Match"))) {
      request.status(304);
      return;
    }
    String understood = request.header("Accept-Encoding");
    boolean packed = understood != null && understood.contains("gzip");
    if (packed) {
      request.header("Content-Encoding", "gzip");
    }
    request.contentType(asset.type()).result(packed ? asset.packed() : asset.bytes());
  }

  private Assets.Asset find(String name) {
    return assets
        .find(name)
        .orElseThrow(() -> ApiException.notFound("the console has no such file"));
  }

  private void send(Context request, String name) {
    Assets.Asset asset = find(name);
    request.contentType(asset.type()).result(asset.bytes());
  }

  private void file(Context request) throws IOException {
    String name = request.pathParam("name");
    String type =
        SessionDirectory.typeOf(name)
            .orElseThrow(
                () -> ApiException.notFound("the session has no file of that name to show"));
    if (CURRENT.contains(name)) {
      desks.publish().write();
    }
    Path file = desks.directory().served(name);
    if (type.startsWith("text/html")) {
      request.header("Content-Security-Policy", REPORT_POLICY);
    } else {
      request.header("Content-Disposition", "attachment; filename=\"" + name + "\"");
    }
    request.contentType(type).result(Files.newInputStream(file));
  }

  private static int number(Context request) {
    String text = request.pathParam("id");
    if (!text.matches("\\d{1,7}")) {
      throw ApiException.badRequest("a kick is named by its number");
    }
    return Integer.parseInt(text);
  }

  private void state(Context request) throws IOException {
    json(request, desks.json().state(Having.of(request)));
  }

  private static void json(Context request, String json) {
    request.contentType(JSON).result(json);
  }

  private static void errors(RoutesConfig routes) {
    routes.exception(ApiException.class, (e, r) -> error(r, e.status(), e.getMessage()));
    routes.exception(
        HttpResponseException.class,
        (e, r) -> error(r, e.getStatus(), e.getStatus() == 404 ? NOTHING : e.getMessage()));
    routes.exception(IOException.class, (e, r) -> error(r, 507, Failures.words(e)));
    routes.exception(
        UncheckedIOException.class, (e, r) -> error(r, 507, Failures.words(e.getCause())));
    routes.exception(
        Exception.class,
        (e, r) -> {
          LOG.error("defect at {} {}", r.method(), r.path(), e);
          error(r, 500, Failures.words(e));
        });
  }

  private static void error(Context request, int status, String message) {
    try {
      String text = message == null ? "" : message;
      json(request.status(status), MAPPER.writeValueAsString(Map.of("error", text)));
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }
}
