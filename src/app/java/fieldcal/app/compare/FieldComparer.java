package fieldcal.app.compare;

import fieldcal.app.compare.CameraOffsets.Offset;
import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.FieldStatistics;
import fieldcal.app.statistics.Holm;
import fieldcal.app.statistics.Statistic;
import fieldcal.effect.ExtendedModel;
import fieldcal.kick.KickKind;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;

/** Puts a field and a simulator side by side. */
final class FieldComparer {
  private static final double MM = 1000;

  /** Statistics of cameras; those of the ball compare the same kicks, which these are not. */
  private static final List<String> CAMERAS =
      List.of(
          "noise", "interval", "interval_scatter", "lost", "delay", "missed_balls", "false_balls");

  private final Side real;
  private final Side sim;

  FieldComparer(Side real, Side sim) {
    this.real = real;
    this.sim = sim;
  }

  /** All tests of the comparison are corrected together for their number, since the operator reads them together. */
  FieldComparison compare() {
    Differences ball = Differences.of(real.diagnosis().diagnosis(), sim.diagnosis().diagnosis());
    List<Comparison> cameras = cameras();
    TestedRows others = others();
    double[] ofCameras = cameras.stream().mapToDouble(Comparison::p).toArray();
    double[][] paid = Holm.together(ball.probabilities(), ofCameras, others.probabilities());
    return compared(ball.judged(paid[0]), paidFor(cameras, paid[1]), others.judged(paid[2]));
  }

  private static List<Comparison> paidFor(List<Comparison> cameras, double[] corrected) {
    return IntStream.range(0, corrected.length)
        .mapToObj(i -> cameras.get(i).withCorrected(corrected[i]))
        .toList();
  }

  private FieldComparison compared(
      Differences.Result found, List<Comparison> cameras, List<Row> others) {
    ExtendedModel field = real.diagnosis().diagnosis().model();
    ExtendedModel all = applied(field, found.significant(), null);
    Cost cost = new Cost(real.diagnosis().diagnosis().kicks(), field);
    Map<Double, Double> errors = cost.errors(all);
    double passReal = Cost.pass(field);
    double passSim = Cost.pass(all);
    List<Named> named = new ArrayList<>();
    for (Difference d : found.significant()) {
      ExtendedModel without = applied(field, found.significant(), d);
      double total = errors.getOrDefault(Cost.SHARE_HORIZON, Double.NaN);
      double left = cost.errors(without).getOrDefault(Cost.SHARE_HORIZON, Double.NaN);
      double passLeft = Cost.pass(without) - passReal;
      named.add(
          new Named(
              d.id(),
              d.words(),
              d.unit(),
              d.real(),
              d.realError(),
              d.sim(),
              d.simError(),
              (total - left) / total,
              (passSim - passReal - passLeft) / (passSim - passReal)));
    }
    named.sort(Comparator.comparingDouble((Named n) -> -finite(n.shareOfError())));
    return new FieldComparison(
        CompareWords.verdict(passReal, passSim, named, errors)
            + CompareWords.doubt(
                named,
                real.diagnosis().diagnosis().unexplained(),
                sim.diagnosis().diagnosis().unexplained()),
        named,
        found.parameters(),
        cameras,
        others,
        passReal,
        passSim,
        errors);
  }

  private static double finite(double value) {
    return Double.isFinite(value) ? value : 0;
  }

  /** The field's model with the simulator's values of all differences but one. */
  private static ExtendedModel applied(
      ExtendedModel field, List<Difference> differences, Difference but) {
    ExtendedModel model = field;
    for (Difference d : differences) {
      model = d == but ? model : d.asSimulated().apply(model);
    }
    return model;
  }

  private List<Comparison> cameras() {
    return Comparison.of(statistics(real), statistics(sim));
  }

  private static List<Statistic> statistics(Side side) {
    return FieldStatistics.of(
            side.recording(), k -> Optional.of(String.format(Locale.ROOT, "kick %04d", k.id())))
        .stream()
        .filter(s -> CAMERAS.contains(s.id().replaceFirst("\\..*", "")))
        .map(s -> new Statistic(s.id(), s.words(), s.unit(), Statistic.How.LEVEL, s.samples()))
        .toList();
  }

