package fieldcal.app.sslsim;

import fieldcal.app.net.Arrival;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Notices when vision is silent and when its clock jumps. A reader that was busy or paused finds frames late; only what is true whenever they came is told. Not thread-safe.
 */
final class VisionWatch {
  /** Vision that sends nothing for longer is silent, s: 35 frames. */
  private static final double SILENT = 0.5;

  /** A clock whose distance from this machine's changes by more within one frame has jumped, s; networks delay by less. */
  private static final double JUMP = 0.2;

  private static final int MOST = 10;

  private final List<String> told = new ArrayList<>();
  private double begin = Double.NaN;
  private Arrival last;
  private double lastCaptured;
  private int all;

  /** A frame: when it says it was captured, s, and when it arrived. */
  void frame(double captured, Arrival arrived) {
    begin = Double.isNaN(begin) ? arrived.latest() : begin;
    if (last != null) {
      compare(captured - lastCaptured, arrived);
    }
    last = arrived;
    lastCaptured = captured;
  }

  private void compare(double step, Arrival arrived) {
    // Frames keep their order: this one came between these two times after the last one.
    double soonest = Math.max(0, arrived.earliest() - last.latest());
    double latest = arrived.latest() - last.earliest();
    if (arrived.seamless() && soonest > SILENT) {
      tell(String.format(Locale.ROOT, "vision was silent for %.1f s", soonest), arrived.latest());
    }
    if (step < soonest - JUMP || step > latest + JUMP) {
      double jump = step - (arrived.latest() - last.latest());
      tell(String.format(Locale.ROOT, "vision's clock jumped by %+.2f s", jump), arrived.latest());
    }
  }

  private void tell(String what, double at) {
    all++;
    if (all <= MOST) {
      told.add(String.format(Locale.ROOT, "%s, %.0f s after its first frame", what, at - begin));
    } else if (all == MOST + 1) {
      told.add(
          "vision keeps falling silent, or its clock keeps jumping; from now on this is only"
              + " counted");
    }
  }

  /** As it happened; none ever changes or goes away. */
  List<String> complaints() {
    return List.copyOf(told);
  }

  /** For the end. */
  List<String> notes() {
    return all == 0
        ? List.of()
        : List.of(
            all == 1
                ? "vision: 1 silence or jump of its clock"
                : "vision: " + all + " silences and jumps of its clock");
  }
}
