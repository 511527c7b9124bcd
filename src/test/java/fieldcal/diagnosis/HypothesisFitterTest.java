package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.HiddenRun;
import fieldcal.fit.KickFit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Where a fit ends must not depend on where it starts: a second cause would explain the difference. */
class HypothesisFitterTest {
  /** A field with fourteen chips and nothing hidden. */
  private static final long CHIPS = 41000019;

  /** Flat kicks with side spin: no straight path leads from where some of the balls lay. */
  private static final long CURVED = 41000392;

  private static HypothesisFitter fitter;
  private static FittedHypothesis simple;

  @BeforeAll
  static void fitChips() {
    fitter = fitter(HiddenRun.problem(HiddenCase.draw(CHIPS)));
    simple = fitter.fitSimple();
    assertThat(simple.chiSquare() / simple.residuals()).isCloseTo(1, within(0.1));
  }

  private static List<KickData> kicks(DiagnosisProblem problem) {
    NoiseCalibration noise = NoiseCalibration.of(problem.fits(), problem.cameras());
    return problem.fits().stream()
        .map(fit -> new KickData(fit, noise.cameras(), noise.stampNoise()))
        .toList();
  }

  private static HypothesisFitter fitter(DiagnosisProblem problem) {
    List<KickFit> fits = problem.fits();
    return new HypothesisFitter(
        kicks(problem),
        problem.observers(),
        problem.sessionStart(),
        Kinds.flat(fits),
        Kinds.chip(fits, Kinds.flat(fits)));
  }

  private static FittedHypothesis spoilt(List<double[]> own, int[] flights) {
    return new FittedHypothesis(
        Hypothesis.SIMPLE,
        simple.shared(),
        own,
        flights,
        new double[0],
        simple.chiSquare(),
        simple.cost(),
        simple.residuals(),
        simple.logEvidence(),
        simple.covariance(),
        false);
  }

  private static void assertSame(FittedHypothesis again) {
    assertThat(again.flights()).isEqualTo(simple.flights());
    assertThat(again.chiSquare()).isCloseTo(simple.chiSquare(), within(1.0));
    assertThat(again.shared()).containsExactly(simple.shared(), within(1e-4));
  }

  @Test
  void wrongNumbersOfHopsOfAllChipsDoNotHoldEachOtherUp() {
    int[] oneMore = Arrays.stream(simple.flights()).map(n -> n + 1).toArray();
    assertSame(
        fitter.fit(
            Hypothesis.SIMPLE, simple.shared().clone(), spoilt(simple.own(), oneMore), true));
  }

  @Test
  void aChipWhoseHeightWasConfusedStartsAnew() {
    List<double[]> own = new ArrayList<>(simple.own());
    double[] confused = own.get(3).clone();
    confused[4] *= 0.6;
    own.set(3, confused);
    int[] flights = simple.flights().clone();
    flights[3] += 2;
    assertSame(fitter.fit(Hypothesis.SIMPLE, simple.shared().clone(), spoilt(own, flights), true));
  }

  @Test
  void aRestThatNoStraightPathExplainsIsKept() {
    List<KickData> curved = kicks(HiddenRun.problem(HiddenCase.draw(CURVED)));
    for (KickData kick : curved) {
      double[] rest = Outliers.rest(kick.kick);
      int resting = 0;
      int used = 0;
      for (int i = 0; i < kick.size && kick.time[i] < kick.kick.time() - 0.1; i++) {
        resting++;
        used += kick.used[i] ? 1 : 0;
      }
      assertThat(used).as("kick %d", kick.kick.id()).isGreaterThan(resting / 2);
      assertThat(Math.hypot(kick.start[0] - rest[0], kick.start[1] - rest[1]))
          .as("start of kick %d", kick.kick.id())
          .isLessThan(0.1);
    }
  }
}
