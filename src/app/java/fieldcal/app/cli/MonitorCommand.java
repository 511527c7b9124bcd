package fieldcal.app.cli;

import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.monitor.LineDisplay;
import fieldcal.app.monitor.MatchDisplay;
import fieldcal.app.monitor.MatchFeed;
import fieldcal.app.monitor.MonitorRequest;
import fieldcal.app.monitor.MonitorSession;
import fieldcal.app.monitor.NetworkFeed;
import fieldcal.app.monitor.ReplayFeed;
import fieldcal.app.monitor.ScreenDisplay;
import fieldcal.app.net.NetworkPlace;
import fieldcal.live.ConfiguredLimits;
import fieldcal.vision.BallModels;
import fieldcal.vision.Team;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code fieldcal monitor}: watches a match, live or recorded. */
@Command(
    name = "monitor",
    mixinStandardHelpOptions = true,
    description =
        "Watches a match, live or recorded: shows the ball model from the last 31 kicks, warns when"
            + " it differs from the published one by more than 20 %%, and shows the movement limits"
            + " of both teams and the state of the cameras. Ctrl-C ends it with a summary.")
final class MonitorCommand implements Callable<Integer> {
  /** Ctrl-C waits so long for the summary, s. */
  private static final long PATIENCE = 5;

  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @ArgGroup(multiplicity = "1")
  private Source source;

  @Option(
      names = "--referee",
      paramLabel = "ADDR:PORT",
      description =
          "multicast address of the referee; the league's is 224.5.23.1:10003. Without it"
              + " everything counts, including breaks")
  private String referee;

  @Option(
      names = "--interface",
      paramLabel = "NAME",
      description = "name or address of the network interface to receive on; default: all of them")
  private String networkInterface;

  @Option(
      names = "--models",
      paramLabel = "FILE",
      description =
          "ball models to compare with: SSL_GeometryModels, binary or text, or a calibration.json;"
              + " default: those that vision publishes")
  private Path models;

  @Option(
      names = "--json",
      paramLabel = "FILE",
      description = "writes one line of JSON per change to this file, as it happens")
  private Path json;

  @Option(
      names = "--state",
      paramLabel = "FILE",
      description =
          "pools matches on the same carpet: starts with the samples in this file, if it exists,"
              + " and writes all samples back at the end")
  private Path state;

  @Option(
      names = "--robot-limits",
      paramLabel = "TEAM:V,A,B",
      description =
          "what a team's robots are configured to do: velocity m/s, acceleration and braking m/s²,"
              + " for example yellow:3,3.5,5; warns when they move differently. May be repeated")
  private final List<String> robotLimits = new ArrayList<>();

  /** One of both. */
  private static final class Source {
    @ArgGroup(exclusive = false)
    private Replay replay;

    @ArgGroup(exclusive = false)
    private Network network;
  }

  /** A running match. */
  private static final class Network {
    @Option(
        names = "--multicast",
        required = true,
        paramLabel = "ADDR:PORT",
        description =
            "where vision sends to; the league's multicast group is 224.5.23.2:10006;"
                + " 255.255.255.255:10006 receives vision that is broadcast")
    private String vision;
  }

  /** A recorded match. */
  private static final class Replay {
    @Option(
        names = "--log",
        required = true,
        paramLabel = "LOG",
        description = "a recorded match, .log or .log.gz")
    private Path log;

    @Option(
        names = "--speed",
        paramLabel = "X",
        description =
            "replays at X times the match's own speed; default: as fast as the machine can")
    private Double speed;
  }

  @Override
  public Integer call() throws IOException {
    OutputPlaces.check(null, json);
    Optional<BallModels> given =
        models == null ? Optional.empty() : Optional.of(InitialModels.read(models));
    MonitorRequest request =
        new MonitorRequest(
            given, Optional.ofNullable(json), Optional.ofNullable(state), configured());
    PrintWriter out = spec.commandLine().getOut();
    try (MatchFeed feed = feed();
        MatchDisplay display =
            TerminalProgress.isTerminal(1)
                ? new ScreenDisplay(new PrintWriter(System.out), ZoneId.systemDefault())
                : new LineDisplay(out, ZoneId.systemDefault())) {
      run(new MonitorSession(request, feed, display));
    }
    return 0;
  }

  private Map<Team, ConfiguredLimits> configured() {
    Map<Team, ConfiguredLimits> all = new EnumMap<>(Team.class);
    for (String text : robotLimits) {
      String[] parts = text.split("[:,]", -1);
      try {
        Team team = Team.valueOf(parts[0].toUpperCase(Locale.ROOT));
        double[] v = Arrays.stream(parts).skip(1).mapToDouble(Double::parseDouble).toArray();
        if (v.length == 3 && !Arrays.stream(v).anyMatch(Double::isNaN)) {
          all.put(team, new ConfiguredLimits(v[0], v[1], v[2]));
          continue;
        }
      } catch (IllegalArgumentException e) {
        // The message below says what is expected.
      }
      throw new ParameterException(
          spec.commandLine(),
          "--robot-limits must be TEAM:V,A,B with positive numbers, like yellow:3,3.5,5, but is '"
              + text
              + "'");
    }
    return all;
  }

  private MatchFeed feed() throws IOException {
    if (source.network != null) {
      return network();
    }
    if (referee != null || networkInterface != null) {
      spec.commandLine()
          .getErr()
          .println(
              "fieldcal: --referee and --interface belong to --multicast; a recording has its own"
                  + " referee");
    }
    return replay();
  }

  private MatchFeed network() throws IOException {
    try {
      NetworkPlace vision = NetworkPlace.parse(source.network.vision, networkInterface);
      Optional<NetworkPlace> whistle =
          referee == null
              ? Optional.empty()
              : Optional.of(NetworkPlace.parse(referee, networkInterface));
      if (vision.address().getPort() == 0
          || whistle.map(w -> w.address().getPort() == 0).orElse(false)) {
        throw new IllegalArgumentException(
            "nobody sends to port 0; the league's vision uses 10006, its referee 10003");
      }
      return new NetworkFeed(vision, whistle);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }

  private MatchFeed replay() throws IOException {
    double speed = source.replay.speed == null ? ReplayFeed.UNLIMITED : source.replay.speed;
    if (source.replay.speed != null && !(speed > 0 && speed < 1e6)) {
      throw new ParameterException(
          spec.commandLine(), "--speed must be a positive number, but is " + speed);
    }
    return new ReplayFeed(source.replay.log, speed, logOptions.opener());
  }

  /** Ctrl-C stops the session, and the machine waits for its summary. */
  private static void run(MonitorSession session) throws IOException {
    CountDownLatch done = new CountDownLatch(1);
    Thread atExit =
        new Thread(
            () -> {
              session.stop();
              try {
                done.await(PATIENCE, TimeUnit.SECONDS);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "fieldcal-monitor-exit");
    Runtime.getRuntime().addShutdownHook(atExit);
    try {
      session.run();
    } finally {
      done.countDown();
      try {
        Runtime.getRuntime().removeShutdownHook(atExit);
      } catch (IllegalStateException e) {
        // The machine is going down already, which is why the session ended.
      }
    }
  }
}
