package fieldcal.movement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The limit of acceleration or of braking, driven or turned, and whether it depends on speed or direction.
 *
 * <p>An effect is named when, with it, clearly more manoeuvres lie at the limit than at the best uniform limit, its coefficient is clearly not zero, and large enough to matter. By chance, an effect that
 * is not there gains about 1 % of the manoeuvres. The margins are wide enough for the eight tests that two teams need.
 */
final class AccelerationLimit {
  /** Fewest manoeuvres that determine a limit. */
  static final int FEWEST = 15;

  /** Fewest manoeuvres that show effects. */
  private static final int FEWEST_FOR_EFFECTS = 60;

  /** An effect is named if it brings at least this factor more manoeuvres to the limit. */
  private static final double GAIN = 1.1;

  /** An envelope, which has 36 numbers of its own, replaces the named effects if this factor more manoeuvres lie at it; by chance it is up to 1.05 in simulated matches of three minutes … */
  private static final double ENVELOPE_GAIN = 1.1;

  /** … or if its shape departs from theirs by this many standard errors, rms over the directions. By chance, and because the errors are a little too small, it is up to 1.6. */
  private static final double DEPARTS = 3;

  /**
   * From this factor on the shape may differ from the named one, and the limit with the envelope goes into the error. An ellipse that is 30 to 50 % weaker sideways, or braking by 1 − 0.3·sin²φ, had 1.05 to 1.13 and limits that were 4 to 10 % too large; teams with |sin φ| had up to 1.035.
   */
  private static final double DOUBTFUL_GAIN = 1.04;

  /** Standard errors by which a significant coefficient differs from zero. */
  private static final double SIGNIFICANT = 5;

  private static final double SMALLEST = 0.08;
  private static final double LARGEST = 0.97;

  /** If a smaller part of the manoeuvres lies at the limit, it was not reached. */
  private static final double REACHED = 0.1;

  /**
   * Error of the method apart from noise, as a part of the limit: corners of other shapes than a {@link Rounding} describes, and robots of a team that differ by 1 %. Half a per cent rms over 60 teams of another simulator (trapezoids, limited jerk, controllers that lag or plan with a
   * margin). It goes into the standard error.
   */
  static final double SYSTEMATIC = 0.006;

  /** The same for a limit that few manoeuvres reach: wrongly cut pieces made small clusters up to 3 % above the limit of two of these teams. */
  private static final double SYSTEMATIC_OF_FEW = 0.015;

  /**
   * How far off a mode is, in mean errors of its manoeuvres: wrongly cut pieces are mostly too weak, so that a measured limit tends to be too small. Turns of 0.1 s with errors of 8 % came out 6 % too small in simulated matches; well measured manoeuvres show no such error.
   */
  private static final double LEANING = 0.3;

  /**
   * Error of a coefficient of {@link MovementEffect#TORQUE_LIMITED} apart from noise, since pieces of constant acceleration stand for one that falls with speed: root mean square of 60 in simulated matches of ten minutes, whose errors by noise are 0.002.
   */
  private static final double SYSTEMATIC_TORQUE = 0.013;

  /** The same of {@link MovementEffect#DIRECTIONAL}: 20 of acceleration and 20 of braking were off by 0.0023 and 0.0027, and 60 and 60 of sin²φ by 0.0023 and 0.0043, with errors by noise below 0.001. */
  private static final double SYSTEMATIC_DIRECTIONAL = 0.004;

  private static final double[] COEFFICIENTS = {0, 0.3, 0.6};
  private static final double[] NARROWING = {0.3, 0.15, 0.07};

  private final ManoeuvreTable.Columns data;
  private final long samples;
  private final Kind kind;
  private final int robots;
  private final double velocity;

  /** The reduction of the limit that is known from elsewhere, and was taken out of the data. */
  private final Reduction shared;

  private final List<MovementEffect> named = new ArrayList<>();
  private SaturationFit.Uniform uniform;
  private SaturationFit.Mode mode;
  private Envelope envelope;

