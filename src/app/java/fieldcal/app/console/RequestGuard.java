package fieldcal.app.console;

import io.javalin.http.Context;
import io.javalin.http.Cookie;
import io.javalin.http.HandlerType;
import io.javalin.http.SameSite;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Who may ask for what: this console's own page, and nobody else's.
 *
 * <p>Pages of other sites cannot make the browser change anything here: what changes something needs a header of its own, which a browser sends across sites only after asking first, and requests that say
 * they come from elsewhere are refused. A name that somebody points at this machine ({@code DNS rebinding}) is not one of ours. Where others reach the console, visitors need a token. Immutable.
 */
final class RequestGuard {
  /** What the page puts into every request that changes something. */
  static final String HEADER = "X-Fieldcal-Console";

  private static final Set<HandlerType> READING = Set.of(HandlerType.GET, HandlerType.HEAD);

  private static final Set<String> OWN_NAMES = Set.of("localhost", "127.0.0.1", "[::1]");

  private final boolean local;
  private final Optional<String> token;

  RequestGuard(ConsoleSettings settings) {
    local = ConsoleSettings.isLoopback(settings.address());
    token = settings.token();
  }

  /**
   * Lets a request pass.
   *
   * @throws ApiException when it may not
   */
  void check(Context request) {
    String host = Optional.ofNullable(request.header("Host")).orElse("");
    if (local && !OWN_NAMES.contains(host.replaceFirst(":\\d+$", "").toLowerCase(Locale.ROOT))) {
      throw forbidden("this console is called localhost, not “" + printable(host) + "”");
    }
    String origin = request.header("Origin");
    if (origin != null && !origin.equalsIgnoreCase("http://" + host)) {
      throw forbidden("requests from other sites are refused");
    }
    String site = request.header("Sec-Fetch-Site");
    boolean own = site == null || site.equals("same-origin") || site.equals("none");
    // A link on another page may lead here; what it shows, that page cannot see.
    boolean visit =
        READING.contains(request.method())
            && request.path().equals("/")
            && "navigate".equals(request.header("Sec-Fetch-Mode"));
    if (!own && !visit) {
      throw forbidden("requests from other sites are refused");
    }
    if (!READING.contains(request.method())) {
      requireOwnPage(request);
    }
  }

  private static void requireOwnPage(Context request) {
    if (request.method() != HandlerType.POST) {
      throw new ApiException(405, "only GET and POST are understood");
    }
    if (request.header(HEADER) == null) {
      throw forbidden("requests that change something need the header " + HEADER);
    }
    String type = Optional.ofNullable(request.contentType()).orElse("");
    if (!type.toLowerCase(Locale.ROOT).startsWith("application/json")) {
      throw new ApiException(415, "the request must be JSON (Content-Type: application/json)");
    }
  }

  private static ApiException forbidden(String message) {
    return new ApiException(403, message);
  }

  /** Whether the visitor showed the token before, or needs none. */
  boolean isKnown(Context request) {
    return token.isEmpty() || isToken(request.cookie(cookieName(request)));
  }

  /** Whether a text is the token; takes as long for any other. */
  boolean isToken(String shown) {
    return token.isPresent()
        && shown != null
        && MessageDigest.isEqual(
            shown.getBytes(StandardCharsets.UTF_8), token.get().getBytes(StandardCharsets.UTF_8));
  }

  /** Lets the browser show the token from now on. */
  void welcome(Context request) {
    Cookie cookie = new Cookie(cookieName(request), token.orElseThrow());
    cookie.setHttpOnly(true);
    cookie.setSameSite(SameSite.STRICT);
    request.cookie(cookie);
  }

  /** Browsers do not tell ports apart in cookies; two consoles on one machine must. */
  private static String cookieName(Context request) {
    return "fieldcal-" + request.req().getLocalPort();
  }

  private static String printable(String text) {
    String plain = text.replaceAll("[^\\x20-\\x7e]", "?");
    return plain.length() > 60 ? plain.substring(0, 60) + "…" : plain;
  }
}
