package fieldcal.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.diagnosis.decision.Decision;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MotionEffect.Bounce;
import fieldcal.effect.MotionEffect.ImpactLaw;
import fieldcal.effect.MotionEffect.SpinAtKick;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedCurve.Support;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Polynomial;
import fieldcal.effect.learned.Variable;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** What helps the prediction without being a named cause, as findings. */
final class LearnedFindings {
  private LearnedFindings() {}

  static LearnedFinding of(FittedModel model, int component, Judgement j, Arena arena) {
    Gain gain = Gain.of(j);
    if (!(j.effect() instanceof LearnedTerm term)) {
      return new LearnedFinding(
          j.effect().within(arena),
          actsOn(j.effect()),
          j.follows()
              .filter(d -> !j.effect().hasOwnMean())
              .map(d -> List.of(d.on().label()))
              .orElse(j.effect().dependsOn()),
          OptionalInt.empty(),
          List.of(),
          j.scatter(),
          j.follows(),
          gain);
    }
    return new LearnedFinding(
        term,
        term.actsOn(),
        term.dependsOn(),
        term.camera(),
        curves(model, component, term, arena),
        j.scatter(),
        j.follows(),
        gain);
  }

  /** Where an effect acts: "ground", "impact", "kick" or "measurement". */
  static String actsOn(Effect effect) {
    if (effect instanceof MeasurementEffect) {
      return "measurement";
    }
    if (effect instanceof SpinAtKick) {
      return "kick";
    }
    return effect instanceof Bounce || effect instanceof ImpactLaw ? "impact" : "ground";
  }

  private static List<LearnedCurve> curves(
      FittedModel model, int component, LearnedTerm term, Arena arena) {
    int size = term.coefficients().length;
    int from = model.model().offset(component);
    double[][] covariance = new double[size][size];
    Optional<double[][]> all = model.solution().covariance();
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        covariance[i][j] = all.isPresent() ? all.get()[from + i][from + j] : Double.NaN;
      }
    }
    List<LearnedCurve> curves = new ArrayList<>();
    int components = term.family().quantity().components();
    for (int c = 0; c < components; c++) {
      curves.add(LearnedCurve.of(term, c, covariance, support(model, term, arena)));
    }
    return curves;
  }

  /** The range over which the kicks show a term: without speeds that only one or two kicks reach, where a curve describes these kicks alone. */
  private static Support support(FittedModel model, LearnedTerm term, Arena arena) {
    List<Double> speeds = new ArrayList<>();
    List<Double> rises = new ArrayList<>();
    for (int k = 0; k < model.kickCount(); k++) {
      double[] own = model.solution().own(k);
      speeds.add(Math.hypot(own[2], own[3]));
      if (model.kick(k).record().timeIndex() == 5) {
        rises.add(own[4]);
      }
    }
    double speed = reachedBySome(speeds);
    double rise = reachedBySome(rises);
    double[] times = arena.kickTimes();
    double session = times.length == 0 ? 1 : times[times.length - 1];
    List<Variable> variables = term.family().variables();
    double[][] range = new double[2][];
    int n = 0;
    for (Variable v : variables) {
      switch (v) {
        case PLACE -> {
          range[n++] = new double[] {arena.x0(), arena.x1()};
          range[n++] = new double[] {arena.y0(), arena.y1()};
        }
        case IMAGE_POSITION -> {
          Polynomial area = (Polynomial) term.family().basis();
          range[n++] = new double[] {area.fromX(), area.toX()};
          range[n++] = new double[] {area.fromY(), area.toY()};
        }
        case HEADING -> range[n++] = new double[] {-Math.PI, Math.PI};
        case SESSION_TIME ->
            range[n++] =
                term.family().basis() instanceof Harmonics h
                    ? new double[] {0, h.period()}
                    : new double[] {Math.min(0, session), session};
        case VERTICAL_SPEED -> range[n++] = new double[] {0, Math.max(rise, 1)};
        case HOP -> range[n++] = new double[] {1, 4};
        case TIME_SINCE_KICK -> range[n++] = new double[] {0, reachedBySome(ends(model, false))};
        case DISTANCE_ROLLED ->
            range[n++] =
                term.family().basis() instanceof Harmonics h
                    ? new double[] {0, h.period()}
                    : new double[] {0, reachedBySome(ends(model, true))};
        default -> range[n++] = new double[] {0, Math.max(speed, 1)};
      }
      if (n == 2) {
        break;
      }
    }
    return n == 2
        ? new Support(range[0][0], range[0][1], range[1][0], range[1][1])
        : Support.of(range[0][0], range[0][1]);
  }

  /** When each kick was last seen, s after the kick, or how far from it, m. */
  private static List<Double> ends(FittedModel model, boolean asDistance) {
    List<Double> ends = new ArrayList<>();
    for (int k = 0; k < model.kickCount(); k++) {
      ExtendedTrajectory path =
          model.kick(k).path(model.solution().own(k), model.solution().state());
      double last = model.kick(k).record().time(model.kick(k).record().size() - 1);
      BallState begin = path.stateAt(path.kickTime());
      BallState end = path.stateAt(last);
      ends.add(
          asDistance
              ? Math.hypot(end.x() - begin.x(), end.y() - begin.y())
              : last - path.kickTime());
    }
    return ends;
  }

  /** The largest value that more than {@link Decision#TOO_FEW_KICKS} kicks reach; the smallest with so few kicks, 0 without any. */
  private static double reachedBySome(List<Double> values) {
    List<Double> sorted = values.stream().sorted(Comparator.reverseOrder()).toList();
    return sorted.isEmpty() ? 0 : sorted.get(Math.min(Decision.TOO_FEW_KICKS, sorted.size() - 1));
  }
}
