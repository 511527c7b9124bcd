package fieldcal.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Which of the causes that a search found may be named. What remains unexplained is an error that all detections of a kick share, so evidence counts less the more of it there is: the
 * likelihood is tempered by one plus the systematic variance times the detections of a kick. A cause must be worth its evidence so, pay on kicks that were held out, and, where
 * something remains, be as strong in each kick as in the others.
 */
final class Decision {
  /** Evidence (natural logarithm of a Bayes factor) that a cause needs: pays for some hundred effects and places that were tried. */
  private static final double NEEDED = 12;

  /** Explanations nearer than that in evidence are not told apart. */
  static final double TIE = 6;

  /** A rival must explain that share of what a cause explains to be looked at. */
  private static final double RIVAL_SHARE = 0.8;

  /** Rivals refitted for each cause. */
  private static final int RIVALS = 5;

  /** Least gain on held-out kicks, per cent of their residual: less does not pay whatever it is. */
  private static final double LEAST_GAIN = 0.7;

  private final CauseSearch search;
  private final long seed;
  private FittedHypothesis best;
  private final Map<Chart, List<String>> ties = new java.util.HashMap<>();

  Decision(CauseSearch search, FittedHypothesis best, long seed) {
    this.search = search;
    this.best = best;
    this.seed = seed;
  }

  FittedHypothesis best() {
    return best;
  }

  /** By how much the remaining misfit devalues chi-square. */
  static double temper(HypothesisFitter fitter, FittedHypothesis f) {
    Structure s = Structure.of(fitter, f);
    double perKick = f.residuals() / (double) fitter.kicks.size();
    return 1 + (s.deviation() > 3 ? Math.max(0, s.systematic()) * perKick : 0);
  }

  /** Evidence for the first over the second with tempered likelihoods; Occam's factors shrink with the information, by half the logarithm of the temper per unknown. */
  static double evidence(FittedHypothesis with, FittedHypothesis than, double temper) {
    double likelihood = 0.5 * (than.chiSquare() - with.chiSquare());
    double occam = with.logEvidence() - than.logEvidence() - likelihood;
    int more = with.hypothesis().coordinates() - than.hypothesis().coordinates();
    return likelihood / temper + occam + 0.5 * more * Math.log(temper);
  }

  /** Takes causes out that are not worth it, and puts rivals in that are better, until nothing changes. */
  void settle() {
    for (int round = 0; round < 8; round++) {
      if (!dropped() && !swapped()) {
        return;
      }
    }
  }

  private FittedHypothesis without(Chart chart) {
    return search.without(best, chart);
  }

  private boolean dropped() {
    double temper = temper(search.fitter(), best);
    Chart weakest = null;
    double least = NEEDED;
    for (Chart chart : best.hypothesis().charts()) {
      double evidence = evidence(best, without(chart), temper);
      if (evidence < least) {
        least = evidence;
        weakest = chart;
      }
    }
    if (weakest == null) {
      return false;
    }
    best = without(weakest);
    return true;
  }

  private boolean swapped() {
    double temper = temper(search.fitter(), best);
    ties.clear();
    for (Chart chart : best.hypothesis().charts()) {
      FittedHypothesis less = without(chart);
      double explained = less.chiSquare() - best.chiSquare();
      List<String> tied = new ArrayList<>();
      FittedHypothesis better = null;
      List<Score> rivals =
          search.scores(less).stream()
              .filter(s -> !s.chart().sameCause(chart) || s.chart().size() != chart.size())
              .filter(s -> s.gain() > RIVAL_SHARE * explained)
              .sorted(Comparator.comparingDouble(s -> -s.evidence()))
              .limit(RIVALS)
              .toList();
      for (Score s : rivals) {
        Hypothesis h = less.hypothesis().with(s.chart(), s.perKick());
        FittedHypothesis rival = search.extend(less, s);
        rival = rival == null ? search.fit(h, less) : rival;
        double ahead = evidence(best, rival, temper);
        if (ahead < 0 && (better == null || evidence(better, rival, temper) < 0)) {
          better = rival;
        }
        if (ahead < TIE && !s.chart().id().equals(chart.id())) {
          tied.add(s.chart().id());
        }
      }
      if (better != null) {
        best = better;
        return true;
      }
      ties.put(chart, tied.stream().distinct().toList());
    }
    return false;
  }

  List<String> ties(Chart chart) {
    return ties.getOrDefault(chart, List.of());
  }

  /** Evidence of a cause within the best hypothesis. */
  double evidence(Chart chart) {
    return evidence(best, without(chart), temper(search.fitter(), best));
  }

  /** What each cause gains on kicks that were held out; those that do not pay leave. */
  Map<Chart, Gain> gains(Consumer<String> progress) {
    while (true) {
      HoldOut all = HoldOut.of(search.fitter(), best, seed);
      Map<Chart, Gain> gains = new java.util.LinkedHashMap<>();
      Chart useless = null;
      for (Chart chart : best.hypothesis().charts()) {
        HoldOut less = HoldOut.of(search.fitter(), without(chart), seed);
        Gain gain = all.gainOn(less, seed);
        gains.put(chart, gain);
        if (!(gain.lowMm() > 0) || gain.percent() < LEAST_GAIN || all.gainsByOneKick(less)) {
          useless = chart;
        }
      }
      if (useless == null) {
        return gains;
      }
      progress.accept("not named: " + useless + " does not pay on kicks that were held out");
      best = without(useless);
      settle();
    }
  }

  /** Takes causes out that the remaining structure makes doubtful. */
  void acquit(List<Chart> charts) {
    for (Chart chart : charts) {
      best = without(chart);
    }
  }

  /** How many residuals of noise are left beyond what noise makes. */
  Structure structure() {
    return Structure.of(search.fitter(), best);
  }
}
