package fieldcal.diagnosis;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationRequest;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.FieldcalProcess;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.Scratch;
import fieldcal.calibration.HandSelection;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.effect.EffectCatalogue;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Wall time and memory of {@code ./fieldcal diagnose} as the operator has it, a process of its own with its report, on recordings of 24 kicks with different causes in them; and time of the score tests alone, of all
 * effects that act everywhere, warm.
 */
public final class DiagnosisSpeed {
  private static final Goal SECONDS = Goal.atMost(5, "%.0f s");
  private static final Goal MANY_SECONDS = Goal.atMost(10, "%.0f s");

  /** So many causes take longer. */
  private static final int MANY = 4;

  private static final Goal SCORES = Goal.atMost(1, "%.0f s");
  private static final Goal MEGABYTES = Goal.atMost(400, "%.0f MB");
  private static final String[] KICKS = {"--scenario", "mixed", "--kicks", "24"};

  /** From nothing to what takes longest: bounces, and two and four at once. */
  private static final List<List<String>> WORLDS =
      List.of(
          List.of(),
          List.of("air_drag:cd=0.45"),
          List.of("camera_offset:x_mm=20,y_mm=-8,camera=1"),
          List.of("bounce_spin_coupling:coefficient=0.1"),
          List.of("worn_region:change=0.2,region=[-3,0,-2,1]", "kick_spin:fraction=-0.3"),
          List.of(
              "air_drag:cd=0.45",
              "camera_offset:x_mm=20,y_mm=-8,camera=1",
              "field_slope:percent=0.2,direction=0.5",
              "bounce_spin_coupling:coefficient=0.1"));

  private DiagnosisSpeed() {}

  /**
   * Measures.
   *
   * @param settings of which the seed counts
   * @param out where to
   * @param findings the numbers of the page
   * @throws Exception when a program cannot be run
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws Exception {
    Path project = Path.of(System.getProperty("fieldcal.projectDir", ".")).toAbsolutePath();
    try (Scratch scratch = new Scratch("diagnosis-benchmark")) {
      Path directory = scratch.path();
      FieldcalProcess.run(project, List.of("--help")); // builds, when something has changed
      out.printf(
          "%-50s %10s %9s %10s %9s%n", "", "detections", "diagnose", "resident", "all scores");
      boolean met = true;
      double largest = 0;
      double scores = 0;
      for (int w = 0; w < WORLDS.size(); w++) {
        Path log = directory.resolve("world" + w + ".log.gz");
        FieldcalProcess.run(project, simulation(WORLDS.get(w), settings.seed() + w, log));
        List<String> words = new ArrayList<>(List.of("diagnose", log.toString()));
        words.addAll(List.of("--out", directory.resolve("out").toString()));
        FieldcalProcess.Used used = FieldcalProcess.run(project, words);
        DiagnosisProblem problem = problem(log);
        double scored = scores(problem);
        int detections = problem.fits().stream().mapToInt(f -> f.statistics().used()).sum();
        out.printf(
            Locale.ROOT,
            "%-50s %10d %7.1f s %7.0f MB %7.2f s%n",
            WORLDS.get(w).isEmpty() ? "nothing" : String.join(" + ", WORLDS.get(w)),
            detections,
            used.seconds(),
            used.megabytes(),
            scored);
        Goal goal = WORLDS.get(w).size() < MANY ? SECONDS : MANY_SECONDS;
        met &= goal.met(used.seconds());
        findings.value(
            "`./fieldcal diagnose`, " + name(WORLDS.get(w)), "%.1f s", used.seconds(), goal);
        largest = Math.max(largest, used.megabytes());
        scores = Math.max(scores, scored);
      }
      out.printf("diagnose %s, of four causes %s: %s%n", SECONDS, MANY_SECONDS, Goal.verdict(met));
      out.printf("resident memory %s: %s%n", MEGABYTES, MEGABYTES.verdict(largest));
      out.printf("score tests %s: %s%n", SCORES, SCORES.verdict(scores));
      findings.value("resident memory, largest", "%.0f MB", largest, MEGABYTES);
      findings.value("score tests of all effects alone, slowest", "%.2f s", scores, SCORES);
    }
  }

  /** The causes without their sizes. */
  private static String name(List<String> world) {
    return switch (world.size()) {
      case 0 -> "nothing hidden";
      case 1 -> "one cause: " + ids(world);
      case 2 -> "two causes: " + ids(world);
      default -> "four causes: " + ids(world);
    };
  }

  private static String ids(List<String> world) {
    return String.join(
        ", ", world.stream().map(e -> e.replaceFirst(":.*", "").replace('_', ' ')).toList());
  }

  private static List<String> simulation(List<String> effects, long seed, Path log) {
    List<String> words = new ArrayList<>(List.of("simulate"));
    words.addAll(List.of(KICKS));
    effects.forEach(e -> words.addAll(List.of("--effect", e)));
    words.addAll(List.of("--seed", Long.toString(seed), "--out", log.toString()));
    return words;
  }

  private static DiagnosisProblem problem(Path log) throws IOException {
    CalibrationOutcome calibration =
        new CalibrationSession(FitSettings.defaults())
            .run(
                CalibrationRequest.of(List.of(log), HandSelection.none(), List.of()),
                CalibrationSession.Progress.UNSEEN);
    return new DiagnosisSession(FitSettings.defaults(), 1)
        .diagnose(calibration, said -> {})
        .problem();
  }

  /** Fastest of three, s. */
  private static double scores(DiagnosisProblem problem) {
    FittedField field = FittedField.of(problem);
    Alternatives all =
        new Alternatives(field.fitter(), new Dictionary(EffectCatalogue.all(), field.arena()));
    double[] seconds = new double[3];
    for (int i = 0; i < seconds.length; i++) {
      long before = System.nanoTime();
      all.scores(field.simple());
      seconds[i] = (System.nanoTime() - before) * 1e-9;
    }
    return Arrays.stream(seconds).min().orElseThrow();
  }
}
