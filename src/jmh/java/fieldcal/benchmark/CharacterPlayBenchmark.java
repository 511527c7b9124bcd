package fieldcal.benchmark;

import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.ServedField;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import fieldcal.simulation.robot.RobotCharacter;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Plays over UDP on loopback against what {@code simulate --serve} serves, with each character of robots and of vision by itself, and with all of them: one flat session and one of chips each. In real time and one after the other, a quarter
 * of an hour per run.
 */
final class CharacterPlayBenchmark {
  private static final int KICKS = 4;

  /** Time after which a session that has not ended hangs, s: more than twice the longest of 720 drawn plays with six kicks and eight troubles, 128 s. */
  private static final double HANGS = 300;

  /** Goal of the time until the first kick, s. */
  private static final double LATEST_START = 40;

  private CharacterPlayBenchmark() {}

  /** What one served field is like. */
  private record Pair(Set<RobotCharacter> robots, Set<VisionCharacter> vision) {
    @Override
    public String toString() {
      String like =
          robots.stream().map(RobotCharacter::label).collect(Collectors.joining(","))
              + " / "
              + vision.stream().map(VisionCharacter::label).collect(Collectors.joining(","));
      return like.length() < 46
          ? like
          : robots.size() + " robots' / " + vision.size() + " visions'";
    }
  }

  /**
   * How one session went.
   *
   * @param outcome of the play
   * @param watch of the true field
   * @param began time of the first snapshot, s
   */
  private record Session(PlaySession.Outcome outcome, FieldWatch watch, double began) {
    double firstKick() {
      SessionSnapshot last = outcome.last();
      double at = last.kicks().isEmpty() ? last.time() : last.kicks().get(0).played().time();
      return at - began;
    }

    boolean inTime() {
      return !outcome.last().kicks().isEmpty() && firstKick() <= LATEST_START;
    }
  }

  /** Each character of robots with good vision, each of vision with good robots, and all together, with noise and without. */
  private static List<Pair> pairs() {
    List<Pair> pairs = new ArrayList<>();
    for (RobotCharacter robots : RobotCharacter.values()) {
      pairs.add(new Pair(EnumSet.of(robots), EnumSet.of(VisionCharacter.IDEAL)));
    }
    for (VisionCharacter vision : EnumSet.complementOf(EnumSet.of(VisionCharacter.IDEAL))) {
      pairs.add(new Pair(EnumSet.of(RobotCharacter.IDEAL), EnumSet.of(vision)));
    }
    Set<RobotCharacter> robots = EnumSet.complementOf(EnumSet.of(RobotCharacter.IDEAL));
    pairs.add(
        new Pair(
            robots,
            EnumSet.complementOf(EnumSet.of(VisionCharacter.IDEAL, VisionCharacter.NOISELESS))));
    pairs.add(new Pair(robots, EnumSet.complementOf(EnumSet.of(VisionCharacter.IDEAL))));
    return pairs;
  }

  static void run(BenchmarkSettings settings, PrintStream out) throws IOException {
    out.printf(
        "%-46s %-5s %-9s %6s %10s %12s %10s %8s%n",
        "robots / vision", "kind", "kicks", "made", "first kick", "contact", "edge", "session");
    List<Session> sessions = new ArrayList<>();
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      for (int run = 0; run < settings.runs(); run++) {
        long seed = 1000 * settings.seed() + 100 * run;
        for (Pair pair : pairs()) {
          for (KickKind kind : KickKind.values()) {
            Session session = play(pair, kind, seed++, threads);
            sessions.add(session);
            print(pair, kind, session, out);
          }
        }
      }
    } finally {
      threads.shutdown();
    }
    total("sessions with all kicks", sessions, s -> s.outcome().complete(), out);
    total("first kick within 40 s", sessions, Session::inTime, out);
    total("no contact above 0.1 m/s", sessions, s -> !s.watch().hurt(), out);
    total("nobody outside the margin", sessions, s -> !s.watch().outside(), out);
  }

  private static void total(
      String what, List<Session> sessions, Predicate<Session> which, PrintStream out) {
    long count = sessions.stream().filter(which).count();
    Goal all = Goal.atLeast(sessions.size(), "%.0f");
    out.printf("%s: %d, goal %s: %s%n", what, count, all, all.verdict(count));
  }

  private static Session play(Pair pair, KickKind kind, long seed, ExecutorService threads)
      throws IOException {
    SessionRequest request = SessionRequest.of(kind, KICKS).withChoice(false, seed);
    InteractiveField field =
        ServedField.now(
                VisionCharacter.apply(pair.vision(), SimulationSettings.DEFAULT.withSeed(seed)),
                request.first(),
                request.second(),
                List.of(),
                System.currentTimeMillis() * 1_000_000L)
            .robotsLike(pair.robots());
    FieldWatch watch = new FieldWatch(field);
    double[] began = {Double.NaN};
    PlaySession[] session = new PlaySession[1];
    PlaySession.Outcome outcome;
    try (LoopbackSimulator simulator =
        new LoopbackSimulator(field, Impairment.NONE, seed, watch::look, threads)) {
      session[0] =
          new PlaySession(
              request,
              simulator.open(),
              s -> {
                began[0] = Double.isNaN(began[0]) ? s.time() : began[0];
                if (s.time() - began[0] > HANGS) {
                  session[0].abort("hangs");
                }
              });
      outcome = session[0].run();
    }
    return new Session(outcome, watch, began[0]);
  }

  private static void print(Pair pair, KickKind kind, Session session, PrintStream out) {
    SessionSnapshot last = session.outcome().last();
    boolean complete = session.outcome().complete();
    out.printf(
        "%-46s %-5s %-9s %6d %8.1f s %8.2f m/s %7.0f mm %6.0f s%s%n",
        pair,
        kind.id(),
        complete ? "all" : "NOT all",
        last.state().made(),
        session.firstKick(),
        session.watch().contactSpeed(),
        1000 * session.watch().nearestEdge(),
        last.time() - session.began(),
        complete ? "" : ": " + last.state().waiting().orElse("no reason"));
  }
}
