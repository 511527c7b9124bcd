package fieldcal.kick;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.camera.Camera;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickTruth;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * Kicks of simulated matches: passes, receptions, redirects, chips, dribbling, six robots a side. Deflections are none; passes of
 * less than 0.4 s may be missed, there is too little to see of them. Of 162 kicks 5 were missed and 5 invented when this was written; the
 * live monitor will have to halve the latter.
 */
class MatchKicksTest {
  private static final long[] SEEDS = {51, 52, 53};
  private static final double SAME = 0.06;
  private static final double SHORT = 0.4;

  private int kicks;
  private int missed;
  private int invented;
  private int ends;
  private int wrongEnds;

  @Test
  void kicksOfMatchesAreFoundAndFewAreInvented() {
    for (long seed : SEEDS) {
      play(seed);
    }
    String sum =
        "seeds 51 to 53: %d kicks, %d missed, %d invented, %d of %d ends wrong"
            .formatted(kicks, missed, invented, wrongEnds, ends);
    System.out.println(sum);
    assertThat(kicks).as(sum).isGreaterThan(60);
    assertThat(missed).as(sum).isLessThanOrEqualTo((int) (0.05 * kicks));
    assertThat(invented).as(sum).isLessThanOrEqualTo((int) (0.04 * kicks));
    assertThat(wrongEnds).as(sum).isLessThanOrEqualTo((int) (0.1 * ends));
  }

  private void play(long seed) {
    ScenarioSettings match = ScenarioSettings.of(ScenarioKind.MATCH, 0).withMatch(6, 3);
    SimulatedRecording recording =
        Simulation.record(SimulationSettings.DEFAULT.withScenario(match).withSeed(seed));
    List<Kick> found = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), found::add);
    Map<Integer, Camera> cameras =
        recording.geometry().cameras().stream()
            .map(Camera::of)
            .collect(Collectors.toMap(Camera::id, c -> c));
    finder.geometry(recording.geometry(), cameras);
    recording.frames().forEach(finder::accept);
    finder.finish();
    compare(recording.truth().kicks(), found);
  }

  private void compare(List<KickTruth> truth, List<Kick> found) {
    List<Kick> left = new ArrayList<>(found);
    for (KickTruth t : truth) {
      if (t.kind() == fieldcal.simulation.truth.KickKind.DEFLECTION) {
        continue;
      }
      Kick kick =
          left.stream().filter(k -> Math.abs(k.time() - t.time()) < SAME).findFirst().orElse(null);
      if (kick == null) {
        kicks += t.duration() > SHORT ? 1 : 0;
        missed += t.duration() > SHORT ? 1 : 0;
        continue;
      }
      left.remove(kick);
      kicks++;
      ends++;
      wrongEnds += expected(t.end()).contains(kick.end()) ? 0 : 1;
    }
    invented += left.size();
  }

  private static List<KickEnd> expected(EndReason end) {
    return switch (end) {
      case STOPPED -> List.of(KickEnd.STOPPED);
      case LEFT_FIELD, GOAL -> List.of(KickEnd.LEFT_FIELD);
      case TOUCHED_ROBOT, REDIRECTED -> List.of(KickEnd.TOUCHED_ROBOT);
      case PLACED -> List.of(KickEnd.values());
      case RECORDING_ENDED -> List.of(KickEnd.RECORDING_ENDED);
    };
  }
}
