package fieldcal.diagnosis.model;

import fieldcal.ball.ChipModel;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;

/** Fits models with effects to the same kicks, each starting from where another fit ended. Immutable, and thread-safe if the watcher is. */
public final class ModelFitter {
  /** By how much chi-square must fall for hops below the league's lowest; noise reaches that once in ten thousand recordings. */
  private static final double LOW_HOP_PRICE = 15;

  /** Lowest hops between the league's and the engines', as shares of the way in logarithms. A bounce takes about three quarters of the height, so that the steps are half a bounce: with a whole one, each chip could have one bounce too many or too few, and fits that settle some hold the others there. */
  private static final double[] IN_BETWEEN = {0.25, 0.5, 0.75};

  /** Share of what is left that hops in between must explain: they are nobody's model, and where bounces follow another law they also explain a part of it. */
  private static final double IN_BETWEEN_SHARE = 0.5;

  /** Share of what is left that the engines' hops must explain; the same holds for a law of impacts. */
  private static final double LOW_HOP_SHARE = 0.1;

  /** Steps of a fit once the effort is spent; chosen: from another model's fit, a model that is right needs two or three. */
  private static final int FEW_ITERATIONS = 6;

  private final List<KickRecord> kicks;
  private final double sessionStart;
  private final Effort effort;
  private final Consumer<FittedModel> watcher;

  /**
   * A fitter.
   *
   * @param kicks at least one
   * @param sessionStart beginning of the session on the kicks' clock, s
   * @param effort to which all paths are added
   * @param watcher receives every fit, in the thread that asked for it
   */
  public ModelFitter(
      List<KickRecord> kicks, double sessionStart, Effort effort, Consumer<FittedModel> watcher) {
    this.kicks = List.copyOf(kicks);
    this.sessionStart = sessionStart;
    this.effort = effort;
    this.watcher = watcher;
  }

  /**
   * A fitter of other kicks of the same session.
   *
   * @param others at least one
   * @return a fitter with the same watcher and effort
   */
  public ModelFitter among(List<KickRecord> others) {
    return new ModelFitter(others, sessionStart, effort, watcher);
  }

  /**
   * How much work has been done, and how much may be done.
   *
   * @return the effort of all fits of the diagnosis
   */
  public Effort effort() {
    return effort;
  }

  /**
   * The kicks.
   *
   * @return as given
   */
  public List<KickRecord> kicks() {
    return kicks;
  }

  /**
   * Fits a model from each kick's own fit. What the model lacks may have led each kick alone to a wrong number of flights, and kicks that disagree about it hold each other there. So the numbers that the model's start values suggest are
   * tried, too, and, since balls may hop lower than in the league's models, the numbers with lower hops.
   *
   * @param model with values to start from
   * @param solver how
   * @return the best fit
   */
  public FittedModel fit(EffectModel model, SharedSolver solver) {
    FittedModel fitted = fitAlone(model, solver);
    if (!solver.settlesVariants() || kicks.stream().noneMatch(k -> k.kind == KickKind.CHIP)) {
      return fitted;
    }
    FittedModel ruled = fitAlone(model, solver.startingByRule());
    FittedModel best = ruled.evenCost() < fitted.evenCost() ? ruled : fitted;
    return withLowHops(best, solver);
  }

  /**
   * Fits a model with hops below the league's lowest, where chips show them. What else is in the model may have hidden them from a fit without it.
   *
   * @param from the model, fitted to the same kicks
   * @param solver how
   * @return the same where hops are already as low, where a law of impacts gives the lowest hop, and where lower hops explain too little of what is left
   */
  public FittedModel withLowHops(FittedModel from, SharedSolver solver) {
    FittedModel between = withHopsInBetween(from, solver);
    FittedModel low =
        better(withHops(ChipModel.ENGINE_MIN_HOP_HEIGHT, from, solver), from, LOW_HOP_SHARE);
    boolean closer = between.evenCost() + LOW_HOP_PRICE < low.evenCost();
    return low == from || closer ? between : low;
  }

  /** The best of the fits with hops in between; the same where that explains too little. */
  private FittedModel withHopsInBetween(FittedModel from, SharedSolver solver) {
    double high = ChipModel.MIN_HOP_HEIGHT;
    double low = ChipModel.ENGINE_MIN_HOP_HEIGHT;
    FittedModel best =
        Arrays.stream(IN_BETWEEN)
            .mapToObj(share -> withHops(high * Math.pow(low / high, share), from, solver))
            .min(Comparator.comparingDouble(FittedModel::evenCost))
            .orElse(from);
    return better(best, from, IN_BETWEEN_SHARE);
  }

  private FittedModel withHops(double lowest, FittedModel from, SharedSolver solver) {
    if (!canHop(lowest, from)) {
      return from;
    }
    EffectModel start = from.resumed().withLowestHop(lowest);
    return fit(start, from, Weighing.ALIKE, solver.startingByRule());
  }

