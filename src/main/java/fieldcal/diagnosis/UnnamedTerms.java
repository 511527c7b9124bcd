package fieldcal.diagnosis;

import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.decision.DecisionSettings;
import fieldcal.diagnosis.decision.Dependence;
import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.effect.Effect;
import fieldcal.fit.joint.SharedSolver;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The stage that describes what has no name: laws that values of the kicks follow, what differs from kick to kick by chance, and learned curves and maps. Each must follow or predict held-out kicks better. What is added to causes must not predict worse than the simple model, and what replaces something must not predict worse than that. Not
 * thread-safe.
 */
final class UnnamedTerms {
  /** A simpler model is taken unless a larger one follows held-out kicks better by this share of their residual: a tenth of the smallest excess over the noise that matters. */
  private static final double CLEARLY_BETTER = 0.01;

  /** If the size of a cause changes by at least this share when a learned term is added, the term has taken its place. */
  private static final double SUPPLANTED = 0.5;

  /** Curves alone must leave less than this share of the held-out variance that named causes leave; otherwise they only describe the same in another form. */
  static final double IMITATED = 0.5;

  private final ModelChoice choice;
  private final HoldOut heldBase;
  private final CurveSearch curves;
  private final DiagnosisProgress progress;

  private final FittedModel base;
  private final ModelFitter fitter;
  private final DecisionSettings settings;
  private final SharedSolver solver;
  private final LawForValues laws;
  private final long seed;

  /**
   * @param problem the screened kicks and what may explain them
   * @param choice which of the components that are found stay
   * @param heldBase how the simple model does on kicks that were held out
   * @param curves search for learned terms
   * @param progress told in words what is being done
   */
  UnnamedTerms(
      DiagnosisCase problem,
      ModelChoice choice,
      HoldOut heldBase,
      CurveSearch curves,
      DiagnosisProgress progress) {
    this.choice = choice;
    this.heldBase = heldBase;
    this.curves = curves;
    this.progress = progress;
    base = problem.base();
    fitter = problem.fitter();
    settings = problem.settings();
    solver = problem.solver();
    laws = problem.laws();
    seed = problem.seed();
  }

  /**
   * Describes.
   *
   * @param named the model with named causes, or the simple one if there are none
   * @return the same where nothing is left and nothing follows a law
   */
  Weighed beside(Weighed named) {
    Weighed best = named;
    if (chanceFollows(named) || Leftover.of(named.model()).isSignificant()) {
      progress.stage("describing what has no name");
      best = described(named);
    }
    return predicting(lawful(best));
  }

  /** With laws, chance and learned terms for what has no name. */
  private Weighed described(Weighed found) {
    if (isSpent()) {
      return curved(found, true);
    }
    // Beside the simple model first: causes may have imitated a law.
    List<FittedModel> starts = new ArrayList<>(List.of(base));
    if (found.model() != base) {
      starts.add(laws.withoutValues(found.model()));
    }
    Weighed lawful = withLaws(found, starts);
    if (lawful != found) {
      return besideLaws(lawful);
    }
    Weighed best = withoutLaws(found);
    if (!chanceFollows(best)) {
      return best;
    }
    FittedModel start = laws.withoutValues(best.model());
    HoldOut held = HoldOut.of(start, true, seed);
    Weighed plain = new Weighed(start, List.of(), held);
    lawful = withLaws(plain, List.of(start));
    return lawful != plain && !lawful.held().predictsWorseThan(best.held(), seed)
        ? besideLaws(lawful)
        : best;
  }

  /** If what was found predicts most kicks worse than the simple model, curves replace everything else if they predict better. Values for each kick may follow it and still not predict the next one. */
  private Weighed predicting(Weighed found) {
    if (!found.held().predictsMostWorseThan(heldBase, seed)) {
      return found;
    }
    Weighed curved = choice.of(curves.beside(base, List.of(), false));
    boolean sound =
        curved.held().rmsMm() <= heldBase.rmsMm()
            && !curved.held().predictsWorseThan(heldBase, seed)
            && curved.held().errorFactor(heldBase) < 1;
    return sound && curved.foretellsMoreThan(found, seed) ? curved : found;
  }

