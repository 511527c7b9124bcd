package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Leads the starts of one kick to its lowest minimum. Each start is first led down with a wide loss on part of the observations; only what ends in different minima
 * there, and is not clearly worse than others, goes on to all observations.
 *
 * <p>The objective of a chip is smooth only at a fixed number of flights, and a wrong number has its own minima, from which a descent does not find the right number. So every number near what the 10 mm rule says is tried from every start. The number may differ by one from what the rule says of
 * the result, since a real ball does not stop hopping at exactly that height; it may not differ by more, or frictionless hops of a millimetre would explain anything.
 */
final class MinimumFinder {
  /**
   * Scale of the loss while searching, m: a chip whose hops are missed by centimetres must still have a gradient that leads to its minimum. Narrowed to
   * the settings' scale for the last steps (graduated non-convexity, Blake and Zisserman 1987).
   */
  private static final double WIDE_LOSS = 0.02;

  /** How far the number of flights of a start may be from that of the best fit. */
  private static final int FLIGHTS_OFF = 2;

  /** Enough observations to tell numbers of flights apart. */
  private static final int MEDIUM_OBSERVATIONS = 200;

  /** Points that are nearer to each other than one standard error are on the way to the same minimum: different ones are tens of errors apart, and a descent stops within 0.2 of its minimum. */
  private static final double SAME_MINIMUM = 1;

  /** At a minimum of the wide loss, the narrow loss is at most this many times that at its own minimum. Chosen: narrowing moves a minimum by a few standard errors, which cost a few units of some four hundred. */
  private static final double CLEARLY_WORSE = 2;

  /** A number of flights that leaves this many times more of part of the observations than another is not tried on all of them. Chosen: the right number leaves less. */
  private static final double WORSE_IN_PART = 1.2;

  private final FitProblem problem;
  private final KickKind kind;
  private final FlightData data;
  private final FlightData part;
  private final List<Parameter> parameters;
  private final double narrowLoss;
  private final double wideLoss;
  private final List<FlightProblem> made = new ArrayList<>();

  MinimumFinder(
      FitProblem problem,
      KickKind kind,
      FlightData data,
      List<Parameter> parameters,
      FitSettings settings) {
    this.problem = problem;
    this.kind = kind;
    this.data = data;
    this.parameters = parameters;
    part = data.pick(SearchSubset.pick(data, problem.kick().time(), MEDIUM_OBSERVATIONS));
    narrowLoss = settings.lossScale();
    double perMetre = 0;
    for (double w : data.w22) {
      perMetre += w / data.size;
    }
    wideLoss = Math.max(narrowLoss, WIDE_LOSS * perMetre);
  }

  /** How often an objective was evaluated. */
  int evaluations() {
    return made.stream().mapToInt(FlightProblem::evaluations).sum();
  }

  /** The objective with the wide loss; the caller must count its evaluations. */
  FlightProblem widely(FlightData on, int flights) {
    FlightCurve curve = FlightCurve.of(kind, flights, problem.kick().fromRest());
    FlightProblem flight = new FlightProblem(on, curve, parameters.size());
    flight.holdFixed(parameters);
    flight.lossScale(wideLoss);
    if (!problem.kick().fromRest()) {
      int t0 = FlightLayout.timeIndex(kind);
      flight.prior(t0, problem.kick().time(), problem.kick().timeError());
    }
    return flight;
  }

  private FlightProblem objective(FlightData on, int flights) {
    FlightProblem flight = widely(on, flights);
    made.add(flight);
    return flight;
  }

  /**
   * Ways down from some starts.
   *
   * @param near where they lead on part of the observations, with the wide loss, each once
   * @param minimum the lowest that these lead to on all
   */
  record Descent(List<Minimum> near, Minimum minimum) {}

  /** Leads starts down. */
  Descent descend(List<double[]> starts) {
    return further(new Descent(List.of(), null), starts);
  }

  /** Leads further starts down; those that go where others went change nothing. */
  Descent further(Descent before, List<double[]> starts) {
    List<Minimum> near = new ArrayList<>(before.near);
    for (double[] start : starts) {
      for (int flights : flightsToTry(start)) {
        approach(flights, start, near);
      }
    }
    if (near.size() == before.near.size()) {
      return before;
    }
    return new Descent(near, kind == KickKind.FLAT ? lowest(near) : climb(bestInPart(near)));
  }

