package fieldcal.app.sslsim;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Notices when vision is silent and when its clock jumps, by when frames arrived, not by when somebody looked at them. Not thread-safe. */
final class VisionWatch {
  /** Vision that sends nothing for longer is silent, s: 35 frames. */
  private static final double SILENT = 0.5;

  /** A clock whose distance from this machine's changes by more within one frame has jumped, s; networks delay by less. */
  private static final double JUMP = 0.2;

  private static final int MOST = 10;

  private final List<String> told = new ArrayList<>();
  private double begin = Double.NaN;
  private double lastArrived = Double.NaN;
  private double lastApart = Double.NaN;
  private int all;

  /** A frame: when it says it was captured, and when it arrived, s. */
  void frame(double captured, double arrived) {
    begin = Double.isNaN(begin) ? arrived : begin;
    double silence = arrived - lastArrived;
    if (silence > SILENT) {
      tell(String.format(Locale.ROOT, "vision was silent for %.1f s", silence), arrived);
    }
    double apart = captured - arrived;
    double jump = apart - lastApart;
    if (Math.abs(jump) > JUMP) {
      tell(String.format(Locale.ROOT, "vision's clock jumped by %+.2f s", jump), arrived);
    }
    lastArrived = arrived;
    lastApart = apart;
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
