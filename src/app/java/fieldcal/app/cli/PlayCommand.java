package fieldcal.app.cli;

import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.PlayRun;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.play.SessionSnapshot;
import fieldcal.app.simulation.TruthJson;
import fieldcal.app.sslsim.NetworkPlayField;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayLimits;
import fieldcal.play.PlayLine.Half;
import fieldcal.play.PlayState;
import fieldcal.simulation.FieldTrouble;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code fieldcal play}: two robots collect the kicks, and the model comes out. */
@Command(
    name = "play",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description =
        "Two robots kick the ball to each other until there are enough good kicks. Each kick is"
            + " recorded and fitted at once. Ends with a calibrated model.",
    footer = {
      "",
      "Example: fieldcal play --sim --kind flat --kicks 12 --out session",
      "         fieldcal play --sim --kind chip --kicks 12 --out session   (calibrates both"
          + " together)"
    })
final class PlayCommand implements Callable<Integer> {
  /** Sessions of one simulated field begin that far apart, s. */
  private static final double BETWEEN_SESSIONS = 1800;

  /** Kicks that the play can make, m/s. */
  private static final double SLOWEST = 0.7;

  private static final double FASTEST = 10;

  /** More than any robot of the league drives, m/s; chosen. Below, a kick would take minutes. */
  private static final double FASTEST_DRIVE = 10;

  private static final double SLOWEST_DRIVE = 0.1;

  /** Options that only mean something on the simulated field, or only on the network. */
  private static final List<String> SIMULATED =
      List.of(
          "--preset",
          "--like",
          "--effect",
          "--vision-like",
          "--robots-like",
          "--troubles",
          "--pace");

  private static final List<String> NETWORK = List.of("--vision", "--referee", "--interface");

  /** The flattest chip, degrees; chosen: a flatter one does not leave the carpet for long enough to be told from a flat kick. */
  private static final double FLATTEST = 10;

  /** The steepest chip, degrees; the play takes up to 1.4 rad. */
  private static final double STEEPEST = 80;

  /** The receiver is no nearer than the shortest line to kick along is long, m. */
  private static final double NEAREST = 1.5;

  /** Longer than any field of the league, m. */
  private static final double FARTHEST = 20;

  /** Options that only mean something for one kind of kick. */
  private static final List<String> OF_FLATS = List.of("--half");

  private static final List<String> OF_CHIPS = List.of("--elevation", "--across");

  /** More than any session has seen; chosen. */
  private static final int MOST_TROUBLES = 100;

  /** As a shell has it for a program that Ctrl-C has ended. */
  private static final int INTERRUPTED = 130;

  @Spec private CommandSpec spec;

  @Option(names = "--sim", description = "plays on the simulated field in this process")
  private boolean sim;

  @Option(
      names = "--ssl-sim",
      paramLabel = "HOST",
      description =
          "plays on a simulator that speaks the league's simulation protocol and sends its vision"
              + " by multicast")
  private String sslSim;

  @Option(
      names = "--robots-at",
      paramLabel = "HOST:PORT",
      description =
          "plays with real robots: sends the simulation protocol's robot commands to a bridge that"
              + " the team writes (docs/bridge.py); receives vision by multicast")
  private String robotsAt;

  @Option(
      names = "--kind",
      required = true,
      paramLabel = "flat|chip",
      description = "flat kicks along the diagonals, or chips along the half-way line")
  private String kind;

  @Option(
      names = "--kicks",
      required = true,
      paramLabel = "N",
      description = "number of good kicks, 1 to 1000; kicks that determine too little are repeated")
  private int kicks;

  @Option(
      names = "--adaptive",
      description =
          "chooses each kick so that it determines the least certain parameter best; with --out"
              + " also kicks that distinguish causes. Without --adaptive, the speeds are spread"
              + " evenly")
  private boolean adaptive;

