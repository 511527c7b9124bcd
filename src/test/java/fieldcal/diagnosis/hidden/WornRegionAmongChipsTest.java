package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Test;

/** A part of the carpet that brakes more, under flat kicks and chips: its edges and the chips' numbers of hops must not hold each other up where they do not belong. */
class WornRegionAmongChipsTest {
  private static final double[] REGION = {-3, 0, -2, 1};
  private static final String[] EDGES = {"region_x0", "region_x1", "region_y0", "region_y1"};

  private static final SimulationSettings WORLD =
      SimulationSettings.DEFAULT
          .withScenario(ScenarioKind.MIXED, 24)
          .withEffects("worn_region:change=0.2,region=[-3,0,-2,1]");

  private static Diagnosis diagnose(SimulationSettings world, List<String> said) {
    return new Diagnoser().diagnose(HiddenRun.problem(SeenKicks.of(world), false), said::add);
  }

  private static void assertRegion(Cause cause) {
    assertThat(cause.effect().id()).isEqualTo("worn_region");
    assertThat(cause.effect().value("change")).isCloseTo(0.2, within(0.01));
    for (int edge = 0; edge < REGION.length; edge++) {
      assertThat(cause.effect().value(EDGES[edge]))
          .as(EDGES[edge])
          .isCloseTo(REGION[edge], within(0.05));
    }
  }

  /** The first explanation of this world has its region 0.7 m too short. */
  @Disabled(
      "known defect: the joint search stops in a local minimum of the edges, 145 in chi-square"
          + " above the true region; the change itself is right")
  @Test
  void itsEdgesAreFoundAlthoughChipsSeemToSayOtherwise() {
    Diagnosis diagnosis = diagnose(WORLD.withSeed(9), new ArrayList<>());
    assertThat(diagnosis.causes()).hasSize(1);
    assertRegion(diagnosis.causes().get(0));
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }

  /** Three flat kicks of this world pass for chips as long as the region is not known, and one of them would again each time that the simple model is asked. */
  @Disabled(
      "known defect: the joint search stops in a local minimum of the edges, 145 in chi-square"
          + " above the true region; the change itself is right")
  @Test
  void kindsOfKicksThatTheRegionMadeClearAreNotAskedAgain() {
    List<String> said = new ArrayList<>();
    Diagnosis diagnosis =
        diagnose(
            WORLD
                .withEffects("worn_region:change=0.2,region=[-3,0,-2,1]", "kick_spin:fraction=-0.3")
                .withSeed(5),
            said);
    assertRegion(diagnosis.causes().get(0));
    assertThat(said).containsOnlyOnce("looking again at kicks that stand out");
  }
}
