package fieldcal.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Simulated matches against the truth. The benchmark {@code live} has more of them; this is what fits into a build. */
class LiveMatchTest {
  private static final double MINUTES = 3.5;
  private static SimulatedMatch match;
  private static SimulatedMatch otherCarpet;

  @BeforeAll
  static void play() {
    match = SimulatedMatch.play(2, MINUTES, -0.28);
    otherCarpet = SimulatedMatch.play(2, MINUTES, 1.3 * -0.28);
  }

  /** Notes what it is told. */
  private static final class Notes implements LiveListener {
    private final List<LiveKick> kicks = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();

    @Override
    public void kick(LiveKick kick) {
      kicks.add(kick);
    }

    @Override
    public void warningRaised(LiveWarning warning) {
      warnings.add("raised " + warning.parameter().id() + " after " + kicks.size());
    }

    @Override
    public void warningCleared(LiveWarning warning) {
      warnings.add("cleared " + warning.parameter().id() + " after " + kicks.size());
    }
  }

  @Test
  void mediansAreTheTruthAndAChangeOfTheCarpetIsWarnedAboutOnce() {
    Notes notes = new Notes();
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withLimitsInterval(1000),
            match.recording().epoch(),
            notes,
            Runnable::run);
    match.feed(monitor, 0);
    BallSnapshot before = monitor.snapshot().ball();
    int kicks = notes.kicks.size();
    assertThat(notes.warnings).isEmpty();
    assertThat(before.counts().used()).isGreaterThan(25);
    assertThat(before.kicks()).extracting(LiveKick::id).isSorted();
    assertThat(before.counts().dropped()).isZero();
    near(before, BallParameter.ACC_SLIDE, 0.05);
    near(before, BallParameter.ACC_ROLL, 0.05);
    near(before, BallParameter.K_SWITCH, 0.05);
    near(before, BallParameter.DAMPING_XY_FIRST_HOP, 0.08);
    near(before, BallParameter.DAMPING_XY_OTHER_HOPS, 0.08);
    near(before, BallParameter.DAMPING_Z, 0.08);
    assertThat(monitor.snapshot().cameras())
        .hasSize(4)
        .allSatisfy(
            camera -> {
              assertThat(camera.rateHz()).isBetween(68.0, 77.0);
              assertThat(Math.hypot(camera.offsetXMm(), camera.offsetYMm())).isBetween(5.0, 20.0);
              assertThat(camera.calibrated()).isTrue();
              // 2 mm at the centre of an image, more towards its edge.
              assertThat(camera.noiseMm()).isBetween(1.8, 2.8);
              assertThat(camera.disagrees()).isTrue();
              assertThat(camera.apartFrom().getAsInt()).isNotEqualTo(camera.id());
            });

    otherCarpet.feed(monitor, match.duration() + 0.1);
    monitor.finish();
    assertThat(notes.warnings).as("seed 2, %d kicks before", kicks).hasSize(1);
    int after = Integer.parseInt(notes.warnings.get(0).replaceFirst("raised acc_roll after ", ""));
    assertThat(after - kicks).isBetween(6, 31);
    assertThat(monitor.snapshot().ball().warnings())
        .singleElement()
        .satisfies(w -> assertThat(w.deviation()).isGreaterThan(0.2));
  }

  private static void near(BallSnapshot ball, BallParameter parameter, double share) {
    ParameterEstimate estimate = ball.of(parameter);
    double truth = parameter.of(SimulatedMatch.TRUTH).orElseThrow();
    assertThat(estimate.median())
        .as(parameter.id())
        .isCloseTo(truth, within(share * Math.abs(truth)));
    assertThat(estimate.deviation()).isCloseTo(0, within(share));
  }

  @Test
  void mediansOfPooledMatchesAreThoseOfOneLongMatch() {
    LiveSettings settings = LiveSettings.defaults().withLimitsInterval(1000);
    LiveMonitor first =
        new LiveMonitor(settings, match.recording().epoch(), LiveListener.NONE, Runnable::run);
    match.feed(first, 0);
    first.finish();
    BallSamples kept = LiveStateDocument.read(LiveStateDocument.of(first.samples()));
    LiveMonitor second =
        new LiveMonitor(settings, match.recording().epoch(), LiveListener.NONE, Runnable::run);
    second.add(kept);
    for (BallParameter parameter : BallParameter.values()) {
      assertThat(second.snapshot().ball().of(parameter).median())
          .isEqualTo(first.snapshot().ball().of(parameter).median());
    }
    otherCarpet.feed(second, match.duration() + 100);
    second.finish();
    LiveMonitor alone =
        new LiveMonitor(settings, match.recording().epoch(), LiveListener.NONE, Runnable::run);
    otherCarpet.feed(alone, match.duration() + 100);
    alone.finish();
    assertThat(second.samples().of(BallParameter.K_SWITCH))
        .containsAll(alone.samples().of(BallParameter.K_SWITCH))
        .hasSizeGreaterThan(31);
  }
}
