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

  private final List<Pair> pairs;
  private final List<ObservedCamera> observers;
  private final CameraViews views;
  private final double time;

  /** Two explanations of the same kicks. */
  private record Pair(
      String words, String advice, ExtendedModel model, Explanation named, Explanation rival) {
    double expected(SeenKick kick) {
      return 0.5 * (rival.misfit(kick, named) + named.misfit(kick, rival));
    }
  }

  private UndecidedCauses(
      List<Pair> pairs, List<ObservedCamera> observers, CameraViews views, double time) {
    this.pairs = pairs;
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
    List<Pair> pairs = new ArrayList<>();
    Explanation named = null;
    for (Cause cause : diagnosis.causes()) {
      for (String id : cause.indistinguishableFrom()) {
        Optional<Effect> rival = rival(diagnosis, id);
        if (rival.isPresent()) {
          named = named == null ? Explanation.of(model, observers).knowing(kicks) : named;
          Explanation other =
              Explanation.of(instead(model, cause.effect(), rival.get()), observers)
                  .fittedTo(named, kicks);
          String words = EffectName.of(cause.effect()) + " or " + EffectName.of(rival.get());
          pairs.add(
              new Pair(
                  words,
                  NextKicks.toTellApart(cause.effect().id(), cause.indistinguishableFrom()),
                  whole(model),
                  named,
                  other));
        }
      }
    }
    double last = diagnosis.kicks().stream().mapToDouble(k -> k.kick().endTime()).max().orElse(0);
    return new UndecidedCauses(pairs, observers, outcome.problem().cameras(), last + BETWEEN);
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

  boolean isEmpty() {
    return pairs.isEmpty();
  }

  /** When the next kick may be, s. */
  double time() {
    return time;
  }

  /** How much a kick is expected to tell: chi-square by which the wrong one of two explanations falls behind, of all that are undecided; more than enough for one counts little. */
  double expected(SeenKick.Plan plan) {
    double sum = 0;
    for (Pair pair : pairs) {
      double told = pair.expected(SeenKick.of(plan, pair.model, observers, views));
      sum += told / (1 + told / TOLD_APART);
    }
    return sum;
  }

  /** For the operator: one line for each pair. */
  List<String> words() {
    return pairs.stream().map(Pair::words).toList();
  }

  /** Which kicks of any sort would tell them apart, for the operator. */
  List<String> advice() {
    return pairs.stream().map(Pair::advice).distinct().toList();
  }
}
