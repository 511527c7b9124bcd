package fieldcal.app.console;

import io.javalin.http.sse.SseClient;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * Tells every open window what changed. An event that was not sent yet is replaced by a newer one of the same name, so that a slow window gets the latest and delays
 * nobody. Thread-safe.
 */
final class EventHub {
  /** Windows are told that often that the connection lives, ms; the page takes three times that for a lost one. */
  private static final long BEAT_MS = 3000;

  /** More windows than that are a mistake. */
  private static final int MOST_WINDOWS = 24;

  private final Set<Window> windows = new HashSet<>();
  private boolean closed;

  /** What one window is still to be told. */
  private static final class Window {
    private final Map<String, String> pending = new LinkedHashMap<>();
    private boolean closed;

    synchronized void tell(String event, String data) {
      pending.put(event, data);
      notifyAll();
    }

    synchronized void close() {
      closed = true;
      notifyAll();
    }

    /** Waits for news; a beat when there are none for a while, null when the window is closed. */
    synchronized Map<String, String> next() throws InterruptedException {
      if (pending.isEmpty() && !closed) {
        wait(BEAT_MS);
      }
      if (closed) {
        return null;
      }
      Map<String, String> news = new LinkedHashMap<>(pending);
      pending.clear();
      return news.isEmpty() ? Map.of("beat", "{}") : news;
    }
  }

  /** Serves one window until it is closed; the calling thread is its own. */
  void serve(SseClient client) {
    Window window = new Window();
    synchronized (this) {
      if (closed || windows.size() >= MOST_WINDOWS) {
        client.close();
        return;
      }
      windows.add(window);
    }
    client.onClose(window::close);
    try {
      client.sendEvent("beat", "{}");
      while (!client.terminated()) {
        Map<String, String> news = window.next();
        if (news == null) {
          return;
        }
        news.forEach(client::sendEvent);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        windows.remove(window);
      }
      client.close();
    }
  }

  /** Tells all windows. */
  synchronized void tell(String event, String data) {
    windows.forEach(window -> window.tell(event, data));
  }

  /** Ends all connections; later ones are refused. */
  synchronized void close() {
    closed = true;
    windows.forEach(Window::close);
  }
}
