package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.Statistic;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What the twin does not reproduce, in words. */
class TwinWordsTest {
  private static Comparison compared(String id, double first, double second) {
    Statistic statistic =
        new Statistic(id, "scatter of dampingZ", "", Statistic.How.SCATTER, Map.of());
    return new Comparison(statistic, first, second, second - first, 0.001, 20, 1e-6, 1e-5);
  }

  @Test
  void scatterOfBouncesIsNamedAsNotReproduced() {
    String why = "the twin's all obey one model";
    assertThat(TwinWords.sentence(compared("chip_scatter.dampingZ", 0.006, 0.001)))
        .startsWith("Scatter of dampingZ: 0.006000 in the recording, 0.001000 in the twin.")
        .contains(why);
    assertThat(TwinWords.sentence(compared("chip_scatter.dampingZ", 0.001, 0.006)))
        .doesNotContain(why);
    assertThat(TwinWords.sentence(compared("flat_scatter.accRoll", 0.006, 0.001)))
        .doesNotContain(why);
  }
}
