package fieldcal.diagnosis.screening;

import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.Screening;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/** Looks again at kicks that a fitted model explains much worse than their fellows. Thread-safe; fits a kick as the other kind once, however often it is asked. */
public final class KickScreen {
  /** A kick whose reduced chi-square is this many times that of the median kick is screened again. */
  private static final double STANDS_OUT = 2.5;

  /** After a change, its reduced chi-square must be less than this many times that of the median kick. */
  private static final double LIKE_THE_OTHERS = 1.5;

  /** As the other kind, a kick must leave less than this share of what it leaves now. */
  private static final double CLEARLY_BETTER = 0.5;

  /** If a kick that is fitted alone leaves less than this share as the other kind, it is of that kind whatever the other kicks show: an order of magnitude, since ball parameters that fit one kick alone imitate the wrong kind to some extent. */
  private static final double BY_ITSELF = 0.1;

  /** Tangent of the flattest chip, 27°: chip kickers lift the ball by 30 to 60 degrees. */
  private static final double FLATTEST_CHIP = 0.5;

  /** Lengths of a kick's end that are tried without, s, because the ball may not be free there: a robot touches a ball for a tenth of a second before this is noticed, and may hold it for longer. */
  private static final double[] ENDS = {0.1, 0.2, 0.4, 0.8, 1.6};

  /** How long before a kick the ball certainly rests, s: before that it may have been placed. */
  private static final double SETTLED = 0.2;

  /** Share of the kicks that may be left out: more would be a finding. */
  private static final double MOST_LEFT_OUT = 0.1;

  /** Kicks that leave this many times what all others leave together would hide any cause: an order of magnitude, since one of a dozen kicks may well leave as much as the others by chance. */
  private static final double LOUD = 10;

  /** Most kicks count as explained if the median of their reduced chi-squares is below this. */
  private static final double EXPLAINED = 1.6;

  private final MovingNoise noise;
  private final EffectModel simple;
  private final double sessionStart;
  private final KickFitter fitter;
  private final SharedSolver solver = SharedSolver.withDefaults().withMaxIterations(30);
  private final Map<KickKind, Map<Kick, Optional<KickRecord>>> others =
      Map.of(
          KickKind.FLAT, Collections.synchronizedMap(new IdentityHashMap<>()),
          KickKind.CHIP, Collections.synchronizedMap(new IdentityHashMap<>()));

  /**
   * A screen.
   *
   * @param noise the cameras with their noise
   * @param simple the simple model, whose ball fits start from
   * @param sessionStart beginning of the session on the kicks' clock, s
   * @param settings of single fits
   */
  public KickScreen(
      MovingNoise noise, EffectModel simple, double sessionStart, FitSettings settings) {
    this.noise = noise;
    this.simple = simple;
    this.sessionStart = sessionStart;
    fitter = new KickFitter(settings);
  }

  /**
   * One kick's fit as a record.
   *
   * @param fit not a failed one
   * @param noise the cameras with their noise
   * @return the record, with the detections that are the ball
   */
  public static KickRecord record(KickFit fit, MovingNoise noise) {
    boolean[] kept = Screening.kept(fit, noise.cameras());
    return new KickRecord(fit, kept, noise);
  }

  /**
   * The kicks, revised with a model: kicks that stand out are cut or taken for the other kind, and what was cut is used again where the model explains it.
   *
   * @param at the model, fitted to the kicks
   * @param cuts whether beginnings and ends may be cut: false while the model is known to be wrong, because this would make them look wrong
   * @return an equal list when nothing changes
   */
  public List<KickRecord> revise(FittedModel at, boolean cuts) {
    double median = median(at);
    ModelState state = at.solution().state();
    double[] values = at.solution().values();
    double[] means =
        at.solution().problem().randoms().stream().mapToDouble(r -> values[r.mean()]).toArray();
    KickRecord[] revised = new KickRecord[at.kickCount()];
    IntStream.range(0, revised.length)
        .parallel()
        .forEach(
            k -> {
              KickRecord now = at.kick(k).record();
              boolean stands = at.reduced(k) > STANDS_OUT * Math.max(1, median);
              boolean cut = now.usedCount() < now.whole().usedCount();
              revised[k] = stands || cut ? look(at, k, state, means, median, cuts) : now;
            });
    return List.of(revised);
  }

