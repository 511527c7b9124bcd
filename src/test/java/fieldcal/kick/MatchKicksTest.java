package fieldcal.kick;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** Kicks of drawn matches against the truth; {@code ./gradlew benchmark -PbenchmarkArgs=match-kicks} does the same with many more. */
class MatchKicksTest {
  private static final long[] SEEDS = LongStream.rangeClosed(51, 56).toArray();
  private static final double MINUTES = 1.5;

  @Test
  void kicksOfMatchesAreFoundAndFewAreInvented() {
    KickJudge judge = new KickJudge();
    for (long seed : SEEDS) {
      DrawnMatch match = DrawnMatch.of(seed, MINUTES);
      System.out.println(match);
      judge.judge(match);
    }
    judge.cases().forEach(System.out::println);
    System.out.println(judge.summary());
    String all = judge.summary() + "\n" + String.join("\n", judge.cases());
    assertThat(judge.counted()).as(all).isGreaterThan(100);
    assertThat(judge.found()).as(all).isGreaterThanOrEqualTo((int) (0.95 * judge.counted()));
    assertThat(judge.invented()).as(all).isLessThanOrEqualTo((int) (0.02 * judge.counted()));
    assertThat(judge.rightEnds()).as(all).isGreaterThanOrEqualTo((int) (0.9 * judge.judgedEnds()));
    assertThat(judge.rightlyFlagged()).as(all).isGreaterThanOrEqualTo((int) (0.9 * judge.found()));
  }
}
