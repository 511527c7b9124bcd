package fieldcal.live;

import fieldcal.fit.FitSettings;
import fieldcal.kick.KickFinderSettings;
import fieldcal.vision.BallModels;
import java.util.Objects;
import java.util.Optional;

/**
 * How a match is watched. Start from {@link #defaults} and change it with the with-methods.
 *
 * @param published the ball models to compare with; empty: those that vision publishes
 * @param samples how many of the newest samples of a parameter count, at least {@link SampleTree#ENOUGH}
 * @param warnAbove a median that is off by a larger part of the published value is warned about (–)
 * @param clearBelow the warning ends when it is off by a smaller part (–), at most {@code warnAbove}; where samples scatter much, somewhat lower, down to half of {@code warnAbove}
 * @param falseWarnings largest share of matches in which a warning from fewer than {@link SampleTree#ENOUGH} samples begins although no parameter is off by more than {@code warnAbove} (–, at most 0.5); the share is smaller unless all parameters are off by exactly that
 * @param maxRelativeError a sample with a larger standard error, as a part of its value, does not count (–)
 * @param waitingKicks how many kicks may wait to be fitted before the oldest of them is dropped
 * @param limitsInterval time between two estimates of the movement limits, s of the frames' time
 * @param kicks thresholds of kick finding
 * @param fit how kicks are fitted
 */
public record LiveSettings(
    Optional<BallModels> published,
    int samples,
    double warnAbove,
    double clearBelow,
    double falseWarnings,
    double maxRelativeError,
    int waitingKicks,
    double limitsInterval,
    KickFinderSettings kicks,
    FitSettings fit) {

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a number is out of its range
   */
  public LiveSettings {
    Objects.requireNonNull(published, "published");
    Objects.requireNonNull(kicks, "kicks");
    Objects.requireNonNull(fit, "fit");
    if (samples < SampleTree.ENOUGH || waitingKicks < 1) {
      throw new IllegalArgumentException(
          "samples must be at least %d and waitingKicks at least 1, not %d and %d"
              .formatted(SampleTree.ENOUGH, samples, waitingKicks));
    }
    if (!(clearBelow > 0 && warnAbove >= clearBelow && warnAbove < 1)) {
      throw new IllegalArgumentException(
          "0 < clearBelow ≤ warnAbove < 1 is needed, not " + clearBelow + " and " + warnAbove);
    }
    if (!(falseWarnings > 0 && falseWarnings <= 0.5)) {
      throw new IllegalArgumentException(
          "falseWarnings must lie in (0, 0.5], but is " + falseWarnings);
    }
    if (!(maxRelativeError > 0 && limitsInterval > 0)) {
      throw new IllegalArgumentException(
          "maxRelativeError and limitsInterval must be positive: "
              + maxRelativeError
              + ", "
              + limitsInterval);
    }
  }

  /**
   * Settings that were measured to work well. A warning above 20 % is the rule of the league's teams. It ends below 15 %: of series of 150 samples of accRoll
   * whose model is off by just 20 %, 4 % are warned about more than once then, 14 % where it ends at 17 %; after a change of the carpet it is raised once in either case ({@code ./gradlew benchmark
   * -PbenchmarkArgs="live-carpets sample-tree"}). One match in a thousand with a false early warning is one in some ten tournaments, and a budget ten times as large would
   * save less than two samples. A sample whose error is more than half of what is warned about proves little. Kicks come at
   * most every second and take a tenth of that to fit, so that 64 never wait unless the host stands still for a minute. Movement limits take some tenths of a second to estimate, and change slowly.
   *
   * @return the defaults
   */
  public static LiveSettings defaults() {
    return new LiveSettings(
        Optional.empty(),
        SampleTree.ENOUGH,
        0.20,
        0.15,
        0.001,
        0.10,
        64,
        10,
        KickFinderSettings.defaults(),
        FitSettings.defaults());
  }

  /**
   * The same with models to compare with.
   *
   * @param models instead of those that vision publishes
   * @return the changed copy
   */
  public LiveSettings withPublished(BallModels models) {
    return new LiveSettings(
        Optional.of(models),
        samples,
        warnAbove,
        clearBelow,
        falseWarnings,
        maxRelativeError,
        waitingKicks,
        limitsInterval,
        kicks,
        fit);
  }

  /**
   * The same with another number of samples: more make the medians more precise and warnings later.
   *
   * @param count at least {@link SampleTree#ENOUGH}
   * @return the changed copy
   */
  public LiveSettings withSamples(int count) {
    return new LiveSettings(
        published,
        count,
        warnAbove,
        clearBelow,
        falseWarnings,
        maxRelativeError,
        waitingKicks,
        limitsInterval,
        kicks,
        fit);
  }

  /**
   * The same with another budget for early warnings: a larger one makes them earlier.
   *
   * @param share of all matches in which an early warning may be false, in (0, 0.5]
   * @return the changed copy
   */
  public LiveSettings withFalseWarnings(double share) {
    return new LiveSettings(
        published,
        samples,
        warnAbove,
        clearBelow,
        share,
        maxRelativeError,
        waitingKicks,
        limitsInterval,
        kicks,
        fit);
  }

  /**
   * The same with another queue.
   *
   * @param count how many kicks may wait
   * @return the changed copy
   */
  public LiveSettings withWaitingKicks(int count) {
    return new LiveSettings(
        published,
        samples,
        warnAbove,
        clearBelow,
        falseWarnings,
        maxRelativeError,
        count,
        limitsInterval,
        kicks,
        fit);
  }

  /**
   * The same with another time between two estimates of the movement limits.
   *
   * @param seconds of the frames' time
   * @return the changed copy
   */
  public LiveSettings withLimitsInterval(double seconds) {
    return new LiveSettings(
        published,
        samples,
        warnAbove,
        clearBelow,
        falseWarnings,
        maxRelativeError,
        waitingKicks,
        seconds,
        kicks,
        fit);
  }
}
