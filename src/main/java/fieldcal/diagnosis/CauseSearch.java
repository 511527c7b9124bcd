package fieldcal.diagnosis;

import fieldcal.effect.MotionEffect;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Looks for the hypothesis with the largest evidence: score tests choose what is worth a refit, the best few hypotheses are carried on, not the best alone, since the best single explanation of two causes may
 * be neither. Keeps every fit.
 */
final class CauseSearch {
  /** An effect whose score promises less evidence is not refitted; chance makes 10 once in more recordings than will ever be played. */
  static final double WORTH_A_FIT = 10;

  /** A hypothesis that explains less than that share of what the best does is not carried on. */
  private static final double NEAR = 0.5;

  /** A region whose score is less than that share of the best effect's is not looked at closely. */
  private static final double OF_STRONGEST = 0.5;

  /** A step that explains that share of what remains is a step on the way, whatever remains then. */
  private static final double A_GOOD_PART = 0.25;

  private static final Comparator<FittedHypothesis> BY_EVIDENCE =
      Comparator.comparingDouble(f -> -f.logEvidence());

  private static final double[] BOUNCE_STARTS = {0.05, -0.05, 0.12, -0.12, 0.2, -0.2, 0.3, -0.3};

  /** Spin of a ball between hops, as a fraction of rolling. */
  private static final double TYPICAL_SPIN = 0.5;

  /** A search that has fitted so many hypotheses without an end will find none. */
  private static final int MOST_FITS = 40;

  /** Where an error of the cameras alone leaves less than that share of the structure, or one of the ground or the air, nobody looks for wrong valleys of bounces. */
  private static final double LEFT_BY_CAMERAS = 0.1;

  private static final double LEFT_BY_MOTION = 0.05;

  /** Where flat kicks have that share of the structure, something else than bounces must be found first. */
  private static final double LEFT_BY_FLATS = 0.25;

  /** Evidence by which two fits of one hypothesis differ when they ended in different valleys. */
  private static final double OTHER_VALLEY = 1;

  /** Hypotheses carried on. */
  private static final int BEAM = 3;

  /** Refits for the best hypothesis, and for each of the others. */
  private static final int REFITS = 6;

  private static final int REFITS_OF_OTHERS = 3;

  /** Refits of one effect at different places, or with different magnitudes free. */
  private static final int OF_ONE_EFFECT = 2;

  private final HypothesisFitter fitter;
  private final Candidates candidates;
  private final RegionEdges edges;
  private final Consumer<String> progress;
  private final Map<FittedHypothesis, List<Score>> scores = new HashMap<>();
  private final List<FittedHypothesis> fitted = new ArrayList<>();
  private final Map<FittedHypothesis, Map<Chart, FittedHypothesis>> without = new HashMap<>();

  /** Whose region's edges are where they should be. */
  private final Set<FittedHypothesis> polished = new HashSet<>();

  CauseSearch(HypothesisFitter fitter, Consumer<String> progress) {
    this.fitter = fitter;
    this.progress = progress;
    candidates = new Candidates(fitter);
    edges = new RegionEdges(fitter);
  }

  /**
   * The best hypothesis with at most so many causes.
   *
   * @param dirty told the best so far after each step; when it says yes, the search ends, because the kicks must be cleaned first
   */
  FittedHypothesis search(
      FittedHypothesis simple, int maxCauses, Predicate<FittedHypothesis> dirty) {
    fitted.add(simple);
    return climb(simple, List.of(), maxCauses, dirty);
  }