  private static double median(FittedModel at) {
    double[] reduced = new double[at.kickCount()];
    for (int k = 0; k < reduced.length; k++) {
      reduced[k] = at.reducedAsSeen(k);
    }
    Arrays.sort(reduced);
    return reduced[reduced.length / 2];
  }

  private KickRecord look(
      FittedModel at, int k, ModelState state, double[] means, double median, boolean cuts) {
    EffectKick term = at.kick(k);
    KickRecord now = term.record();
    double[] own = at.solution().own(k);
    double[] scatters = at.solution().scatters();
    double good = LIKE_THE_OTHERS * Math.max(1, median);
    // Where most kicks are not explained, their ends look wrong, too.
    List<KickRecord> parts = cuts && median < STANDS_OUT ? parts(now) : List.of();
    if (now.usedCount() < now.whole().usedCount()) {
      // What was cut because of a worse model comes back when this one explains it.
      parts = List.of(now.whole());
    }
    for (KickRecord part : parts) {
      EffectKick cut = term.with(part);
      double left =
          solver.fitOwn(cut, own, state, means, scatters).chiSquare() / Math.max(1, cut.rows());
      if (left < good) {
        return part;
      }
    }
    boolean stands = at.reduced(k) > STANDS_OUT * Math.max(1, median);
    Optional<KickRecord> other = stands ? other(now) : Optional.empty();
    if (other.isEmpty()) {
      return now;
    }
    KickRecord changed = other.get();
    EffectKick as = term.as(changed);
    double[] start = Arrays.copyOf(changed.start(), as.ownSize());
    System.arraycopy(means, 0, start, changed.timeIndex() + 1, means.length);
    double left = Double.POSITIVE_INFINITY;
    List<EffectKick> variants = new ArrayList<>(List.of(as));
    as.neighbours().forEach(n -> variants.add((EffectKick) n));
    for (EffectKick variant : variants) {
      left =
          Math.min(
              left,
              solver.fitOwn(variant, start, state, means, scatters).chiSquare()
                  / Math.max(1, variant.rows()));
    }
    boolean better = left < CLEARLY_BETTER * at.reduced(k);
    // A model that does not explain the other kicks cannot tell the kind of this one, unless the
    // other kind leaves // less than the present kind does in a fit of this kick alone, or the kick
    // shows it by itself.
    double most = median < STANDS_OUT ? Math.max(good, now.alone()) : now.alone();
    boolean speaks = changed.alone() < BY_ITSELF * now.alone();
    return better && (left < most || speaks) ? changed : now;
  }

  /** The kick without a part in which the ball may not be free: its end, the time before it was certainly at rest, or all detections before the kick. */
  private static List<KickRecord> parts(KickRecord now) {
    List<KickRecord> parts = new ArrayList<>();
    double end = Double.NEGATIVE_INFINITY;
    boolean[] used = now.used();
    for (int i = 0; i < used.length; i++) {
      end = used[i] ? Math.max(end, now.time(i)) : end;
    }
    double kick = now.kick().time();
    for (double cut : ENDS) {
      add(now, Double.NEGATIVE_INFINITY, end - cut, parts);
    }
    if (now.fromRest()) {
      add(now, kick - SETTLED, Double.POSITIVE_INFINITY, parts);
      add(now, kick, Double.POSITIVE_INFINITY, parts);
    }
    return parts;
  }

  private static void add(KickRecord now, double from, double to, List<KickRecord> parts) {
    boolean[] used = now.used();
    int left = 0;
    int before = now.usedCount();
    for (int i = 0; i < used.length; i++) {
      used[i] &= now.time(i) >= from && now.time(i) <= to;
      left += used[i] ? 1 : 0;
    }
    if (left < before && left > 0.5 * before && left > 4 * now.start().length) {
      parts.add(now.withUsed(used));
    }
  }

  private Optional<KickRecord> other(KickRecord now) {
    KickKind kind = now.kind() == KickKind.FLAT ? KickKind.CHIP : KickKind.FLAT;
    Map<Kick, Optional<KickRecord>> known = others.get(kind);
    Optional<KickRecord> other = known.get(now.kick());
    if (other == null) {
      other = fitOther(now, kind);
      known.put(now.kick(), other);
    }
    return other;
  }

