package fieldcal.benchmark;

import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.FieldTrouble;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.Preset;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.vision.Epoch;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;

/** Seeded plays on the embedded field with random troubles: how they end, and whether anybody is hurt. 40 plays per run. */
final class PlayBenchmark {
  private static final int PLAYS_PER_RUN = 40;
  private static final int KICKS = 6;
  private static final int TROUBLES = 8;

  /** Field time after which a play that has not ended hangs, s. */
  private static final double HANGS = 1800;

  /** Goal of the time until the first kick, s. */
  private static final double LATEST_START = 40;

  private PlayBenchmark() {}

  /** Passes everything on and looks at the true field in every tick. */
  private static final class Watched implements PlayField {
    private final EmbeddedPlayField inner;
    private final FieldWatch watch;
    private double begun = Double.NaN;

    Watched(InteractiveField field) {
      watch = new FieldWatch(field);
      inner = new EmbeddedPlayField(field, Double.POSITIVE_INFINITY);
    }

    @Override
    public Epoch epoch() {
      return inner.epoch();
    }

    @Override
    public double next(Receiver receiver) throws IOException {
      double now = inner.next(receiver);
      begun = Double.isNaN(begun) ? now : begun;
      watch.look();
      return now;
    }

    @Override
    public void order(List<RobotOrder> orders) {
      inner.order(orders);
    }

    @Override
    public void layBall(BallRequest request) {
      inner.layBall(request);
    }

    @Override
    public Permission permission() {
      return inner.permission();
    }

    @Override
    public boolean goesOnByItself() {
      return inner.goesOnByItself();
    }

    @Override
    public void close() {
      inner.close();
    }
  }

  static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws IOException {
    int plays = PLAYS_PER_RUN * settings.runs();
    Map<String, Integer> reasons = new TreeMap<>();
    int well = 0;
    int hangs = 0;
    int hurt = 0;
    int outside = 0;
    double hardest = 0;
    double nearest = Double.POSITIVE_INFINITY;
    double[] times = new double[plays];
    double[] starts = new double[plays];
    double longest = 0;
    for (int i = 0; i < plays; i++) {
      long seed = 1000 * settings.seed() + i;
      SessionRequest request = request(i, seed);
      Watched field = new Watched(field(request, i, seed));
      PlaySession[] session = new PlaySession[1];
      session[0] =
          new PlaySession(
              request,
              field,
              s -> {
                if (s.time() > HANGS) {
                  session[0].abort("hangs");
                }
              });
      PlaySession.Outcome outcome = session[0].run();
      times[i] = outcome.last().time();
      starts[i] =
          outcome.last().kicks().isEmpty()
              ? outcome.last().time()
              : outcome.last().kicks().get(0).played().time() - field.begun;
      if (outcome.complete()) {
        well++;
      } else {
        String reason = outcome.last().state().waiting().orElse("no reason");
        hangs += reason.equals("hangs") || reason.equals("no reason") ? 1 : 0;
        reasons.merge(reason, 1, Integer::sum);
        out.printf("play %d, seed %d, %s: %s%n", i, seed, request.kind().id(), reason);
      }
      double undisturbed = undisturbed(seed, starts[i]);
      longest = Math.max(longest, undisturbed);
      if (starts[i] > LATEST_START) {
        out.printf(
            "play %d, seed %d: first kick after %.1f s, %.1f s after the last trouble%n",
            i, seed, starts[i], undisturbed);
      }
      if (field.watch.hurt() || field.watch.outside()) {
        out.printf(
            "play %d, seed %d: contact %.2f m/s, edge %.3f m%n",
            i, seed, field.watch.contactSpeed(), field.watch.nearestEdge());
      }
      hurt += field.watch.hurt() ? 1 : 0;
      outside += field.watch.outside() ? 1 : 0;
      hardest = Math.max(hardest, field.watch.contactSpeed());
      nearest = Math.min(nearest, field.watch.nearestEdge());
    }
    Arrays.sort(times);
    Arrays.sort(starts);
    double share = 100.0 * well / plays;
    Goal ended = Goal.atLeast(98, "%.0f %%");
    Goal none = Goal.atMost(0, "%.0f");
    out.printf("%d plays of %d good kicks with %d troubles each%n", plays, KICKS, TROUBLES);
    out.printf("ended with all kicks: %.1f %%, goal %s: %s%n", share, ended, ended.verdict(share));
    reasons.forEach((reason, n) -> out.printf("  %d: %s%n", n, reason));
    out.printf("hangs: %d, goal %s: %s%n", hangs, none, none.verdict(hangs));
    out.printf(
        "contacts above 0.1 m/s: %d plays (hardest %.2f m/s), goal %s: %s%n",
        hurt, hardest, none, none.verdict(hurt));
    out.printf(
        "outside of the margin: %d plays (nearest to its edge %.3f m), goal %s: %s%n",
        outside, nearest, none, none.verdict(outside));
    Goal usual = Goal.atMost(15, "%.0f s");
    Goal slowest = Goal.atMost(LATEST_START, "%.0f s");
    double median = starts[plays / 2];
    double last = starts[plays - 1];
    out.printf(
        "first kick: median after %.1f s, goal %s: %s; last after %.1f s, goal %s: %s%n",
        median, usual, usual.verdict(median), last, slowest, slowest.verdict(last));
    out.printf("first kick after the last trouble before it: at most %.1f s%n", longest);
    out.printf(
        "field time: median %.0f s, 95 %% within %.0f s, longest %.0f s%n",
        times[plays / 2], times[(int) (0.95 * (plays - 1))], times[plays - 1]);
    new Tally(plays, well, hangs, hurt, outside).tell(findings, starts, times);
  }

