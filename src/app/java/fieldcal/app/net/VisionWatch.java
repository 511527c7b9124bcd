package fieldcal.app.net;

import fieldcal.app.wording.Amount;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Notices when vision is silent and when its clock jumps. A reader that was busy or paused finds frames late; only what is true whenever they came is told. Not thread-safe.
 */
public final class VisionWatch {
  /** Vision that sends nothing for longer is silent, s: 35 frames. */
  private static final double SILENT = 0.5;

  /** A clock whose distance from this machine's changes by more within one frame has jumped, s; networks delay by less. */
  private static final double JUMP = 0.2;

  /** Kicks are cut off where frames are missing for longer, s; as where a recording is searched for kicks. */
  private static final double GAP = 0.25;

  private static final int MOST = 10;

  private final List<String> told = new ArrayList<>();
  private double begin = Double.NaN;
  private Arrival last;
  private double lastCaptured;
  private int all;
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
      double step = captured - lastCaptured;
      whole = isWhole(step, arrived);
      compare(step, arrived);
    }
    last = arrived;
    lastCaptured = captured;
    return whole;
  }

  private boolean isWhole(double step, Arrival arrived) {
    boolean jumped = step > arrived.latest() - last.earliest() + JUMP;
    boolean silent = arrived.seamless() && arrived.earliest() - last.latest() > GAP;
    return step < GAP || jumped || silent;
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
      jumps += jump;
      String by = Amount.minus(String.format(Locale.ROOT, "%+.2f s", jump));
      tell("vision's clock jumped by " + by, arrived.latest());
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
    return List.copyOf(told);
  }

  /**
   * A summary for the end.
   *
   * @return one line, or none when nothing happened
   */
  public List<String> notes() {
    return all == 0
        ? List.of()
        : List.of(
            all == 1
                ? "vision: 1 silence or jump of its clock"
                : "vision: " + all + " silences and jumps of its clock");
  }
}
