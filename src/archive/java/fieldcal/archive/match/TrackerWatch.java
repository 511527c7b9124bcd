package fieldcal.archive.match;

import fieldcal.gamelog.TrackerFrame;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Keeps what the trackers of a match say of the ball: 32 bytes a frame, 12 MB for each tracker and hour. */
public final class TrackerWatch {
  /** A match has some four trackers; what more send is left out. */
  private static final int MOST = 8;

  /** Kicks whose starts differ by less are the same one, reported again with a better estimate, s. */
  private static final double SAME_KICK = 0.15;

  private final Map<String, Source> sources = new TreeMap<>();

  /** One tracker. */
  static final class Source {
    private final String name;
    private final String uuid;
    private final List<Report> reports = new ArrayList<>();
    private double[] time = new double[1024];
    private float[] ball = new float[5 * 1024];
    private int size;
    private int frames;
    private boolean ordered = true;

    private Source(String name, String uuid) {
      this.name = name;
      this.uuid = uuid;
    }

    private void add(TrackerFrame frame) {
      frames++;
      frame.kick().ifPresent(kick -> report(kick, frame.time()));
      if (frame.ball().isEmpty()) {
        return;
      }
      ordered &= size == 0 || frame.time() > time[size - 1];
      if (size == time.length) {
        time = Arrays.copyOf(time, 2 * size);
        ball = Arrays.copyOf(ball, 10 * size);
      }
      TrackerFrame.Ball b = frame.ball().get();
      time[size] = frame.time();
      int at = 5 * size++;
      ball[at] = (float) b.x();
      ball[at + 1] = (float) b.y();
      ball[at + 2] = (float) b.vx();
      ball[at + 3] = (float) b.vy();
      ball[at + 4] = (float) b.z();
    }

    /** Brings the frames into the order of their times, since samples are searched by time; of those of the same time the first stays. One frame whose time is far off then costs itself alone. */
    private void order() {
      if (ordered) {
        return;
      }
      Integer[] byTime = new Integer[size];
      Arrays.setAll(byTime, i -> i);
      Arrays.sort(byTime, Comparator.comparingDouble(i -> time[i]));
      double[] times = new double[size];
      float[] balls = new float[5 * size];
      int kept = 0;
      for (int i : byTime) {
        if (kept == 0 || time[i] > times[kept - 1]) {
          times[kept] = time[i];
          System.arraycopy(ball, 5 * i, balls, 5 * kept, 5);
          kept++;
        }
      }
      time = times;
      ball = balls;
      size = kept;
      ordered = true;
    }

    private void report(TrackerFrame.Kick kick, double now) {
      Report newest = reports.isEmpty() ? null : reports.get(reports.size() - 1);
      if (newest == null || Math.abs(kick.start() - newest.kick.start()) > SAME_KICK) {
        newest = new Report();
        reports.add(newest);
      }
      newest.kick = kick;
      if (newest.early == null && now - kick.start() >= EARLY) {
        newest.early = kick;
      }
    }

    String name() {
      return name;
    }

    String uuid() {
      return uuid;
    }

    int frames() {
      return frames;
    }

    List<Report> reports() {
      return reports;
    }

    /** Index of the first sample at or after a time. */
    int from(double t) {
      int index = Arrays.binarySearch(time, 0, size, t);
      return index < 0 ? -index - 1 : index;
    }

    int size() {
      return size;
    }

    double time(int i) {
      return time[i];
    }

    double x(int i) {
      return ball[5 * i];
    }

    double y(int i) {
      return ball[5 * i + 1];
    }

    double vx(int i) {
      return ball[5 * i + 2];
    }

    double vy(int i) {
      return ball[5 * i + 3];
    }
  }

  /** Where a ball will stop is worth knowing while it is on its way, s after the kick. */
  static final double EARLY = 0.3;

  /** A kick as one tracker reports it. */
  static final class Report {
    private TrackerFrame.Kick kick;
    private TrackerFrame.Kick early;

    /** As it was reported last. */
    TrackerFrame.Kick kick() {
      return kick;
    }

    /** As it was reported first {@link #EARLY} after the kick; null when it was not. */
    TrackerFrame.Kick early() {
      return early;
    }
  }

  void accept(TrackerFrame frame) {
    String key = frame.source() + '\n' + frame.uuid();
    Source source = sources.get(key);
    if (source == null && sources.size() < MOST) {
      source = new Source(frame.source(), frame.uuid());
      sources.put(key, source);
    }
    if (source != null) {
      source.add(frame);
    }
  }

  List<Source> sources() {
    sources.values().forEach(Source::order);
    return List.copyOf(sources.values());
  }
}