  /** How many plays, and what happened in them. */
  private record Tally(int plays, int well, int hangs, int hurt, int outside) {
    void tell(Findings findings, double[] starts, double[] times) {
      Goal none = Goal.atMost(0, "%.0f");
      findings.share("plays that ended with all kicks", well, plays, ShareGoal.atLeast(0.98));
      findings.value("plays with a contact above 0.1 m/s, of " + plays, "%.0f", hurt, none);
      findings.value("plays with a robot outside the margin", "%.0f", outside, none);
      findings.value("plays that hang", "%.0f", hangs, none);
      findings.value("first kick, median", "%.1f s", starts[plays / 2], Goal.atMost(15, "%.0f s"));
      findings.value(
          "first kick, last", "%.1f s", starts[plays - 1], Goal.atMost(LATEST_START, "%.0f s"));
      findings.note("field time, median", String.format(Locale.ROOT, "%.0f s", times[plays / 2]));
    }
  }

  /** How long a play took from the last moment at which something began or ended to go wrong until the first kick, s. */
  private static double undisturbed(long seed, double start) {
    double last = 0;
    for (FieldTrouble t : troubles(seed)) {
      for (double moment : new double[] {t.time(), t.time() + t.duration()}) {
        last = moment < start ? Math.max(last, moment) : last;
      }
    }
    return start - last;
  }

  private static List<FieldTrouble> troubles(long seed) {
    return FieldTrouble.random(seed, TROUBLES, 10.0 * KICKS);
  }

  private static SessionRequest request(int i, long seed) {
    KickKind kind = i % 2 == 0 ? KickKind.FLAT : KickKind.CHIP;
    RobotId first = new RobotId(Team.YELLOW, i % 12);
    RobotId second = new RobotId(i % 3 == 0 ? Team.YELLOW : Team.BLUE, (i + 5) % 12);
    return SessionRequest.of(kind, KICKS).withRobots(first, second).withChoice(false, seed);
  }

  /** Each of them in every other play, in all combinations. */
  private static <C extends Enum<C>> Set<C> drawn(Class<C> characters, SplittableRandom random) {
    Set<C> drawn = EnumSet.allOf(characters);
    drawn.removeIf(c -> random.nextBoolean());
    return drawn;
  }

  private static InteractiveField field(SessionRequest request, int i, long seed) {
    SimulationSettings settings = SimulationSettings.DEFAULT.withSeed(seed);
    if (i % 5 == 4) {
      settings = settings.withField(FieldSize.DIVISION_B);
    } else if (i % 5 == 3) {
      settings = Preset.LAB.applyTo(settings);
    }
    SplittableRandom random = new SplittableRandom(seed);
    Set<RobotCharacter> robots = drawn(RobotCharacter.class, random);
    Set<VisionCharacter> vision = drawn(VisionCharacter.class, random);
    return InteractiveField.of(
            VisionCharacter.apply(vision, settings),
            request.first(),
            request.second(),
            troubles(seed))
        .robotsLike(robots);
  }
}
