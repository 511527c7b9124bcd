package fieldcal.app.console;

import io.javalin.http.Context;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
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
    private static final Map<String, String> BEAT = Map.of("beat", "{}");

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
      return news.isEmpty() ? BEAT : news;
    }
  }

  /**
   * Serves one window until it is closed, with server-sent events; the calling thread is its own, so that the request is still there when the window has gone: afterwards the server would use it for somebody
   * else.
   */
  void serve(Context request) {
    Window window = new Window();
    synchronized (this) {
      if (closed || windows.size() >= MOST_WINDOWS) {
        throw new ApiException(503, "too many windows are open, or the console is ending");
      }
      windows.add(window);
    }
    try {
      request.contentType("text/event-stream; charset=utf-8");
      OutputStream out = request.res().getOutputStream();
      Map<String, String> news = Window.BEAT;
      while (news != null) {
        for (Map.Entry<String, String> event : news.entrySet()) {
          send(out, event.getKey(), event.getValue());
        }
        out.flush();
        news = window.next();
      }
    } catch (IOException e) {
      // The window is closed, or its network is gone: it asks again if it is still there.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        windows.remove(window);
      }
    }
  }

  /** What is told is JSON without line ends. */
  private static void send(OutputStream out, String event, String data) throws IOException {
    String text = "event: " + event + "\ndata: " + data + "\n\n";
    out.write(text.getBytes(StandardCharsets.UTF_8));
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