  /** What is neither the ball nor in the frames of single cameras. */
  private TestedRows others() {
    TestedRows rows = new TestedRows();
    offsets(real, sim, rows);
    for (KickKind kind : KickKind.values()) {
      double[] a = speeds(real, kind);
      double[] b = speeds(sim, kind);
      if (a.length > 0 && b.length > 0) {
        rows.untested(
            "kick_speed." + kind.id(),
            "median speed of " + kind.id() + " kicks",
            "m/s",
            StatUtils.percentile(a, 50),
            StatUtils.percentile(b, 50));
      }
    }
    Kickers.rows(real, sim, rows);
    for (Team team : Team.values()) {
      limits(team, rows);
    }
    return rows;
  }

  /** Offsets of the cameras that both have. */
  private static void offsets(Side real, Side sim, TestedRows rows) {
    Set<Integer> both = new TreeSet<>(CameraOffsets.seen(real.diagnosis().diagnosis()));
    both.retainAll(CameraOffsets.seen(sim.diagnosis().diagnosis()));
    Map<Integer, Offset> field = CameraOffsets.of(real.diagnosis().diagnosis(), both);
    Map<Integer, Offset> other = CameraOffsets.of(sim.diagnosis().diagnosis(), both);
    field.forEach(
        (camera, a) -> {
          Offset b = other.get(camera);
          if (b != null) {
            rows.sampled(
                offset("x", camera, a.x(), a.errorX(), b.x(), b.errorX()), a.kicks(), b.kicks());
            rows.sampled(
                offset("y", camera, a.y(), a.errorY(), b.y(), b.errorY()), a.kicks(), b.kicks());
          }
        });
  }

  private static Row offset(String axis, int camera, double a, double ea, double b, double eb) {
    return new Row(
        "offset_" + axis + "." + camera,
        "offset in " + axis + " of camera " + camera,
        "mm",
        MM * a,
        MM * ea,
        MM * b,
        MM * eb,
        false);
  }

  private static double[] speeds(Side side, KickKind kind) {
    return side.diagnosis().diagnosis().kicks().stream()
        .filter(k -> k.kind() == kind)
        .map(k -> k.after().stateAt(k.after().kickTime()))
        .mapToDouble(s -> Math.sqrt(s.vx() * s.vx() + s.vy() * s.vy() + s.vz() * s.vz()))
        .toArray();
  }

  private void limits(Team team, TestedRows rows) {
    TeamLimits a = real.limits().limits(team);
    TeamLimits b = sim.limits().limits(team);
    limit(team, "velocity", "m/s", a.velocity(), b.velocity(), rows);
    limit(team, "acceleration", "m/s²", a.acceleration(), b.acceleration(), rows);
    limit(team, "braking", "m/s²", a.braking(), b.braking(), rows);
    TurnLimits real = a.turning();
    TurnLimits simulated = b.turning();
    limit(team, "rate of turning", "rad/s", real.velocity(), simulated.velocity(), rows);
    limit(
        team,
        "angular acceleration",
        "rad/s²",
        real.acceleration(),
        simulated.acceleration(),
        rows);
    limit(team, "angular braking", "rad/s²", real.braking(), simulated.braking(), rows);
  }

  /** Two limits that were reached; or one, and robots on the other side that did more than that. */
  private static void limit(
      Team team, String name, String unit, LimitEstimate a, LimitEstimate b, TestedRows rows) {
    boolean comparable =
        a.known()
            && b.known()
            && (a.reached() && b.reached()
                || a.reached() && b.value() > a.value()
                || b.reached() && a.value() > b.value());
    if (!comparable) {
      return;
    }
    String atLeast =
        a.reached() && b.reached()
            ? ""
            : a.reached() ? ", in the simulator at least" : ", on the field at least";
    rows.tested(
        new Row(
            "limit." + team.label() + "." + name.replace(' ', '_'),
            "largest " + name + " of " + team.label() + atLeast,
            unit,
            a.value(),
            a.standardError(),
            b.value(),
            b.standardError(),
            false));
  }
}
