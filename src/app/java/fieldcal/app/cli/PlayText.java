package fieldcal.app.cli;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.play.KickResult;
import fieldcal.app.play.KickStrength;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.play.SessionSnapshot.Undecided;
import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.calibration.Calibration;
import fieldcal.fit.Estimate;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayState;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;

/** Tells the operator how the play is going, kick by kick, and what came out. */
final class PlayText {
  /** Who looks at a file or a pipe sees that it goes on, ns. */
  private static final long BETWEEN_LINES = 5_000_000_000L;

  /** Causes that go away sooner are not worth a line, s. */
  private static final double LASTS = 2;

  private final PrintWriter out;
  private final boolean onTerminal;
  private final LongSupplier nanoTime;
  private long lastLine;
  private String cause = "";
  private double causeSince;
  private boolean causeTold;
  private final Set<String> complaints = new HashSet<>();
  private final List<Boolean> goodWhenTold = new ArrayList<>();
  private int told;
  private Undecided undecided = new Undecided(List.of(), List.of(), List.of());

  PlayText(PrintWriter out) {
    this(out, TerminalProgress.isTerminal(TerminalProgress.ERROR_STREAM), System::nanoTime);
  }

  /** For an operator at a terminal, or for a file; with a clock in ns. */
  PlayText(PrintWriter out, boolean onTerminal, LongSupplier nanoTime) {
    this.out = out;
    this.onTerminal = onTerminal;
    this.nanoTime = nanoTime;
    lastLine = nanoTime.getAsLong();
  }

  private void line(String format, Object... args) {
    lastLine = nanoTime.getAsLong();
    out.println(String.format(Locale.ROOT, format, args));
    out.flush();
  }

  /** One line for each kick when it is judged; what is being done now in place on a terminal. */
  void follow(SessionSnapshot s, TerminalProgress progress) {
    for (int i = 0; i < told; i++) {
      KickResult k = s.kicks().get(i);
      if (k.good() != goodWhenTold.get(i)) {
        progress.say("");
        goodWhenTold.set(i, k.good());
        line(
            "%3d  %s",
            k.played().number(),
            k.good()
                ? "was judged again, and counts"
                : "was judged again, and does not count: " + k.reason());
      }
    }
    while (told < s.kicks().size() && s.kicks().get(told).verdict().isPresent()) {
      progress.say("");
      if (told == 0) {
        line("kick, robot, kind, commanded → measured speed, residual, what the kick determines");
      }
      goodWhenTold.add(s.kicks().get(told).good());
      kick(s.kicks().get(told++));
    }
    if (!s.undecided().equals(undecided)) {
      progress.say("");
      undecided = s.undecided();
      undecided();
    }
    PlayState state = s.state();
    complaints(state.remarks(), progress);
    waiting(s, progress);
    String now =
        String.format(
            Locale.ROOT,
            "%5.1f s  %d of %d good kicks  %s%s",
            s.time(),
            state.good(),
            state.wanted(),
            state.phase().text(),
            state.waiting().map(w -> ": " + w).orElse(""));
    progress.say(now);
    if (!onTerminal && nanoTime.getAsLong() - lastLine > BETWEEN_LINES) {
      line("     %s", now.trim());
    }
  }

  /** A cause that lasts is told when it comes up, not only at the end. */
  private void waiting(SessionSnapshot s, TerminalProgress progress) {
    String reason = s.state().waiting().orElse("");
    if (!s.ballWanted().isEmpty()) {
      reason =
          String.format(
              Locale.ROOT,
              "please place the ball at (%s, %s) m: %s",
              Amount.decimals(s.ballWanted().get(0), 1),
              Amount.decimals(s.ballWanted().get(1), 1),
              reason);
    }
    if (!reason.equals(cause)) {
      cause = reason;
      causeSince = s.time();
      causeTold = false;
    } else if (!reason.isEmpty() && !causeTold && s.time() - causeSince > LASTS) {
      causeTold = true;
      progress.say("");
      line("     %5.1f s: %s", s.time(), reason);
    }
  }

  /** What is wrong with the other side or a robot is said once, when it comes up. */
  void complaints(List<String> all, TerminalProgress progress) {
    for (String complaint : all) {
      if (complaints.add(complaint)) {
        progress.say("");
        line("     %s", complaint);
      }
    }
  }

  private void undecided() {
    for (String causes : undecided.causes()) {
      String how =
          undecided.sought().contains(causes)
              ? "the next kick is chosen to distinguish them"
              : "no kick of this play can distinguish them";
      line("     undecided: %s; %s", causes, how);
    }
    if (undecided.causes().isEmpty()) {
      line("     all causes are decided now");
    }
  }

  private void kick(KickResult k) {
    String measured =
        Double.isNaN(k.rmsMm())
            ? ""
            : String.format(Locale.ROOT, " → %.2f m/s, %.1f mm rms", k.speed(), k.rmsMm());
    StringBuilder parameters = new StringBuilder();
    for (Estimate e : k.parameters().stream().limit(3).toList()) {
      parameters.append(
          String.format(
              Locale.ROOT,
              "%s %s %s%s",
              parameters.isEmpty() ? " " : ",",
              ParameterWords.words(e.name()),
              CalibrationText.withError(e.value(), e.standardError()).strip(),
              ParameterWords.unit(e.name())));
    }
    line(
        "%3d  %-9s %s %.2f m/s%s%s%s",
        k.played().number(),
        k.played().robot(),
        k.played().planned().chip() ? "chip" : "flat",
        k.played().planned().speed(),
        measured,
        k.used() ? parameters : "",
        k.good() ? "" : "  does not count: " + k.reason());
  }

