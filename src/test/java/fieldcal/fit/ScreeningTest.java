package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.fit.Screening.Verdict;
import fieldcal.kick.Observations;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** An outlier stands alone; a run that is off alike is a model that does not fit. */
class ScreeningTest {
  private static final int SIZE = 200;
  private static final double NOISE = 0.001;
  private static final double DISTANCE = FitSettings.defaults().outlierDistance();

  private final FlightData data = twoCameras();
  private final double[] rx = new double[SIZE];
  private final double[] ry = new double[SIZE];

  /** Two cameras in turns, each at 70 Hz. */
  private static FlightData twoCameras() {
    Observations.Builder b = new Observations.Builder();
    for (int i = 0; i < SIZE; i++) {
      b.add(i / 140.0, i % 2, 0.01 * i, 0, 0, 0);
    }
    CameraViews views =
        FitSupport.positionsOnly(NOISE, new double[] {-1, 0, 5}, new double[] {1, 0, 5});
    return FlightData.of(b.build(), views);
  }

  @BeforeEach
  void drawNoise() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < SIZE; i++) {
      rx[i] = NOISE * IdealKicks.gaussian(random);
      ry[i] = NOISE * IdealKicks.gaussian(random);
    }
  }

  private Screening screen() {
    return Screening.of(data, rx, ry, DISTANCE);
  }

  private int count(Verdict verdict) {
    Screening screening = screen();
    int count = 0;
    for (int i = 0; i < SIZE; i++) {
      count += screening.verdict(i) == verdict ? 1 : 0;
    }
    return count;
  }

  @Test
  void noiseFits() {
    assertThat(count(Verdict.FITS)).isEqualTo(SIZE);
    assertThat(screen().outliers() + screen().lackOfFit()).isZero();
  }

  @Test
  void whatStandsAloneIsAnOutlierAlsoTwoInARow() {
    rx[50] += 0.02;
    ry[80] -= 0.1;
    rx[120] += 0.03;
    rx[122] += 0.03; // the same camera's next
    Screening screening = screen();
    assertThat(screening.outliers()).isEqualTo(4);
    assertThat(screening.lackOfFit()).isZero();
    assertThat(List.of(50, 80, 120, 122)).allMatch(i -> !screening.kept(i));
    assertThat(screening.kept()).hasSize(SIZE);
  }

  @Test
  void aRunThatIsOffAlikeIsLackOfFitAndKept() {
    // A slide that the model gets wrong: it grows to 20 mm and jumps back.
    for (int i = 40; i < 70; i++) {
      rx[i] += 0.02 * (i - 40) * (i - 40) / 900.0;
    }
    Screening screening = screen();
    assertThat(screening.outliers()).isZero();
    assertThat(screening.lackOfFit()).isBetween(8, 30);
    assertThat(screening.verdict(68)).isEqualTo(Verdict.LACK_OF_FIT);
  }

  @Test
  void anOutlierWithinSuchARunIsStillOne() {
    for (int i = 40; i < 70; i++) {
      rx[i] += 0.02;
    }
    ry[55] += 0.15;
    Screening screening = screen();
    assertThat(screening.verdict(55)).isEqualTo(Verdict.OUTLIER);
    assertThat(screening.outliers()).isEqualTo(1);
    assertThat(screening.lackOfFit()).isEqualTo(29);
  }

  @Test
  void oneCameraOfTwoMayBeOff() {
    for (int i = 1; i < SIZE; i += 2) {
      ry[i] += 0.04;
    }
    Screening screening = screen();
    assertThat(screening.outliers()).isZero();
  }

  @Test
  void aRunTooFarToBeTheBallIsNone() {
    for (int i = 40; i < 60; i++) {
      rx[i] += 0.4;
    }
    assertThat(screen().outliers()).isEqualTo(20);
  }

  @Test
  void whereNobodyElseSawTheBallTheFitDecides() {
    double[] far = Arrays.copyOf(rx, 4);
    far[1] = 0.05;
    FlightData few = data.pick(new int[] {0, 1, 2, 3});
    assertThat(Screening.of(few, far, new double[4], DISTANCE).kept(1)).isFalse();
  }
}
