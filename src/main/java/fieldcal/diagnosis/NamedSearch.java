package fieldcal.diagnosis;

import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.screening.KickScreen;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Optional;

/** The stage that searches among the effects of the catalogue and then screens kicks that stand out again, with what was found. Not thread-safe. */
final class NamedSearch {
  /** How often the kicks are screened again with the model that was found. */
  private static final int SCREENINGS = 3;

  /** With fewer flat kicks the search does not begin with these alone. */
  private static final int FEWEST_FLATS = 6;

  /** Flat kicks whose reduced chi-square stays above that are not explained by themselves. */
  private static final double EXPLAINED = 1.5;

  /** Components that a model may have in addition to those that may be named: forms of others, and components that are removed later. */
  private static final int SPARE = 5;

  private final SampledSearch search;
  private final DiagnosisProgress progress;

  /**
   * @param search for components
   * @param progress told in words what is being done
   */
  NamedSearch(SampledSearch search, DiagnosisProgress progress) {
    this.search = search;
    this.progress = progress;
  }

  /**
   * What was found.
   *
   * @param at the kicks as they were screened last
   * @param model fitted to these kicks with equal weights
   * @param ofFlats what explains the flat kicks by themselves, fitted to all kicks; empty where nothing does, or no chips were recorded
   */
  record Found(DiagnosisCase at, FittedModel model, Optional<FittedModel> ofFlats) {}

  Found search(DiagnosisCase given) {
    DiagnosisCase at = given;
    Optional<FittedModel> ofFlats = ofFlats(at);
    FittedModel start = withoutDominant(at, ofFlats.orElse(at.base()));
    for (int round = 0; round < SCREENINGS; round++) {
      progress.stage(round == 0 ? "searching for causes" : "searching for causes again");
      FittedModel found = named(at, start);
      ModelFitter fitter = at.fitter();
      FittedModel best = fitter.withLowHops(search.alike(fitter, found), at.solver());
      FittedModel seen = explaining(at, best, found);
      List<KickRecord> before = fitter.kicks();
      List<KickRecord> revised = at.screen().revise(seen, true);
      if (revised.equals(before)) {
        revised = at.screen().withoutStrays(seen);
      }
      if (revised.equals(before)) {
        return new Found(at, best, ofFlats);
      }
      progress.stage("looking again at kicks that stand out");
      at = at.refitted(revised);
      start = at.fit(seen, Weighing.EXPLAINED_FIRST);
    }
    return new Found(at, search.alike(at.fitter(), start), ofFlats);
  }

  /** The fit that decides which kicks stand out: a robust one where it explains most kicks. With equal weights, a kick whose ball was not free would lead the fit away from the others. */
  private static FittedModel explaining(DiagnosisCase at, FittedModel alike, FittedModel found) {
    if (!KickScreen.hasStandingOut(alike)) {
      return alike;
    }
    FittedModel deaf =
        at.fitter().fit(found.resumed(), found, Weighing.EXPLAINED_ONLY, at.solver());
    return at.screen().explainsMost(deaf) ? deaf : alike;
  }

  private FittedModel named(DiagnosisCase at, FittedModel start) {
    Dictionary dictionary =
        new Dictionary(
            at.catalogue(), EffectCatalogue.unnamed(), LearnedLibrary.stopping(), at.arena());
    int most = at.problem().maxCauses() + SPARE;
    return search.search(at.fitter(), start, dictionary, most, true);
  }

  /** What explains the flat kicks by themselves: chips hide other causes until their bounces are explained. */
  private Optional<FittedModel> ofFlats(DiagnosisCase at) {
    List<KickRecord> flats =
        KickScreen.withoutDominant(at.base()).stream()
            .filter(k -> k.kind() == KickKind.FLAT)
            .toList();
    if (!at.arena().chips() || flats.size() < FEWEST_FLATS) {
      return Optional.empty();
    }
    progress.stage("searching for causes in the flat kicks");
    return Optional.of(foundAmong(at, flats, at.base())).filter(found -> found != at.base());
  }

  /** Begins without the few kicks that leave far more than all others, such as a touched ball. What the others show is found first, and then these kicks are included. */
  private FittedModel withoutDominant(DiagnosisCase at, FittedModel start) {
    List<KickRecord> quiet = KickScreen.withoutDominant(at.base());
    if (quiet.size() == at.fitter().kicks().size()) {
      return start;
    }
    progress.stage("searching for causes without the kicks that stand out most");
    return foundAmong(at, quiet, start);
  }

  /** What is found among some kicks, fitted to all; the start where this does not explain them, and the simple model where nothing is found. */
  private FittedModel foundAmong(DiagnosisCase all, List<KickRecord> kicks, FittedModel start) {
    DiagnosisCase some = all.refitted(kicks);
    boolean fromNothing = start == all.base();
    FittedModel begin = fromNothing ? some.base() : some.fit(start, Weighing.EXPLAINED_FIRST);
    FittedModel found = named(some, begin);
    if (found.solution().reducedChiSquare() > EXPLAINED && !all.screen().explainsMost(found)) {
      return start;
    }
    if (found.model().components().isEmpty()) {
      return all.base();
    }
    EffectModel model = found.resumed().in(all.arena());
    if (kicks.stream().noneMatch(k -> k.kind() == KickKind.CHIP)) {
      // How low the ball hops flat kicks do not show; the base fit of all kicks does.
      model = model.withLowestHop(all.base().solution().state().chip().lowestHop());
    }
    return all.fitter().fit(model, all.base(), Weighing.EXPLAINED_FIRST, all.solver());
  }
}
