package fieldcal.app.compare;

import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.FieldStatistics;
import fieldcal.app.statistics.Statistic;
import fieldcal.effect.ExtendedModel;
import fieldcal.fit.CameraView;
import fieldcal.kick.KickKind;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.stat.StatUtils;

/** Puts a field and a simulator side by side. */
final class FieldComparer {
  /** Standard errors beyond which two limits of robots differ: 1 % of two equal ones would. */
  private static final double SIGMAS = 2.58;

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

  FieldComparison compare() {
    Differences.Result found = Differences.of(real, sim);
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
        CompareWords.verdict(passReal, passSim, named, errors),
        named,
        found.parameters(),
        cameras(),
        others(),
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

  private List<Row> others() {
    List<Row> rows = new ArrayList<>();
    for (CameraView view : views(real)) {
      views(sim).stream()
          .filter(v -> v.id() == view.id())
          .findFirst()
          .ifPresent(
              v -> {
                String of = " of camera " + view.id();
                rows.add(
                    plain(
                        "offset_x." + view.id(),
                        "offset in x" + of,
                        "mm",
                        MM * view.offsetX(),
                        MM * v.offsetX()));
                rows.add(
                    plain(
                        "offset_y." + view.id(),
                        "offset in y" + of,
                        "mm",
                        MM * view.offsetY(),
                        MM * v.offsetY()));
              });
    }
    for (KickKind kind : KickKind.values()) {
      double[] a = speeds(real, kind);
      double[] b = speeds(sim, kind);
      if (a.length > 0 && b.length > 0) {
        rows.add(
            plain(
                "kick_speed." + kind.id(),
                "median speed of " + kind.id() + " kicks",
                "m/s",
                StatUtils.percentile(a, 50),
                StatUtils.percentile(b, 50)));
      }
    }
    Kickers.rows(real, sim, rows);
    for (Team team : Team.values()) {
      limits(team, rows);
    }
    return rows;
  }

  static Row plain(String id, String words, String unit, double a, double b) {
    return new Row(id, words, unit, a, Double.NaN, b, Double.NaN, false);
  }

  private static List<CameraView> views(Side side) {
    return List.copyOf(side.recording().calibration().calibration().cameras().all());
  }

  private static double[] speeds(Side side, KickKind kind) {
    return side.diagnosis().diagnosis().kicks().stream()
        .filter(k -> k.kind() == kind)
        .map(k -> k.after().stateAt(k.after().kickTime()))
        .mapToDouble(s -> Math.sqrt(s.vx() * s.vx() + s.vy() * s.vy() + s.vz() * s.vz()))
        .toArray();
  }

  private void limits(Team team, List<Row> rows) {
    TeamLimits a = real.limits().limits(team);
    TeamLimits b = sim.limits().limits(team);
    limit(team, "velocity", "m/s", a.velocity(), b.velocity(), rows);
    limit(team, "acceleration", "m/s²", a.acceleration(), b.acceleration(), rows);
    limit(team, "braking", "m/s²", a.braking(), b.braking(), rows);
  }

  private static void limit(
      Team team, String name, String unit, LimitEstimate a, LimitEstimate b, List<Row> rows) {
    if (!a.known() || !b.known() || !a.reached() || !b.reached()) {
      return;
    }
    double sigmas =
        Math.abs(a.value() - b.value()) / Math.hypot(a.standardError(), b.standardError());
    rows.add(
        new Row(
            "limit." + team.label() + "." + name,
            "largest " + name + " of " + team.label(),
            unit,
            a.value(),
            a.standardError(),
            b.value(),
            b.standardError(),
            sigmas > SIGMAS));
  }
}
