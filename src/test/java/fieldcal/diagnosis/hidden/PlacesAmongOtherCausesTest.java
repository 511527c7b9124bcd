package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import org.junit.jupiter.api.Test;

/** Seams and regions beside other causes that are as strong. Cases of a study that came out wrong before. */
class PlacesAmongOtherCausesTest {
  private static Diagnosis diagnosis(long seed) {
    return new Diagnoser().diagnose(HiddenRun.problem(HiddenCase.draw(seed)), said -> {});
  }

  /** A region and a seam elsewhere took up what a rolling that depends on the speed does, since they were chosen first. */
  @Test
  void aSeamIsFoundBesideARollingThatDependsOnTheSpeed() {
    Diagnosis diagnosis = diagnosis(2_316_000_005L);
    assertThat(diagnosis.causes())
        .extracting(c -> c.effect().id())
        .containsExactlyInAnyOrder("carpet_seam", "speed_dependent_roll", "side_spin");
    assertThat(diagnosis.extended().holdoutRmsMm())
        .isLessThan(1.1 * diagnosis.extended().noiseMm());
  }

  /** An edge of the region at the wrong place needed a seam beside it, and what was left when that had no proof took the spin of the kicker along. */
  @Test
  void noSeamStandsInForTheEdgeOfARegion() {
    Diagnosis diagnosis = diagnosis(2_316_000_017L);
    assertThat(diagnosis.causes())
        .extracting(c -> c.effect().id())
        .contains("worn_region", "camera_pose_error", "kick_spin")
        .doesNotContain("carpet_seam");
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }
}
