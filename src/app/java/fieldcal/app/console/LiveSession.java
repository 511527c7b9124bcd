package fieldcal.app.console;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Optional;

/**
 * Something that goes on by itself until it ends or is ended: a match that is watched, a play. One at a time; what it shows last stays. Thread-safe.
 */
final class LiveSession {
  /** What goes on. */
  interface Run {
    /** Goes on until it ends. */
    void run() throws IOException;
  }

  private final String name;
  private final Runnable changed;
  private Thread thread;
  private boolean running;
  private Optional<String> failure = Optional.empty();

  LiveSession(String name, Runnable changed) {
    this.name = name;
    this.changed = changed;
  }

  synchronized boolean running() {
    return running;
  }

  /** Why the last one did not come to a good end. */
  synchronized Optional<String> failure() {
    return failure;
  }

  /**
   * Checks that none goes on, for those who must open something before they start one.
   *
   * @throws ApiException when one does
   */
  synchronized void requireNone() {
    if (running) {
      throw ApiException.conflict("the " + name + " is running already; end it first");
    }
  }

  /**
   * Lets one go on.
   *
   * @param goesOn what it is
   * @throws ApiException when another one does
   */
  void start(Run goesOn) {
    synchronized (this) {
      requireNone();
      running = true;
      failure = Optional.empty();
      thread = new Thread(() -> run(goesOn), name);
      thread.setDaemon(true);
      thread.start();
    }
    changed.run();
  }

  private void run(Run goesOn) {
    Optional<String> why = Optional.empty();
    try {
      goesOn.run();
    } catch (IOException | RuntimeException | Error e) {
      // Whatever it was: it is over, and another one may begin.
      why = Optional.of(Failures.words(e));
    }
    synchronized (this) {
      running = false;
      failure = why;
    }
    changed.run();
  }

  /** What a page needs to begin with: whether it goes on, why it failed, and what it told last. */
  ObjectNode state(Optional<ObjectNode> last) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("running", running());
    node.put("failure", failure().orElse(null));
    last.ifPresent(status -> node.set("status", status));
    return node;
  }

  /** Waits for the end, but not for long. */
  void join(long millis) {
    Thread waitedFor;
    synchronized (this) {
      waitedFor = thread;
    }
    if (waitedFor == null) {
      return;
    }
    try {
      waitedFor.join(millis);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
