package fieldcal.app.play;

import fieldcal.app.play.SeenKick.Sighting;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffect.ImpactLaw;
import fieldcal.effect.MotionEffect.SpinAtKick;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * One explanation of recorded kicks: a ball model with effects, how well the kicks determine its numbers, and what it predicts of others. Each kick has position, velocity and time of its own, and spin where
 * that is part of the explanation; the model's parameters and the effects' magnitudes are shared by all. Linear about where it stands; unknowns are counted in steps. Immutable.
 */
final class Explanation {
  /** A step of a model's parameter, as a share of it. */
  private static final double STEP = 0.01;

  /** What is known of a parameter beforehand, in steps: half of its value. */
  private static final double KNOWN = 50;

  /** A step of an effect, as a share of a small one of its kind, and what is expected of one beforehand, in steps: four small ones. */
  private static final double EFFECT_STEP = 0.1;

  private static final double EFFECT_KNOWN = 40;

  /** How spin differs from kick to kick, in steps of a hundredth: the ten matches of 2026 had 0.2. */
  private static final double SPIN_KNOWN = 20;

  /** Steps of a kick's own unknowns: place, m; velocity, m/s; time, s. */
  private static final double PLACE_STEP = 1e-3;

  private static final double VELOCITY_STEP = 1e-2;
  private static final double TIME_STEP = 1e-3;

  /** Keeps what a kick does not determine from making its equations singular. */
  private static final double FLOOR = 1e-8;

  private static final int ROUNDS = 4;

  private final ExtendedModel base;
  private final List<ObservedCamera> observers;
  private final List<Effect> shared = new ArrayList<>();
  private final List<Effect> ofEachKick = new ArrayList<>();
  private final double[] at;
  private final Variant centre;
  private final List<Variant> stepped = new ArrayList<>();
  private final RealMatrix information;

  /** A model ready to predict. */
  private record Variant(
      FlatModel flat, ChipModel chip, MotionEffects motion, MeasurementEffects seen, double start) {
    ExtendedTrajectory path(SeenKick kick, double[] s, MotionEffects acting) {
      double t0 = s[kick.timeIndex()];
      return kick.kind() == KickKind.FLAT
          ? ExtendedTrajectory.flat(flat, acting, start, t0, s[0], s[1], s[2], s[3])
          : ExtendedTrajectory.chipWithHops(
              chip, acting, start, t0, s[0], s[1], s[2], s[3], Math.max(0, s[4]), kick.flights());
    }

    /** Reported positions, each divided by its noise. */
    double[] report(SeenKick kick, ExtendedTrajectory path) {
      double[] out = new double[2 * kick.sightings().size()];
      double[] ball = new double[3];
      double[] ground = new double[2];
      int n = 0;
      for (Sighting s : kick.sightings()) {
        path.positionAt(seen.ballTime(s.camera(), s.stamp() - start, s.row()) + start, ball);
        seen.report(s.camera(), s.stamp() - start, ball, ground);
        out[n++] = s.weight() * ground[0];
        out[n++] = s.weight() * ground[1];
      }
      return out;
    }

    double[] predict(SeenKick kick) {
      return report(kick, path(kick, kick.start(), motion));
    }
  }

  /** One kick's equations for the shared unknowns, its own eliminated. */
  private record Equations(RealMatrix normal, RealVector right, double rest) {}

  private Explanation(
      ExtendedModel base, List<ObservedCamera> observers, double[] at, RealMatrix information) {
    this.base = base;
    this.observers = observers;
    for (Effect effect : base.effects()) {
      if (!(effect instanceof KickerEffect) && !isForm(effect)) {
        List<Effect> to = effect instanceof SpinAtKick ? ofEachKick : shared;
        effect.probes().stream().filter(probe -> moves(effect, probe)).forEach(to::add);
      }
    }
    this.at = at == null ? new double[parameters().size() + shared.size()] : at;
    this.information = information == null ? beforehand() : information;
    centre = variant(this.at);
    for (int k = 0; k < this.at.length; k++) {
      double[] more = this.at.clone();
      more[k]++;
      stepped.add(variant(more));
    }
  }