  void result(
      PlayRun.Result result,
      SessionRequest request,
      Optional<JsonNode> truth,
      Optional<Path> directory) {
    SessionSnapshot last = result.session().last();
    if (result.calibration().isPresent()) {
      CalibrationOutcome outcome = result.calibration().get();
      line("");
      new CalibrationText(out).print(outcome, directory.orElse(null));
      truth.ifPresent(t -> truth(outcome.calibration(), t));
    }
    long usedInPart = last.kicks().stream().filter(k -> k.used() && !k.good()).count();
    line(
        "%n%s after %.0f s of field time: %d good %s of %d made%s.",
        result.session().complete() ? "Finished" : "Stopped",
        last.time(),
        last.state().good(),
        last.state().good() == 1 ? "kick" : "kicks",
        last.state().made(),
        usedInPart == 0
            ? ""
            : ", and "
                + usedInPart
                + " used for the parameters that "
                + (usedInPart == 1 ? "it determines" : "they determine"));
    if (result.session().complete() && last.state().wanted() < request.kicks()) {
      line(
          "Every parameter is known to %s %%, as asked. The rest of the %d kicks is not needed.",
          new DecimalFormat("0.##", DecimalFormatSymbols.getInstance(Locale.ROOT))
              .format(100 * request.precision()),
          request.kicks());
    }
    strengths(result.strengths());
    if (!last.undecided().causes().isEmpty()) {
      line("%nUndecided: %s.", String.join("; ", last.undecided().causes()));
      last.undecided().advice().forEach(advice -> line("  %s", advice));
    }
    directory.ifPresentOrElse(
        d -> line("%nrecording: %s", result.session().log().orElse(d)),
        () -> line("%nThe recording is not kept: --out was not given."));
  }

  private void truth(Calibration calibration, JsonNode truth) {
    line(
        "%nAgainst the truth                          %12s %12s %10s",
        "true", "joint fit", "off by");
    for (KickKind kind : KickKind.values()) {
      boolean flat = kind == KickKind.FLAT;
      if (calibration.kicks(kind).isEmpty()) {
        continue;
      }
      List<Parameter> names =
          flat ? FlatModel.typical().parameters() : ChipModel.typical().parameters().subList(0, 3);
      for (Parameter p : names) {
        JsonNode value = truth.get(ParameterWords.inFiles(p.name()));
        Optional<Estimate> joint = calibration.joint(kind, p.name()).filter(Estimate::usable);
        if (value != null && value.isNumber() && joint.isPresent()) {
          double off = joint.get().value() - value.doubleValue();
          line(
              "  %-40s %12s %12s %8s σ",
              ParameterWords.words(p.name()) + (p.unit().isEmpty() ? "" : ", " + p.unit()),
              Amount.decimals(value.doubleValue(), 5),
              Amount.decimals(joint.get().value(), 5),
              Amount.decimals(off / joint.get().standardError(), 1));
        }
      }
    }
    if (!truth.path("exact_flat").asBoolean(true) || !truth.path("exact_chip").asBoolean(true)) {
      line("  The simulated ball does not obey these models exactly.");
    }
  }

  private void strengths(List<KickStrength> strengths) {
    if (strengths.isEmpty()) {
      return;
    }
    line("%nKick strength: measured speed = offset + gain × commanded speed");
    for (KickStrength s : strengths) {
      line(
          "  %-9s %s, %2d %s: gain %.3f%s%s%s; yaw %s%s°%s",
          s.robot(),
          s.kind().id(),
          s.kicks(),
          s.kicks() == 1 ? "kick" : "kicks",
          s.gain(),
          error(s.gainError(), "%.3f"),
          Double.isNaN(s.offset())
              ? " (no offset: the speeds are too few or too alike)"
              : String.format(
                  Locale.ROOT,
                  ", offset %s%s m/s",
                  signed(s.offset(), "%+.2f"),
                  error(s.offsetError(), "%.2f")),
          Double.isNaN(s.speedScatter())
              ? ""
              : String.format(Locale.ROOT, ", scatter %.2f m/s", s.speedScatter()),
          signed(Math.toDegrees(s.yaw()), "%+.2f"),
          error(Math.toDegrees(s.yawError()), "%.2f"),
          s.kind() == KickKind.CHIP
              ? String.format(
                  Locale.ROOT,
                  "; elevation %s%s°",
                  signed(Math.toDegrees(s.elevation()), "%+.1f"),
                  error(Math.toDegrees(s.elevationError()), "%.1f"))
              : "");
    }
  }

  private static String signed(double value, String format) {
    return Amount.minus(String.format(Locale.ROOT, format, value));
  }

  private static String error(double value, String format) {
    return Double.isNaN(value) ? "" : " ± " + String.format(Locale.ROOT, format, value);
  }
}
