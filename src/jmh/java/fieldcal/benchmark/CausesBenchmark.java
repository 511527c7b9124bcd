package fieldcal.benchmark;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.play.EndedSession;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.SessionRequest;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.kick.KickKind;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallPhysics;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;

/**
 * How many kicks it takes until a diagnosis names the cause that is there and no other: chosen for what they tell, against spread; after a session that ended with its kicks along one line, which leave
 * two causes that look alike there, and from the first kick of all. 4 fields per run.
 */
final class CausesBenchmark {
  private static final int FIELDS_PER_RUN = 4;
  private static final int KICKS = 12;

  /** The first half of a session's kicks goes to and fro on one line. */
  private static final int ONE_LINE = KICKS / 2;

  /** A diagnosis needs so many kicks. */
  private static final int FEWEST = 4;

  private static final double BETWEEN = 1800;

  /** A solid ball, as the effects have it, so that nothing else is wrong. */
  private static final BallPhysics SOLID =
      BallPhysics.ideal(-3.1, -0.28, 5.0 / 7, 0.75, 0.95, 0.52);

  /** Along the first diagonal of the play, where one brakes one way as the other does. */
  private static final List<String> CAUSES =
      List.of("field_slope:percent=0.04,direction=0.6", "carpet_nap:amplitude=0.015,direction=0.6");

  private CausesBenchmark() {}

  static void run(BenchmarkSettings settings, PrintStream out) throws IOException {
    int fields = FIELDS_PER_RUN * settings.runs();
    out.printf(
        "kicks until the cause that is there is named and no other can be, %d fields each; %d ="
            + " never%n",
        fields, KICKS + 1);
    out.printf(
        "%-20s %-44s %-9s %6s %6s %7s %5s%n",
        "", "cause", "plan", "fields", "mean", "median", "most");
    for (boolean afterOneLine : new boolean[] {false, true}) {
      for (String cause : CAUSES) {
        for (boolean adaptive : new boolean[] {false, true}) {
          row(afterOneLine, cause, adaptive, fields, settings.seed(), out);
        }
      }
    }
  }

  private static void row(
      boolean afterOneLine,
      String cause,
      boolean adaptive,
      int fields,
      long firstSeed,
      PrintStream out)
      throws IOException {
    List<Integer> kicks = new ArrayList<>();
    for (int i = 0; i < fields; i++) {
      kicks(cause, afterOneLine, adaptive, 41_000 + 1000 * firstSeed + i).ifPresent(kicks::add);
    }
    double[] n = kicks.stream().mapToDouble(k -> k).sorted().toArray();
    out.printf(
        "%-20s %-44s %-9s %6d %6.2f %7.1f %5.0f%n",
        afterOneLine ? "undecided till then" : "from the first kick",
        cause,
        adaptive ? "adaptive" : "spread",
        n.length,
        Arrays.stream(n).average().orElse(Double.NaN),
        n.length == 0 ? Double.NaN : 0.5 * (n[(n.length - 1) / 2] + n[n.length / 2]),
        n.length == 0 ? Double.NaN : n[n.length - 1]);
  }

  /** Empty when the first session left nothing undecided. */
  private static OptionalInt kicks(String cause, boolean afterOneLine, boolean adaptive, long seed)
      throws IOException {
    try (Scratch scratch = new Scratch("fieldcal-causes-benchmark")) {
      Path directory = scratch.path();
      int before = 0;
      if (afterOneLine) {
        play(cause, false, seed, 0, directory, ONE_LINE);
        Diagnosis one =
            first(KICKS, PlayRun.calibrate(directory, CalibrationSession.Progress.UNSEEN));
        if (one.causes().stream().allMatch(c -> c.indistinguishableFrom().isEmpty())) {
          return OptionalInt.empty();
        }
        before = one.kicks().size();
      }
      play(cause, adaptive, seed, BETWEEN, directory, KICKS);
      CalibrationOutcome all = PlayRun.calibrate(directory, CalibrationSession.Progress.UNSEEN);
      for (int n = Math.max(1, FEWEST - before); n <= KICKS; n++) {
        if (isNamed(cause.split(":")[0], first(before + n, all))) {
          return OptionalInt.of(n);
        }
      }
      return OptionalInt.of(KICKS + 1);
    }
  }

  private static void play(
      String cause, boolean adaptive, long seed, double later, Path directory, int enough)
      throws IOException {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, KICKS).withChoice(adaptive, seed).into(directory);
    SimulationSettings world =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withPhysics(SOLID)
            .withEffects(List.of(EffectSetting.parse(cause)));
    EndedSession.play(world, request, later, enough);
  }

  private static Diagnosis first(int n, CalibrationOutcome outcome) {
    return new Diagnoser().diagnose(EndedSession.firstKicks(outcome, n), said -> {});
  }

  private static boolean isNamed(String id, Diagnosis diagnosis) {
    List<Cause> causes = diagnosis.causes();
    return causes.size() == 1
        && causes.get(0).effect().id().equals(id)
        && causes.get(0).indistinguishableFrom().isEmpty();
  }
}
