package fieldcal.app.net;

import java.util.List;
import java.util.Locale;

/**
 * Notices when vision is silent and when its clock jumps. A reader that was busy or paused finds frames late; only what is true whenever they came is told. Not thread-safe.
 */
public final class VisionWatch {
  /** Vision that sends nothing for longer is silent, s: 35 frames. */
  private static final double SILENT = 0.5;

  /** Kicks are cut off where frames are missing for longer, s; as where a recording is searched for kicks. */
  private static final double GAP = 0.25;

  private final Happenings happenings =
      new Happenings(
          "vision keeps falling silent, or its clock keeps jumping; from now on this is only"
              + " counted");
  private double begin = Double.NaN;
  private final FrameLateness lateness = new FrameLateness();
  private Arrival last;
  private double lastCaptured;
  private double jumps;

  /**
   * Takes a frame.
   *
   * @param captured when it says it was captured, s
   * @param arrived when it came
   * @return false when frames are missing before it that this reader may have lost, since it was late: that is no silence of vision
   */
  public boolean frame(double captured, Arrival arrived) {
    begin = Double.isNaN(begin) ? arrived.latest() : begin;
    boolean whole = true;
    if (last != null) {
      whole = isWhole(captured, arrived);
      // Frames keep their order: this one came that long after the last one, or later.
      double silent = arrived.earliest() - last.latest();
      if (arrived.seamless() && silent > SILENT) {
        tell(String.format(Locale.ROOT, "vision was silent for %.1f s", silent), arrived.latest());
      }
    }
    double jump = lateness.take(captured, arrived);
    if (jump != 0) {
      jumps += jump;
      String by = String.format(Locale.ROOT, "%+.2f s", jump).replace('-', '−');
      tell("vision's clock jumped by " + by, arrived.latest());
    }
    last = arrived;
    lastCaptured = captured;
    return whole;
  }

  private boolean isWhole(double captured, Arrival arrived) {
    boolean silent = arrived.seamless() && arrived.earliest() - last.latest() > GAP;
    return captured - lastCaptured < GAP || silent || lateness.isTooEarly(captured, arrived);
  }

  private void tell(String what, double at) {
    happenings.add(
        String.format(Locale.ROOT, "%s, %.0f s after its first frame", what, at - begin));
  }

  /**
   * By how much the clock has jumped in all.
   *
   * @return forward, s
   */
  public double jumps() {
    return jumps;
  }

  /**
   * What happened, as it happened.
   *
   * @return a sentence each; none ever changes or goes away
   */
  public List<String> complaints() {
    return happenings.told();
  }

  /**
   * A summary for the end.
   *
   * @return one line, or none when nothing happened
   */
  public List<String> notes() {
    int all = happenings.count();
    return switch (all) {
      case 0 -> List.of();
      case 1 -> List.of("vision: 1 silence or jump of its clock");
      default -> List.of("vision: " + all + " silences and jumps of its clock");
    };
  }
}
