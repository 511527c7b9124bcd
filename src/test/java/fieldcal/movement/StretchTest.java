package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class StretchTest {
  @Test
  void detectionsOfSeveralCamerasAreSorted() {
    Stretch s = new Stretch();
    s.add(10, 1, 2, 0, 4);
    s.add(10.02, 1.2, 2, 0, 4);
    s.add(10.01, 1.1, 2, 0, 7);
    assertThat(s.t[1]).isEqualTo(0.01, within(1e-12));
    assertThat(s.x[1]).isEqualTo(0.1, within(1e-12));
    assertThat(s.camera[1]).isEqualTo(1);
    assertThat(s.camera[2]).isZero();
    assertThat(s.cameras()).isEqualTo(2);
    assertThat(s.span()).isEqualTo(0.02, within(1e-12));
  }

  @Test
  void whatIsForgottenTakesItsCamerasAlong() {
    Stretch s = new Stretch();
    for (int i = 0; i < 100; i++) {
      s.add(10 + 0.01 * i, i, 2 * i, 0, i < 60 ? 3 : 5);
    }
    s.forgetBefore(0.695);
    assertThat(s.size()).isEqualTo(30);
    assertThat(s.cameras()).isEqualTo(1);
    assertThat(s.camera[0]).isZero();
    assertThat(s.baseTime()).isEqualTo(10.7, within(1e-9));
    assertThat(s.t[0]).isZero();
    assertThat(s.t[29]).isEqualTo(0.29, within(1e-9));
    assertThat(s.x[29]).isEqualTo(29, within(1e-9));
  }

  @Test
  void aFullOneTakesNoMore() {
    Stretch s = new Stretch();
    for (int i = 0; i < Stretch.CAPACITY + 5; i++) {
      s.add(i, 0, 0, 0, 0);
    }
    assertThat(s.full()).isTrue();
    assertThat(s.size()).isEqualTo(Stretch.CAPACITY);
  }

  @Test
  void moreCamerasThanEverSeeOneRobotAreLeftOut() {
    Stretch s = new Stretch();
    for (int c = 0; c < Stretch.CAMERAS + 3; c++) {
      s.add(c, 0, 0, 0, c);
    }
    assertThat(s.size()).isEqualTo(Stretch.CAMERAS);
  }
}
