package fieldcal.app.compare;

import fieldcal.app.wording.EffectName;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;

/** Finds what the simulator's ball has otherwise than the field's, each difference with the probability that chance makes it so large. */
final class Differences {
  /** A parameter of the ball's simple model. */
  private record BallParameter(String name, boolean chip) {
    String words() {
      return ParameterWords.of(name);
    }

    String unit() {
      return ParameterWords.unit(name).strip();
    }
  }

  private static final List<BallParameter> PARAMETERS =
      List.of(
          new BallParameter("accSlide", false),
          new BallParameter("accRoll", false),
          new BallParameter("kSwitch", false),
          new BallParameter("dampingXyFirstHop", true),
          new BallParameter("dampingXyOtherHops", true),
          new BallParameter("dampingZ", true));

  /** Fewest kicks of a kind whose parameters are compared: one does not show how much they scatter. */
  private static final int FEWEST = 2;

  private final Diagnosis real;
  private final Diagnosis sim;
  private final List<Difference> candidates = new ArrayList<>();
  private final List<Double> probabilities = new ArrayList<>();
  private final List<Row> rows = new ArrayList<>();

  private Differences(Diagnosis real, Diagnosis sim) {
    this.real = real;
    this.sim = sim;
  }

  /**
   * What differs, and all that was compared.
   *
   * @param significant the differences that chance does not explain
   * @param parameters a row for each parameter that both have
   */
  record Result(List<Difference> significant, List<Row> parameters) {}

  /** Everything that the diagnoses of both sides have of the ball. */
  static Differences of(Diagnosis real, Diagnosis sim) {
    Differences d = new Differences(real, sim);
    PARAMETERS.forEach(d::parameter);
    d.causes();
    return d;
  }

  /** Probabilities that chance makes each of the possible differences so large, in their order. */
  double[] probabilities() {
    return probabilities.stream().mapToDouble(v -> v).toArray();
  }

  /** What differs by the probabilities after correction for their number. */
  Result judged(double[] corrected) {
    List<Difference> significant = new ArrayList<>();
    for (int i = 0; i < corrected.length; i++) {
      if (corrected[i] < FieldComparison.ALPHA && isClearestOfItsCause(i)) {
        significant.add(candidates.get(i));
      }
    }
    Set<String> ids = significant.stream().map(Difference::id).collect(Collectors.toSet());
    return new Result(significant, rows.stream().map(r -> r.judged(ids.contains(r.id()))).toList());
  }

  /** Whether no other number of the same cause differs more certainly: a cause is one difference, however many of its numbers differ. */
  private boolean isClearestOfItsCause(int i) {
    UnaryOperator<ExtendedModel> change = candidates.get(i).asSimulated();
    int clearest = i;
    for (int j = 0; j < candidates.size(); j++) {
      boolean clearer = probabilities.get(j) < probabilities.get(clearest);
      boolean sameButFirst =
          probabilities.get(j).equals(probabilities.get(clearest)) && j < clearest;
      if (candidates.get(j).asSimulated() == change && (clearer || sameButFirst)) {
        clearest = j;
      }
    }
    return clearest == i;
  }

  private void candidate(Difference difference, double probability) {
    candidates.add(difference);
    probabilities.add(probability);
  }

  private static double byChance(double sigmas) {
    return 2 * new NormalDistribution().cumulativeProbability(-Math.abs(sigmas));
  }

  /**
   * Probability that chance gives a side a cause that the other side lacks. One that differs from kick to kick is there whatever its mean is: what chi-square rises by without it says so, with one degree of freedom for each parameter and one for the
   * scatter (Wilks 1938; a scatter cannot be negative, so the true probability is lower, Self and Liang 1987).
   */
  static double ofPresence(Cause cause, double sigmas) {
    if (cause.scatter() <= 0) {
      return byChance(sigmas);
    }
    double freedom = cause.standardErrors().size() + 1.0;
    return 1
        - new ChiSquaredDistribution(null, freedom).cumulativeProbability(2 * cause.evidence());
  }

