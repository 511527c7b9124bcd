package fieldcal.gamelog;

import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.Comparator;
import java.util.PriorityQueue;

/**
 * Puts what was received into the order of capture times: an entry waits until one is received that was captured later by the
 * tolerance; with a tolerance of 0 none waits. Geometry and referee messages take the latest capture time before them.
 */
final class CaptureOrder {
  private static final Comparator<Entry> ORDER =
      Comparator.comparingDouble(Entry::time).thenComparingLong(Entry::number);

  private final double tolerance;
  private final RecordingListener listener;
  private final PriorityQueue<Entry> waiting = new PriorityQueue<>(ORDER);
  private double latest = Double.NEGATIVE_INFINITY;
  private long number;

  private record Entry(double time, long number, Object content, double receivedTime) {}

  CaptureOrder(double tolerance, RecordingListener listener) {
    this.tolerance = tolerance;
    this.listener = listener;
  }

  void add(VisionFrame frame, double receivedTime) {
    latest = Math.max(latest, frame.captureTime());
    waiting.add(new Entry(frame.captureTime(), number++, frame, receivedTime));
    release();
  }

  void add(FieldGeometry geometry) {
    waiting.add(new Entry(latest, number++, geometry, Double.NaN));
    release();
  }

  void add(RefereeState state, double receivedTime) {
    waiting.add(new Entry(latest, number++, state, receivedTime));
    release();
    if (latest == Double.NEGATIVE_INFINITY) {
      // Before the first frame nothing can come earlier; a log of nothing but referee messages must
      // not pile up.
      flush();
    }
  }

  /** Hands on what has waited long enough; nothing waits without a tolerance. */
  private void release() {
    while (!waiting.isEmpty() && (tolerance == 0 || waiting.peek().time < latest - tolerance)) {
      tell(waiting.poll());
    }
  }

  /** Hands on all entries that wait, and forgets the time. */
  void flush() {
    while (!waiting.isEmpty()) {
      tell(waiting.poll());
    }
    latest = Double.NEGATIVE_INFINITY;
  }

  private void tell(Entry entry) {
    if (entry.content instanceof VisionFrame frame) {
      listener.onFrame(frame, entry.receivedTime);
    } else if (entry.content instanceof FieldGeometry geometry) {
      listener.onGeometry(geometry);
    } else {
      listener.onReferee((RefereeState) entry.content, entry.receivedTime);
    }
  }
}
