package fieldcal.live;

import fieldcal.vision.BallModels;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One parameter through a match: its samples, the history of its median, and whether a warning is active. */
final class ParameterTrack {
  /** Largest number of medians that are remembered for plots; when there are more, every other one is forgotten. */
  private static final int HISTORY = 240;

  /** Samples of both kinds are compared from this many of each on … */
  private static final int COMPARABLE = 5;

  /** … or from this many of each on, if there are as many in all and they scatter so little that a difference that matters would show. One ball that spun unnoticed does not move the median of three. */
  private static final int FEWEST_COMPARABLE = 3;

  /** Samples that differ by more than this many standard errors are not of the same kind … */
  private static final double DIFFERENT = 2.5;

  /** … if they also differ by this part of their value: a smaller difference affects no warning, and the error of few samples is poorly known. */
  private static final double MATTERS = 0.05;

  private final BallParameter parameter;
  private final LiveSettings settings;
  private final WarningRule rule;
  private final SampleTree clean;
  private final SampleTree spinning;
  private SampleTree counted;
  private final UsualSpeed usual = new UsualSpeed();
  private final List<MedianPoint> history = new ArrayList<>();
  private int stride = 1;
  private int skipped;
  private double newest = Double.NaN;
  private LiveWarning warning;

  ParameterTrack(BallParameter parameter, LiveSettings settings) {
    this.parameter = parameter;
    this.settings = settings;
    rule = new WarningRule(settings);
    clean = new SampleTree(settings.samples());
    spinning = new SampleTree(settings.samples());
    counted = clean;
  }

  /** Takes the next sample, or one of an earlier match; one that is here already counts once. */
  void add(BallSample sample) {
    SampleTree its = sample.possiblySpinning() ? spinning : clean;
    if (its.samples().stream().anyMatch(s -> BallSample.BY_TIME.compare(s, sample) == 0)) {
      return;
    }
    its.add(sample);
    counted = spinning.size() > 0 && (!comparable() || agree()) ? both() : clean;
    usual.add(sample.speed());
    if (sample.time() < newest) {
      // The history goes on from the newest sample.
      return;
    }
    newest = sample.time();
    if (++skipped >= stride) {
      skipped = 0;
      history.add(new MedianPoint(sample.time(), counted.median(), counted.size()));
    }
    if (history.size() > HISTORY) {
      for (int i = history.size() - 1; i >= 0; i -= 2) {
        history.remove(i);
      }
      stride *= 2;
    }
  }

  private boolean comparable() {
    int fewer = Math.min(clean.size(), spinning.size());
    return fewer >= COMPARABLE
        || fewer >= FEWEST_COMPARABLE
            && clean.size() + spinning.size() >= 2 * COMPARABLE
            && DIFFERENT * errorOfDifference() <= matters();
  }

  /** Whether most samples that count are of balls that may have spun, with too few others to compare them with. */
  private boolean maybeSpun() {
    return spinning.size() > clean.size() && !comparable();
  }

  /**
   * Whether spin may be why the samples differ from a published value. A dribbler pulls the top of the ball towards the robot, and such backspin makes all that depends on spin smaller ({@link BallParameter#spinSensitive}). So where it
   * is not known whether most balls spun, only larger samples prove that the published value is wrong.
   */
  private boolean mayBeBackspin(double published) {
    return maybeSpun() && !(counted.median() > published);
  }

  private boolean agree() {
    return Math.abs(clean.median() - spinning.median())
        <= Math.max(matters(), DIFFERENT * errorOfDifference());
  }

  private double matters() {
    return MATTERS * Math.abs(clean.median());
  }

  /** Standard error of the difference between balls that may have spun and those that did not; both scatter alike, or those that spun more. */
  private double errorOfDifference() {
    double[] deviations = new double[clean.size() + spinning.size()];
    int n = 0;
    for (SampleTree tree : List.of(clean, spinning)) {
      for (BallSample sample : tree.samples()) {
        deviations[n++] = Math.abs(sample.value() - tree.median());
      }
    }
    return WarningRule.errorOfDifference(
        WarningRule.scatter(deviations), clean.size(), spinning.size());
  }

  private SampleTree both() {
    SampleTree tree = new SampleTree(settings.samples());
    clean.samples().forEach(tree::add);
    spinning.samples().forEach(tree::add);
    return tree;
  }

  /** All samples, also those that do not count now. */
  List<BallSample> samples() {
    List<BallSample> all = new ArrayList<>(clean.samples());
    all.addAll(spinning.samples());
    return all;
  }

  Optional<LiveWarning> warning() {
    return Optional.ofNullable(warning);
  }

  /** Compares with the published models; returns the warning that this begins or ends. */
  Optional<LiveWarning> compare(BallModels published) {
    double value = parameter.of(published).orElse(Double.NaN);
    boolean on = warning != null;
    WarningRule.Verdict verdict =
        rule.judge(counted, usual.square(), mayBeBackspin(value) ? Double.NaN : value, on);
    if (verdict.warn() == on) {
      return Optional.empty();
    }
    LiveWarning now =
        new LiveWarning(parameter, newest, verdict.median(), value, verdict.samples());
    warning = verdict.warn() ? now : null;
    return Optional.of(now);
  }

  ParameterEstimate estimate(BallModels published) {
    return new ParameterEstimate(
        parameter,
        counted.median(),
        counted.quantile(0.25),
        counted.quantile(0.75),
        counted.size(),
        maybeSpun(),
        parameter.of(published),
        warning != null,
        history);
  }
}