  private void parameter(BallParameter p) {
    Optional<double[]> field = estimate(real, p);
    Optional<double[]> other = estimate(sim, p);
    if (field.isEmpty() || other.isEmpty()) {
      return;
    }
    double[] a = field.get();
    double[] b = other.get();
    rows.add(new Row(p.name, p.words(), p.unit(), a[0], a[1], b[0], b[1], false));
    candidate(
        new Difference(
            p.name, p.words(), a[0], a[1], b[0], b[1], p.unit(), m -> with(m, p.name, b[0])),
        byChance((b[0] - a[0]) / Math.hypot(a[1], b[1])));
  }

  /** The value in the extended model with its standard error there; empty when too few kicks show it. */
  private static Optional<double[]> estimate(Diagnosis diagnosis, BallParameter p) {
    KickKind kind = p.chip ? KickKind.CHIP : KickKind.FLAT;
    OptionalDouble value = value(diagnosis.model(), p.name);
    Double error = diagnosis.ballErrors().get(p.name);
    boolean few = diagnosis.kicks().stream().filter(k -> k.kind() == kind).count() < FEWEST;
    return few || value.isEmpty() || error == null
        ? Optional.empty()
        : Optional.of(new double[] {value.getAsDouble(), error});
  }

  private static OptionalDouble value(ExtendedModel m, String name) {
    OptionalDouble flat =
        m.flat().stream()
            .flatMap(f -> f.parameters().stream())
            .filter(p -> p.name().equals(name))
            .mapToDouble(p -> p.value())
            .findFirst();
    return flat.isPresent()
        ? flat
        : m.chip().stream()
            .flatMap(c -> c.parameters().stream())
            .filter(p -> p.name().equals(name))
            .mapToDouble(p -> p.value())
            .findFirst();
  }

  /** The same model with another value of a parameter, in both kinds of kicks that have it. */
  private static ExtendedModel with(ExtendedModel m, String name, double value) {
    Optional<FlatModel> flat =
        m.flat().map(f -> f.withParameters(values(f.parameters(), name, value)));
    Optional<ChipModel> chip =
        m.chip().map(c -> c.withParameters(values(c.parameters(), name, value)));
    return new ExtendedModel(flat, chip, m.effects(), m.sessionStart());
  }

  private static double[] values(List<Parameter> parameters, String name, double value) {
    return parameters.stream()
        .mapToDouble(p -> p.name().equals(name) ? value : p.value())
        .toArray();
  }

  private static ExtendedModel with(ExtendedModel m, UnaryOperator<List<Effect>> change) {
    return new ExtendedModel(
        m.flat(), m.chip(), change.apply(new ArrayList<>(m.effects())), m.sessionStart());
  }

  private static boolean same(Effect a, Effect b) {
    return a.id().equals(b.id()) && a.subject().equals(b.subject());
  }

  /** Causes of the ball's motion; what cameras do wrong is compared camera by camera, and no AI carries it to another field. */
  private void causes() {
    List<Cause> field = motion(real);
    List<Cause> other = motion(sim);
    for (Cause cause : field) {
      Optional<Cause> twin = like(cause, other);
      cause(Optional.of(cause), twin);
    }
    for (Cause cause : other) {
      if (like(cause, field).isEmpty()) {
        cause(Optional.empty(), Optional.of(cause));
      }
    }
    learned();
  }

  private static List<Cause> motion(Diagnosis diagnosis) {
    return diagnosis.causes().stream().filter(c -> c.effect() instanceof MotionEffect).toList();
  }

  /** The same cause, or one that explains the same kicks. */
  private static Optional<Cause> like(Cause cause, List<Cause> others) {
    return others.stream()
        .filter(
            o ->
                same(o.effect(), cause.effect())
                    || o.indistinguishableFrom().contains(cause.effect().id())
                    || cause.indistinguishableFrom().contains(o.effect().id()))
        .findFirst();
  }