  @Option(
      names = "--precision",
      paramLabel = "PERCENT",
      description =
          "ends before N kicks when every parameter's standard error is below this percentage, for"
              + " example 0.5")
  private Double precision;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "directory for recording, commands and results; earlier sessions in it are calibrated"
              + " together with this one")
  private Path out;

  @Mixin private SimulatorOptions simulator;

  @Option(
      names = "--half",
      paramLabel = "whole|negative|positive",
      description = "part of the field for flat kicks: all, or the half at negative or positive x")
  private String half = "whole";

  @Option(
      names = "--across",
      paramLabel = "X",
      description =
          "x of the line of chips in m, where cameras overlap (default: 0 m, the half-way line)")
  private double across;

  @Option(
      names = "--speed-min",
      paramLabel = "M/S",
      description = "slowest kick, 0.7 to 10 m/s (default: 2 m/s for flat kicks, 3 m/s for chips)")
  private Double speedMin;

  @Option(
      names = "--speed-max",
      paramLabel = "M/S",
      description =
          "fastest kick, 0.7 to 10 m/s (default: 6.5 m/s for flat kicks, 5.5 m/s for chips)")
  private Double speedMax;

  @Option(
      names = "--elevation",
      paramLabel = "DEG",
      description = "elevation of chips, 10 to 80° (default: 45°)")
  private double elevation = 45;

  @Option(
      names = "--margin",
      paramLabel = "M",
      description =
          "how far outside the lines robots may drive, 0 to 1 m (default: 0.2 m, less where the"
              + " field has less room)")
  private Double margin;

  @Option(
      names = "--receiver-distance",
      paramLabel = "M",
      description =
          "largest distance between the receiver and the ball, 1.5 to 20 m (default: the receiver"
              + " stands at the end of the line)")
  private Double receiverDistance;

  @Option(
      names = "--drive-speed",
      paramLabel = "M/S",
      description = "the robots' highest speed, 0.1 to 10 m/s (default: 2.5 m/s)")
  private Double driveSpeed;

  @Option(
      names = "--patience",
      paramLabel = "S",
      description =
          "longest wait for a robot, vision or the ball to come back, above 0 s (default: 60 s)")
  private Double patience;

  @Option(
      names = "--seed",
      paramLabel = "S",
      description =
          "seed of the kicks' order and of the simulated field (default: ${DEFAULT-VALUE})")
  private long seed = 1;

  @Mixin private SimulatedFieldOptions fieldOptions;

  @Option(
      names = "--troubles",
      paramLabel = "N",
      description =
          "simulated field: number of things that go wrong during the play, 0 to 100 (default: 0)")
  private int troubles;

  @Option(
      names = "--pace",
      paramLabel = "X",
      description =
          "simulated field: speed in multiples of real time, above 0 (default: as fast as"
              + " possible)")
  private double pace = Double.POSITIVE_INFINITY;

  @Option(
      names = "--referee",
      paramLabel = "ADDR:PORT",
      description = "on the network: multicast address of a referee whose HALT and STOP are obeyed")
  private String referee;

  @Option(
      names = "--interface",
      paramLabel = "NAME",
      description = "on the network: network interface for vision and referee (default: all)")
  private String networkInterface;

  PlayCommand() {}

  @Override
  public Integer call() throws IOException {
    SessionRequest request;
    Optional<InteractiveField> simulated;
    OutputPlaces.check(out, null);
    try {
      if ((sim ? 1 : 0) + (sslSim == null ? 0 : 1) + (robotsAt == null ? 0 : 1) != 1) {
        throw new IllegalArgumentException(
            "name one field: --sim, --ssl-sim HOST or --robots-at HOST:PORT");
      }
      checkField();
      request = request();
      simulated = sim ? Optional.of(simulated(request)) : Optional.empty();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
    PlayField field = simulated.isPresent() ? embedded(simulated.get()) : onTheNetwork();
    Path directory = out == null ? Files.createTempDirectory("fieldcal-play") : out;
    try {
      return play(request.into(directory), field, simulated, directory);
    } finally {
      forgetUnlessKept(directory);
    }
  }

  private PlayField embedded(InteractiveField simulated) {
    return new EmbeddedPlayField(simulated, pace);
  }

  private PlayField onTheNetwork() throws IOException {
    try {
      NetworkPlace vision = simulator.vision(networkInterface);
      Optional<NetworkPlace> whistle =
          Optional.ofNullable(referee).map(r -> NetworkPlace.parse(r, networkInterface));
      if (robotsAt != null) {
        RobotId[] pair = simulator.robots();
        return NetworkPlayField.ofRobots(robotsAt, pair[0], pair[1], vision, whistle);
      }
      return new NetworkPlayField(sslSim, simulator.ports(), vision, whistle);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }

  private int play(
      SessionRequest request, PlayField field, Optional<InteractiveField> simulated, Path directory)
      throws IOException {
    PlayText text = new PlayText(spec.commandLine().getOut());
    PlayRun.Result result;
    try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none());
        WorkProgress fitting = new WorkProgress(Heartbeat.of(spec))) {
      PlaySession session = new PlaySession(request, field, s -> follow(s, field, text, progress));
      session.whileItHasNotBegun(reason -> text.complaints(List.of(reason), progress));
      PrintWriter err = spec.commandLine().getErr();
      Runnable cleanUp = () -> forgetUnlessKept(directory);
      try (StopOnExit stop = new StopOnExit(session, Optional.ofNullable(out), cleanUp, err)) {
        try {
          result = PlayRun.run(session, directory, fitting);
        } catch (IOException e) {
          if (stop.happened()) {
            return INTERRUPTED;
          }
          throw e;
        }
      }
    }
    Optional<ObjectNode> truth = simulated.map(f -> TruthJson.of(f.finish(packet -> {})));
    if (out != null) {
      PlayRun.write(result, request);
      if (truth.isPresent()) {
        Path log = result.session().log().orElseThrow();
        String name = log.getFileName().toString().replaceFirst("\\.log$", ".truth.json");
        JsonFiles.write(truth.get(), log.resolveSibling(name));
      }
    }
    text.result(
        result,
        request,
        truth.map(t -> t.get("ideal_model")),
        Optional.ofNullable(out).map(o -> result.directory()));
    tellLeftOut(result);
    simulatorNotes(field);
    if (!result.session().complete()) {
      throw new InputException(stopped(result, field));
    }
    return 0;
  }

  /** The last line: why it stopped, and what can be done with what was recorded. */
  private String stopped(PlayRun.Result result, PlayField field) {
    PlayState state = result.session().last().state();
    return "The play stopped after "
        + state.good()
        + " of "
        + kicks
        + " good kicks: "
        + state.waiting().orElse("no reason is known")
        + field.silent().map(who -> " (" + who + ")").orElse("")
        + "."
        + StopOnExit.toCalibrate(state.made(), Optional.ofNullable(out));
  }

  private static void follow(
      SessionSnapshot s, PlayField field, PlayText text, TerminalProgress progress) {
    text.complaints(field.complaints(), progress);
    text.follow(s, progress);
  }

  /** Earlier sessions of the directory that are not part of the result. */
  private void tellLeftOut(PlayRun.Result result) throws IOException {
    if (out == null || result.calibration().isEmpty()) {
      return;
    }
    Path log = result.session().log().orElseThrow();
    for (String other : PlayRun.leftOut(out, log)) {
      spec.commandLine().getOut().println("left out: " + other);
    }
  }

  private void simulatorNotes(PlayField field) {
    field.notes().forEach(spec.commandLine().getOut()::println);
    spec.commandLine().getOut().flush();
  }

  /** Best effort: it lies where the machine cleans up by itself. */
  private void forgetUnlessKept(Path directory) {
    if (out != null || !Files.exists(directory)) {
      return;
    }
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    } catch (IOException | UncheckedIOException e) {
      spec.commandLine().getErr().println("fieldcal: " + directory + " could not be deleted");
    }
  }

  private InteractiveField simulated(SessionRequest request) throws IOException {
    SimulationSettings settings =
        fieldOptions.withEffects(
            fieldOptions.withPreset(SimulationSettings.DEFAULT.withSeed(seed)));
    int earlier;
    try {
      earlier = out == null ? 0 : PlayRun.logs(out).size();
    } catch (IOException e) {
      throw new IllegalArgumentException(out + ": " + e.getMessage(), e);
    }
    return InteractiveField.later(
            settings,
            request.first(),
            request.second(),
            FieldTrouble.random(seed, troubles, 8.0 * kicks),
            earlier * BETWEEN_SESSIONS)
        .robotsLike(fieldOptions.robots());
  }

  private SessionRequest request() {
    KickKind wanted =
        switch (kind.toLowerCase(Locale.ROOT)) {
          case "flat" -> KickKind.FLAT;
          case "chip" -> KickKind.CHIP;
          default ->
              throw new IllegalArgumentException("--kind must be flat or chip, not '" + kind + "'");
        };
    refuse(
        wanted == KickKind.CHIP ? OF_FLATS : OF_CHIPS, "--kind " + kind.toLowerCase(Locale.ROOT));
    checkRanges();
    RobotId[] pair = simulator.robots();
    SessionRequest r = SessionRequest.of(wanted, kicks);
    PlayLimits limits = r.limits();
    if (driveSpeed != null) {
      limits = limits.withDriveSpeed(driveSpeed);
    }
    if (receiverDistance != null) {
      limits = limits.withReceiverDistance(receiverDistance);
    }
    if (patience != null) {
      limits = limits.withPatience(patience, Math.max(limits.stall(), 2 * patience));
    }
    return r.withRobots(pair[0], pair[1])
        .withPlace(half(), across)
        .withSpeeds(
            speedMin == null ? r.slowest() : speedMin,
            speedMax == null ? r.fastest() : speedMax,
            Math.toRadians(elevation))
        .withChoice(adaptive, seed, share(precision))
        .withLimits(limits, Optional.ofNullable(margin));
  }

  /** An option that the chosen field ignores was meant for another one. */
  private void checkField() {
    refuse(sim ? NETWORK : SIMULATED, sim ? "--sim" : sslSim != null ? "--ssl-sim" : "--robots-at");
    if (sslSim == null) {
      refuse(List.of("--port"), sim ? "--sim" : "--robots-at");
    }
  }

  private void refuse(List<String> options, String beside) {
    for (String option : options) {
      if (spec.commandLine().getParseResult().hasMatchedOption(option)) {
        throw new IllegalArgumentException(option + " has no effect with " + beside);
      }
    }
  }

  private void checkRanges() {
    OptionRange.check("--kicks", kicks, 1, SessionRequest.MOST_KICKS, "");
    OptionRange.check("--speed-min", speedMin, SLOWEST, FASTEST, " m/s");
    OptionRange.check("--speed-max", speedMax, SLOWEST, FASTEST, " m/s");
    OptionRange.check("--elevation", elevation, FLATTEST, STEEPEST, "°");
    OptionRange.check("--margin", margin, 0, 1, " m");
    OptionRange.check("--troubles", troubles, 0, MOST_TROUBLES, "");
    OptionRange.check("--receiver-distance", receiverDistance, NEAREST, FARTHEST, " m");
    OptionRange.check("--drive-speed", driveSpeed, SLOWEST_DRIVE, FASTEST_DRIVE, " m/s");
    OptionRange.positive("--patience", patience);
    OptionRange.positive("--pace", pace);
  }

  /** A relative standard error; none was asked for: 0. */
  private static double share(Double percent) {
    if (percent == null) {
      return 0;
    }
    if (!(percent > 0 && percent < 100)) {
      throw new IllegalArgumentException(
          "--precision must be above 0 % and below 100 %, but is " + percent);
    }
    return percent / 100;
  }

  private Half half() {
    try {
      return Half.valueOf(half.toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "--half must be whole, negative or positive, not '" + half + "'", e);
    }
  }
}