  /** With laws for what kickers do: values with a mean of their own that follow the kick do not differ by chance, and a law predicts where values do not. */
  private Weighed lawful(Weighed found) {
    Weighed best = found;
    for (Judgement j : found.judged()) {
      // A law that was taken changes all judgements; values that it left are judged there.
      if (best.judged().contains(j) && j.effect().hasOwnMean() && j.follows().isPresent()) {
        best = withLawFor(best, j);
      }
    }
    return best;
  }

  /** With a law in place of these values and of all others that follow the same quantity, since one law may explain all of them; otherwise in place of these values alone. */
  private Weighed withLawFor(Weighed before, Judgement values) {
    Dependence follows = values.follows().orElseThrow();
    List<Judgement> alike =
        before.judged().stream()
            .filter(j -> j.effect().hasOwnMean() && j.followsSameAs(values))
            .toList();
    return Stream.of(alike, List.of(values))
        .distinct()
        .flatMap(
            group ->
                laws.insteadOf(before.model(), indices(before, group), follows)
                    .map(m -> choice.withLaw(m, before, group)))
        .filter(with -> with.isAsGoodAs(before, settings.formGain()))
        .filter(with -> with.predictsBetterThan(before, seed))
        .findFirst()
        .orElse(before);
  }

  private static List<Integer> indices(Weighed of, List<Judgement> group) {
    return group.stream().map(of.judged()::indexOf).toList();
  }

  /** With the laws that values of the kicks follow, one after another, as long as each explains more than half of what is left; unchanged where there is none. */
  private Weighed withLaws(Weighed found, List<FittedModel> starts) {
    Weighed best = found;
    List<FittedModel> from = starts;
    for (int i = 0; i < CurveSearch.MOST_LEARNED; i++) {
      Weighed before = best;
      for (FittedModel start : from) {
        if (isSpent()) {
          return best;
        }
        for (FittedModel law : laws.beside(start)) {
          Weighed with = lean(found.model(), choice.of(law));
          boolean sound = !with.held().predictsWorseThan(before.held(), seed);
          best = sound && excess(with) < IMITATED * excess(best) ? with : best;
        }
      }
      if (best == before || !Leftover.of(best.model()).isSignificant()) {
        break;
      }
      from = List.of(best.model());
    }
    return best;
  }

  /** Without causes whose place a law took, unless they explain more than half of what it leaves: beside the law a cause may get its true size, or describe what the law's form misses. */
  private Weighed lean(FittedModel before, Weighed after) {
    FittedModel fewer = withoutSupplanted(before, after.model());
    if (fewer == after.model()) {
      return after;
    }
    Weighed lean = choice.of(fewer);
    return excess(after) < IMITATED * excess(lean) ? after : lean;
  }

  /** With curves for what laws leave, unless what is left differs from kick to kick by chance. */
  private Weighed besideLaws(Weighed lawful) {
    boolean done =
        !Leftover.of(lawful.model()).isSignificant() || laws.leavesChance(lawful.model());
    return done ? lawful : curved(lawful, false);
  }

  /** With chance and learned terms. Several effects may have imitated one that has no name. Therefore curves alone replace all names if they leave much less, or predict better. */
  private Weighed withoutLaws(Weighed found) {
    Weighed best = curved(found);
    boolean alreadyAlone = found.model().model().components().isEmpty();
    if (alreadyAlone || isSpent() || !Leftover.of(best.model()).isSignificant()) {
      return best;
    }
    Weighed alone = choice.of(curves.beside(base, List.of(), true));
    boolean named = best.judged().stream().anyMatch(Judgement::isName);
    double most = named ? IMITATED : 1;
    boolean imitated =
        Math.pow(alone.held().rmsMm(), 2) < most * Math.pow(best.held().rmsMm(), 2)
            && !alone.held().predictsWorseThan(best.held(), seed);
    return imitated || alone.foretellsMoreThan(best, seed) ? alone : best;
  }