  private int[] flightsToTry(double[] start) {
    if (kind == KickKind.FLAT) {
      return new int[] {0};
    }
    int rule = ruleFlights(start);
    return IntStream.rangeClosed(
            Math.max(1, rule - FLIGHTS_OFF), Math.min(ChipModel.MAX_FLIGHTS, rule + FLIGHTS_OFF))
        .toArray();
  }

  private Minimum lowest(List<Minimum> near) {
    return near.stream()
        .map(from -> settle(data, from))
        .min(Comparator.comparingDouble(Minimum::cost))
        .orElseThrow();
  }

  /** The minimum that an earlier fit of the same kick leads to, whose path had so many flights. */
  Minimum follow(double[] earlier, int flights) {
    Minimum near = approached(flights, earlier);
    return kind == KickKind.FLAT ? settle(data, near) : climb(settle(part, near));
  }

  /** Leads a start down on part of the observations with the wide loss; adds it to the others unless it went where one of them is. */
  private void approach(int flights, double[] start, List<Minimum> others) {
    Minimum end = approached(flights, start);
    if (others.stream().noneMatch(other -> isSame(end, other))) {
      others.add(end);
    }
  }

  private static boolean isSame(Minimum end, Minimum other) {
    return other.flights() == end.flights()
        && end.equations().squaredDistance(end.theta(), other.theta()) < SAME_MINIMUM;
  }

  private Minimum approached(int flights, double[] start) {
    FlightProblem flight = objective(part, flights);
    double[] theta = start.clone();
    LevenbergMarquardt solver = new LevenbergMarquardt(parameters).roughly();
    double cost = solver.minimize(flight, theta);
    return new Minimum(flights, flight, theta, cost, solver.equations());
  }

  /** Goes on with the narrow loss; roughly, since what is not an outlier is fitted once more without any. */
  private Minimum settle(FlightData on, Minimum from) {
    FlightProblem flight = objective(on, from.flights());
    flight.lossScale(narrowLoss);
    double[] theta = from.theta().clone();
    LevenbergMarquardt solver = new LevenbergMarquardt(parameters).roughly();
    double cost = solver.minimize(flight, theta);
    return new Minimum(from.flights(), flight, theta, cost, solver.equations());
  }

  /** The best of all on part of the observations, those first that leave least. */
  private Minimum bestInPart(List<Minimum> near) {
    List<Minimum> sorted =
        near.stream()
            .map(this::narrowed)
            .sorted(Comparator.comparingDouble(Minimum::priced))
            .toList();
    Minimum best = null;
    for (Minimum from : sorted) {
      if (best != null && plausible(best) && from.priced() > CLEARLY_WORSE * best.priced()) {
        break;
      }
      Minimum next = settle(part, from);
      if (best == null || isBetter(next, best)) {
        best = next;
      }
    }
    return best;
  }

  /** What the narrow loss leaves at the same point. */
  private Minimum narrowed(Minimum wide) {
    wide.flight().lossScale(narrowLoss);
    double cost = wide.flight().cost(wide.theta());
    return new Minimum(wide.flights(), wide.flight(), wide.theta(), cost, wide.equations());
  }

  private static boolean isBetter(Minimum next, Minimum best) {
    return plausible(next) == plausible(best) ? next.priced() < best.priced() : plausible(next);
  }

  /** On all observations, and to the neighbouring numbers of flights while that explains the kick better. */
  private Minimum climb(Minimum from) {
    Minimum inPart = from;
    Minimum best = settle(data, from);
    boolean improved = true;
    while (improved) {
      improved = false;
      for (int flights : new int[] {best.flights() - 1, best.flights() + 1}) {
        if (flights < 1 || flights > ChipModel.MAX_FLIGHTS) {
          continue;
        }
        Minimum nextInPart = settle(part, approached(flights, best.theta()));
        if (plausible(best) && nextInPart.priced() > WORSE_IN_PART * inPart.priced()) {
          continue;
        }
        Minimum next = settle(data, nextInPart);
        boolean allowed = plausible(next) || !plausible(best);
        if (allowed && next.priced() < best.priced() * (1 - 1e-9)) {
          best = next;
          inPart = nextInPart;
          improved = true;
          break;
        }
      }
    }
    return best;
  }

  private static boolean plausible(Minimum m) {
    return Math.abs(m.flights() - ruleFlights(m.theta())) <= 1;
  }

  private static int ruleFlights(double[] theta) {
    return Math.max(
        1, ChipTrajectory.flightsByRule(FlightLayout.chipModel(theta), theta[ChipTrajectory.VZ0]));
  }
}
