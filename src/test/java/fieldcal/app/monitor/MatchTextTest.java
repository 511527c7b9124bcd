package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.live.BallParameter;
import fieldcal.live.BallSample;
import fieldcal.live.BallSamples;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MatchTextTest {
  private static final BallModels PUBLISHED =
      new BallModels(
          Optional.of(new FlatModel(-3.1, -0.28, 0.65)),
          Optional.of(new ChipModel(0.75, 0.95, 0.52, -0.28)));

  private final MatchText text = new MatchText(ZoneOffset.UTC);

  /** The ball rolls worse than published; of chips three are known. */
  private static MatchStatus status() {
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withPublished(PUBLISHED), new Epoch(0), LiveListener.NONE);
    monitor.add(
        new BallSamples(
            Map.of(
                BallParameter.ACC_ROLL, samples(31, -0.40),
                BallParameter.DAMPING_Z, samples(3, 0.52))));
    while (monitor.poll()) {
      // Compares with what is published.
    }
    String note =
        "vision: 1234 packets, 0 dropped, SILENT for 12 s, joined again 6 times (no route)";
    return new MatchStatus(
        monitor.snapshot(), new FeedStatus("a match", List.of(note), false), Optional.empty());
  }

  private static List<BallSample> samples(int count, double value) {
    return IntStream.range(0, count)
        .mapToObj(i -> new BallSample(i, value, 0.001, false, Double.NaN))
        .toList();
  }

  @Test
  void aTerminalOfEightyColumnsCutsNothing() {
    List<String> lines = text.lines(status(), 79);
    assertThat(lines).allSatisfy(line -> assertThat(line.length()).isLessThan(80));
    assertThat(lines)
        .anyMatch(line -> line.matches(" +acc_roll, m/s² +-0.400 +-0.280 +43 % more +31 +-0.400.*"))
        .anyMatch(line -> line.matches(" +damping_z +0.520 +0.520 +too few yet +3/31 +0.520.*"))
        .anyMatch(line -> line.matches(" +k_switch +– +0.650 +0/31"));
  }

  @ParameterizedTest
  @ValueSource(ints = {40, 60, 79, 200})
  void sentencesAreBrokenAndNothingOfThemIsLost(int width) {
    String all = String.join(" ", text.lines(status(), width)).replaceAll(" +", " ");
    assertThat(all)
        .contains("WARNING since 00:00:30: acc_roll is -0.400 m/s², 43 % more than the published")
        .contains("(median of 31 kicks)")
        .contains("SILENT for 12 s, joined again 6 times (no route)");
  }

  @Test
  void whatMattersMostComesFirst() {
    List<String> lines = text.lines(status(), MatchText.UNBROKEN);
    assertThat(lines.get(0)).endsWith("a match");
    assertThat(lines.subList(0, 6))
        .anyMatch(line -> line.startsWith("WARNING"))
        .anyMatch(line -> line.startsWith("vision: "));
  }

  @Test
  void theEndTellsHowToGoOnWhereAMatchWasTooShort() {
    assertThat(text.summary(status(), MatchText.UNBROKEN))
        .last()
        .asString()
        .startsWith("fewer than 31 kicks for acc_slide (0), k_switch (0)")
        .contains("damping_z (3)")
        .contains("--state FILE")
        .doesNotContain("acc_roll");
  }
}