  /**
   * The same for kicks that were searched before, now that some of them, or of their detections, count differently: what was fitted then is fitted again from where it ended.
   *
   * @param earlier the search before
   */
  FittedHypothesis searchAgain(
      FittedHypothesis simple,
      CauseSearch earlier,
      int maxCauses,
      Predicate<FittedHypothesis> dirty) {
    fitted.add(simple);
    List<KickData> kicksThen = earlier.fitter.kicks;
    // A kick of the wrong kind may have misled the bounces: they are searched anew.
    boolean sameKicks = Cleaning.sameKicks(fitter.kicks, kicksThen);
    List<FittedHypothesis> again = new ArrayList<>();
    for (FittedHypothesis f : earlier.fitted) {
      boolean bounces = f.hypothesis().charts().stream().anyMatch(CauseSearch::isBounce);
      if (!f.hypothesis().isSimple() && (sameKicks || !bounces)) {
        FittedHypothesis from = fitter.adopt(f, kicksThen);
        again.add(fitter.fit(f.hypothesis(), f.shared(), from, false));
      }
    }
    again.sort(BY_EVIDENCE);
    fitted.addAll(again);
    if (!again.isEmpty()) {
      FittedHypothesis first = again.get(0);
      FittedHypothesis settled =
          polishRegion(fitter.fit(first.hypothesis(), first.shared(), first, true));
      know(settled);
      again.set(0, settled);
    }
    return climb(simple, again, maxCauses, dirty);
  }

  /**
   * Extends the best hypotheses while that pays.
   *
   * @param known extensions of the simple model that are fitted already
   */
  private FittedHypothesis climb(
      FittedHypothesis simple,
      List<FittedHypothesis> known,
      int maxCauses,
      Predicate<FittedHypothesis> dirty) {
    FittedHypothesis best = simple;
    List<FittedHypothesis> beam = List.of(simple);
    int mostFits = MOST_FITS + known.size();
    while (best.hypothesis().size() < maxCauses) {
      if (fitted.size() > mostFits || dirty.test(best) || worthwhile(best).isEmpty()) {
        break;
      }
      List<FittedHypothesis> next = new ArrayList<>(best == simple ? known : List.of());
      addExtensions(best, beam, next);
      next.sort(BY_EVIDENCE);
      if (next.isEmpty() || !isProgress(best, next.get(0))) {
        break;
      }
      FittedHypothesis better = backward(next.get(0));
      if (better.hypothesis().sameCauses(best.hypothesis())) {
        break;
      }
      best = polishRegion(better);
      beam = beam(simple, best, next);
      progress.accept("best explanation so far: " + best.hypothesis());
    }
    return best;
  }

  /**
   * Refits of what the scores promise, until one of them leaves nothing to be explained: whatever else explains as much is found when rivals are compared.
   *
   * @param next what is known so far; what is fitted is added
   */
  private void addExtensions(
      FittedHypothesis best, List<FittedHypothesis> beam, List<FittedHypothesis> next) {
    if (next.stream().anyMatch(this::isExplained)) {
      return;
    }
    List<FittedHypothesis> known = List.copyOf(next);
    for (FittedHypothesis from : beam) {
      for (Score score : chosen(from, from == best ? REFITS : REFITS_OF_OTHERS)) {
        Hypothesis h = from.hypothesis().with(score.chart(), score.perKick());
        if (known.stream().anyMatch(k -> sameButForEdges(k.hypothesis(), h))) {
          continue;
        }
        FittedHypothesis f = extend(from, score);
        if (f == null) {
          continue;
        }
        // An edge in the wrong place looks like a second cause, and keeps bounces under suspicion.
        boolean ahead = next.stream().allMatch(n -> n.logEvidence() < f.logEvidence());
        FittedHypothesis found = ahead ? polishRegion(f) : f;
        next.add(found);
        if (isExplained(found)) {
          return;
        }
      }
    }
  }

  private boolean isExplained(FittedHypothesis f) {
    return Structure.of(fitter, f).isNothing();
  }

  /** Whether a step is worth its evidence even if what it leaves is an error of whole kicks, or explains a good part of what was left. */
  private boolean isProgress(FittedHypothesis before, FittedHypothesis after) {
    double excess = Structure.of(fitter, before).systematic() * before.residuals();
    double gained = before.chiSquare() - after.chiSquare();
    return Decision.evidence(after, before, Decision.temper(fitter, after)) > WORTH_A_FIT
        || gained > A_GOOD_PART * excess
            && after.logEvidence() - before.logEvidence() > WORTH_A_FIT;
  }

