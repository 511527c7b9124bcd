package fieldcal.app.console;

import fieldcal.app.calibrate.InputException;
import io.javalin.util.JavalinException;
import java.io.IOException;
import java.net.BindException;
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
    Throwable cause = e;
    while (cause != null && !(cause instanceof BindException)) {
      cause = cause.getCause();
    }
    boolean busy = cause != null || String.valueOf(e.getMessage()).contains("already in use");
    String at = settings.address() + ":" + settings.port();
    return new InputException(
        busy
            ? at + ": another program listens there; choose another with --port"
            : at + ": cannot listen there: " + e.getMessage());
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