  private Optional<KickRecord> fitOther(KickRecord now, KickKind kind) {
    double[] ball = simple.globals().stream().mapToDouble(p -> p.value()).toArray();
    ModelState state = simple.at(ball);
    KickFit fit =
        fitter.fit(FitProblem.of(now.kick(), noise.cameras(), state.flat(), state.chip()), kind);
    if (fit.failure().isPresent()) {
      return Optional.empty();
    }
    if (kind == KickKind.CHIP) {
      double run = Math.hypot(fit.estimate("vx").value(), fit.estimate("vy").value());
      if (fit.estimate("vz").value() < FLATTEST_CHIP * run) {
        // A flat kick that spins looks like a chip of many low hops.
        return Optional.empty();
      }
    }
    return Optional.of(record(fit, noise));
  }

  /**
   * Whether any kick is explained much worse than its fellows.
   *
   * @param at the model, fitted to the kicks
   * @return whether one is to be looked at
   */
  public static boolean hasStandingOut(FittedModel at) {
    double most = STANDS_OUT * Math.max(1, median(at));
    return IntStream.range(0, at.kickCount()).anyMatch(k -> at.reduced(k) > most);
  }

  /**
   * Whether a model explains most kicks. In those that it does not explain, the ball may not have been free.
   *
   * @param at the model, fitted to the kicks
   * @return whether the median kick is explained
   */
  public boolean explainsMost(FittedModel at) {
    return median(at) < EXPLAINED;
  }

  /**
   * The kicks without the few that stand out while all others are explained: another ball, or one that hit something.
   *
   * @param at the model, fitted to the kicks
   * @return the same list when all stay
   */
  public List<KickRecord> withoutStrays(FittedModel at) {
    if (!explainsMost(at)) {
      return at.records();
    }
    List<KickRecord> few = withoutFew(at);
    return few.size() < at.kickCount() ? few : withoutDominant(at);
  }

  /**
   * The same if the median kick is only nearly explained: it would not stand out itself.
   *
   * @param at the model, fitted to the kicks
   * @return the same list when all stay
   */
  public static List<KickRecord> withoutFew(FittedModel at) {
    List<KickRecord> good = good(at);
    boolean few = at.kickCount() - good.size() <= mostLeftOut(at);
    return few && median(at) < STANDS_OUT ? good : at.records();
  }

  /**
   * The kicks without the few that leave far more than all others together.
   *
   * @param at a model, fitted to the kicks
   * @return the same list where there are none, or more than a few
   */
  public static List<KickRecord> withoutDominant(FittedModel at) {
    List<Integer> byLeft =
        IntStream.range(0, at.kickCount())
            .boxed()
            .sorted(Comparator.comparingDouble(k -> -left(at, k)))
            .toList();
    double rest = byLeft.stream().mapToDouble(k -> left(at, k)).sum();
    double all = rest;
    int loud = 0;
    while (loud < mostLeftOut(at) && rest * LOUD > all - rest) {
      rest -= left(at, byLeft.get(loud));
      loud++;
    }
    // Compared with kicks that leave nothing, even noise would leave much.
    double most = STANDS_OUT * Math.max(1, median(at));
    boolean stand = byLeft.subList(0, loud).stream().allMatch(k -> at.reducedAsSeen(k) > most);
    if (rest * LOUD > all - rest || !stand) {
      return at.records();
    }
    Set<Integer> out = Set.copyOf(byLeft.subList(0, loud));
    return IntStream.range(0, at.kickCount())
        .filter(k -> !out.contains(k))
        .mapToObj(k -> at.kick(k).record())
        .toList();
  }

  /**
   * The kicks, each with so much noise that a model leaves no more than noise of it: the weights of a likelihood in which the noise of a kick is unknown.
   *
   * @param at the model, fitted to the kicks
   * @return records in the model's order
   */
  public static List<KickRecord> withWhatIsLeftAsNoise(FittedModel at) {
    return IntStream.range(0, at.kickCount())
        .mapToObj(k -> at.kick(k).record().withNoise(Math.sqrt(Math.max(1, at.reduced(k)))))
        .toList();
  }

  private static double left(FittedModel at, int k) {
    return at.solution().kicks().get(k).rows() * Math.max(0, at.reducedAsSeen(k) - 1);
  }

  private static int mostLeftOut(FittedModel at) {
    return (int) Math.max(1, MOST_LEFT_OUT * at.kickCount());
  }

  private static List<KickRecord> good(FittedModel at) {
    double median = median(at);
    List<KickRecord> good = new ArrayList<>();
    for (int k = 0; k < at.kickCount(); k++) {
      if (at.reducedAsSeen(k) <= 2 * STANDS_OUT * Math.max(1, median)) {
        good.add(at.kick(k).record());
      }
    }
    return good;
  }
}