  private static boolean canHop(double lowest, FittedModel fitted) {
    boolean chips = fitted.records().stream().anyMatch(k -> k.kind == KickKind.CHIP);
    double now = fitted.solution().state().chip().lowestHop();
    return chips
        && now > lowest
        && fitted.model().components().stream().noneMatch(Component::isLaw);
  }

  private static FittedModel better(FittedModel low, FittedModel high, double share) {
    double left = high.evenCost() - high.solution().rows();
    double least = Math.max(LOW_HOP_PRICE, share * left);
    return low.evenCost() + least < high.evenCost() ? low : high;
  }

  private FittedModel fitAlone(EffectModel model, SharedSolver solver) {
    List<EffectKick> terms = new ArrayList<>();
    List<double[]> starts = new ArrayList<>();
    for (KickRecord kick : kicks) {
      terms.add(new EffectKick(kick, model, sessionStart, effort));
      starts.add(startWith(kick.start, model, null, null));
    }
    return solve(model, terms, starts, ones(), solver);
  }

  /**
   * Fits a model from where another one ended.
   *
   * @param model with values to start from
   * @param before a fit of the same kicks
   * @param weighing how much kicks count that the other model does not explain
   * @param solver how
   * @return the fit
   */
  public FittedModel fit(
      EffectModel model, FittedModel before, Weighing weighing, SharedSolver solver) {
    List<EffectKick> terms = new ArrayList<>();
    List<double[]> starts = new ArrayList<>();
    double[] weights = weighing.of(before);
    for (int k = 0; k < kicks.size(); k++) {
      EffectKick term = new EffectKick(kicks.get(k), model, sessionStart, effort);
      boolean same = before.kick(k).record().kind == kicks.get(k).kind;
      terms.add(same ? term.withFlights(before.kick(k).flights()) : term);
      double[] own = same ? before.solution().own(k) : kicks.get(k).start;
      starts.add(startWith(own, model, same ? before.model() : null, kicks.get(k)));
    }
    return solve(model, terms, starts, weights, solver);
  }

  /**
   * Fits the places of a model's components together with everything else, and holds them there again.
   *
   * @param from the model, fitted to the same kicks
   * @param weighing how much kicks count that it does not explain
   * @param solver how
   * @return the same when nothing in it has a place
   */
  public FittedModel fitPlaces(FittedModel from, Weighing weighing, SharedSolver solver) {
    if (from.model().components().stream().noneMatch(Component::hasPlace)) {
      return from;
    }
    FittedModel moved = fitWithPlaces(from, weighing, solver);
    List<Component> held = moved.started().stream().map(Component::withPlaceHeld).toList();
    return fit(from.resumedWith(held), moved, weighing, solver);
  }

  /**
   * Fits the places of a model's components together with everything else. The standard errors of such a fit include what is not known of the places.
   *
   * @param from the model, fitted to the same kicks
   * @param weighing how much kicks count that it does not explain
   * @param solver how
   * @return the fit, in which the places are free
   */
  public FittedModel fitWithPlaces(FittedModel from, Weighing weighing, SharedSolver solver) {
    List<Component> freed =
        from.started().stream().map(c -> c.hasPlace() ? c.withPlaceFree() : c).toList();
    return fit(from.resumedWith(freed), from, weighing, solver);
  }

  /** A kick's own parameters for another model: the values of random effects that both have stay, others start at their mean. */
  private static double[] startWith(
      double[] own, EffectModel model, EffectModel before, KickRecord kick) {
    List<Component> random = model.random();
    int plain = before == null ? own.length : KickRecord.ownSize(kick.kind);
    double[] start = Arrays.copyOf(own, plain + random.size());
    for (int r = 0; r < random.size(); r++) {
      Component c = random.get(r);
      double value = c.coordinates().get(0).value();
      List<Component> known = before == null ? List.of() : before.random();
      for (int i = 0; i < known.size(); i++) {
        if (known.get(i).isSameCause(c)) {
          value = own[plain + i];
        }
      }
      start[plain + r] = value;
    }
    return start;
  }

  private double[] ones() {
    double[] weights = new double[kicks.size()];
    Arrays.fill(weights, 1);
    return weights;
  }

  private FittedModel solve(
      EffectModel model,
      List<EffectKick> terms,
      List<double[]> starts,
      double[] weights,
      SharedSolver solver) {
    SharedProblem<ModelState> problem =
        new SharedProblem<>(
            model, terms, starts, model.globals(), model.priors(), model.randoms(), weights);
    SharedSolver used = effort.isSpent() ? solver.withAtMost(FEW_ITERATIONS) : solver;
    FittedModel fitted = new FittedModel(model, used.solve(problem));
    watcher.accept(fitted);
    return fitted;
  }
}
