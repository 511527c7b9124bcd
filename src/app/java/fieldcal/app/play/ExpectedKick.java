package fieldcal.app.play;

import fieldcal.app.play.SeenKick.Sighting;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.diagnosis.model.Component;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffects;
import fieldcal.fit.joint.KickTerm;
import fieldcal.fit.joint.Probe;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A kick that goes as one explanation has it, seen by another: a term of the kernel. Per-kick parameters: position, velocity and time (m, m/s, s), then what the kick adds to each magnitude that differs from kick to kick. Immutable.
 */
final class ExpectedKick implements KickTerm<ExpectedKick.State> {
  /** Steps of the derivatives by the per-kick parameters: place, m; velocity, m/s; time, s; share of an effect's scale. */
  private static final double PLACE_STEP = 1e-3;

  private static final double VELOCITY_STEP = 1e-2;
  private static final double TIME_STEP = 1e-3;
  private static final double EFFECT_STEP = 0.1;

  /** How spin, in units of rolling spin, differs from kick to kick: the ten matches of 2026 had 0.2. */
  private static final double SPIN_SCATTER = 0.2;

  private final SeenKick kick;
  private final List<Component> ofEachKick;
  private final double[] expected;

  /**
   * A model ready to predict.
   *
   * @param flat how the ball slides and rolls
   * @param chip how it bounces
   * @param motion what else moves it
   * @param seen what cameras make of it
   * @param start begin of the session, s
   */
  record State(
      FlatModel flat, ChipModel chip, MotionEffects motion, MeasurementEffects seen, double start) {
    private boolean hasMotionOf(State other) {
      return flat.equals(other.flat)
          && chip.equals(other.chip)
          && motion.effects().equals(other.motion.effects());
    }
  }

  /**
   * A kick.
   *
   * @param kick where it starts and when it is seen
   * @param right what it goes like
   * @param ofEachKick effects that differ from kick to kick, absent
   */
  ExpectedKick(SeenKick kick, State right, List<Component> ofEachKick) {
    this.kick = kick;
    this.ofEachKick = ofEachKick;
    expected = report(right, path(start(), right));
  }

  /** As the kick was made, with no more spin than the model has. */
  double[] start() {
    return Arrays.copyOf(kick.start(), ownSize());
  }

  private ExtendedTrajectory path(double[] own, State state) {
    MotionEffects acting = acting(own, state);
    double t0 = own[kick.timeIndex()];
    return kick.kind() == KickKind.FLAT
        ? ExtendedTrajectory.flat(
            state.flat, acting, state.start, t0, own[0], own[1], own[2], own[3])
        : ExtendedTrajectory.chipWithHops(
            state.chip,
            state.flat,
            acting,
            state.start,
            t0,
            own[0],
            own[1],
            own[2],
            own[3],
            Math.max(0, own[4]),
            kick.flights());
  }

  private MotionEffects acting(double[] own, State state) {
    List<MotionEffect> all = new ArrayList<>(state.motion.effects());
    int k = kick.timeIndex() + 1;
    for (Component component : ofEachKick) {
      MotionEffect more = (MotionEffect) component.effect(own, k);
      if (!more.isAbsent()) {
        all.add(more);
      }
      k += component.size();
    }
    return all.size() == state.motion.effects().size() ? state.motion : MotionEffects.of(all);
  }

  /** Reported positions, each divided by its noise. */
  private double[] report(State state, ExtendedTrajectory path) {
    double[] out = new double[rows()];
    double[] ball = new double[3];
    double[] ground = new double[2];
    int n = 0;
    for (Sighting s : kick.sightings()) {
      double since = s.stamp() - state.start;
      double speed = path.stateAt(s.stamp()).groundSpeed();
      path.positionAt(state.seen.ballTime(s.camera(), since, s.row(), speed) + state.start, ball);
      state.seen.report(s.camera(), since, ball, ground);
      out[n++] = s.weight() * ground[0];
      out[n++] = s.weight() * ground[1];
    }
    return out;
  }

  @Override
  public int ownSize() {
    return kick.start().length + ofEachKick.stream().mapToInt(Component::size).sum();
  }

  @Override
  public int rows() {
    return 2 * kick.sightings().size();
  }

  @Override
  public void residuals(double[] own, State state, double[] out) {
    double[] here = report(state, path(own, state));
    for (int i = 0; i < here.length; i++) {
      out[i] = expected[i] - here[i];
    }
  }

  @Override
  public void ownColumns(double[] own, State state, double[] residuals, double[][] columns) {
    double[] here = report(state, path(own, state));
    for (int k = 0; k < own.length; k++) {
      double[] moved = own.clone();
      double h = step(k);
      moved[k] += h;
      difference(report(state, path(moved, state)), here, h, columns[k]);
    }
  }

  @Override
  public void sharedColumns(
      double[] own,
      State state,
      double[] residuals,
      List<Probe<State>> probes,
      double[][] columns) {
    ExtendedTrajectory path = path(own, state);
    double[] here = report(state, path);
    for (int c = 0; c < columns.length; c++) {
      Probe<State> probe = probes.get(c);
      double[] from = probe.from() == null ? here : moved(own, state, path, probe.from());
      difference(moved(own, state, path, probe.to()), from, probe.width(), columns[c]);
    }
  }

  /** What is reported under another state. */
  private double[] moved(double[] own, State state, ExtendedTrajectory path, State there) {
    return report(there, there.hasMotionOf(state) ? path : path(own, there));
  }

  private static void difference(double[] to, double[] from, double h, double[] column) {
    for (int i = 0; i < column.length; i++) {
      column[i] = (to[i] - from[i]) / h;
    }
  }

  private double step(int k) {
    if (k < 2) {
      return PLACE_STEP;
    }
    if (k < kick.timeIndex()) {
      return VELOCITY_STEP;
    }
    return k == kick.timeIndex() ? TIME_STEP : EFFECT_STEP * scaleOfEffect(k);
  }

  private double scaleOfEffect(int k) {
    return ofEachKick.stream()
        .flatMap(c -> c.coordinates().stream())
        .toList()
        .get(k - kick.timeIndex() - 1)
        .scale();
  }

  @Override
  public double ownPrior(int index) {
    return 0;
  }

  @Override
  public double ownPrecision(int index) {
    return index > kick.timeIndex() ? 1 / (SPIN_SCATTER * SPIN_SCATTER) : 0;
  }
}
