package fieldcal.app.report;

import fieldcal.app.report.CalibrationReport.Camera;
import fieldcal.app.report.CalibrationReport.Kick;
import fieldcal.app.report.CalibrationReport.KickParameter;
import fieldcal.app.report.CalibrationReport.Kind;
import fieldcal.app.report.CalibrationReport.Model;
import fieldcal.app.report.CalibrationReport.ModelParameter;
import fieldcal.app.wording.PublishWords;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * A calibration session that looks like a real one: 28 flat kicks on the diagonals and 32 chips along the half-way line, two
 * cameras 40 mm apart, outliers, kicks that end early, one that hit a robot, one bad fit. Seeded.
 */
final class SampleReport {
  static final Field FIELD = new Field(12.04, 9.02, 0.3, 1.8, 0.18, 1.8, 3.6, 0.5);
  static final PublishWords VERDICT =
      new PublishWords(
          "check_first",
          "check first",
          List.of("The residuals are 2.6 times the noise of the cameras."),
          List.of("No chip model is published to compare with."),
          List.of("Run diagnose on these recordings: it looks for the cause."));
  private static final double START = 1795254402.8;

  private final Random random;
  private final List<Kick> kicks = new ArrayList<>();

  private SampleReport(long seed) {
    random = new Random(seed);
  }

  /** The whole session. */
  static CalibrationReport session(long seed) {
    SampleReport sample = new SampleReport(seed);
    for (int i = 0; i < 28; i++) {
      sample.kicks.add(sample.flat(i + 1));
    }
    for (int i = 0; i < 32; i++) {
      sample.kicks.add(sample.chip(i + 29));
    }
    return sample.report();
  }

  /** A report with the kicks of a session that the test wants, and otherwise its own choice. */
  static CalibrationReport of(List<Model> models, List<Kick> kicks, Optional<Field> field) {
    return new CalibrationReport(
        new Provenance(List.of("session.log.gz"), "fieldcal test", 1, Double.NaN, Double.NaN),
        models,
        List.of(),
        field,
        kicks,
        VERDICT,
        List.of(),
        List.of());
  }

  private CalibrationReport report() {
    Model flat =
        new Model(
            Kind.FLAT,
            List.of(
                parameter(Kind.FLAT, "accSlide", "m/s²", -3.0),
                parameter(Kind.FLAT, "accRoll", "m/s²", -0.26),
                parameter(Kind.FLAT, "kSwitch", "", 0.64)),
            2.17,
            "");
    Model chip =
        new Model(
            Kind.CHIP,
            List.of(
                parameter(Kind.CHIP, "dampingXyFirstHop", "", 0.8),
                parameter(Kind.CHIP, "dampingXyOtherHops", "", 0.85),
                parameter(Kind.CHIP, "dampingZ", "", 0.47)),
            3.71,
            "accRoll of the chips is fixed to the flat calibration's −0.315 m/s².");
    return new CalibrationReport(
        new Provenance(
            List.of("flat-calibration.log.gz", "chip-calibration.log.gz"),
            "fieldcal 0.1.0",
            20251121,
            START,
            347.2),
        List.of(flat, chip),
        List.of(
            new Camera(
                0,
                1.92,
                66.6,
                10412,
                20.1,
                0.4,
                -0.3,
                0.4,
                -3,
                0,
                "its published rotation contradicts its published position: only the position is"
                    + " used"),
            new Camera(
                1,
                2.31,
                66.7,
                11020,
                -20.1,
                0.4,
                0.3,
                0.4,
                3,
                0,
                "its published rotation contradicts its published position: only the position is"
                    + " used")),
        Optional.of(FIELD),
        kicks,
        VERDICT,
        List.of(
            "Both cameras publish placeholder rotations; only their positions are used.",
            "Cameras 0 and 1 disagree by 40 mm in x. The offset is taken out here, but not in"
                + " vision."),
        List.of(
            new Problem(
                "chip-calibration.log.gz, byte 1048576",
                "garbage between two records",
                1,
                "312 bytes skipped"),
            new Problem("flat-calibration.log.gz", "duplicated frame", 12, "counted once"),
            new Problem(
                "flat-calibration.log.gz", "detection without finite coordinates", 3, "skipped")));
  }

  private ModelParameter parameter(Kind kind, String name, String unit, double published) {
    List<KickParameter> values =
        kicks.stream()
            .filter(k -> k.kind() == kind && k.selected())
            .flatMap(k -> k.parameters().stream())
            .filter(p -> p.name().equals(name) && p.undetermined().isEmpty())
            .toList();
    double mean = values.stream().mapToDouble(KickParameter::value).average().orElse(Double.NaN);
    double squares = values.stream().mapToDouble(p -> Math.pow(p.value() - mean, 2)).sum();
    double sigma = Math.sqrt(squares / (values.size() - 1));
    double error = sigma / Math.sqrt(values.size());
    double joint = mean + 0.5 * error;
    return new ModelParameter(
        name, unit, mean, error, values.size(), sigma, joint, error * 0.6, published, "");
  }

