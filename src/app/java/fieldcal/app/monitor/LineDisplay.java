package fieldcal.app.monitor;

import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.RefereeWords;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.LimitWarning;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveWarning;
import java.io.PrintWriter;
import java.time.ZoneId;
import java.util.HashSet;
import java.util.Set;

/** A match as plain lines, for files and pipes: warnings, what the referee changes, every kick; at the end the whole state. */
public final class LineDisplay implements MatchDisplay {
  private final PrintWriter out;
  private final MatchText text;
  private final Set<String> faults = new HashSet<>();
  private boolean begun;
  private boolean refereeHeard;
  private boolean silent;

  /**
   * A display.
   *
   * @param out gets the lines
   * @param zone of the times of day
   */
  public LineDisplay(PrintWriter out, ZoneId zone) {
    this.out = out;
    text = new MatchText(zone);
  }

  private synchronized void line(String line) {
    out.println(line);
    out.flush();
  }

  @Override
  public void show(MatchStatus status) {
    if (!begun) {
      begun = true;
      line("watching " + status.feed().title());
    }
    if (status.feed().silent() != silent) {
      silent = !silent;
      line(silent ? status.feed().notes().get(0) : "vision is back");
    }
    faults(status);
  }

  /** A match may last for hours: a camera that is not used is named when that is known, and not again in the state at the end. */
  private void faults(MatchStatus status) {
    for (String fault : CameraFaultText.lines(status.snapshot().cameraFaults())) {
      if (faults.add(MatchText.fault(fault))) {
        line(fault);
      }
    }
  }

  @Override
  public void referee(RefereeState state, double time) {
    // What it says first may have been so for minutes.
    String says = refereeHeard ? "  referee: " : "  referee is heard: ";
    refereeHeard = true;
    line(text.clock(time) + says + RefereeWords.of(state));
  }

  @Override
  public void refereeLost() {
    refereeHeard = false;
    line("the referee is silent: everything counts");
  }

  @Override
  public void kick(LiveKick kick) {
    line(text.kick(kick));
  }

  @Override
  public void warningRaised(LiveWarning warning) {
    String words = ParameterWords.spelledOut(warning.text());
    line(text.clock(warning.time()) + "  WARNING  " + words + ". " + warning.advice());
  }

  @Override
  public void warningCleared(LiveWarning warning) {
    line(
        text.clock(warning.time())
            + "  warning ended: "
            + ParameterWords.spelledOut(warning.text()));
  }

  @Override
  public void limitWarningRaised(LimitWarning warning) {
    line(text.clock(warning.time()) + "  WARNING  " + warning.text() + ". " + warning.advice());
  }

  @Override
  public void limitWarningCleared(LimitWarning warning) {
    line(text.clock(warning.time()) + "  warning ended: " + warning.text());
  }

  @Override
  public boolean watched() {
    return !out.checkError();
  }

  @Override
  public void summary(MatchStatus status) {
    faults(status);
    line("");
    text.summary(status, MatchText.UNBROKEN).stream()
        .filter(line -> !faults.contains(line))
        .forEach(this::line);
  }
}
