package fieldcal.diagnosis;

import fieldcal.kick.KickKind;
import java.util.Arrays;
import java.util.List;

/**
 * Puts the edges of a worn region where they belong. A score test finds them to some decimetres, and who crosses an edge changes in steps: so they are first fitted together with everything else, then moved one
 * by one. Immutable.
 */
final class RegionEdges {
  /** First and last step of an edge, m; how often all edges are tried with one step, and how many steps one edge goes. */
  private static final double FIRST_STEP = 0.32;

  private static final double LAST_STEP = 0.015;
  private static final int ROUNDS = 4;
  private static final int STEPS = 8;

  /** The standard error of an edge that balls crossed, m: in drawn fields most are found to a centimetre. */
  private static final double ERROR = 0.02 / Math.sqrt(3);

  /** Decrease of the cost that a step outwards must be worth, and increase that a step inwards may have. */
  private static final double BETTER = 0.5;

  private static final double COSTS_NOTHING = 0.1;

  /** So many flat kicks may say where the edges are. */
  private static final int FEWEST_FLATS = 5;

  private final HypothesisFitter fitter;

  RegionEdges(HypothesisFitter fitter) {
    this.fitter = fitter;
  }

  /** The region of a hypothesis; null when it has none. */
  static Chart region(Hypothesis h) {
    return h.fixed().stream().filter(c -> c.id().equals("worn_region")).findFirst().orElse(null);
  }

  /**
   * The fit with the edges where they belong: as the flat kicks alone say at first, then for all kicks, and where something remains to be explained once more with the kicks as their own fits left them, since
   * wrong numbers of hops and wrong edges hold each other up. The same object without a region, and when nothing is better.
   */
  FittedHypothesis polish(FittedHypothesis f) {
    if (region(f.hypothesis()) == null) {
      return f;
    }
    FittedHypothesis best = settle(withEdgesOfFlats(f));
    if (!Structure.of(fitter, best).isNothing()) {
      FittedHypothesis again = fitEdges(best, fitter.withOwnFits(best));
      best = again == best ? best : moveEdges(again);
    }
    return best;
  }

  private FittedHypothesis settle(FittedHypothesis f) {
    return moveEdges(fitEdges(f, f));
  }

  /** The fit with the edges that its flat kicks alone say: no number of hops hides a wrong edge there. The same object when that is not better for all kicks, or there are not both kinds. */
  private FittedHypothesis withEdgesOfFlats(FittedHypothesis f) {
    List<KickData> flats = fitter.kicks.stream().filter(k -> k.kind == KickKind.FLAT).toList();
    if (flats.size() < FEWEST_FLATS || flats.size() == fitter.kicks.size()) {
      return f;
    }
    HypothesisFitter some = fitter.of(flats);
    FittedHypothesis from = some.adopt(f, fitter.kicks);
    FittedHypothesis alone =
        new RegionEdges(some).settle(some.fit(f.hypothesis(), f.shared(), from, false));
    Chart region = region(alone.hypothesis());
    if (region == region(f.hypothesis())) {
      return f;
    }
    Hypothesis h = with(f.hypothesis(), region);
    FittedHypothesis all = fitter.fit(h, start(h, f, alone), f, true);
    return all.cost() < f.cost() - BETTER ? all : f;
  }

  /**
   * One edge after the other, outwards as far as that improves the fit, or else inwards as far as it costs nothing. An edge that lies beyond what balls crossed would hold its neighbours where they are, since to move those
   * would take in balls that never felt the region.
   */
  private FittedHypothesis moveEdges(FittedHypothesis f) {
    FittedHypothesis best = f;
    FittedHypothesis[] triedFrom = new FittedHypothesis[RegionSearch.EDGES];
    for (double step = FIRST_STEP; step > LAST_STEP; step /= 2) {
      Arrays.fill(triedFrom, null);
      for (int round = 0; round < ROUNDS; round++) {
        FittedHypothesis before = best;
        for (int edge = 0; edge < RegionSearch.EDGES; edge++) {
          if (triedFrom[edge] != best) {
            best = moveEitherWay(best, edge, step, triedFrom);
          }
        }
        if (best == before) {
          break;
        }
      }
    }
    return best == f ? f : fitEdges(best, best);
  }

