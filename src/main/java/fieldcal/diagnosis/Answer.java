package fieldcal.diagnosis;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.diagnosis.validation.FormErrors;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What was decided, and the diagnosis that it makes. Immutable.
 *
 * @param decided the model that was chosen, beside the simple one
 * @param kickers causes that only commands show
 */
record Answer(Decided decided, List<Cause> kickers) {

  /** The diagnosis, with what was tried and what failed. */
  Diagnosis diagnosis(List<SearchStep> trace, List<String> problems) {
    FittedModel base = decided.base();
    FittedModel extended = decided.model();
    FittedModel free = withPlacesFree(extended);
    double[] ofForms = FormErrors.variances(free);
    List<Judgement> judged = decided.best().judged();
    Leftover after = Leftover.ofSeen(extended);
    List<Integer> named = told(judged);
    List<Cause> causes = new ArrayList<>();
    List<LearnedFinding> learned = new ArrayList<>();
    for (int i = 0; i < judged.size(); i++) {
      Judgement j = judged.get(i);
      if (named.contains(i)) {
        List<String> ties = decided.screened().decision().ties(extended, i, j);
        causes.add(cause(j, errors(free, i, ofForms), ties));
      } else {
        learned.add(LearnedFindings.of(extended, i, j, decided.screened().arena()));
      }
    }
    learned.sort((x, y) -> Double.compare(y.gain().mm(), x.gain().mm()));
    List<Cause> robots = kickers.subList(0, Math.min(kickers.size(), mostCauses() - causes.size()));
    causes.addAll(robots);
    causes.sort((x, y) -> Double.compare(y.evidence(), x.evidence()));
    List<StructureProfile> before = Profiles.of(base, decided.screened().problem().sessionStart());
    List<StructureProfile> left =
        Profiles.of(extended, decided.screened().problem().sessionStart());
    Quality quality = Quality.of(base, decided.heldBase());
    Unexplained unexplained =
        new Unexplained(
            after.isSignificant(),
            quality.noiseMm() * Math.sqrt(Math.max(0, after.systematic())),
            after.deviation(),
            after.isSignificant() ? Profiles.named(left) : List.of());
    return new Diagnosis(
        verdict(causes, learned, unexplained.significant()),
        quality,
        Quality.of(extended, decided.best().held()),
        causes,
        learned,
        candidates(causes),
        unexplained,
        before,
        left,
        residuals(),
        model(base, List.of()),
        model(extended, robots),
        trace,
        problems,
        ballErrors(free, ofForms),
        decided.screened().seed());
  }

  private int mostCauses() {
    return decided.screened().problem().maxCauses();
  }

  /** The components that are told as causes: those with a name, the most evident where there are too many. The others stay in the model and are told among what was learned. */
  private List<Integer> told(List<Judgement> judged) {
    return IntStream.range(0, judged.size())
        .filter(i -> judged.get(i).isName())
        .boxed()
        .sorted(Comparator.comparingDouble(i -> -judged.get(i).evidence()))
        .limit(mostCauses())
        .toList();
  }

  /** The same model with its places free, too, for the errors; the places themselves hardly move any more. */
  private FittedModel withPlacesFree(FittedModel model) {
    DiagnosisCase at = decided.screened();
    boolean none = model.model().components().stream().noneMatch(Component::hasPlace);
    return none
        ? model
        : at.fitter().fitWithPlaces(model, Weighing.ALIKE, at.solver().withMaxIterations(1));
  }

  /** Standard errors of what is estimated; those of places are not given. */
  private static Map<String, Double> errors(FittedModel free, int component, double[] ofForms) {
    Map<String, Double> errors =
        new LinkedHashMap<>(free.errors(component, ofForms).orElse(Map.of()));
    errors.keySet().removeAll(free.model().components().get(component).template().places());
    return errors;
  }

  private static Map<String, Double> ballErrors(FittedModel f, double[] ofForms) {
    Map<String, Double> errors = new HashMap<>();
    List<Parameter> ball = f.model().globals().subList(0, EffectModel.BALL);
    f.solution()
        .covariance()
        .ifPresent(
            v -> {
              for (int i = 0; i < ball.size(); i++) {
                if (ball.get(i).estimated()) {
                  errors.put(ball.get(i).name(), Math.sqrt(v[i][i] + ofForms[i]));
                }
              }
            });
    return errors;
  }

  private static Verdict verdict(List<Cause> causes, List<LearnedFinding> learned, boolean left) {
    if (causes.isEmpty() && learned.isEmpty()) {
      return left ? Verdict.UNEXPLAINED_STRUCTURE : Verdict.MODEL_ADEQUATE;
    }
    boolean unnamed = learned.stream().anyMatch(l -> l.kind() != LearnedFinding.Kind.LAW);
    return left || unnamed || causes.isEmpty() ? Verdict.PARTLY_EXPLAINED : Verdict.EXPLAINED;
  }

  private Cause cause(Judgement j, Map<String, Double> errors, List<String> ties) {
    Effect effect = j.effect().within(decided.screened().arena());
    return new Cause(effect, errors, j.scatter(), 0.5 * j.evidence(), Gain.of(j), ties);
  }

  private List<Candidate> candidates(List<Cause> causes) {
    List<Candidate> all = new ArrayList<>();
    for (Alternatives.Scored s : decided.screened().alternatives().scores(decided.base())) {
      boolean named =
          causes.stream()
              .anyMatch(
                  c ->
                      c.effect().id().equals(s.effect().id())
                          && c.effect().subject().equals(s.effect().subject()));
      all.add(new Candidate(s.effect(), s.gain(), named));
    }
    return all;
  }

  private List<KickResiduals> residuals() {
    FittedModel base = decided.base();
    FittedModel extended = decided.model();
    ModelState stateBefore = base.solution().state();
    ModelState stateAfter = extended.solution().state();
    List<KickResiduals> all = new ArrayList<>();
    for (int k = 0; k < extended.kickCount(); k++) {
      EffectKick before = base.kick(k);
      EffectKick after = extended.kick(k);
      KickRecord d = after.record();
      double[][] r = new double[4][d.size()];
      double[] own = base.solution().own(k);
      double[] ownAfter = extended.solution().own(k);
      before.plainResiduals(own, stateBefore, r[0], r[1]);
      after.plainResiduals(ownAfter, stateAfter, r[2], r[3]);
      BallTrajectory pathBefore = before.path(own, stateBefore);
      BallTrajectory pathAfter = after.path(ownAfter, stateAfter);
      all.add(
          new KickResiduals(
              d.kick(),
              d.kind(),
              pathBefore,
              pathAfter,
              r[0],
              r[1],
              r[2],
              r[3],
              d.used(),
              decided.heldBase().rmsMm(k),
              decided.best().held().rmsMm(k)));
    }
    return all;
  }

  private ExtendedModel model(FittedModel f, List<Cause> kickers) {
    ModelState state = f.solution().state();
    List<Effect> effects = new ArrayList<>();
    f.effects().stream()
        .filter(Effect::hasOwnMean)
        .forEach(e -> effects.add(e.within(decided.screened().arena())));
    kickers.forEach(c -> effects.add(c.effect()));
    return new ExtendedModel(
        decided.screened().arena().flats() ? Optional.of(state.flat()) : Optional.empty(),
        decided.screened().arena().chips() ? Optional.of(state.chip()) : Optional.empty(),
        effects,
        decided.screened().problem().sessionStart());
  }
}
