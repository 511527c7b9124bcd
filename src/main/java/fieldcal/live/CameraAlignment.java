package fieldcal.live;

import fieldcal.fit.CameraNoise;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.LensCheck;
import fieldcal.fit.OverlapOffsets;
import fieldcal.kick.Kick;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;

/**
 * What the cameras add to their reports, learnt from the kicks of the match, and taken out before a kick is judged: cameras disagree by centimetres on every field, and a step of that size in the middle of a
 * kick is worth 25 % in accSlide. A kick that several cameras saw waits until the offsets between them are settled, some kicks at most.
 */
final class CameraAlignment {
  /** The kicks that offsets and noise are estimated from; cameras move when somebody bumps into a mount, so not all of a match. */
  private static final int MEMORY = 60;

  /** Offsets that moved less with the last kick are settled, m: the noise of a camera. */
  private static final double SETTLED = 0.002;

  /** Cameras that share no ball never settle; after so many further kicks a kick is judged as it is. */
  private static final int PATIENCE = 8;

  private final Deque<Kick> recent = new ArrayDeque<>();
  private final Deque<Waiting> waiting = new ArrayDeque<>();
  private CameraViews published = CameraViews.of(List.of());
  private CameraViews before = published;

  /** Read by other threads. */
  private volatile CameraViews views = published;

  /** A kick that waits since some kicks. */
  private static final class Waiting {
    private final Kick kick;
    private int since;

    Waiting(Kick kick) {
      this.kick = kick;
    }
  }

  /** What is known of one camera. NaN where it is not. */
  record Known(double noise, double offsetX, double offsetY, boolean calibrated) {
    static final Known NOTHING = new Known(Double.NaN, Double.NaN, Double.NaN, false);
  }

  /** The cameras' geometry changed: what was learnt of the old one is forgotten, and kicks that wait are dropped; how many is returned. */
  int restart(CameraViews geometry) {
    int lost = waiting.size();
    recent.clear();
    waiting.clear();
    published = geometry;
    views = geometry;
    before = geometry;
    return lost;
  }

  /** Learns from a kick; returns those that can be judged now, oldest first. */
  List<Kick> add(Kick kick) {
    recent.add(kick);
    if (recent.size() > MEMORY) {
      recent.remove();
    }
    learn();
    waiting.forEach(w -> w.since++);
    waiting.add(new Waiting(kick));
    List<Kick> ready = new ArrayList<>();
    for (Iterator<Waiting> i = waiting.iterator(); i.hasNext(); ) {
      Waiting w = i.next();
      if (w.since >= PATIENCE || settled(w.kick)) {
        ready.add(w.kick);
        i.remove();
      }
    }
    return ready;
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
    boolean measured = view.noise() != CameraView.DEFAULT_NOISE;
    return new Known(
        measured ? view.noise() : Double.NaN,
        compared ? view.offsetX() : Double.NaN,
        compared ? view.offsetY() : Double.NaN,
        view.camera().isPresent());
  }

  private void learn() {
    List<Kick> kicks = List.copyOf(recent);
    CameraViews all = withUnpublished(kicks);
    CameraViews known =
        LensCheck.usable(kicks, all).map(v -> v.withNoise(views.get(v.id()).noise()));
    before = views;
    views = OverlapOffsets.estimate(kicks, CameraNoise.measured(kicks, known));
  }

  private CameraViews withUnpublished(List<Kick> kicks) {
    TreeSet<Integer> ids = new TreeSet<>();
    kicks.forEach(
        k -> {
          for (int id : k.observations().cameras()) {
            ids.add(id);
          }
        });
    List<CameraView> all = new ArrayList<>(published.all());
    all.forEach(v -> ids.remove(v.id()));
    ids.forEach(id -> all.add(CameraView.of(id, Optional.empty())));
    return CameraViews.of(all);
  }

  private boolean settled(Kick kick) {
    int[] cameras = kick.observations().cameras();
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
