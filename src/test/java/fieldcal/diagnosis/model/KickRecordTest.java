package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Blocks of detections. */
class KickRecordTest {
  private final FittedField field = FittedField.flats();

  /** Residuals of blocks when each detection lies off by white noise of the size that its camera has. */
  @Test
  void blocksOfWhiteNoiseHaveVarianceOne() {
    Random random = new Random(11);
    double sum = 0;
    double cross = 0;
    int n = 0;
    for (KickRecord kick : field.fitter().kicks()) {
      for (int[] block : kick.blocks) {
        double[] white = new double[2];
        for (int i : block) {
          // The inverse of the whitening turns unit noise into the camera's.
          double u = random.nextGaussian();
          double v = random.nextGaussian();
          double rx = u / kick.w11[i];
          double ry = (v - kick.w21[i] * rx) / kick.w22[i];
          double[] one = new double[2];
          kick.whiten(i, rx, ry, one);
          assertThat(one[0]).isCloseTo(u, within(1e-9));
          assertThat(one[1]).isCloseTo(v, within(1e-9));
          white[0] += one[0] / Math.sqrt(block.length);
          white[1] += one[1] / Math.sqrt(block.length);
        }
        sum += white[0] * white[0] + white[1] * white[1];
        cross += white[0] * white[1];
        n += 2;
      }
    }
    // Three standard deviations of the mean of n squares.
    assertThat(sum / n).isCloseTo(1, within(3 * Math.sqrt(2.0 / n)));
    assertThat(2 * cross / n).isCloseTo(0, within(3 * Math.sqrt(2.0 / n)));
  }

  /** The same for the noise of the simulated cameras, as the kernel sees it; each kick has five numbers of its own. */
  @Test
  void blocksOfASoundFieldHaveVarianceOne() {
    double chi = field.simple().solution().chiSquare();
    double freedom = field.simple().solution().rows() - 5.0 * field.simple().kickCount() - 3;
    assertThat(chi / freedom).isCloseTo(1, within(0.1));
  }

  @Test
  void blocksAreOfOneCameraShortAndComplete() {
    for (KickRecord kick : field.fitter().kicks()) {
      int count = 0;
      for (int[] block : kick.blocks) {
        count += block.length;
        for (int i : block) {
          assertThat(kick.used[i]).isTrue();
          assertThat(kick.camera(i)).isEqualTo(kick.camera(block[0]));
          assertThat(kick.time(i) - kick.time(block[0])).isBetween(0.0, 0.05);
          assertThat(kick.time(i) < kick.kick().time())
              .as("rest and flight are apart")
              .isEqualTo(kick.time(block[0]) < kick.kick().time());
        }
      }
      assertThat(count).isEqualTo(kick.usedCount());
    }
  }

  @Test
  void detectionsThatDoNotCountAreInNoBlock() {
    KickRecord kick = field.fitter().kicks().get(0);
    boolean[] used = kick.used();
    for (int i = 0; i < used.length; i += 2) {
      used[i] = false;
    }
    KickRecord half = kick.withUsed(used);
    for (int[] block : half.blocks) {
      for (int i : block) {
        assertThat(i % 2).isEqualTo(1);
      }
    }
    assertThat(half.whole()).isSameAs(kick.whole());
    assertThat(half.usedCount()).isLessThan(kick.usedCount());
  }

  @Test
  void variancesAreThoseOfTheCameras() {
    KickRecord kick = field.fitter().kicks().get(0);
    for (int i = 0; i < kick.size(); i++) {
      double noise = field.noise().cameras().get(kick.camera(i)).noise();
      assertThat(Math.sqrt(kick.variance(i))).isBetween(0.5 * noise, 4 * noise);
    }
  }

  @Test
  void aKickWithMoreNoiseHasLessWeightAndForgetsNothing() {
    KickRecord kick = field.fitter().kicks().get(0);
    KickRecord louder = kick.withNoise(4);
    double[] plain = new double[2];
    double[] loud = new double[2];
    kick.whiten(3, 0.002, -0.001, plain);
    louder.whiten(3, 0.002, -0.001, loud);
    assertThat(loud[0]).isCloseTo(plain[0] / 4, within(1e-12));
    assertThat(loud[1]).isCloseTo(plain[1] / 4, within(1e-12));
    assertThat(louder.block11[0]).isCloseTo(kick.block11[0] / 4, within(1e-12));
    assertThat(kick.asSeen()).isSameAs(kick);
    assertThat(louder.asSeen().variance(3)).isEqualTo(kick.variance(3));
    assertThat(louder.variance(3)).isCloseTo(16 * kick.variance(3), within(1e-12));
    assertThat(louder.timesNoise()).isCloseTo(4, within(1e-12));
    assertThat(louder.whole()).isSameAs(louder);
    boolean[] some = kick.used();
    some[0] = false;
    KickRecord cut = louder.withNoise(2).withUsed(some);
    assertThat(cut.variance(3)).isCloseTo(64 * kick.variance(3), within(1e-12));
    assertThat(cut.asSeen().variance(3)).isEqualTo(kick.variance(3));
    assertThat(cut.whole().variance(3)).isEqualTo(cut.variance(3));
    assertThat(cut.whole().usedCount()).isEqualTo(kick.usedCount());
    assertThat(cut.asSeen().usedCount()).isEqualTo(cut.usedCount());
  }
}
