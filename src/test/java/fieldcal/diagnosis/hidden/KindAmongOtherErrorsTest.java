package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.RecordedProblem;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Whether a kick was chipped is told right where other causes leave much more than the noise. Worlds of a study whose cases came out wrong before. */
class KindAmongOtherErrorsTest {
  private static List<KickKind> kinds(long seed, String... effects) {
    SimulationSettings world = HiddenCase.draw(seed).settings().withEffects(effects);
    return HiddenRun.problem(world).fits().stream().map(KickFit::kind).toList();
  }

  /** Nine flat kicks, then nine chips, one of which rolls for six of its seven seconds; a rolling shutter of 8 ms and a seam leave 3 to 9 mm. */
  @Test
  void aChipThatRollsForLongIsAChip() {
    List<KickKind> kinds =
        kinds(
            909_000_021,
            "drift:percent_per_10min=-11.81",
            "rolling_shutter:ms=8.29",
            "carpet_seam:loss=0.01765,turn=0.003838,normal=2.562,distance=0.3637");
    assertThat(kinds.subList(0, 9)).containsOnly(KickKind.FLAT);
    assertThat(kinds.subList(9, 18)).containsOnly(KickKind.CHIP);
  }

  /** It flies for a second, and then curves down a slope for four. A fit that follows the roll misses the hops. */
  @Test
  void aChipThatRollsDownASlopeIsAChip() throws IOException {
    assertThat(RecordedProblem.of("mujoco-rolling-chip").fits())
        .extracting(KickFit::kind)
        .containsExactly(KickKind.CHIP);
  }

  /** A friction that falls with the slip makes fast kicks look as if they flew. */
  @Test
  void flatKicksOfAnOddFrictionAreFlat() {
    assertThat(
            kinds(
                909_000_035,
                "carpet_nap:amplitude=0.07279,direction=-2.118",
                "ball_height_error:mm=-23.48",
                "slip_dependent_friction:slope=-0.35"))
        .containsOnly(KickKind.FLAT);
  }

  /** Spin about the direction of travel bends the way at each impact; neither model follows, and four of these were taken for flat kicks. */
  @Test
  void chipsThatBendSidewaysAreChips() {
    assertThat(chipsWithSideSpin(0.07, 0.02)).hasSize(12).containsOnly(KickKind.CHIP);
  }

  /** Much spin turns them where they first land, within the first second; only the first flight itself shows what they are. */
  @Test
  void chipsThatTurnAtTheirFirstBounceAreChips() {
    assertThat(chipsWithSideSpin(0.35, 0.1)).hasSize(12).containsOnly(KickKind.CHIP);
  }

  private static List<KickKind> chipsWithSideSpin(double mean, double scatter) {
    SimulationSettings world = SimulationSettings.DEFAULT.withSeed(1);
    return HiddenRun.problem(
            world
                .withScenario(ScenarioSettings.of(ScenarioKind.CHIP, 12))
                .withKickBehaviour(world.kickBehaviour().withSideSpin(mean, scatter)))
        .fits()
        .stream()
        .map(KickFit::kind)
        .toList();
  }
}