  private void cause(Optional<Cause> field, Optional<Cause> other) {
    Cause any = field.or(() -> other).orElseThrow();
    boolean comparable =
        field.isEmpty()
            || other.isEmpty()
            || field.get().effect().id().equals(other.get().effect().id());
    if (!comparable) {
      // Two names of what these kicks cannot tell apart.
      return;
    }
    Optional<Effect> simulated = other.map(Cause::effect);
    UnaryOperator<ExtendedModel> asSimulated =
        m ->
            with(
                m,
                effects -> {
                  effects.removeIf(e -> same(e, any.effect()));
                  simulated.ifPresent(effects::add);
                  return effects;
                });
    if (field.isPresent() && other.isPresent()) {
      numbers(field.get(), other.get(), asSimulated);
    } else {
      presence(any, field.isPresent(), asSimulated);
    }
  }

  /** A cause that one side lacks is there or not by its magnitude. */
  private void presence(Cause cause, boolean ofTheField, UnaryOperator<ExtendedModel> asSimulated) {
    Parameter magnitude = cause.effect().parameters().get(0);
    double value = magnitude.value();
    double error = error(cause, magnitude.name());
    double nan = Double.NaN;
    candidate(
        new Difference(
            cause.effect().id(),
            EffectName.of(cause.effect()),
            ofTheField ? value : nan,
            ofTheField ? error : nan,
            ofTheField ? nan : value,
            ofTheField ? nan : error,
            magnitude.unit(),
            asSimulated),
        ofPresence(cause, error > 0 ? value / error : Double.POSITIVE_INFINITY));
  }

  /** A cause that both sides have may differ in any number that was estimated on both. */
  private void numbers(Cause field, Cause other, UnaryOperator<ExtendedModel> asSimulated) {
    Effect effect = field.effect();
    List<Parameter> parameters = effect.parameters();
    for (int i = 0; i < parameters.size(); i++) {
      Parameter p = parameters.get(i);
      double a = p.value();
      double b = other.effect().value(p.name());
      double ea = error(field, p.name());
      double eb = error(other, p.name());
      double error = Math.hypot(ea, eb);
      if (!(error > 0)) {
        continue;
      }
      boolean first = i == 0;
      candidate(
          new Difference(
              first ? effect.id() : effect.id() + "." + p.name(),
              EffectName.of(effect) + (first ? "" : ", " + p.name().replace('_', ' ')),
              a,
              ea,
              b,
              eb,
              p.unit(),
              asSimulated),
          byChance(distance(a, b, p.unit()) / error));
    }
  }

  /** How far apart two values are; of angles the short way round. */
  private static double distance(double a, double b, String unit) {
    return unit.equals("rad") ? Math.IEEEremainder(b - a, 2 * Math.PI) : b - a;
  }

  private static double error(Cause cause, String parameter) {
    return cause.standardErrors().getOrDefault(parameter, Double.NaN);
  }

  /** Learned terms that one has and the other lacks; a term has passed a test on kicks held out. Of two of one family the shapes are not compared. */
  private void learned() {
    List<LearnedTerm> field = learned(real);
    List<LearnedTerm> other = learned(sim);
    for (LearnedTerm term : field) {
      if (other.stream().noneMatch(o -> same(o, term))) {
        learned(term, m -> with(m, effects -> without(effects, term)));
      }
    }
    for (LearnedTerm term : other) {
      if (field.stream().noneMatch(o -> same(o, term))) {
        learned(
            term,
            m ->
                with(
                    m,
                    effects -> {
                      effects.add(term);
                      return effects;
                    }));
      }
    }
  }

  private void learned(LearnedTerm term, UnaryOperator<ExtendedModel> asSimulated) {
    String words =
        "a change of "
            + term.family().quantity().label().replace('_', ' ')
            + " with "
            + String.join(" and ", term.dependsOn()).replace('_', ' ');
    double nan = Double.NaN;
    candidate(
        new Difference(
            "learned " + term.family().key(), words, nan, nan, nan, nan, "", asSimulated),
        0);
  }

  private static List<Effect> without(List<Effect> effects, LearnedTerm term) {
    effects.removeIf(e -> same(e, term));
    return effects;
  }

  private static List<LearnedTerm> learned(Diagnosis diagnosis) {
    return diagnosis.model().effects().stream()
        .filter(e -> e instanceof LearnedTerm && e instanceof MotionEffect)
        .map(LearnedTerm.class::cast)
        .toList();
  }
}
