package fieldcal.diagnosis;

import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.CauseSearch;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.search.SearchStep;
import fieldcal.fit.joint.SharedSolver;
import java.util.List;
import java.util.stream.IntStream;

/** Searches for components among as many kicks as a search needs, and fits what was found to all of them. Not thread-safe. */
final class SampledSearch {
  /** With more kicks, the search uses this many, spread over the session; fits and decisions use all. */
  private static final int SEARCHED_KICKS = 60;

  private static final int COARSE_ITERATIONS = 15;

  private final SharedSolver solver;

  /** A solver with coarse tolerance: in a search, only the differences between models count. */
  private final SharedSolver coarse;

  private final List<SearchStep> trace;
  private final DiagnosisProgress progress;

  /**
   * @param solver of the fits before and after a search
   * @param trace to which what was tried is added
   * @param progress told which part of a search begins
   */
  SampledSearch(SharedSolver solver, List<SearchStep> trace, DiagnosisProgress progress) {
    this.solver = solver;
    this.trace = trace;
    this.progress = progress;
    coarse = solver.withTolerance(1).withMaxIterations(COARSE_ITERATIONS);
  }

  /**
   * Searches.
   *
   * @param fitter of the kicks
   * @param start model to add to, fitted to them
   * @param dictionary what may be proposed
   * @param most components
   * @param revises whether further pursuits start while something is left
   * @return the model that was found, fitted to all kicks, in which kicks that it does not explain weigh less
   */
  FittedModel search(
      ModelFitter fitter, FittedModel start, Dictionary dictionary, int most, boolean revises) {
    int n = start.kickCount();
    if (n <= SEARCHED_KICKS) {
      return found(fitter, start, dictionary, most, revises);
    }
    List<KickRecord> some = sample(n).mapToObj(fitter.kicks()::get).toList();
    ModelFitter few = fitter.among(some);
    FittedModel begin = few.fit(start.resumed(), start.restrictedTo(some), Weighing.ALIKE, solver);
    FittedModel found = found(few, begin, dictionary, most, revises);
    FittedModel all = fitter.fit(found.resumed(), start, Weighing.EXPLAINED_FIRST, solver);
    // The first fit had the weights of the start; this one has those of the model itself.
    return fitter.fit(all.resumed(), all, Weighing.EXPLAINED_FIRST, solver);
  }

  /**
   * Selects by prediction.
   *
   * @param fitter of the kicks
   * @param start model to add to, fitted to them
   * @param dictionary what may be added
   * @param seed of the parts of the kicks that are held out
   * @param steps to which what was added is added
   * @return the start when nothing helps; otherwise a fit of all kicks, in which kicks that it does not explain weigh less
   */
  FittedModel selected(
      ModelFitter fitter,
      FittedModel start,
      Dictionary dictionary,
      long seed,
      List<SearchStep> steps) {
    int n = start.kickCount();
    if (n <= SEARCHED_KICKS) {
      return new PredictiveSelection(fitter, dictionary, coarse, seed).from(start, steps);
    }
    List<KickRecord> some = sample(n).mapToObj(fitter.kicks()::get).toList();
    ModelFitter few = fitter.among(some);
    FittedModel begin = few.fit(start.resumed(), start.restrictedTo(some), Weighing.ALIKE, solver);
    FittedModel found = new PredictiveSelection(few, dictionary, coarse, seed).from(begin, steps);
    return found == begin
        ? start
        : fitter.fit(found.resumed(), start, Weighing.EXPLAINED_FIRST, solver);
  }

  /** Indices of the kicks that a search uses: all, or some that are spread over the session. */
  static IntStream sample(int kicks) {
    return kicks <= SEARCHED_KICKS
        ? IntStream.range(0, kicks)
        : IntStream.range(0, SEARCHED_KICKS).map(i -> (int) ((long) i * kicks / SEARCHED_KICKS));
  }

  private FittedModel found(
      ModelFitter fitter, FittedModel start, Dictionary dictionary, int most, boolean revises) {
    CauseSearch search = new CauseSearch(fitter, dictionary, most, coarse, progress::part);
    FittedModel found = search.search(start, revises);
    trace.addAll(search.trace());
    return found;
  }

  /**
   * The same model fitted with equal weights, as decisions need it: in a search, kicks that are far from explained hardly count.
   *
   * @param fitter of the kicks
   * @param found by a search of the same kicks
   * @return the fit
   */
  FittedModel alike(ModelFitter fitter, FittedModel found) {
    return alike(fitter, found, solver);
  }

  /**
   * The same, as coarsely as in a search: enough where the difference is large.
   *
   * @param fitter of the kicks
   * @param found by a search of the same kicks
   * @return the fit
   */
  FittedModel nearlyAlike(ModelFitter fitter, FittedModel found) {
    return alike(fitter, found, coarse);
  }

  private static FittedModel alike(ModelFitter fitter, FittedModel found, SharedSolver how) {
    return fitter.fit(found.resumed(), found, Weighing.ALIKE, how);
  }
}