  private Kick flat(int id) {
    double speed = 2 + 4.5 * random.nextInt(19) / 18;
    boolean forward = random.nextBoolean();
    double angle =
        (forward ? 0 : Math.PI) + (random.nextBoolean() ? 1 : -1) * 0.64 + 0.02 * gauss();
    double x0 = -5.3 * Math.cos(angle);
    double y0 = -5.3 * Math.sin(angle) * 1.1;
    double accSlide = -3.1 - 0.03 * gauss();
    double accRoll = -0.315 + 0.004 * gauss();
    double kSwitch = 0.655 + 0.004 * gauss();
    if (id == 9) {
      accRoll = -0.42;
    }
    double tSwitch = speed * (kSwitch - 1) / accSlide;
    double rest = tSwitch - speed * kSwitch / accRoll;
    boolean touched = id == 17;
    double end = touched ? 0.9 : rest;
    SampleTrack track = new SampleTrack(random, x0, y0, Math.cos(angle), Math.sin(angle));
    for (double t : SampleTrack.grid(Math.min(end, 9), List.of(tSwitch))) {
      double roll = Math.max(0, Math.min(t, rest) - tSwitch);
      double slide = Math.min(t, tSwitch);
      double v = speed + accSlide * slide + accRoll * roll;
      double s =
          speed * slide
              + accSlide * slide * slide / 2
              + speed * kSwitch * roll
              + accRoll * roll * roll / 2;
      track.add(t, s, 0, Math.max(0, v));
    }
    boolean left = track.cutAtField(FIELD);
    double lasts = track.duration();
    List<PathEvent> events = new ArrayList<>();
    events.add(track.event(PathEvent.Type.ROLLING, tSwitch));
    if (!left && !touched) {
      events.add(track.event(PathEvent.Type.STOP, rest));
    }
    boolean rollSeen = lasts - tSwitch > 0.4;
    double unit = 0.004 / Math.sqrt(speed);
    List<KickParameter> parameters =
        List.of(
            fitted("accSlide", accSlide, 0.05 * 5 / speed, ""),
            fitted(
                "accRoll",
                accRoll,
                unit * 2,
                rollSeen ? "" : "the ball was seen rolling for less than 0.4 s"),
            fitted("kSwitch", kSwitch, unit, ""));
    String why =
        touched
            ? "touched robot 4 of blue 0.9 s after the kick"
            : id == 9 ? "accRoll −0.420 is 4.9 σ from the mean (round 1)" : "";
    List<Observations> seen = track.observe(id == 17 ? 0.08 : 0.012, 2.1);
    return kick(
        id,
        Kind.FLAT,
        touched ? "touched_robot" : left ? "left_field" : "stopped",
        new double[] {x0, y0, speed * Math.cos(angle), speed * Math.sin(angle), 0},
        parameters,
        why,
        track,
        seen,
        events);
  }

  private Kick chip(int id) {
    double speed = 3 + 3.5 * random.nextInt(15) / 14;
    boolean up = id % 2 == 0;
    double angle = (up ? 1 : -1) * (Math.PI / 2 + 0.03 * gauss());
    double x0 = -0.45 + 0.9 * random.nextDouble();
    double y0 = up ? -4.15 : 4.15;
    double first = 0.77 + 0.01 * gauss();
    double other = 0.93 + 0.01 * gauss();
    double bounce = 0.5 + 0.008 * gauss();
    boolean failed = id == 40;
    double vz = speed * Math.sqrt(0.5);
    SampleTrack track = new SampleTrack(random, x0, y0, Math.cos(angle), Math.sin(angle));
    List<PathEvent> events =
        track.hop(vz, first, other, bounce, failed ? Double.NaN : -0.315, failed ? 1.2 : 7);
    boolean left = track.cutAtField(FIELD);
    double lasts = track.duration();
    events.removeIf(e -> e.t() > lasts);
    long landings = events.stream().filter(e -> e.type() == PathEvent.Type.LANDING).count();
    List<KickParameter> parameters =
        List.of(
            fitted("dampingXyFirstHop", first, 0.008, ""),
            fitted(
                "dampingXyOtherHops",
                other,
                0.012,
                landings < 2 ? "the ball was lost before its second landing" : ""),
            fitted("dampingZ", bounce, 0.009, ""));
    return kick(
        id,
        Kind.CHIP,
        left ? "left_field" : failed ? "lost" : "stopped",
        new double[] {x0, y0, vz * Math.cos(angle), vz * Math.sin(angle), vz},
        parameters,
        failed ? "residual of 18.3 mm: the model does not fit this kick" : "",
        track,
        track.observe(0.02, failed ? 18 : 2.4),
        events);
  }

  private Kick kick(
      int id,
      Kind kind,
      String end,
      double[] start,
      List<KickParameter> parameters,
      String why,
      SampleTrack track,
      List<Observations> seen,
      List<PathEvent> events) {
    int count = seen.stream().mapToInt(Observations::size).sum();
    int used =
        seen.stream()
            .mapToInt(o -> (int) IntStream.range(0, o.size()).filter(i -> o.used()[i]).count())
            .sum();
    return new Kick(
        id,
        kind,
        kind == Kind.FLAT ? "flat-calibration.log.gz" : "chip-calibration.log.gz",
        START + id * 5.7,
        id % 3 == 0 ? "yellow" : "blue",
        id % 2,
        end,
        count,
        count - used,
        track.rmsMm(),
        start[0],
        start[1],
        start[2],
        start[3],
        start[4],
        parameters,
        why.isEmpty(),
        why,
        seen,
        track.path(),
        events);
  }

  private KickParameter fitted(String name, double truth, double error, String undetermined) {
    return undetermined.isEmpty()
        ? new KickParameter(name, truth + error * gauss() / 2, error, "", "")
        : new KickParameter(name, Double.NaN, Double.NaN, undetermined, "");
  }

  private double gauss() {
    // Within two sigma, as after a selection.
    return Math.max(-1.5, Math.min(1.5, random.nextGaussian()));
  }
}