  /** The fit with all edges moved at once to where the balls that cross them say, the kicks starting as in another fit; the same object when that is not better. */
  private FittedHypothesis fitEdges(FittedHypothesis f, FittedHypothesis kicks) {
    Chart now = region(f.hypothesis());
    Chart free = RegionSearch.withFreeEdges(now);
    Hypothesis h = f.hypothesis().without(now).with(free, false);
    double[] start = CauseSearch.start(h, f);
    int at = CauseSearch.offset(h, free);
    start[at] = f.shared()[f.offset(now)];
    System.arraycopy(RegionSearch.edges(now), 0, start, at + 1, RegionSearch.EDGES);
    FittedHypothesis fitted =
        kicks == f
            ? fitter.fit(h, start, f, true)
            : fitter.fitHeldAtFirst(h, start, kicks, at, free.size());
    double[] edges = Arrays.copyOfRange(fitted.shared(), at + 1, at + 1 + RegionSearch.EDGES);
    FittedHypothesis better =
        RegionSearch.chart(edges)
            .map(region -> withRegion(f, region, fitted, f.cost() - BETTER))
            .orElse(null);
    return better == null ? f : better;
  }

  /** One edge moved by such steps; {@code triedFrom} tells from where it goes neither way. */
  private FittedHypothesis moveEitherWay(
      FittedHypothesis f, int edge, double step, FittedHypothesis[] triedFrom) {
    double inwards = edge % 2 == 0 ? step : -step;
    // Outwards first: where no ball is, an edge would wander off inwards from what it should take
    // in.
    FittedHypothesis larger = moveEdge(f, edge, -inwards, -BETTER);
    if (larger != f) {
      return larger;
    }
    FittedHypothesis smaller = moveEdge(f, edge, inwards, COSTS_NOTHING);
    if (smaller == f) {
      triedFrom[edge] = f;
    }
    return smaller;
  }

  /** The fit after steps of one edge in one direction, each of which may raise the cost by so much; the same object when the first does more. */
  private FittedHypothesis moveEdge(FittedHypothesis f, int edge, double step, double atMost) {
    FittedHypothesis best = f;
    for (int i = 0; i < STEPS; i++) {
      FittedHypothesis tried = withEdge(best, edge, step, best.cost() + atMost);
      if (tried == null) {
        return best;
      }
      best = tried;
    }
    return best;
  }

  /** The fit with one edge moved; null when the region would be too small, or the cost not lower than a limit. */
  private FittedHypothesis withEdge(FittedHypothesis f, int edge, double step, double mostCost) {
    Chart now = region(f.hypothesis());
    Chart moved = RegionSearch.moved(now, edge, step).orElse(null);
    if (moved == null) {
      return null;
    }
    return withRegion(f, moved, f, mostCost);
  }

  /** The fit with another region in the place of its own, from where another one with a region ended; null when the cost would not be lower than a limit. */
  private FittedHypothesis withRegion(
      FittedHypothesis f, Chart region, FittedHypothesis from, double mostCost) {
    Hypothesis h = with(f.hypothesis(), region);
    return fitter.fitBelow(h, start(h, from, from), from, mostCost);
  }

  /** A hypothesis with another region in the place of its own. */
  private static Hypothesis with(Hypothesis h, Chart region) {
    return h.without(region(h)).with(region, false);
  }

  /** Where to start a fit: everything as in one fit, the change of the region as in another. */
  private static double[] start(Hypothesis h, FittedHypothesis all, FittedHypothesis change) {
    double[] start = CauseSearch.start(h, all);
    start[CauseSearch.offset(h, region(h))] =
        change.shared()[change.offset(region(change.hypothesis()))];
    return start;
  }

  /**
   * What the edges of a region leave open of its change: a region that is a little too large is a little less worn. Zero without a region.
   */
  double error(FittedHypothesis f) {
    Chart now = region(f.hypothesis());
    double sum = 0;
    for (int edge = 0; edge < RegionSearch.EDGES && now != null; edge++) {
      double[] change = {f.shared()[f.offset(now)], f.shared()[f.offset(now)]};
      for (int side = 0; side < 2; side++) {
        FittedHypothesis moved =
            withEdge(f, edge, side == 0 ? -ERROR : ERROR, Double.POSITIVE_INFINITY);
        change[side] =
            moved == null ? change[side] : moved.shared()[moved.offset(region(moved.hypothesis()))];
      }
      double difference = (change[1] - change[0]) / 2;
      sum += difference * difference;
    }
    return Math.sqrt(sum);
  }
}