  /**
   * An explanation of which nothing is known but its numbers.
   *
   * @param model a part that no kick told anything of is taken to be typical
   */
  static Explanation of(ExtendedModel model, List<ObservedCamera> observers) {
    ExtendedModel whole =
        new ExtendedModel(
            Optional.of(model.flat().orElse(FlatModel.typical())),
            Optional.of(model.chip().orElse(ChipModel.typical())),
            model.effects(),
            model.sessionStart());
    return new Explanation(whole, observers, null, null);
  }

  /** A learned curve or a law of impacts is the form of the model: it holds as it is. */
  private static boolean isForm(Effect effect) {
    return effect instanceof LearnedTerm || effect instanceof ImpactLaw;
  }

  /** Only magnitudes that the explanation uses may move. */
  private static boolean moves(Effect effect, Effect probe) {
    return probe.magnitudes().stream()
        .allMatch(name -> probe.value(name) == 0 || effect.value(name) != 0);
  }

  private List<Parameter> parameters() {
    List<Parameter> all = new ArrayList<>(base.flat().orElseThrow().parameters());
    all.addAll(base.chip().orElseThrow().parameters());
    return all;
  }

  private RealMatrix beforehand() {
    RealMatrix known = MatrixUtils.createRealMatrix(at.length, at.length);
    for (int k = 0; k < at.length; k++) {
      double width = k < parameters().size() ? KNOWN : EFFECT_KNOWN;
      known.setEntry(k, k, 1 / (width * width));
    }
    return known;
  }

  private Variant variant(double[] steps) {
    List<Parameter> all = parameters();
    double[] values = new double[all.size()];
    for (int k = 0; k < values.length; k++) {
      Parameter p = all.get(k);
      values[k] = p.clamp(p.value() * (1 + STEP * steps[k]));
    }
    List<Effect> effects = new ArrayList<>(base.effects());
    for (int k = 0; k < shared.size(); k++) {
      effects.add(scaled(shared.get(k), EFFECT_STEP * steps[values.length + k]));
    }
    ExtendedModel model = new ExtendedModel(base.flat(), base.chip(), effects, base.sessionStart());
    return new Variant(
        base.flat().orElseThrow().withParameters(values[0], values[1], values[2]),
        base.chip().orElseThrow().withParameters(values[3], values[4], values[5], values[6]),
        model.motion(),
        MeasurementEffects.of(observers, model.measurement()),
        model.sessionStart());
  }

  private static Effect scaled(Effect probe, double factor) {
    Effect scaled = probe;
    for (String name : probe.magnitudes()) {
      scaled = scaled.with(name, factor * probe.value(name));
    }
    return scaled;
  }

  /** The same, knowing what these kicks tell of its numbers. */
  Explanation knowing(List<SeenKick> kicks) {
    RealMatrix known = beforehand();
    for (SeenKick kick : kicks) {
      double[] nothing = new double[2 * kick.sightings().size()];
      known = known.add(equations(kick, nothing).normal);
    }
    return new Explanation(base, observers, at, known);
  }

  /** With the numbers that explain kicks best which went as another explanation has them. */
  Explanation fittedTo(Explanation other, List<SeenKick> kicks) {
    Explanation now = this;
    for (int round = 0; round < ROUNDS; round++) {
      RealMatrix normal = now.beforehand();
      RealVector right = new ArrayRealVector(at.length);
      for (SeenKick kick : kicks) {
        Equations e = now.equations(kick, now.residual(kick, other));
        normal = normal.add(e.normal);
        right = right.add(e.right);
      }
      double[] better = now.at.clone();
      RealVector step = solve(normal, right);
      for (int k = 0; k < better.length; k++) {
        better[k] += step.getEntry(k);
      }
      now = new Explanation(base, observers, better, null);
    }
    return now.knowing(kicks);
  }

