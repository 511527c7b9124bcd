package fieldcal.live;

import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.RecentKicks;
import fieldcal.kick.Kick;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * What the cameras add to their reports, learnt from the kicks of the match, and taken out before a kick is judged: cameras disagree by centimetres on every field, and a step of that size in the middle of a
 * kick changes accSlide by 25 %. A kick that several cameras saw waits until the offsets between them are settled, but only for some kicks.
 */
final class CameraAlignment {
  /** Number of kicks from which offsets and noise are estimated; not all of a match, since cameras move when somebody bumps into a mount. */
  private static final int MEMORY = 60;

  /** Offsets that moved less with the last kick are settled, m: the noise of a camera. */
  private static final double SETTLED = 0.002;

  /** Cameras that share no ball never settle; after this many further kicks a kick is judged as it is, and later ones of the same cameras do not wait. */
  private static final int PATIENCE = 8;

  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private final Set<Set<Integer>> hopeless = new HashSet<>();
  private CameraViews before = CameraViews.of(List.of());
  private RecentKicks recent = new RecentKicks(before, MEMORY);

  /** Read by other threads. */
  private volatile CameraViews views = before;

  /** A kick that waits, and since which kick. */
  private static final class Waiting {
    private final Kick kick;
    private final Set<Integer> cameras = new TreeSet<>();
    private int since;

    Waiting(Kick kick) {
      this.kick = kick;
      for (int id : kick.observations().cameras()) {
        cameras.add(id);
      }
    }
  }

  /** What is known of one camera; NaN where it is not known. */
  record Known(double offsetX, double offsetY, boolean calibrated) {
    /** Distance between the offsets of this camera and another one, m; NaN when one of the two is not known. */
    double distance(Known other) {
      return Math.hypot(offsetX - other.offsetX, offsetY - other.offsetY);
    }
  }

  /** The cameras' geometry changed: what was learnt with the old one is forgotten, and the kicks that wait are dropped; returns their number. */
  int restart(CameraViews geometry) {
    int lost = waiting.size();
    waiting.clear();
    hopeless.clear();
    recent = new RecentKicks(geometry, MEMORY);
    views = geometry;
    before = geometry;
    return lost;
  }

  /** Learns from a kick; returns those that can be judged now, oldest first. */
  List<Kick> add(Kick kick) {
    recent.add(kick);
    before = views;
    views = recent.views(before);
    waiting.forEach(w -> w.since++);
    waiting.add(new Waiting(kick));
    List<Kick> ready = new ArrayList<>();
    while (!waiting.isEmpty() && ready(waiting.peek())) {
      ready.add(waiting.remove().kick);
    }
    return ready;
  }

  /** In the order of the kicks, so that one that waits keeps those behind it. */
  private boolean ready(Waiting first) {
    int[] cameras = first.kick.observations().cameras();
    if (hopeless.contains(first.cameras) || settled(cameras)) {
      return true;
    }
    if (first.since >= PATIENCE) {
      // Offsets that were waited for in vain are not waited for again.
      hopeless.add(first.cameras);
      return true;
    }
    return false;
  }

  /** The kicks that still wait; nothing more will be learnt. */
  List<Kick> flush() {
    List<Kick> all = waiting.stream().map(w -> w.kick).toList();
    waiting.clear();
    return all;
  }

  int waiting() {
    return waiting.size();
  }

  CameraViews views() {
    return views;
  }

  Known known(int camera) {
    CameraView view = views.get(camera);
    boolean compared = compared(view);
    return new Known(
        compared ? view.offsetX() : Double.NaN,
        compared ? view.offsetY() : Double.NaN,
        view.camera().isPresent());
  }

  private boolean settled(int[] cameras) {
    CameraView first = views.get(cameras[0]);
    CameraView firstBefore = before.get(cameras[0]);
    for (int i = 1; i < cameras.length; i++) {
      CameraView other = views.get(cameras[i]);
      CameraView otherBefore = before.get(cameras[i]);
      double dx = other.offsetX() - first.offsetX() - otherBefore.offsetX() + firstBefore.offsetX();
      double dy = other.offsetY() - first.offsetY() - otherBefore.offsetY() + firstBefore.offsetY();
      if (!compared(other) || !compared(first) || !(Math.hypot(dx, dy) < SETTLED)) {
        return false;
      }
    }
    return true;
  }

  /** A measured offset is never exactly zero. */
  private static boolean compared(CameraView view) {
    return view.offsetX() != 0 || view.offsetY() != 0;
  }
}