  /** What is limited, and on what that may depend. */
  enum Kind {
    /** Speeding up. */
    ACCELERATION("acceleration", MovementEffect.TORQUE_LIMITED, MovementEffect.DIRECTIONAL),
    /** Slowing down, as a positive number. It does not fall with speed: what slows the motors helps to brake. */
    BRAKING("braking", MovementEffect.DIRECTIONAL),
    /** Turning faster. */
    TURNING("turning"),
    /** Turning slower. */
    TURN_BRAKING("braking of turns");

    private final String label;
    private final List<MovementEffect> effects;

    Kind(String label, MovementEffect... effects) {
      this.label = label;
      this.effects = List.of(effects);
    }

    private boolean hasDirection() {
      return effects.contains(MovementEffect.DIRECTIONAL);
    }
  }

  /**
   * Estimates the limit from manoeuvres of one kind.
   *
   * @param velocity the team's limit, m/s; NaN when unknown or without meaning
   * @param robots number of robots that were seen to manoeuvre
   */
  AccelerationLimit(ManoeuvreTable table, Kind kind, double velocity, int robots) {
    this(table.columns(), table.samples(), kind, velocity, robots, Reduction.NONE);
  }

  private AccelerationLimit(
      ManoeuvreTable.Columns columns,
      long samples,
      Kind kind,
      double velocity,
      int robots,
      Reduction shared) {
    data = columns;
    this.robots = robots;
    this.velocity = velocity;
    this.shared = shared;
    this.samples = samples;
    this.kind = kind;
    if (samples < FEWEST) {
      return;
    }
    uniform = SaturationFit.uniform(data);
    if (uniform == null) {
      return;
    }
    mode = uniform.highest();
    if (samples < FEWEST_FOR_EFFECTS) {
      return;
    }
    select(candidates());
    if (shared == Reduction.NONE && kind.hasDirection()) {
      boolean fast = named.contains(MovementEffect.TORQUE_LIMITED);
      EnvelopeFit byDirection = envelopeFit(coefficient(MovementEffect.TORQUE_LIMITED));
      EnvelopeFit alone = fast ? envelopeFit(0) : null;
      if (alone != null && !(byDirection != null && byDirection.mass() > GAIN * alone.mass())) {
        // A dependence on direction that has another shape explains the manoeuvres without a
        // dependence on
        // speed.
        select(List.of(List.of(MovementEffect.DIRECTIONAL)));
        byDirection = alone;
      }
      envelope = envelope(byDirection);
    }
  }

  private List<List<MovementEffect>> candidates() {
    List<List<MovementEffect>> candidates = new ArrayList<>();
    if (kind.hasDirection()) {
      candidates.add(List.of(MovementEffect.DIRECTIONAL));
    }
    if (kind.effects.contains(MovementEffect.TORQUE_LIMITED) && velocity > 0) {
      candidates.add(List.of(MovementEffect.TORQUE_LIMITED));
      candidates.add(List.of(MovementEffect.TORQUE_LIMITED, MovementEffect.DIRECTIONAL));
    }
    return candidates;
  }

  /** Names the effects with which most manoeuvres lie at the limit, or none. */
  private void select(List<List<MovementEffect>> candidates) {
    mode = uniform.highest();
    named.clear();
    double most = uniform.largest().mass();
    for (List<MovementEffect> effects : candidates) {
      SaturationFit.Mode with = withEffects(effects);
      if (with != null && with.mass() > GAIN * most && believable(with)) {
        most = with.mass();
        mode = with;
        named.clear();
        named.addAll(effects);
      }
    }
  }

  /**
   * Braking of a team that accelerates less to the side. The same wheels brake, so its braking depends on the direction as well, even if too few manoeuvres brake at the limit to show it.
   */
  static AccelerationLimit braking(
      ManoeuvreTable table, double velocity, int robots, AccelerationLimit acceleration) {
    AccelerationLimit own = new AccelerationLimit(table, Kind.BRAKING, velocity, robots);
    int known = acceleration.named.indexOf(MovementEffect.DIRECTIONAL);
    if (known < 0 || !own.named.isEmpty() || own.shaped()) {
      return own;
    }
    Reduction byDirection =
        new Reduction(
            0, 0, acceleration.coefficient(known), acceleration.coefficientError(known), velocity);
    AccelerationLimit shared =
        new AccelerationLimit(
            byDirection.takenOut(table.columns()),
            table.samples(),
            Kind.BRAKING,
            velocity,
            robots,
            byDirection);
    if (shared.mode == null) {
      return own;
    }
    shared.envelope = own.envelope;
    return shared;
  }

