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
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A part of the carpet that brakes more, under flat kicks and chips: its edges and the chips' numbers of hops must not hold each other up where they do not belong. */
class WornRegionAmongChipsTest {
  /** How alike the found and the true region are along the paths of the balls: an edge 0.1 m off, of one that is 3 m wide, leaves less. */
  private static final double SAME = 0.98;

  private static final SimulationSettings WORLD =
      SimulationSettings.DEFAULT
          .withScenario(ScenarioKind.MIXED, 24)
          .withEffects("worn_region:change=0.2,region=[-3,0,-2,1]");

  private static Diagnosis diagnose(SeenKicks seen, List<String> said) {
    return new Diagnoser().diagnose(HiddenRun.problem(seen, false), said::add);
  }

  private static void assertRegion(Cause cause, SimulationSettings world, SeenKicks seen) {
    assertThat(cause.effect().id()).isEqualTo("worn_region");
    assertThat(cause.effect().value("change")).isCloseTo(0.2, within(0.01));
    assertThat(RegionOverlap.correlation(world.effects().get(0), cause.effect(), seen.truth()))
        .as("%s", cause.effect())
        .isGreaterThan(SAME);
  }

  private static Cause named(Diagnosis diagnosis, String id) {
    return diagnosis.causes().stream()
        .filter(c -> c.effect().id().equals(id))
        .findFirst()
        .orElseThrow(() -> new AssertionError(diagnosis.causes()));
  }

  /** Steps of single edges stop where the region is 0.7 m too short. */
  @Test
  void itsEdgesAreFoundAlthoughChipsSeemToSayOtherwise() {
    SimulationSettings world = WORLD.withSeed(9);
    SeenKicks seen = SeenKicks.of(world);
    Diagnosis diagnosis = diagnose(seen, new ArrayList<>());
    assertThat(diagnosis.causes()).hasSize(1);
    assertRegion(diagnosis.causes().get(0), world, seen);
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }

  /** Three flat kicks of this world pass for chips as long as the region is not known, and one of them would again each time that the simple model is asked. */
  @Tag("study")
  @Test
  void kindsOfKicksThatTheRegionMadeClearAreNotAskedAgain() {
    SimulationSettings world =
        WORLD
            .withEffects("worn_region:change=0.2,region=[-3,0,-2,1]", "kick_spin:fraction=-0.3")
            .withSeed(5);
    SeenKicks seen = SeenKicks.of(world);
    List<String> said = new ArrayList<>();
    Diagnosis diagnosis = diagnose(seen, said);
    assertRegion(named(diagnosis, "worn_region"), world, seen);
    assertThat(said).filteredOn("looking again at kicks that stand out"::equals).hasSizeLessThan(2);
  }
}
