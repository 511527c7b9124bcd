package fieldcal.app.console;

import fieldcal.app.calibrate.InputException;
import io.javalin.util.JavalinException;
import java.io.IOException;
import java.net.UnknownHostException;
import java.nio.channels.UnresolvedAddressException;
import java.time.Clock;

/** A running console. */
public final class Console implements AutoCloseable {
  private final ConsoleSettings settings;
  private final Desks desks;
  private final WebServer server;

  private Console(ConsoleSettings settings, Desks desks, WebServer server) {
    this.settings = settings;
    this.desks = desks;
    this.server = server;
  }

  /**
   * Starts a console: it listens when this returns, and reads the session's recordings meanwhile.
   *
   * @param settings what is wanted
   * @param clock of what is noted
   * @return the console, to be closed
   * @throws InputException when the directory cannot be used or the address cannot be listened on; one line for the operator
   * @throws IOException when a file of the session cannot be read
   */
  public static Console start(ConsoleSettings settings, Clock clock) throws IOException {
    Desks desks = new Desks(settings, clock);
    WebServer server = new WebServer(settings, desks);
    try {
      server.start();
    } catch (JavalinException e) {
      throw unreachable(settings, e);
    }
    desks.start();
    return new Console(settings, desks, server);
  }

  private static InputException unreachable(ConsoleSettings settings, JavalinException e) {
    StringBuilder why = new StringBuilder();
    boolean unknown = false;
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      why.append(cause.getMessage()).append(' ');
      unknown |=
          cause instanceof UnresolvedAddressException || cause instanceof UnknownHostException;
    }
    String at = settings.address() + ":" + settings.port() + ": ";
    // The operating system's own words are first; what is wrapped around them guesses.
    if (unknown || why.indexOf("assign requested address") >= 0) {
      return new InputException(
          at + "this machine does not have that address; --address 0.0.0.0 listens on all it has");
    }
    if (why.indexOf("ermission denied") >= 0) {
      return new InputException(
          at + "only the administrator may listen there; choose 1024 or more with --port");
    }
    return new InputException(
        why.indexOf("in use") >= 0
            ? at + "another program listens there; choose another with --port"
            : at + "cannot listen there: " + e.getMessage());
  }

  /**
   * Where the console is.
   *
   * @return an address for a browser, with the token if there is one
   */
  public String url() {
    String host =
        settings.address().contains(":") ? "[" + settings.address() + "]" : settings.address();
    String query = settings.token().map(token -> "?token=" + token).orElse("");
    return "http://" + host + ":" + server.port() + "/" + query;
  }

  /** Ends it; work that is under way is given up, decisions are on the disk already. */
  @Override
  public void close() {
    desks.stop();
    server.stop();
  }
}