  private static boolean believable(SaturationFit.Mode with) {
    for (int k = 1; k < with.beta().length; k++) {
      double coefficient = -with.beta()[k] / with.beta()[0];
      double error = with.errors()[k] / with.beta()[0];
      if (!(coefficient >= SMALLEST
          && coefficient <= LARGEST
          && coefficient > SIGNIFICANT * error)) {
        return false;
      }
    }
    return true;
  }

  private SaturationFit.Mode withEffects(List<MovementEffect> effects) {
    double[][] columns = new double[effects.size()][];
    for (int k = 0; k < columns.length; k++) {
      columns[k] = column(effects.get(k));
    }
    return new SaturationFit(data, columns).climbFromEverywhere(COEFFICIENTS, NARROWING);
  }

  private double[] column(MovementEffect effect) {
    if (effect == MovementEffect.DIRECTIONAL) {
      return data.sine();
    }
    double[] share = data.speed().clone();
    for (int i = 0; i < share.length; i++) {
      share[i] /= velocity;
    }
    return share;
  }

  /** The limit by direction, with a loss by speed taken out. */
  private EnvelopeFit envelopeFit(double torque) {
    Reduction bySpeed = new Reduction(torque, 0, 0, 0, velocity);
    return EnvelopeFit.of(bySpeed.takenOut(data), this::named);
  }

  /** What the named effects take from the limit. */
  private Reduction named() {
    int torque = named.indexOf(MovementEffect.TORQUE_LIMITED);
    int directional = named.indexOf(MovementEffect.DIRECTIONAL);
    return new Reduction(
        torque < 0 ? 0 : coefficient(torque),
        torque < 0 ? 0 : coefficientError(torque),
        directional < 0 ? 0 : coefficient(directional),
        directional < 0 ? 0 : coefficientError(directional),
        velocity);
  }

  private double coefficientError(int effect) {
    double systematic =
        named.get(effect) == MovementEffect.DIRECTIONAL
            ? SYSTEMATIC_DIRECTIONAL
            : SYSTEMATIC_TORQUE;
    return Math.hypot(mode.errors()[effect + 1] / mode.beta()[0], systematic);
  }

  /** The limit in a direction, from standstill, with the named effects. */
  private double named(double phi) {
    return mode.beta()[0] * named().directed(phi);
  }

  private Envelope envelope(EnvelopeFit fit) {
    if (fit == null) {
      return new Envelope(kind.label, List.of(), Double.NaN, Double.NaN, false);
    }
    double without = fit.shareAt(this::named);
    double with = fit.mass() / fit.total();
    List<Envelope.Point> points = fit.points();
    boolean proven = with > ENVELOPE_GAIN * without || departs(points);
    boolean better = with > without && proven && differs(points);
    return new Envelope(kind.label, points, without, with, better);
  }

  /** Whether the shape of an envelope clearly differs from that of the named effects, in some direction by enough to matter. Only the shape counts: the named limit may be larger by any factor, because robots may plan with less than they have. It may not be smaller. */
  private boolean departs(List<Envelope.Point> points) {
    double product = 0;
    double square = 0;
    for (Envelope.Point p : points) {
      double weight = 1 / (p.standardError() * p.standardError());
      product += weight * p.value() * named(p.angle());
      square += weight * named(p.angle()) * named(p.angle());
    }
    double scale = Math.min(1, product / square);
    double squares = 0;
    double most = 0;
    for (Envelope.Point p : points) {
      double off = p.value() - scale * named(p.angle());
      squares += off * off / (p.standardError() * p.standardError());
      most = Math.max(most, Math.abs(off) / p.value());
    }
    return most > SMALLEST && squares > DEPARTS * DEPARTS * points.size();
  }

  /** Whether the strongest and the weakest direction differ clearly and by enough to matter. */
  private static boolean differs(List<Envelope.Point> points) {
    Comparator<Envelope.Point> bySize = Comparator.comparingDouble(Envelope.Point::value);
    if (points.isEmpty()) {
      return false;
    }
    Envelope.Point most = points.stream().max(bySize).get();
    Envelope.Point least = points.stream().min(bySize).get();
    double error = Math.hypot(most.standardError(), least.standardError());
    double difference = most.value() - least.value();
    return difference > SMALLEST * most.value() && difference > SIGNIFICANT * error;
  }

