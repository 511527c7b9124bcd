package fieldcal.app.cli;

import fieldcal.app.record.NetworkRecorder;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.truth.Truth;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code fieldcal simulate}: a recording with known truth beside it. */
@Command(
    name = "simulate",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description =
        "Simulates a field and writes a game log, with the truth and the robots' commands beside"
            + " it.",
    footer = {
      "",
      "Effects and their parameters (zero = absent; docs/effects.md has the units):",
      "  air_drag:cd",
      "  magnus:cl",
      "  wind:speed,direction (with air_drag)",
      "  field_slope:percent,direction",
      "  carpet_nap:amplitude,direction",
      "  speed_dependent_roll:slope",
      "  slip_dependent_friction:slope",
      "  worn_region:change,region=[x0,x1,y0,y1]",
      "  carpet_seam:loss,turn,normal,distance",
      "  kick_spin:fraction,scatter,chips",
      "  side_spin:fraction,scatter",
      "  robot_kick_bias:percent,yaw,team,robot",
      "  speed_dependent_restitution:slope",
      "  bounce_spin_coupling:coefficient",
      "  contact_impacts:reversed,friction,loss,rolling,lowest_hop_mm",
      "  camera_offset:x_mm,y_mm,camera",
      "  camera_time_offset:ms,camera",
      "  camera_pose_error:tilt_mrad,axis,height_mm,shift_x_mm,",
      "    shift_y_mm,camera",
      "  camera_position_error:x_mm,y_mm,height_mm,camera",
      "  lens_distortion_error:delta,camera",
      "  ball_height_error:mm",
      "  rolling_shutter:ms",
      "  clock_skew:ppm,camera",
      "  camera_moved:x_mm,y_mm,at,camera",
      "  drift:percent_per_10min",
      "  ball_changed:roll,slide,at",
      "  torque_limited:coefficient,team",
      "  directional:coefficient,team",
      "camera may be all; without camera, a lens or a position is wrong in all.",
      "at is the time of the session in s.",
      "",
      "Effects that diagnose has no name for:",
      "  carpet_waves:amplitude,wavelength",
      "  camera_shake:amplitude_mm,hz,camera",
      "  unnamed_restitution_place:change,direction",
      "  unnamed_roll_square:slope",
      "  unnamed_roll_bump:height,speed,width",
      "  unnamed_fading_friction:change,duration",
      "  unnamed_ring:change,inner,outer",
      "  unnamed_once_per_turn:amplitude",
      "  unnamed_four_ways:amplitude,direction",
      "  unnamed_impact_speed:slope",
      "  unnamed_side_force:rate",
      "  unnamed_patches:change,pitch",
      "  unnamed_lens_shear:mm,camera",
      "",
      "Served: fieldcal simulate --serve --seed 7",
      "Example: fieldcal simulate --scenario flat --kicks 24 --effect air_drag:cd=0.45 --seed 7"
          + " --out drag.log.gz"
    })
final class SimulateCommand implements Callable<Integer> {
  /** Of a scenario that is not a match; a match without a number of kicks ends after its time. */
  private static final int USUAL_KICKS = 24;

  private static final Scope PLAYED = new Scope(EnumSet.allOf(ScenarioKind.class), false);
  private static final Scope KICKS =
      new Scope(EnumSet.complementOf(EnumSet.of(ScenarioKind.MATCH)), false);
  private static final Scope MATCH = new Scope(EnumSet.of(ScenarioKind.MATCH), false);
  private static final Scope SERVED = new Scope(EnumSet.noneOf(ScenarioKind.class), true);

  /** Where an option changes something, for those that do not do so everywhere. */
  private static final Map<String, Scope> SCOPES =
      Map.ofEntries(
          Map.entry("--kicks", PLAYED),
          Map.entry("--speed-min", KICKS),
          Map.entry("--speed-max", KICKS),
          Map.entry("--reception", KICKS),
          Map.entry("--minutes", MATCH),
          Map.entry("--team-size", MATCH),
          Map.entry("--robots-like", SERVED),
          Map.entry("--robots", SERVED),
          Map.entry("--vision", SERVED),
          Map.entry("--port", SERVED),
          Map.entry("--loss", SERVED),
          Map.entry("--delay-ms", SERVED));

  /** Scenarios, or the served field, which plays none. */
  private record Scope(Set<ScenarioKind> scenarios, boolean served) {
    boolean contains(ScenarioKind kind, boolean serves) {
      return serves ? served : scenarios.contains(kind);
    }

    @Override
    public String toString() {
      String names = scenarios.stream().map(ScenarioKind::label).collect(Collectors.joining(", "));
      return served ? "--serve" : "--scenario " + names.replaceFirst(", (?=\\w+$)", " or ");
    }
  }

