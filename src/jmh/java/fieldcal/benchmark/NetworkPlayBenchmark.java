package fieldcal.benchmark;

import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.ServedField;
import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * 12 flat kicks and 12 chips over UDP on loopback, on a good network and on a bad one, beside the same in process. In real time: some three minutes per run, both networks at once. One drawn field per run.
 */
public final class NetworkPlayBenchmark {
  private static final int KICKS = 12;

  private NetworkPlayBenchmark() {}

  /** How the play reaches the field. */
  private enum Way {
    IN_PROCESS("in process", Impairment.NONE),
    GOOD("UDP", Impairment.NONE),
    BAD("UDP, 5 % lost, 50 ms late both ways", new Impairment(0.05, 0.05));

    private final String text;
    private final Impairment impairment;

    Way(String text, Impairment impairment) {
      this.text = text;
      this.impairment = impairment;
    }
  }

  /**
   * What came of both sessions.
   *
   * @param joint fit of all kicks
   * @param made kicks
   * @param complete whether both sessions ended with all good kicks
   * @param seconds of field time
   * @param notes of the network and the simulator
   */
  private record Played(
      JointFit joint, int made, boolean complete, double seconds, List<String> notes) {}

  static void run(BenchmarkSettings settings, PrintStream out) throws IOException {
    List<Double> differences = new ArrayList<>();
    int complete = 0;
    for (int i = 0; i < settings.runs(); i++) {
      long seed = 51_000 + 1000 * settings.seed() + i;
      DrawnField field = DrawnField.of(seed);
      Map<Way, Played> played = all(field, seed);
      for (Way way : Way.values()) {
        complete += played.get(way).complete() ? 1 : 0;
        print(out, field, seed, way, played.get(way));
      }
      JointFit here = played.get(Way.IN_PROCESS).joint();
      for (Way way : List.of(Way.GOOD, Way.BAD)) {
        JointFit there = played.get(way).joint();
        field.truth().keySet().forEach(name -> differences.add(difference(name, here, there)));
      }
    }
    long same = differences.stream().filter(d -> Math.abs(d) <= 3).count();
    double worst = differences.stream().mapToDouble(Math::abs).max().orElseThrow();
    double rms = Math.sqrt(differences.stream().mapToDouble(d -> d * d).average().orElseThrow());
    Goal all = Goal.atLeast(differences.size(), "%.0f");
    out.printf("pairs of sessions with all kicks: %d of %d%n", complete, 3 * settings.runs());
    out.printf(
        "over UDP within 3 combined standard errors of the same in process: %d of %d parameters,"
            + " rms %.2f, worst %.2f, goal %s: %s%n",
        same, differences.size(), rms, worst, all, all.verdict(same));
  }

  /**
   * One session of flat kicks and one of chips over a network that loses and delays, in real time.
   *
   * @param seed of field and play
   * @return whether both ended with all kicks
   * @throws IOException when it cannot be run
   */
  public static boolean overBadNetwork(long seed) throws IOException {
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      return served(DrawnField.of(seed), seed, Way.BAD, threads).complete();
    } finally {
      threads.shutdown();
    }
  }

  /** Both networks at the same time; first what needs the whole machine. */
  private static Map<Way, Played> all(DrawnField field, long seed) throws IOException {
    Played here = sessions(seed, kind -> embedded(field, kind, seed));
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      CompletableFuture<Played> good = overNetwork(field, seed, Way.GOOD, threads);
      CompletableFuture<Played> bad = overNetwork(field, seed, Way.BAD, threads);
      return Map.of(Way.IN_PROCESS, here, Way.GOOD, good.join(), Way.BAD, bad.join());
    } finally {
      threads.shutdown();
    }
  }

  private static CompletableFuture<Played> overNetwork(
      DrawnField field, long seed, Way way, ExecutorService threads) {
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return served(field, seed, way, threads);
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        },
        threads);
  }

  /** The served field goes on while one session follows the other. */
  private static Played served(DrawnField drawn, long seed, Way way, ExecutorService threads)
      throws IOException {
    SessionRequest request = request(KickKind.FLAT, seed);
    InteractiveField field =
        ServedField.now(
            drawn.settings(),
            request.first(),
            request.second(),
            List.of(),
            System.currentTimeMillis() * 1_000_000L);
    try (LoopbackSimulator simulator =
        new LoopbackSimulator(field, way.impairment, seed, () -> {}, threads)) {
      return sessions(seed, kind -> simulator.open());
    }
  }

  private static PlayField embedded(DrawnField drawn, KickKind kind, long seed) {
    SessionRequest request = request(kind, seed);
    double later = kind == KickKind.CHIP ? 1800 : 0;
    InteractiveField field =
        InteractiveField.later(
            drawn.settings(), request.first(), request.second(), List.of(), later);
    return new EmbeddedPlayField(field, Double.POSITIVE_INFINITY);
  }

  private static SessionRequest request(KickKind kind, long seed) {
    return SessionRequest.of(kind, KICKS).withChoice(false, seed);
  }

  /** Opens the field for a session. */
  private interface Fields {
    PlayField open(KickKind kind) throws IOException;
  }

  private static Played sessions(long seed, Fields fields) throws IOException {
    try (Scratch scratch = new Scratch("fieldcal-network-benchmark")) {
      Path directory = scratch.path();
      int made = 0;
      boolean complete = true;
      double seconds = 0;
      List<String> notes = new ArrayList<>();
      for (KickKind kind : KickKind.values()) {
        PlayField field = fields.open(kind);
        PlaySession.Outcome outcome =
            new PlaySession(request(kind, seed).into(directory), field, snapshot -> {}).run();
        made += outcome.last().state().made();
        complete &= outcome.complete();
        seconds += outcome.last().time();
        outcome.last().state().waiting().ifPresent(notes::add);
        notes.addAll(field.notes());
      }
      JointFit joint =
          PlayRun.calibrate(directory, CalibrationSession.Progress.UNSEEN)
              .calibration()
              .joint()
              .orElseThrow();
      return new Played(joint, made, complete, seconds, notes);
    }
  }

  private static void print(PrintStream out, DrawnField field, long seed, Way way, Played played) {
    out.printf(
        "seed %d, %s: %s, %d kicks made, %.0f s%s%n",
        seed,
        way.text,
        played.complete() ? "all kicks" : "NOT all kicks",
        played.made(),
        played.seconds(),
        played.notes().isEmpty() ? "" : "; " + String.join("; ", played.notes()));
    field
        .truth()
        .forEach(
            (name, truth) -> {
              Optional<Estimate> e = DrawnField.estimate(played.joint(), name);
              out.printf(
                  "  %-20s %9.5f%s%n",
                  name,
                  e.map(Estimate::value).orElse(Double.NaN),
                  e.map(x -> from(x, truth)).orElse(" is not determined"));
            });
  }

  private static String from(Estimate e, double truth) {
    double off = (e.value() - truth) / e.standardError();
    return String.format(
        Locale.ROOT, " ± %.5f, %+.1f σ from the truth %.5f", e.standardError(), off, truth);
  }

  /** Difference to the play in process in combined standard errors; NaN when one of them does not know. */
  private static double difference(String name, JointFit here, JointFit there) {
    Optional<Estimate> a = DrawnField.estimate(here, name);
    Optional<Estimate> b = DrawnField.estimate(there, name);
    if (a.isEmpty() || b.isEmpty()) {
      return Double.NaN;
    }
    double error = Math.hypot(a.get().standardError(), b.get().standardError());
    return (b.get().value() - a.get().value()) / error;
  }
}
