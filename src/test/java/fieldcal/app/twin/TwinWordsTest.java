package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.Statistic;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.diagnosis.Unexplained;
import java.util.List;
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
    String why = "those of the twin all obey one model";
    assertThat(TwinWords.sentence(compared("chip_scatter.dampingZ", 0.006, 0.001)))
        .startsWith("Scatter of dampingZ: 0.006000 in the recording, 0.001000 in the twin.")
        .contains(why);
    assertThat(TwinWords.sentence(compared("chip_scatter.dampingZ", 0.001, 0.006)))
        .doesNotContain(why);
    assertThat(TwinWords.sentence(compared("flat_scatter.accRoll", 0.006, 0.001)))
        .doesNotContain(why);
  }

  /** Medians of pairs may look alike where every kick differs. */
  @Test
  void ofTheSameKicksTheDifferenceIsTold() {
    Statistic rolling =
        new Statistic(
            "flat.accRoll",
            "rolling deceleration of flat kicks",
            "m/s²",
            Statistic.How.PAIRED,
            Map.of());
    Comparison c = new Comparison(rolling, -0.30014, -0.30013, -9e-5, 4e-5, 23, 9.7e-4, 0.04);
    assertThat(TwinWords.sentence(c))
        .isEqualTo(
            "Rolling deceleration of flat kicks: -0.3001 m/s² in the recording, -0.3001 m/s² in the"
                + " twin; the same kicks differ by -0.000090 m/s².");
  }

  @Test
  void whatHasNoCauseIsLeftOutAndTold() {
    List<StructureVariable> speed = List.of(StructureVariable.SPEED);
    assertThat(TwinWords.unexplained(new Unexplained(true, 1.63, 40, speed)))
        .contains(
            "The twin lacks what the diagnosis could not explain: balls are off by 1.6 mm beyond"
                + " the noise, depending on the speed of the ball.");
    assertThat(TwinWords.unexplained(new Unexplained(false, 0.1, 1, List.of()))).isEmpty();
  }
}