  /** Takes causes out again that later ones made needless. */
  private FittedHypothesis backward(FittedHypothesis f) {
    FittedHypothesis best = f;
    boolean changed = true;
    while (changed && best.hypothesis().size() > 1) {
      changed = false;
      double temper = Decision.temper(fitter, best);
      for (Chart chart : best.hypothesis().charts()) {
        FittedHypothesis less = without(best, chart);
        if (Decision.evidence(best, less, temper) < WORTH_A_FIT) {
          best = less;
          changed = true;
          break;
        }
      }
    }
    return best;
  }

  /** The best, and those that come near it in what they explain. Of regions that differ in their edges alone the first is enough. */
  private static List<FittedHypothesis> beam(
      FittedHypothesis simple, FittedHypothesis best, List<FittedHypothesis> next) {
    double explained = simple.chiSquare() - best.chiSquare();
    List<FittedHypothesis> beam = new ArrayList<>(List.of(best));
    for (FittedHypothesis f : next) {
      if (beam.size() < BEAM
          && simple.chiSquare() - f.chiSquare() > NEAR * explained
          && beam.stream().noneMatch(b -> sameButForEdges(b.hypothesis(), f.hypothesis()))) {
        beam.add(f);
      }
    }
    return beam;
  }

  private static boolean sameButForEdges(Hypothesis a, Hypothesis b) {
    Chart here = RegionEdges.region(a);
    Chart there = RegionEdges.region(b);
    boolean both = here != null && there != null;
    return both ? a.without(here).sameCauses(b.without(there)) : a.sameCauses(b);
  }

  /** Score tests of everything on top of a fitted hypothesis, best first. */
  List<Score> scores(FittedHypothesis at) {
    return scores.computeIfAbsent(at, this::allScores);
  }

  private List<Score> allScores(FittedHypothesis at) {
    ScoreFrame frame = new ScoreFrame(fitter, at);
    List<Score> all = new ArrayList<>();
    for (Chart chart : candidates.fixed()) {
      if (isNew(at.hypothesis(), chart)) {
        all.add(frame.score(chart));
      }
    }
    for (Chart chart : candidates.random()) {
      if (!at.hypothesis().hasCause(chart)) {
        all.add(frame.randomScore(chart));
      }
    }
    double strongest = all.stream().mapToDouble(Score::evidence).max().orElse(0);
    // A second region would be a pattern of the carpet, and no known cause.
    if (!at.hypothesis().hasEffect("worn_region")) {
      all.addAll(new RegionSearch(frame).best(Math.max(WORTH_A_FIT, OF_STRONGEST * strongest)));
    }
    all.sort(Comparator.comparingDouble((Score s) -> -s.evidence()));
    return all;
  }

  /** Whether a chart adds something: another cause, or more magnitudes of one that is there. */
  private static boolean isNew(Hypothesis hypothesis, Chart chart) {
    return hypothesis.charts().stream()
        .noneMatch(c -> c.sameCause(chart) && c.size() >= chart.size());
  }

  private List<Score> worthwhile(FittedHypothesis at) {
    return scores(at).stream().filter(s -> s.evidence() > WORTH_A_FIT).toList();
  }

  private List<Score> chosen(FittedHypothesis at, int most) {
    List<Score> chosen = new ArrayList<>();
    Map<String, Integer> perEffect = new HashMap<>();
    for (Score s : worthwhile(at)) {
      int before = perEffect.merge(s.chart().id(), 1, Integer::sum);
      if (before <= OF_ONE_EFFECT && chosen.size() < most) {
        chosen.add(s);
      }
    }
    if (at.hypothesis().isSimple()) {
      // With wrong numbers of hops the score of what changes bounces says little.
      scores(at).stream()
          .filter(s -> isBounce(s.chart()) && shows(s) && !chosen.contains(s))
          .forEach(chosen::add);
    }
    return chosen;
  }