  /**
   * By how much chi-square would be larger under this explanation, refitted, than under another that is right, once a kick is made: the leading term of Box and Hill's
   * expected discrimination (Technometrics 9, 1967, p. 57).
   */
  double misfit(SeenKick kick, Explanation right) {
    Equations e = equations(kick, residual(kick, right));
    RealVector step = solve(information.add(e.normal), e.right);
    return Math.max(0, e.rest - e.right.dotProduct(step));
  }

  private double[] residual(SeenKick kick, Explanation right) {
    return minus(right.centre.predict(kick), centre.predict(kick));
  }

  private Equations equations(SeenKick kick, double[] residual) {
    ExtendedTrajectory path = centre.path(kick, kick.start(), centre.motion);
    double[] here = centre.report(kick, path);
    RealMatrix own = ownColumns(kick, here);
    RealMatrix common = new Array2DRowRealMatrix(here.length, at.length);
    for (int k = 0; k < at.length; k++) {
      int effect = k - parameters().size();
      boolean seenOnly = effect >= 0 && shared.get(effect) instanceof MeasurementEffect;
      Variant v = stepped.get(k);
      common.setColumn(k, minus(seenOnly ? v.report(kick, path) : v.predict(kick), here));
    }
    RealVector r = new ArrayRealVector(residual, false);
    RealMatrix oo = own.transpose().multiply(own);
    for (int k = 0; k < oo.getRowDimension(); k++) {
      boolean spin = k > kick.timeIndex();
      double floor = FLOOR * (1 + oo.getEntry(k, k));
      oo.addToEntry(k, k, spin ? 1 / (SPIN_KNOWN * SPIN_KNOWN) : floor);
    }
    RealMatrix os = own.transpose().multiply(common);
    RealVector bo = own.preMultiply(r);
    CholeskyDecomposition factor = new CholeskyDecomposition(oo, 1e-6, 0);
    RealMatrix absorbed = factor.getSolver().solve(os);
    return new Equations(
        common.transpose().multiply(common).subtract(os.transpose().multiply(absorbed)),
        common.preMultiply(r).subtract(absorbed.preMultiply(bo)),
        r.dotProduct(r) - bo.dotProduct(factor.getSolver().solve(bo)));
  }

  private RealMatrix ownColumns(SeenKick kick, double[] here) {
    int size = kick.start().length;
    RealMatrix own = new Array2DRowRealMatrix(here.length, size + ofEachKick.size());
    for (int k = 0; k < size; k++) {
      double[] s = kick.start().clone();
      s[k] += k < 2 ? PLACE_STEP : k < kick.timeIndex() ? VELOCITY_STEP : TIME_STEP;
      own.setColumn(k, minus(centre.report(kick, centre.path(kick, s, centre.motion)), here));
    }
    for (int k = 0; k < ofEachKick.size(); k++) {
      Effect more = scaled(ofEachKick.get(k), EFFECT_STEP);
      MotionEffects acting = and(centre.motion, more);
      own.setColumn(
          size + k, minus(centre.report(kick, centre.path(kick, kick.start(), acting)), here));
    }
    return own;
  }

  private static MotionEffects and(MotionEffects some, Effect more) {
    List<MotionEffect> all = new ArrayList<>(some.effects());
    all.add((SpinAtKick) more);
    return MotionEffects.of(all);
  }

  private static double[] minus(double[] a, double[] b) {
    double[] out = a.clone();
    for (int i = 0; i < a.length; i++) {
      out[i] -= b[i];
    }
    return out;
  }

  private static RealVector solve(RealMatrix normal, RealVector right) {
    return new CholeskyDecomposition(normal, 1e-6, 0).getSolver().solve(right);
  }
}