  /** How far a limit is from that of an envelope which describes the manoeuvres somewhat better than what is named; 0 where it does not. */
  private double doubt(double limit) {
    boolean doubtful =
        named.contains(MovementEffect.DIRECTIONAL)
            && envelope != null
            && envelope.shareWith() > DOUBTFUL_GAIN * envelope.shareWithout();
    return doubtful
        ? envelope.strongest().map(most -> Math.abs(limit - most.value())).orElse(0.0)
        : 0;
  }

  private boolean shaped() {
    return envelope != null && envelope.shaped();
  }

  /** The limit by direction; empty when there are too few manoeuvres. */
  Optional<Envelope> byDirection() {
    return Optional.ofNullable(envelope);
  }

  LimitEstimate estimate() {
    if (mode == null) {
      return LimitEstimate.undetermined(samples, "needs " + FEWEST + " manoeuvres");
    }
    if (shaped()) {
      Envelope.Point most = envelope.strongest().orElseThrow();
      return estimate(most.value(), most.standardError(), envelope.shareWith());
    }
    Reduction effects = named();
    ManoeuvreTable.Columns reduced = effects.takenOut(data);
    ManoeuvreTable.Columns values = reduced.merged();
    UpperEdge edge = UpperEdge.of(values.acceleration(), values.error(), values.count());
    if (edge == null) {
      double systematic = Math.hypot(SYSTEMATIC * mode.beta()[0], LEANING * mode.noise());
      double open =
          UpperEdge.open(
              values.acceleration(), values.error(), values.count(), mode.beta()[0], REACHED);
      double error = Math.hypot(Math.hypot(mode.errors()[0], systematic), open);
      return estimate(mode.beta()[0], error, mode.share());
    }
    double differ = edge.scatter() / Math.sqrt(Math.max(1, robots));
    double part = edge.share() < REACHED ? SYSTEMATIC_OF_FEW : SYSTEMATIC;
    double coefficients = Math.hypot(effects.errorOf(edge, reduced), shared.errorOf(edge, reduced));
    double systematic = Math.hypot(part, coefficients) * edge.value();
    double random = Math.hypot(Math.hypot(edge.error(), differ), doubt(edge.value()));
    double error = Math.hypot(Math.hypot(random, systematic), edge.hidden());
    return estimate(edge.value(), error, edge.share());
  }

  private LimitEstimate estimate(double value, double error, double share) {
    boolean reached = share >= REACHED;
    String note =
        reached ? "" : "the robots seldom use all they have; few manoeuvres are at this limit";
    return new LimitEstimate(value, error, samples, reached, note);
  }

  private double coefficient(int effect) {
    return -mode.beta()[effect + 1] / mode.beta()[0];
  }

  /** The coefficient of an effect; 0 when it is not named. */
  private double coefficient(MovementEffect effect) {
    int known = named.indexOf(effect);
    return known < 0 ? 0 : coefficient(known);
  }

  /** The factors by which speed and direction reduce the limit of each row of a table of the same kind; 1 where nothing is known to. */
  double[] reduction(ManoeuvreTable.Columns rows) {
    Reduction effects = named();
    double[] factor = new double[rows.count().length];
    for (int i = 0; i < factor.length; i++) {
      double phi = rows.direction()[i];
      double there;
      if (shaped()) {
        double largest = envelope.strongest().orElseThrow().value();
        there = Double.isNaN(phi) ? phi : envelope.at(phi).orElse(Double.NaN) / largest;
      } else {
        there = effects.directed(phi);
      }
      factor[i] = there * effects.slowed(rows.speed()[i]);
    }
    return factor;
  }

  List<LimitDeviation> deviations() {
    List<LimitDeviation> list = new ArrayList<>();
    for (int k = 0; k < named.size(); k++) {
      list.add(
          new LimitDeviation(
              named.get(k),
              coefficient(k),
              coefficientError(k),
              kind.label,
              uniform.highest().share(),
              mode.share()));
    }
    return list;
  }
}
