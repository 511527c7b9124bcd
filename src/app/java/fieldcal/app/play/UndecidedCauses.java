package fieldcal.app.play;

import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.wording.EffectName;
import fieldcal.app.wording.NextKicks;
import fieldcal.app.wording.Rival;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraViews;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Causes that a diagnosis could not tell from others, and what a kick would do to tell them apart. Immutable. */
final class UndecidedCauses {
  /** Chi-square difference from which on two explanations are told apart: twice the evidence that a diagnosis asks for. */
  private static final double TOLD_APART = 12;

  /** A kick of which less chi-square than this is expected distinguishes nothing, however often it is repeated. */
  static final double LEAST = 0.5;

  /** The next kick comes about that long after the last one, s. */
  private static final double BETWEEN = 10;

  /** Nothing is undecided, or nothing known. */
  static final UndecidedCauses NONE =
      new UndecidedCauses(List.of(), List.of(), CameraViews.of(List.of()), 0);

  private final List<Open> all;
  private final List<ObservedCamera> observers;
  private final CameraViews views;
  private final double time;

  /** Two causes of which either explains the recorded kicks; with their explanations when kicks may tell them apart. */
  private record Open(String words, String advice, Optional<Pair> byKicks) {}

  /** Two explanations of the same kicks, which other kicks may tell apart. */
  private record Pair(ExtendedModel model, Explanation named, Explanation rival) {
    double expected(SeenKick kick) {
      return 0.5 * (rival.misfit(kick, named) + named.misfit(kick, rival));
    }
  }

  private UndecidedCauses(
      List<Open> all, List<ObservedCamera> observers, CameraViews views, double time) {
    this.all = all;
    this.observers = observers;
    this.views = views;
    this.time = time;
  }

  /** What a diagnosis left open; none when it named no cause, or only ones without a rival. */
  static UndecidedCauses of(DiagnosisOutcome outcome) {
    Diagnosis diagnosis = outcome.diagnosis();
    ExtendedModel model = diagnosis.model();
    List<ObservedCamera> observers = outcome.problem().observers();
    List<SeenKick> kicks =
        diagnosis.kicks().stream()
            .map(k -> SeenKick.of(k, model, outcome.problem().cameras()))
            .toList();
    List<Open> all = new ArrayList<>();
    Explanation named = null;
    for (Cause cause : diagnosis.causes()) {
      String sort = cause.effect().id();
      for (String id : cause.indistinguishableFrom()) {
        Optional<Effect> rival = rival(diagnosis, id);
        if (rival.isEmpty()) {
          continue;
        }
        Optional<Pair> byKicks = Optional.empty();
        if (NextKicks.canTellApart(sort, id)) {
          named = named == null ? Explanation.of(model, observers).knowing(kicks) : named;
          Explanation other =
              Explanation.of(instead(model, cause.effect(), rival.get()), observers)
                  .fittedTo(named, kicks);
          byKicks = Optional.of(new Pair(whole(model), named, other));
        }
        String words = EffectName.of(cause.effect()) + " or " + EffectName.of(rival.get());
        String advice = NextKicks.toTellApart(sort, cause.indistinguishableFrom());
        all.add(new Open(words, advice, byKicks));
      }
    }
    double last = diagnosis.kicks().stream().mapToDouble(k -> k.kick().endTime()).max().orElse(0);
    return new UndecidedCauses(all, observers, outcome.problem().cameras(), last + BETWEEN);
  }

  /** The rival as the diagnosis tried it: of several places or cameras, the one that explains most. */
  private static Optional<Effect> rival(Diagnosis diagnosis, String id) {
    Optional<Rival> ofCamera = Rival.ofCamera(id);
    String sort = ofCamera.map(Rival::id).orElse(id);
    return diagnosis.candidates().stream()
        .filter(c -> c.effect().id().equals(sort) && !c.named())
        .filter(c -> ofCamera.isEmpty() || isOf(ofCamera.get().camera(), c.effect()))
        .max(Comparator.comparingDouble(Candidate::scoreGain))
        .map(Candidate::effect);
  }

  private static boolean isOf(int camera, Effect effect) {
    return effect.parameters().stream()
        .anyMatch(p -> p.name().equals("camera") && p.value() == camera);
  }

  private static ExtendedModel instead(ExtendedModel model, Effect cause, Effect rival) {
    List<Effect> effects = new ArrayList<>(model.effects());
    effects.remove(cause);
    effects.add(rival);
    return new ExtendedModel(model.flat(), model.chip(), effects, model.sessionStart());
  }

  /** With a model of the kind of kick that was not made yet. */
  private static ExtendedModel whole(ExtendedModel m) {
    return new ExtendedModel(
        Optional.of(m.flat().orElse(FlatModel.typical())),
        Optional.of(m.chip().orElse(ChipModel.typical())),
        m.effects(),
        m.sessionStart());
  }

  /** Whether kicks, of whatever sort, may tell any two of them apart. */
  boolean mayBeTold() {
    return pairs().findAny().isPresent();
  }

  private Stream<Pair> pairs() {
    return all.stream().flatMap(open -> open.byKicks().stream());
  }

  /** When the next kick may be, s. */
  double time() {
    return time;
  }

  /** How much a kick is expected to tell: chi-square by which the wrong one of two explanations falls behind, of all that kicks may tell apart; more than enough for one counts little. */
  double expected(SeenKick.Plan plan) {
    return pairs()
        .mapToDouble(pair -> pair.expected(SeenKick.of(plan, pair.model, observers, views)))
        .map(told -> told / (1 + told / TOLD_APART))
        .sum();
  }

  /** For the operator: one line for each pair. */
  List<String> words() {
    return all.stream().map(Open::words).toList();
  }

  /** Those of {@link #words} that kicks may tell apart. */
  List<String> wordsByKicks() {
    return all.stream().filter(open -> open.byKicks().isPresent()).map(Open::words).toList();
  }

  /** What would tell them apart, for the operator. */
  List<String> advice() {
    return all.stream().map(Open::advice).distinct().toList();
  }
}
