package fieldcal.app.console;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.LongSupplier;

/**
 * How often a wrong token may be tried: a few times in a minute by all visitors together. Whoever knows the token and shows it by its cookie is not asked here. Thread-safe.
 */
final class Guesses {
  /** A person who mistypes needs three; at this rate the shortest token that is allowed holds out for longer than the universe. */
  private static final int MOST = 10;

  private static final long WINDOW = 60_000_000_000L;

  private final LongSupplier nanoTime;
  private final Deque<Long> wrong = new ArrayDeque<>();

  Guesses(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  synchronized boolean mayTry() {
    long now = nanoTime.getAsLong();
    while (!wrong.isEmpty() && now - wrong.peekFirst() > WINDOW) {
      wrong.removeFirst();
    }
    return wrong.size() < MOST;
  }

  synchronized void wrong() {
    wrong.addLast(nanoTime.getAsLong());
    if (wrong.size() > MOST) {
      wrong.removeFirst();
    }
  }
}