  /** Variance on held-out kicks beyond the noise, mm². */
  private double excess(Weighed weighed) {
    double noise = Quality.of(weighed.model(), weighed.held()).noiseMm();
    return Math.pow(weighed.held().rmsMm(), 2) - noise * noise;
  }

  /** With curves and chance beside the causes, if that follows held-out kicks better. A value for each kick can imitate any cause that differs between kicks. So it takes the place of a named cause only where it explains much more. */
  private Weighed curved(Weighed named) {
    Weighed best = curved(named, true);
    boolean much = Math.pow(best.held().rmsMm(), 2) < IMITATED * Math.pow(named.held().rmsMm(), 2);
    return !much
            && !isSpent()
            && best.judged().stream().anyMatch(UnnamedTerms::isChance)
            && losesName(named, best)
        ? curved(named, false)
        : best;
  }

  private static boolean isChance(Judgement j) {
    return j.component().isChance();
  }

  /** Whether what differs from kick to kick follows something after all, so that a law may be behind it. */
  private static boolean chanceFollows(Weighed weighed) {
    return weighed.judged().stream().anyMatch(j -> isChance(j) && j.follows().isPresent());
  }

  /** Whether nothing optional should be started any more. */
  private boolean isSpent() {
    return fitter.effort().isSpent();
  }

  private static boolean losesName(Weighed before, Weighed after) {
    return before.judged().stream()
        .filter(Judgement::isName)
        .anyMatch(
            j ->
                after.judged().stream()
                    .noneMatch(k -> k.isName() && k.component().isSameCause(j.component())));
  }

  /** With curves beside the causes, if that follows held-out kicks better. Causes whose place a curve took stay where they are still needed: beside a curve a cause may get its true size. */
  private Weighed curved(Weighed named, boolean chance) {
    FittedModel curved = curves.beside(named.model(), named.judged(), chance);
    if (curved == named.model()) {
      return named;
    }
    Weighed best = choice.of(curved);
    FittedModel fewer = withoutSupplanted(named.model(), curved);
    if (fewer != curved && !isSpent()) {
      Weighed lean = choice.of(fewer);
      best = lean.isAsGoodAs(best, CLEARLY_BETTER) ? lean : best;
    }
    boolean better =
        best.held().rmsMm() < (1 - CLEARLY_BETTER) * named.held().rmsMm()
            && !best.held().predictsWorseThan(heldBase, seed);
    return better ? best : named;
  }

  /** Without causes whose place a curve took: if the size of a cause changes much beside the curve, the cause had only imitated the curve. */
  private FittedModel withoutSupplanted(FittedModel before, FittedModel after) {
    double[] then = before.solution().values();
    double[] now = after.solution().values();
    List<Component> kept = new ArrayList<>();
    List<Component> had = before.model().components();
    List<Component> have = after.model().components();
    List<Effect> effects = after.effects();
    for (int i = 0; i < have.size(); i++) {
      Component c = have.get(i);
      boolean stays = c.isPerKick() || c.isLaw();
      boolean known = false;
      for (int j = 0; j < had.size(); j++) {
        if (had.get(j).isSameCause(c) && had.get(j).size() == c.size()) {
          known = true;
          double change = 0;
          double size = 0;
          for (int k = 0; k < c.magnitudeCount(); k++) {
            double was = then[before.model().offset(j) + k];
            double is = now[after.model().offset(i) + k];
            change += (is - was) * (is - was);
            size += was * was;
          }
          stays |= change < SUPPLANTED * SUPPLANTED * size;
        }
      }
      if (stays || !known) {
        kept.add(c.startingAt(effects.get(i)));
      }
    }
    if (kept.size() == have.size()) {
      return after;
    }
    EffectModel model = after.model().startingAt(now, after.solution().scatters()).with(kept);
    return fitter.fit(model, after, Weighing.ALIKE, solver);
  }
}