  @Spec private CommandSpec spec;

  @Option(names = "--scenario", paramLabel = "KIND", description = "flat, chip, mixed or match")
  private String scenario;

  @Option(
      names = "--kicks",
      paramLabel = "N",
      description =
          "number of kicks (default: 24); a match ends after N kicks of both teams or after"
              + " --minutes, whichever comes first")
  private Integer kicks;

  @Option(
      names = "--seed",
      paramLabel = "S",
      description =
          "seed of everything random; the same seed gives the same bytes (default:"
              + " ${DEFAULT-VALUE})")
  private long seed = 1;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description =
          "NAME.log or NAME.log.gz; NAME.truth.json and NAME.commands.csv are written beside it")
  private Path out;

  @Mixin private SimulatedFieldOptions field;

  @Option(
      names = "--physics",
      paramLabel = "NAME",
      description =
          "ideal: obeys the league's models; contact: solid sphere with bounces by contact"
              + " (default: ideal)")
  private String physics;

  @Option(
      names = "--flat-model",
      paramLabel = "ACC_SLIDE,ACC_ROLL,K_SWITCH",
      split = ",",
      hideParamSyntax = true,
      description = "ideal physics with these parameters, for example -3.1,-0.28,0.65")
  private double[] flatModel;

  @Option(
      names = "--chip-model",
      paramLabel = "E_XY1,E_XY,E_Z",
      split = ",",
      hideParamSyntax = true,
      description = "ideal physics with these parameters, for example 0.75,0.95,0.52")
  private double[] chipModel;

  @Option(
      names = "--cameras",
      paramLabel = "N",
      description = "number of cameras, 1 to 8 (default: 4)")
  private Integer cameras;

  @Option(
      names = "--noise-mm",
      paramLabel = "MM",
      description = "noise of a ball straight below a camera (default: 2 mm)")
  private Double noiseMm;

  @Option(
      names = "--camera-height",
      paramLabel = "M",
      description = "height of the cameras above the carpet (default: 5.3 m)")
  private Double cameraHeight;

  @Option(
      names = "--distortion",
      paramLabel = "K",
      description = "radial distortion, either sign (default: 0.12)")
  private Double distortion;

  @Option(
      names = "--disagreement-mm",
      paramLabel = "MM",
      description =
          "distance between the positions that neighbouring cameras report for the same ball"
              + " (default: 0 mm)")
  private Double disagreementMm;

  @Option(names = "--division", paramLabel = "A|B", description = "field size (default: A)")
  private String division;

  @Option(
      names = "--speed-min",
      paramLabel = "M/S",
      description = "slowest kick of flat, chip and mixed, m/s")
  private Double speedMin;

  @Option(
      names = "--speed-max",
      paramLabel = "M/S",
      description = "fastest kick of flat, chip and mixed, m/s")
  private Double speedMax;

  @Option(
      names = "--reception",
      paramLabel = "SHARE",
      description =
          "flat, chip and mixed: share of kicks that the receiver tries to stop (default: 0.7)")
  private Double reception;

  @Option(
      names = "--minutes",
      paramLabel = "M",
      description =
          "how long a match lasts at most (default: 2 min, or with --kicks half a minute per kick"
              + " where that is longer)")
  private Double minutes;

  @Option(
      names = "--team-size",
      paramLabel = "N",
      description = "robots per team of a match (default: 6)")
  private Integer teamSize;

  @Option(
      names = "--yellow-limits",
      paramLabel = "V,A,B",
      split = ",",
      hideParamSyntax = true,
      description =
          "yellow robots: speed m/s, acceleration and braking m/s² (match: drawn from the seed)")
  private double[] yellowLimits;

  @Option(
      names = "--blue-limits",
      paramLabel = "V,A,B",
      split = ",",
      hideParamSyntax = true,
      description = "the same for blue robots")
  private double[] blueLimits;

  @Option(
      names = "--clean",
      description = "noise only: no lost frames, false balls, jitter or shadows")
  private boolean clean;

  @Option(
      names = "--outage",
      paramLabel = "CAMERA:FROM:SECONDS",
      description = "a camera sends nothing for a while; may be repeated")
  private final List<String> outages = new ArrayList<>();

  @Mixin private ServeOptions serving;

  SimulateCommand() {}

  @Override
  public Integer call() throws IOException {
    SimulationSettings settings;
    try {
      require("--scenario KIND is missing", scenario != null || serving.wanted());
      require("--out FILE is missing", out != null || serving.wanted());
      require("--serve writes no recording: leave out --out", out == null || !serving.wanted());
      require(
          "--serve plays no scenario: leave out --scenario", scenario == null || !serving.wanted());
      ScenarioKind kind = kind();
      requireUse(kind);
      settings = settings(kind);
      if (serving.wanted()) {
        serving.serve(settings, field.robots(), spec.commandLine().getOut());
        return 0;
      }
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
    if (!NetworkRecorder.isLogName(out)) {
      throw new ParameterException(
          spec.commandLine(), "--out must end with .log or .log.gz, but is '" + out + "'");
    }
    RecordingFiles files = RecordingFiles.besides(out);
    Truth truth;
    PrintWriter print = spec.commandLine().getOut();
    try (Heartbeat heartbeat = Heartbeat.of(spec);
        TerminalProgress progress = TerminalProgress.ofPercent("simulating", heartbeat)) {
      truth = files.write(settings, share -> progress.at(Math.round(100 * share), 100));
    }
    int played = truth.commandedKicks().size();
    print.printf(
        Locale.ROOT,
        "%s: %.1f s, %s, %d frames of %d cameras, seed %d%n",
        files.log(),
        truth.duration(),
        played == 1 ? "1 kick" : played + " kicks",
        truth.cameras().stream().mapToLong(c -> c.frames()).sum(),
        truth.cameras().size(),
        settings.seed());
    ScenarioSettings match = settings.scenario();
    if (match.kind() == ScenarioKind.MATCH && played < match.kicks()) {
      print.printf(
          Locale.ROOT,
          "the %s minutes were over before %d kicks were played%n",
          Double.toString(match.minutes()).replaceFirst("\\.0$", ""),
          match.kicks());
    }
    settings.effects().forEach(e -> print.printf("effect %s%n", e));
    print.printf("truth %s%ncommands %s%n", files.truth(), files.commands());
    print.flush();
    return 0;
  }

  private static void require(String words, boolean holds) {
    if (!holds) {
      throw new IllegalArgumentException(words);
    }
  }

  /** An option that changes nothing would make the operator believe that it did. */
  private void requireUse(ScenarioKind kind) {
    for (OptionSpec option : spec.commandLine().getParseResult().matchedOptions()) {
      Scope scope = SCOPES.get(option.longestName());
      if (scope != null && !scope.contains(kind, serving.wanted())) {
        throw new IllegalArgumentException(
            "%s changes nothing with %s: it is for %s"
                .formatted(
                    option.longestName(),
                    serving.wanted() ? "--serve" : "--scenario " + kind.label(),
                    scope));
      }
    }
  }

  private SimulationSettings settings(ScenarioKind kind) throws IOException {
    requireOwnField();
    SimulationSettings s =
        SimulationSettings.DEFAULT.withSeed(seed).withField(field()).withScenario(scenario(kind));
    s = field.withPreset(s);
    if (yellowLimits != null || blueLimits != null) {
      ScenarioSettings now = s.scenario();
      s =
          s.withScenario(
              now.withLimits(
                  yellowLimits == null ? now.yellow() : limits("--yellow-limits", yellowLimits),
                  blueLimits == null ? now.blue() : limits("--blue-limits", blueLimits)));
    }
    if (physics != null || flatModel != null || chipModel != null) {
      s = s.withPhysics(physics());
    }
    s = s.withCameras(cameras(s.cameras()));
    if (clean) {
      s = s.withNuisance(Nuisance.NONE);
    }
    if (!field.likeTwin()) {
      s =
          s.withNuisance(
              s.nuisance().withOutages(outages.stream().map(SimulateCommand::outage).toList()));
    }
    return field.withEffects(s);
  }

  /** A twin says what its ball, cameras and field are; two answers would contradict each other. */
  private void requireOwnField() {
    if (!field.likeTwin()) {
      return;
    }
    Map<String, Boolean> given = new LinkedHashMap<>();
    given.put("--physics", physics != null);
    given.put("--flat-model", flatModel != null);
    given.put("--chip-model", chipModel != null);
    given.put("--cameras", cameras != null);
    given.put("--noise-mm", noiseMm != null);
    given.put("--camera-height", cameraHeight != null);
    given.put("--distortion", distortion != null);
    given.put("--disagreement-mm", disagreementMm != null);
    given.put("--division", division != null);
    given.put("--clean", clean);
    given.put("--outage", !outages.isEmpty());
    given.forEach(
        (option, there) -> {
          if (there) {
            throw new IllegalArgumentException(
                option + " contradicts --like: change the twin's file instead");
          }
        });
  }

  private ScenarioKind kind() {
    try {
      return scenario == null
          ? ScenarioKind.FLAT
          : ScenarioKind.valueOf(scenario.toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "unknown scenario '" + scenario + "'; known are flat, chip, mixed, match", e);
    }
  }

  private ScenarioSettings scenario(ScenarioKind kind) {
    if (kicks != null && kicks < 1) {
      throw new IllegalArgumentException("--kicks must be 1 or more, but is " + kicks);
    }
    int usual = kind == ScenarioKind.MATCH ? 0 : USUAL_KICKS;
    ScenarioSettings s = ScenarioSettings.of(kind, kicks == null ? usual : kicks);
    if (speedMin != null || speedMax != null) {
      double min = speedMin == null ? s.flatSpeedMin() : speedMin;
      double max = speedMax == null ? s.flatSpeedMax() : speedMax;
      OptionRange.check("--speed-min", min, 0.3, 10, " m/s");
      OptionRange.check("--speed-max", max, min, 10, " m/s");
      s = s.withSpeeds(min, max);
    }
    OptionRange.check("--reception", reception, 0, 1, "");
    OptionRange.positive("--minutes", minutes);
    OptionRange.check("--team-size", teamSize, 1, 16, "");
    if (reception != null) {
      s = s.withReception(reception);
    }
    if (minutes != null || teamSize != null) {
      s =
          s.withMatch(
              teamSize == null ? s.teamSize() : teamSize, minutes == null ? s.minutes() : minutes);
    }
    return s;
  }

  private FieldSize field() {
    return switch (division == null ? "A" : division.toUpperCase(Locale.ROOT)) {
      case "A" -> FieldSize.DIVISION_A;
      case "B" -> FieldSize.DIVISION_B;
      default ->
          throw new IllegalArgumentException(
              "--division must be A or B, but is '" + division + "'");
    };
  }

  private BallPhysics physics() {
    String name = physics == null ? "ideal" : physics;
    if (name.equals("contact")) {
      if (flatModel != null || chipModel != null) {
        throw new IllegalArgumentException(
            "--flat-model and --chip-model belong to --physics ideal");
      }
      return BallPhysics.contact(0.3, 0.28, 0.52);
    }
    if (!name.equals("ideal")) {
      throw new IllegalArgumentException(
          "--physics must be ideal or contact, but is '" + name + "'");
    }
    double[] flat = three("--flat-model", flatModel, new double[] {-3.1, -0.28, 0.65});
    double[] chip = three("--chip-model", chipModel, new double[] {0.75, 0.95, 0.52});
    return BallPhysics.ideal(flat[0], flat[1], flat[2], chip[0], chip[1], chip[2]);
  }

  private static Nuisance.Outage outage(String text) {
    String[] parts = text.split(":", -1);
    try {
      if (parts.length == 3) {
        return new Nuisance.Outage(
            Integer.parseInt(parts[0]), Double.parseDouble(parts[1]), Double.parseDouble(parts[2]));
      }
    } catch (NumberFormatException e) {
      // The message below says what is expected.
    }
    throw new IllegalArgumentException(
        "--outage must be CAMERA:FROM:SECONDS, but is '" + text + "'");
  }

  private static double[] three(String option, double[] given, double[] usual) {
    if (given == null) {
      return usual;
    }
    if (given.length != 3) {
      throw new IllegalArgumentException(option + " takes three numbers, but got " + given.length);
    }
    return given;
  }

  private static RobotLimits limits(String option, double[] given) {
    if (given == null) {
      return RobotLimits.DEFAULT;
    }
    double[] values = three(option, given, given);
    for (double value : values) {
      OptionRange.positive(option, value);
    }
    return RobotLimits.uniform(values[0], values[1], values[2]);
  }

  private CameraSettings cameras(CameraSettings base) {
    OptionRange.check("--cameras", cameras, 1, 8, "");
    OptionRange.check("--noise-mm", noiseMm, 0, 100, " mm");
    OptionRange.check("--camera-height", cameraHeight, 1, 20, " m");
    OptionRange.check("--distortion", distortion, -0.25, 1, "");
    OptionRange.check("--disagreement-mm", disagreementMm, 0, 500, " mm");
    CameraSettings c = base;
    if (cameras != null) {
      c = c.withCount(cameras);
    }
    if (noiseMm != null) {
      c = c.withNoise(noiseMm / 1000, 1.75 * noiseMm / 1000);
    }
    if (cameraHeight != null) {
      c = c.withHeight(cameraHeight);
    }
    if (distortion != null) {
      c = c.withDistortion(distortion);
    }
    if (disagreementMm != null) {
      c = c.withRegistration(c.ballPlane(), disagreementMm / 1000);
    }
    return c;
  }
}
