package fieldcal.diagnosis;

import fieldcal.diagnosis.NamedSearch.Found;
import fieldcal.diagnosis.model.Effort;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Says what the simple model gets wrong, why, and what a better one gains. Stages: screening and base fit, search among the named effects, learned terms for what is left, decision about names, validation, verdict; {@code docs/diagnosis.md} derives
 * them. Immutable and thread-safe; the same input gives the same answer.
 */
public final class Diagnoser {
  /** What robots do is judged where the reduced chi-square is below that: what is left elsewhere would be theirs. */
  private static final double EXPLAINED = 1.5;

  private static final int FIT_ITERATIONS = 25;

  /**
   * Pieces of paths after which nothing is begun that can be left out; a processor of 2024 integrates about a million in a second. Chosen: flat kicks that causes explain needed half a million, chips of one mixture 15 million, and three recordings that nothing explains 50, 150 and 570
   * million.
   */
  private static final long MOST_EFFORT = 60_000_000;

  private final List<? extends Effect> catalogue;
  private final long mostEffort;

  /** A diagnoser of all effects of the catalogue. */
  public Diagnoser() {
    this(EffectCatalogue.all());
  }

  /**
   * A diagnoser of other effects.
   *
   * @param catalogue absent effects that may be named
   */
  public Diagnoser(List<? extends Effect> catalogue) {
    this(catalogue, MOST_EFFORT);
  }

  Diagnoser(List<? extends Effect> catalogue, long mostEffort) {
    this.catalogue = List.copyOf(catalogue);
    this.mostEffort = mostEffort;
  }

  /**
   * Diagnoses. Takes seconds to minutes.
   *
   * @param problem kicks with their fits, cameras, the begin of the session, commands
   * @param progress told in words what is being done, from the calling thread
   * @return the diagnosis; what broke on the way is in {@link Diagnosis#problems}
   * @throws IllegalArgumentException when no kick has enough detections
   */
  public Diagnosis diagnose(DiagnosisProblem problem, Consumer<String> progress) {
    if (problem.fits().isEmpty()) {
      throw new IllegalArgumentException("a diagnosis needs at least one fitted kick");
    }
    DiagnosisProgress told = new DiagnosisProgress(progress);
    List<SearchStep> trace = new ArrayList<>();
    FailedStages failed = new FailedStages();
    SharedSolver solver =
        SharedSolver.withDefaults().withMaxIterations(FIT_ITERATIONS).settlingVariants();
    SampledSearch search = new SampledSearch(solver, trace, told);
    Effort effort = new Effort(mostEffort);
    told.stage("fitting all kicks together");
    DiagnosisCase screened = BaseFit.of(problem, catalogue, solver, effort, told::fitted);
    Decider decider = new Decider(search, trace, failed, told);
    Found found = found(screened, search, failed, told);
    told.stage("weighing the explanations");
    Decided all = decider.decide(found.at(), found.model());
    Decided first =
        failed.guarded(
            "the decision without strays",
            all,
            () -> withoutStrays(all, found.model(), decider, told));
    Selection selection = new Selection(search, decider, trace);
    Decided decided =
        failed.guarded(
            "the second decision",
            first,
            () -> {
              Decided again = decidedAgain(first, found, selection, told);
              return again == first ? first : withoutStrays(again, again.model(), decider, told);
            });
    if (effort.isSpent()) {
      failed.add("the search ended at its limit of work, so that not everything was tried");
    }
    return answer(decided).diagnosis(trace, failed.problems());
  }

  /**
   * What is decided without the few kicks that stand out while all others are explained. That may take a curve: then the search among the named effects could not tell them.
   *
   * @param begin the model to decide about
   */
  private static Decided withoutStrays(
      Decided decided, FittedModel begin, Decider decider, DiagnosisProgress told) {
    List<KickRecord> kept = decided.screened().screen().withoutStrays(decided.model());
    if (kept.size() == decided.model().kickCount()) {
      return decided;
    }
    told.stage("weighing again without the kicks that stand out");
    DiagnosisCase others =
        decided.screened().refitted(kept.stream().map(KickRecord::asSeen).toList());
    return decider.decide(others, others.fit(begin, Weighing.EXPLAINED_FIRST));
  }

  /** Where much is left: what the flat kicks show by themselves, or else what is selected by prediction. */
  private static Decided decidedAgain(
      Decided first, Found found, Selection selection, DiagnosisProgress told) {
    if (Selection.leavesMuch(first) && found.ofFlats().isPresent()) {
      told.stage("weighing what the flat kicks show");
      Decided ofFlats = selection.with(found.ofFlats().get(), first);
      if (ofFlats != first) {
        return ofFlats;
      }
    }
    if (!Selection.mayHelp(first)) {
      return first;
    }
    told.stage("selecting by prediction");
    return selection.beside(first);
  }

  /** What is found among the named effects; the simple model where nothing may be named. */
  private static Found found(
      DiagnosisCase screened, SampledSearch search, FailedStages failed, DiagnosisProgress told) {
    Found nothing = new Found(screened, screened.base(), Optional.empty());
    return screened.problem().maxCauses() == 0
        ? nothing
        : failed.guarded(
            "the search for causes", nothing, () -> new NamedSearch(search, told).search(screened));
  }

  private Answer answer(Decided decided) {
    DiagnosisProblem problem = decided.screened().problem();
    FittedModel extended = decided.model();
    List<Cause> kickers =
        extended.reducedAsSeen() < EXPLAINED
            ? new KickerBias(extended, problem.commands(), problem.seed())
                .causes(catalogue, decided.screened().arena())
            : List.of();
    return new Answer(decided, kickers);
  }
}