  /** Whether the kicks show anything of an effect at all. */
  private static boolean shows(Score score) {
    return score.evidence() > Double.NEGATIVE_INFINITY;
  }

  /** The hypothesis with one effect more, fitted; null when that was done before. */
  FittedHypothesis extend(FittedHypothesis from, Score score) {
    Hypothesis base = from.hypothesis();
    Chart replaced =
        base.charts().stream().filter(c -> c.sameCause(score.chart())).findFirst().orElse(null);
    Hypothesis next =
        (replaced == null ? base : base.without(replaced)).with(score.chart(), score.perKick());
    for (FittedHypothesis f : fitted) {
      if (f.hypothesis().sameCauses(next)) {
        return null;
      }
    }
    double[] start = start(next, from);
    FittedHypothesis f = fit(next, start, from, replaced == null ? score : null);
    if (isBounce(score.chart()) && !isElsewhere(from)) {
      f = fromOtherStarts(f, score.chart(), start, from);
    }
    fitted.add(f);
    return f;
  }

  /**
   * Whether what a hypothesis leaves is none of the bounces' doing: flat kicks, which do not bounce, leave much of it, or a hypothesis without spin and bounces, which no bounce resembles, is known to explain
   * nearly all of it.
   */
  private boolean isElsewhere(FittedHypothesis from) {
    if (Structure.shareOf(KickKind.FLAT, fitter, from) > LEFT_BY_FLATS) {
      return true;
    }
    double left = Structure.of(fitter, from).systematic();
    for (FittedHypothesis f : fitted) {
      List<Chart> charts = f.hypothesis().charts();
      boolean moves = charts.stream().anyMatch(c -> c.template() instanceof MotionEffect);
      double share = moves ? LEFT_BY_MOTION : LEFT_BY_CAMERAS;
      if (charts.stream().noneMatch(CauseSearch::resemblesBounce)
          && Structure.of(fitter, f).systematic() < share * left) {
        return true;
      }
    }
    return false;
  }

  private static boolean resemblesBounce(Chart chart) {
    return isBounce(chart) || chart.template() instanceof MotionEffect.SpinAtKick;
  }

  /** The best fit from several starts; the first that leaves next to nothing to be explained is the best. */
  private FittedHypothesis fromOtherStarts(
      FittedHypothesis f, Chart chart, double[] start, FittedHypothesis from) {
    FittedHypothesis best = f;
    FittedHypothesis apart = fitter.withOwnFits(from);
    int end = offset(f.hypothesis(), chart) + chart.size();
    double enough = LEFT_BY_MOTION * Structure.of(fitter, from).systematic();
    for (double[] other : bounceStarts(f.hypothesis(), chart, start)) {
      if (isExplained(best) || Structure.of(fitter, best).systematic() < enough) {
        break;
      }
      FittedHypothesis tried =
          fitter.fitHeldAtFirst(
              f.hypothesis(),
              other,
              apart,
              SharedUnknowns.FIRST_HOP,
              end - SharedUnknowns.FIRST_HOP);
      best = tried.logEvidence() > best.logEvidence() ? tried : best;
    }
    return best;
  }

  /** Where to start with what changes bounces: at its absence, and, since spin that ends in rolling puts creases into the objective, on both sides of them. */
  private static List<double[]> bounceStarts(Hypothesis next, Chart chart, double[] start) {
    List<double[]> starts = new ArrayList<>(List.of(start));
    if (chart.template() instanceof BounceSpinCoupling) {
      for (double coefficient : BOUNCE_STARTS) {
        double[] other = start.clone();
        other[offset(next, chart)] = coefficient;
        other[SharedUnknowns.OTHER_HOPS] += TYPICAL_SPIN * coefficient;
        starts.add(other);
      }
    }
    return starts;
  }

  /**
   * A hypothesis without one of its causes. It is fitted from where the whole hypothesis ended even when a fit of it is known: that one may have stopped in another valley, with other numbers of
   * hops, and a cause that does nothing would seem to explain the difference.
   */
  FittedHypothesis without(FittedHypothesis f, Chart chart) {
    return without
        .computeIfAbsent(f, key -> new HashMap<>())
        .computeIfAbsent(chart, c -> fitWithout(f, c));
  }

