package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class VisionWatchTest {
  private final VisionWatch watch = new VisionWatch();

  @Test
  void aSteadyVisionIsNothingToTell() {
    for (int i = 0; i < 500; i++) {
      watch.frame(1000 + 0.015 * i, 5 + 0.015 * i + 0.01 * (i % 3));
    }
    assertThat(watch.complaints()).isEmpty();
    assertThat(watch.notes()).isEmpty();
  }

  @Test
  void silencesAndJumpsAreToldAsTheyHappen() {
    watch.frame(1000, 5);
    watch.frame(1001.2, 6.2);
    assertThat(watch.complaints())
        .containsExactly("vision was silent for 1.2 s, 1 s after its first frame");
    watch.frame(1000.7, 6.215);
    assertThat(watch.complaints()).hasSize(2);
    assertThat(watch.complaints().get(1)).startsWith("vision's clock jumped by -0.5");
    assertThat(watch.notes()).containsExactly("vision: 2 silences and jumps of its clock");
  }

  @Test
  void aVisionThatStallsAllTheTimeDoesNotFloodTheOperator() {
    for (int i = 0; i < 100; i++) {
      watch.frame(i, i);
    }
    assertThat(watch.complaints()).hasSize(11);
    assertThat(watch.notes()).containsExactly("vision: 99 silences and jumps of its clock");
  }
}
