package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.live.BallParameter;
import fieldcal.live.BallSample;
import fieldcal.live.BallSamples;
import fieldcal.live.LiveKick;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
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
        "vision: 1234 packets, 0 dropped. Nothing was received for 12 s. fieldcal joined the group"
            + " again 6 times (no route)";
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
        .anyMatch(
            line -> line.matches(" +rolling deceleration, m/s² +−0.400 +−0.280 +43 % more +31"))
        .anyMatch(line -> line.matches(" +vertical damping +0.520 +0.520 +too few yet +3/31"))
        .anyMatch(line -> line.matches(" +switch to rolling +– +0.650 +0/31"));
  }

  @Test
  void aWideTerminalAlsoShowsTheMiddleHalfOfTheKicks() {
    assertThat(text.lines(status(), 120))
        .anyMatch(line -> line.endsWith("kicks    middle 50 %"))
        .anyMatch(line -> line.matches(" +vertical damping .* 3/31 +0.520 … 0.520"));
  }

  @Test
  void peopleReadNoNamesOfFilesWithoutTheirMeaning() {
    Pattern alone =
        Pattern.compile("(?<!\\()(acc_slide|acc_roll|k_switch|damping_(xy_\\w+_hops?|z))\\b");
    List<String> all = new ArrayList<>(text.summary(status(), MatchText.UNBROKEN));
    all.add(text.kick(kick()));
    assertThat(all).noneMatch(line -> alone.matcher(line).find());
  }

  @Test
  void aKickNamesWhatItDeterminesWithUnits() {
    assertThat(text.kick(kick()))
        .endsWith("sliding deceleration −3.012 m/s², switch to rolling 0.655 (may have spin)");
  }

  private static LiveKick kick() {
    Map<BallParameter, BallSample> samples = new EnumMap<>(BallParameter.class);
    samples.put(BallParameter.ACC_SLIDE, new BallSample(5, -3.012, 0.02, true, Double.NaN));
    samples.put(BallParameter.K_SWITCH, new BallSample(5, 0.655, 0.004, true, Double.NaN));
    return new LiveKick(
        7,
        5,
        0,
        0,
        4,
        3,
        2,
        1.5,
        Optional.empty(),
        Optional.of(KickKind.FLAT),
        KickEnd.STOPPED,
        true,
        1.5,
        samples,
        Optional.empty());
  }

  /** Only kicks after dribbling are known of the switch to rolling. */
  @Test
  void aMarkSaysWhichParameterMayHaveSpin() {
    LiveMonitor monitor =
        new LiveMonitor(
            LiveSettings.defaults().withPublished(PUBLISHED), new Epoch(0), LiveListener.NONE);
    monitor.add(
        new BallSamples(
            Map.of(
                BallParameter.K_SWITCH,
                IntStream.range(0, 31)
                    .mapToObj(i -> new BallSample(i, 0.66, 0.001, true, Double.NaN))
                    .toList())));
    while (monitor.poll()) {
      // Compares with what is published.
    }
    MatchStatus spun =
        new MatchStatus(
            monitor.snapshot(), new FeedStatus("a match", List.of(), false), Optional.empty());
    assertThat(text.lines(spun, 79))
        .allSatisfy(line -> assertThat(line.length()).isLessThan(80))
        .anyMatch(line -> line.matches(" +switch to rolling +0.660 .* 31 \\*"))
        .anyMatch(line -> line.startsWith("  * may have spin: kicked after dribbling or catching"));
  }

  @ParameterizedTest
  @ValueSource(ints = {40, 60, 79, 200})
  void sentencesAreBrokenAndNothingOfThemIsLost(int width) {
    String all = String.join(" ", text.lines(status(), width)).replaceAll(" +", " ");
    assertThat(all)
        .contains(
            "WARNING since 00:00:30: rolling deceleration (acc_roll) is −0.400 m/s², 43 % more")
        .contains("(median of 31 kicks)")
        .contains(
            "Nothing was received for 12 s. fieldcal joined the group again 6 times (no route)");
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
        .startsWith(
            "Fewer than 31 kicks determine the sliding deceleration (0), switch to rolling (0)")
        .contains("vertical damping (3)")
        .contains("--state FILE")
        .doesNotContain("rolling deceleration");
  }
}
