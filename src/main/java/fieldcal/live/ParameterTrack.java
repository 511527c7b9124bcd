package fieldcal.live;

import fieldcal.vision.BallModels;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** One parameter through a match: its samples, how the median went, whether a warning is on. */
final class ParameterTrack {
  /** Medians that are remembered for pictures; when there are more, every other one is forgotten. */
  private static final int HISTORY = 240;

  private final BallParameter parameter;
  private final LiveSettings settings;
  private final SampleTree tree;
  private final List<MedianPoint> history = new ArrayList<>();
  private int stride = 1;
  private int skipped;
  private double newest = Double.NaN;
  private LiveWarning warning;

  ParameterTrack(BallParameter parameter, LiveSettings settings) {
    this.parameter = parameter;
    this.settings = settings;
    tree = new SampleTree(settings.samples());
  }

  void add(BallSample sample) {
    tree.add(sample);
    newest = sample.time();
    if (++skipped >= stride) {
      skipped = 0;
      history.add(new MedianPoint(sample.time(), tree.median(), tree.size()));
    }
    if (history.size() > HISTORY) {
      for (int i = history.size() - 1; i >= 0; i -= 2) {
        history.remove(i);
      }
      stride *= 2;
    }
  }

  List<BallSample> samples() {
    return tree.samples();
  }

  Optional<LiveWarning> warning() {
    return Optional.ofNullable(warning);
  }

  /** Compares with what is published; a warning that begins or ends thereby is returned. */
  Optional<LiveWarning> compare(BallModels published) {
    double value = parameter.of(published).orElse(Double.NaN);
    boolean on = warning != null;
    double limit = on ? settings.clearBelow() : settings.warnAbove();
    boolean off = tree.enough() && Math.abs(tree.median() / value - 1) > limit;
    if (off == on) {
      return Optional.empty();
    }
    LiveWarning now = new LiveWarning(parameter, newest, tree.median(), value, tree.size());
    warning = off ? now : null;
    return Optional.of(now);
  }

  ParameterEstimate estimate(BallModels published) {
    return new ParameterEstimate(
        parameter,
        tree.median(),
        tree.quantile(0.25),
        tree.quantile(0.75),
        tree.size(),
        parameter.of(published),
        warning != null,
        history);
  }
}