  private FittedHypothesis fitWithout(FittedHypothesis f, Chart chart) {
    Hypothesis less = f.hypothesis().without(chart);
    FittedHypothesis fresh = fitter.fit(less, start(less, f), f, true);
    for (int i = 0; i < fitted.size(); i++) {
      FittedHypothesis known = fitted.get(i);
      if (known.hypothesis().sameCauses(less)) {
        if (fresh.logEvidence() < known.logEvidence() + OTHER_VALLEY) {
          return known;
        }
        fitted.set(i, fresh);
        return fresh;
      }
    }
    fitted.add(fresh);
    return fresh;
  }

  /** Takes a fit that was made elsewhere. */
  void know(FittedHypothesis f) {
    fitted.removeIf(known -> known.hypothesis().sameCauses(f.hypothesis()));
    fitted.add(f);
  }

  /** The best fit that is known of the simple model. */
  FittedHypothesis simple() {
    return fitted.stream().filter(f -> f.hypothesis().isSimple()).findFirst().orElseThrow();
  }

  /** The fit of a hypothesis, new or known, from another one's. */
  FittedHypothesis fit(Hypothesis next, FittedHypothesis from) {
    for (FittedHypothesis f : fitted) {
      if (f.hypothesis().sameCauses(next)) {
        return f;
      }
    }
    FittedHypothesis f = fitter.fit(next, start(next, from), from, true);
    fitted.add(f);
    return f;
  }

  private FittedHypothesis fit(
      Hypothesis next, double[] start, FittedHypothesis from, Score score) {
    if (score == null || score.perKick()) {
      return fitter.fit(next, start, from, true);
    }
    int at = offset(next, score.chart());
    double[] best = start;
    double lowest = fitter.cost(next, start, from);
    for (double share = 1; share > 0.05; share /= 2) {
      double[] tried = start.clone();
      for (int j = 0; j < score.coordinates().length; j++) {
        tried[at + j] = share * score.coordinates()[j];
      }
      double cost = fitter.cost(next, tried, from);
      if (cost < lowest) {
        lowest = cost;
        best = tried;
      }
    }
    return fitter.fit(next, best, from, true);
  }

  static int offset(Hypothesis hypothesis, Chart chart) {
    int k = SharedUnknowns.MODEL;
    for (Chart c : hypothesis.charts()) {
      if (c == chart) {
        return k;
      }
      k += c.size();
    }
    throw new IllegalArgumentException(chart + " is no part of " + hypothesis);
  }

  /** Shared values of a hypothesis: what it has in common with another one as fitted there, the rest zero. */
  static double[] start(Hypothesis next, FittedHypothesis from) {
    double[] start = Arrays.copyOf(from.shared(), SharedUnknowns.MODEL + next.coordinates());
    Arrays.fill(start, SharedUnknowns.MODEL, start.length, 0);
    for (Chart chart : next.charts()) {
      if (from.hypothesis().charts().contains(chart)) {
        System.arraycopy(
            from.shared(), from.offset(chart), start, offset(next, chart), chart.size());
      }
    }
    return start;
  }

  /** The fit with the edges of its worn region where they belong; the same object when it has none. */
  FittedHypothesis polishRegion(FittedHypothesis f) {
    if (polished.contains(f)) {
      return f;
    }
    FittedHypothesis best = edges.polish(f);
    if (best != f) {
      know(best);
    }
    polished.add(best);
    return best;
  }

  /** What the edges of a region leave open of its change; zero without a region. */
  double edgeError(FittedHypothesis f) {
    return edges.error(f);
  }

  HypothesisFitter fitter() {
    return fitter;
  }

  /** Everything that was fitted. */
  List<FittedHypothesis> fitted() {
    return fitted;
  }

  private static boolean isBounce(Chart chart) {
    return chart.template() instanceof MotionEffect.Bounce;
  }
}
