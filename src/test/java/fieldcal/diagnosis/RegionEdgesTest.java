package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.simulation.ScenarioKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A region that is named must be where the carpet is worn. */
class RegionEdgesTest {
  /** Flat kicks and chips, and a carpet that brakes 30 % more in x = -4.66 to -0.48 m up to y = 0.59 m; its fourth edge no ball crosses, and few the first. */
  private static final long WORN = 111000301;

  private static final String WEAR = "worn_region:change=0.3034,region=[-4.66,-0.48,-4.45,0.59]";

  private static final HypothesisFitter WORLD =
      ChipsField.fitter(HiddenRun.problem(HiddenCase.of(WORN, ScenarioKind.MIXED, WEAR)));

  private static FittedHypothesis fitted(double... edges) {
    FittedHypothesis simple = WORLD.fitSimple();
    Hypothesis h = Hypothesis.SIMPLE.with(RegionSearch.chart(edges).orElseThrow(), false);
    return WORLD.fit(h, CauseSearch.start(h, simple), simple, true);
  }

  private static double[] edges(FittedHypothesis f) {
    return RegionSearch.edges(RegionEdges.region(f.hypothesis()));
  }

  @ParameterizedTest
  @CsvSource({
    "-4.2, -0.5, 0.6",
    "-5.1, -0.5, 0.6",
    "-4.7, -1.0, 0.6",
    "-4.7, 0.0, 0.6",
    "-4.7, -0.5, 0.2",
    "-4.7, -0.5, 1.1",
    "-5.1, 0.0, 1.1"
  })
  void edgesThatAreHalfAMetreOffComeBack(double x0, double x1, double y1) {
    FittedHypothesis off = fitted(x0, x1, -4.4, y1);
    FittedHypothesis polished = new RegionEdges(WORLD).polish(off);
    double[] edges = edges(polished);
    assertThat(edges[0]).isBetween(-4.75, -4.3);
    assertThat(edges[1]).isCloseTo(-0.48, within(0.1));
    assertThat(edges[3]).isCloseTo(0.59, within(0.1));
    assertThat(polished.cost()).isLessThan(off.cost());
    assertThat(polished.shared()[SharedUnknowns.MODEL]).isCloseTo(0.3034, within(0.01));
  }

  @Test
  void withoutARegionNothingIsMovedAndNothingIsOpen() {
    ChipsField field = ChipsField.fitted();
    RegionEdges edges = new RegionEdges(field.fitter);
    assertThat(edges.polish(field.simple)).isSameAs(field.simple);
    assertThat(edges.error(field.simple)).isZero();
  }
}
