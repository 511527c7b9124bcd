package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/** The kicks, the cameras that saw them, and where the shared unknowns are expected: fits any hypothesis to them, from any start. Immutable. */
final class HypothesisFitter {
  /** Scatter before it is known, in the effect's scales. */
  private static final double FIRST_SCATTER = 1;

  final List<KickData> kicks;
  final List<ObservedCamera> observers;
  final double sessionStart;
  private final FlatModel flat;
  private final ChipModel chip;
  private final boolean flats;
  private final boolean chips;

  HypothesisFitter(
      List<KickData> kicks,
      List<ObservedCamera> observers,
      double sessionStart,
      FlatModel flat,
      ChipModel chip) {
    this.kicks = List.copyOf(kicks);
    this.observers = observers;
    this.sessionStart = sessionStart;
    this.flat = flat;
    this.chip = chip;
    flats = kicks.stream().anyMatch(k -> k.kind == KickKind.FLAT);
    chips = kicks.stream().anyMatch(k -> k.kind == KickKind.CHIP);
  }

  /** A fitter of some of the kicks only. */
  HypothesisFitter of(List<KickData> some) {
    return new HypothesisFitter(some, observers, sessionStart, flat, chip);
  }

  SharedUnknowns unknowns(Hypothesis hypothesis) {
    return new SharedUnknowns(hypothesis, flat, chip, flats, chips);
  }

  /** Shared values and magnitudes of another fit with the kicks as their own fits left them: position, velocity, time and above all number of flights, which a wrong joint model may have spoilt. */
  FittedHypothesis withOwnFits(FittedHypothesis f) {
    return adopt(new Hypothesis(f.hypothesis().fixed(), List.of()), f, new double[0], List.of());
  }

  /** A fit of what were other kicks in part, to start from: those that were the same then as they are there, the others as their own fits left them. */
  FittedHypothesis adopt(FittedHypothesis f, List<KickData> kicksThen) {
    return adopt(f.hypothesis(), f, f.scatter(), kicksThen);
  }

  private FittedHypothesis adopt(
      Hypothesis hypothesis, FittedHypothesis f, double[] scatter, List<KickData> kicksThen) {
    List<double[]> own = new ArrayList<>();
    int[] flights = new int[kicks.size()];
    for (int k = 0; k < flights.length; k++) {
      int then = indexOf(kicks.get(k), kicksThen);
      own.add(then < 0 ? kicks.get(k).start : f.own().get(then));
      flights[k] = then < 0 ? kicks.get(k).flights : f.flights()[then];
    }
    return new FittedHypothesis(
        hypothesis,
        f.shared(),
        own,
        flights,
        scatter,
        f.chiSquare(),
        f.cost(),
        f.residuals(),
        f.logEvidence(),
        f.covariance(),
        false);
  }

  private static int indexOf(KickData kick, List<KickData> others) {
    return IntStream.range(0, others.size())
        .filter(k -> kick.isSame(others.get(k)))
        .findFirst()
        .orElse(-1);
  }

  /** From where each kick's own fit ended. */
  FittedHypothesis fitSimple() {
    double[] shared = unknowns(Hypothesis.SIMPLE).expectedValue.clone();
    JointFit run = new JointFit(this, Hypothesis.SIMPLE, shared, new double[0]);
    return run.fit(true);
  }

  /**
   * From where another hypothesis ended.
   *
   * @param start values of the shared unknowns
   * @param flights whether other numbers of flights are tried
   */
  FittedHypothesis fit(
      Hypothesis hypothesis, double[] start, FittedHypothesis from, boolean flights) {
    return settled(hypothesis, start, from).fit(flights);
  }

  /** From where another hypothesis ended, with its numbers of flights; null when the cost would not be lower than a limit. */
  FittedHypothesis fitBelow(
      Hypothesis hypothesis, double[] start, FittedHypothesis from, double mostCost) {
    return settled(hypothesis, start, from).fitBelow(mostCost);
  }

  private JointFit settled(Hypothesis hypothesis, double[] start, FittedHypothesis from) {
    JointFit run = run(hypothesis, start, from);
    if (!from.converged()) {
      run.settleKicks();
    }
    return run;
  }

  /**
   * From where another hypothesis ended, with some shared unknowns held until each kick has found its own under them, number of flights included: what changes bounces puts creases into the objective, and a fit of
   * everything at once is caught by the nearest.
   *
   * @param held the first of the held unknowns
   * @param count how many
   */
  FittedHypothesis fitHeldAtFirst(
      Hypothesis hypothesis, double[] start, FittedHypothesis from, int held, int count) {
    JointFit run = run(hypothesis, start, from);
    run.settleKicks();
    run.settleOthers(held, count);
    return run.fit(true);
  }

  /** The cost of a hypothesis at given shared unknowns, each kick's own ones as they are. */
  double cost(Hypothesis hypothesis, double[] start, FittedHypothesis from) {
    JointFit run = run(hypothesis, start, from);
    return run.costAtStart();
  }

  private JointFit run(Hypothesis hypothesis, double[] start, FittedHypothesis from) {
    double[] scatter = new double[hypothesis.random().size()];
    for (int j = 0; j < scatter.length; j++) {
      Chart chart = hypothesis.random().get(j);
      int known = from.hypothesis().random().indexOf(chart);
      // A scatter that is not known yet starts at a common one.
      scatter[j] = known < 0 ? FIRST_SCATTER * chart.scale(0) : from.scatter()[known];
    }
    JointFit run = new JointFit(this, hypothesis, start, scatter);
    double[] means = Arrays.copyOfRange(start, start.length - scatter.length, start.length);
    boolean sameRandom = hypothesis.random().equals(from.hypothesis().random());
    for (int i = 0; i < kicks.size(); i++) {
      double[] own = from.own().get(i);
      double[] kept = sameRandom ? own : Arrays.copyOf(own, KickData.ownSize(kicks.get(i).kind));
      run.models.get(i).startFrom(kept, from.flights()[i], means);
    }
    return run;
  }
}
