package fieldcal.live;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Phase;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.FitStatistics;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Fits kicks and decides which parameters each of them determines well enough to count. For one thread. */
final class KickJudge {
  /** A kick whose fit is this many times worse than the last ones of its kind shows something else: a ball that hit a robot, two balls. */
  private static final double WORSE_THAN_OTHERS = 3;

  /** With fewer earlier kicks it is not known what is usual. */
  private static final int FEWEST_OTHERS = 5;

  private static final int OTHERS = 31;

  /** When a larger share of the detections are outliers, the rest is not trusted either. */
  private static final double MOST_OUTLIERS = 0.25;

  /** Evaluations of a search near the published model. */
  private static final int SHORT_SEARCH = 50;

  /** Precision with which the beginning of rolling is looked for, s. */
  private static final double ROLLING_STEP = 0.01;

  private final LiveSettings settings;
  private final Epoch epoch;
  private final KickFitter fitter;
  private final KickFitter nearby;
  private final Map<KickKind, Deque<Double>> residuals = new EnumMap<>(KickKind.class);

  KickJudge(LiveSettings settings, Epoch epoch) {
    this.settings = settings;
    this.epoch = epoch;
    fitter = new KickFitter(settings.fit());
    FitSettings fit = settings.fit();
    nearby =
        new KickFitter(
            new FitSettings(
                fit.seed(),
                SHORT_SEARCH,
                fit.searchObservations(),
                fit.outlierDistance(),
                fit.lossScale()));
    for (KickKind kind : KickKind.values()) {
      residuals.put(kind, new ArrayDeque<>());
    }
  }

  /**
   * Judges a kick.
   *
   * @param roll accRoll of the flat kicks, m/s², for chips that do not determine it
   */
  LiveKick judge(Kick kick, CameraViews cameras, BallModels start, OptionalDouble roll) {
    FitProblem problem =
        FitProblem.of(
            kick,
            cameras,
            start.flat().orElse(FlatModel.typical()),
            start.chip().orElse(ChipModel.typical()));
    KickFit fit = fit(problem);
    if (fit.failure().isPresent()) {
      return kick(kick, fit, Map.of(), fit.failure().get());
    }
    if (fit.kind() == KickKind.CHIP && roll.isPresent() && !counts(fit.estimate("accRoll"))) {
      // What a chip does not show of the rolling is known from the flat kicks; a wrong value would
      // spoil the other estimates.
      fit = fitter.refit(problem.withChipRollFixed(roll.getAsDouble()), fit);
    }
    String distrust = distrust(fit);
    if (distrust != null) {
      return kick(kick, fit, Map.of(), distrust);
    }
    Map<BallParameter, BallSample> samples = samples(fit);
    return kick(kick, fit, samples, samples.isEmpty() ? tooShort(kick.end()) : null);
  }

  /** Most kicks of a match are flat and much like the published model: what is near it and explains the kick needs no long search. */
  private KickFit fit(FitProblem problem) {
    KickFit flat = nearby.fit(problem, KickKind.FLAT);
    boolean explained = flat.failure().isEmpty() && flat.statistics().explained();
    return explained ? flat : fitter.fit(problem);
  }

  private String distrust(KickFit fit) {
    FitStatistics s = fit.statistics();
    Deque<Double> others = residuals.get(fit.kind());
    double[] sorted = others.stream().mapToDouble(v -> v).sorted().toArray();
    others.add(fit.rmsMm());
    if (others.size() > OTHERS) {
      others.remove();
    }
    if (sorted.length >= FEWEST_OTHERS
        && fit.rmsMm() > WORSE_THAN_OTHERS * sorted[sorted.length / 2]) {
      return "fits far worse than the kicks before";
    }
    boolean many = s.observations() - s.used() > MOST_OUTLIERS * s.observations();
    return many ? "too many of its detections do not fit" : null;
  }

  private static String tooShort(KickEnd end) {
    return switch (end) {
      case TOUCHED_ROBOT -> "touched too early to determine a parameter";
      case LEFT_FIELD -> "left the field too early to determine a parameter";
      case LOST -> "out of sight too early to determine a parameter";
      case STOPPED, RECORDING_ENDED -> "too short to determine a parameter";
    };
  }

  private boolean counts(Estimate e) {
    return e.usable() && e.standardError() <= settings.maxRelativeError() * Math.abs(e.value());
  }

  private Map<BallParameter, BallSample> samples(KickFit fit) {
    Map<BallParameter, BallSample> samples = new EnumMap<>(BallParameter.class);
    for (Estimate e : fit.modelEstimates()) {
      Arrays.stream(BallParameter.values())
          .filter(p -> p.modelName().equals(e.name()) && counts(e))
          .forEach(p -> samples.put(p, sample(fit, p, e)));
    }
    return samples;
  }

  private BallSample sample(KickFit fit, BallParameter parameter, Estimate e) {
    Kick kick = fit.kick();
    return new BallSample(
        epoch.unixSeconds(kick.time()),
        e.value(),
        e.standardError(),
        parameter.spinSensitive() && kick.afterDribbling(),
        parameter.speedSensitive() ? rollingSpeed(fit) : Double.NaN);
  }

  /** Mean of the speeds between which the ball was seen rolling; NaN when it was not. */
  private static double rollingSpeed(KickFit fit) {
    Observations seen = fit.kick().observations();
    BallTrajectory path = fit.trajectory();
    double end = Math.min(seen.time(seen.size() - 1), path.restTime());
    double begin = path.kickTime();
    while (begin < end && path.phaseAt(begin) != Phase.ROLLING) {
      begin += ROLLING_STEP;
    }
    return begin < end
        ? 0.5 * (path.stateAt(begin).groundSpeed() + path.stateAt(end).groundSpeed())
        : Double.NaN;
  }

  private LiveKick kick(
      Kick kick, KickFit fit, Map<BallParameter, BallSample> samples, String unused) {
    boolean fitted = fit.failure().isEmpty();
    Observations seen = kick.observations();
    int last = seen.size() - 1;
    return new LiveKick(
        kick.id(),
        epoch.unixSeconds(kick.time()),
        fitted ? fit.estimate("x").value() : kick.x(),
        fitted ? fit.estimate("y").value() : kick.y(),
        fitted ? fit.estimate("vx").value() : kick.vx(),
        fitted ? fit.estimate("vy").value() : kick.vy(),
        last < 0 ? kick.x() : seen.x(last),
        last < 0 ? kick.y() : seen.y(last),
        kick.robot(),
        fitted ? Optional.of(fit.kind()) : Optional.empty(),
        kick.end(),
        kick.afterDribbling(),
        fitted ? fit.rmsMm() : Double.NaN,
        samples,
        Optional.ofNullable(unused));
  }
}
