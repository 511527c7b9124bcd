package fieldcal.diagnosis.hidden;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.learned.Harmonics;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import fieldcal.simulation.ScenarioKind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What nobody has a name for may be in a camera: its reports of a sound field are made wrong here. */
class UnnamedCameraErrorTest {
  private static final int CAMERA = 1;

  /** Sightings of one camera over which a speed is measured. */
  private static final int SPAN = 4;

  private static SeenKicks seen;

  /** One detection, s, m, m/s. */
  private record Sight(double time, double x, double y, double speed) {}

  @FunctionalInterface
  private interface CameraError {
    Sight of(Sight right);
  }

  private static Diagnosis diagnosed(CameraError error) {
    if (seen == null) {
      seen = SeenKicks.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 16));
    }
    List<Kick> wrong = seen.kicks().stream().map(k -> wrong(k, error)).toList();
    SeenKicks told =
        new SeenKicks(wrong, seen.geometry(), seen.cameras(), seen.firstFrame(), seen.truth());
    return new Diagnoser().diagnose(HiddenRun.problem(told, false), said -> {});
  }

  private static Kick wrong(Kick kick, CameraError error) {
    Observations right = kick.observations();
    List<Integer> own = new ArrayList<>();
    for (int i = 0; i < right.size(); i++) {
      if (right.camera(i) == CAMERA) {
        own.add(i);
      }
    }
    List<Sight> all = new ArrayList<>();
    List<Integer> from = new ArrayList<>();
    for (int i = 0; i < right.size(); i++) {
      Sight sight = new Sight(right.time(i), right.x(i), right.y(i), speed(right, own, i));
      all.add(right.camera(i) == CAMERA ? error.of(sight) : sight);
      from.add(i);
    }
    from.sort(Comparator.comparingDouble(i -> all.get(i).time));
    Observations.Builder builder = new Observations.Builder();
    for (int i : from) {
      Sight s = all.get(i);
      builder.add(s.time, right.camera(i), s.x, s.y, right.pixelX(i), right.pixelY(i));
    }
    return kick.withObservations(builder.build());
  }

  /** Speed between neighbouring sightings; 0 of a ball that rests but for noise. */
  private static double speed(Observations seen, List<Integer> own, int i) {
    int at = own.indexOf(i);
    if (at < 0) {
      return 0;
    }
    int a = own.get(Math.max(0, at - SPAN));
    int b = own.get(Math.min(own.size() - 1, at + SPAN));
    double way = Math.hypot(seen.x(b) - seen.x(a), seen.y(b) - seen.y(a));
    return b > a ? way / (seen.time(b) - seen.time(a)) : 0;
  }

  private static LearnedTerm onlyFound(Diagnosis diagnosis, String on) {
    assertThat(diagnosis.causes()).as("%s", diagnosis.causes()).isEmpty();
    LearnedFinding first = diagnosis.learned().get(0);
    assertThat(first.actsOn()).isEqualTo("measurement");
    assertThat(first.dependsOn()).containsExactly(on);
    assertThat(first.camera()).hasValue(CAMERA);
    return (LearnedTerm) first.effect();
  }

  @Test
  void aCameraThatSwingsIsFoundWithItsPeriod() {
    double period = 1.7;
    double swing = 6;
    Diagnosis diagnosis =
        diagnosed(
            s -> {
              double angle = 2 * Math.PI * s.time / period;
              return new Sight(s.time, s.x + 1e-3 * swing * Math.sin(angle), s.y, s.speed);
            });
    LearnedTerm found = onlyFound(diagnosis, "session_time");
    assertThat(((Harmonics) found.family().basis()).period()).isCloseTo(period, within(0.01));
    double[] c = found.coefficients();
    assertThat(Math.hypot(c[0], c[1])).isCloseTo(swing, within(0.5));
    assertThat(Math.hypot(c[2], c[3])).isLessThan(0.5);
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }

  @Test
  void aClockThatIsSetRightAgainAndAgainIsFoundWithItsPeriod() {
    double period = 4.3;
    double jump = 1e-2;
    Diagnosis diagnosis =
        diagnosed(
            s -> {
              double share = s.time / period - Math.floor(s.time / period);
              return new Sight(s.time + jump * (share - 0.5), s.x, s.y, s.speed);
            });
    LearnedTerm found = onlyFound(diagnosis, "session_time");
    assertThat(((Harmonics) found.family().basis()).period()).isCloseTo(period, within(0.03));
    assertThat(diagnosis.extended().holdoutRmsMm())
        .isLessThan(0.7 * diagnosis.base().holdoutRmsMm());
  }

  /** Its swings are over within a tenth of a second, and no term follows them; but the model is not called right. */
  @Test
  void aCameraThatVibratesIsNotCalledSound() {
    Diagnosis diagnosis =
        diagnosed(
            s -> {
              double shake = 4e-3 * Math.sin(2 * Math.PI * 9.3 * s.time);
              return new Sight(s.time, s.x + shake, s.y, s.speed);
            });
    assertThat(diagnosis.causes()).as("%s", diagnosis.causes()).isEmpty();
    assertThat(diagnosis.verdict()).isNotEqualTo(Verdict.MODEL_ADEQUATE);
    assertThat(diagnosis.unexplained().significant()).isTrue();
  }

  @Tag("study")
  @Test
  void stampsThatAreLateByTheSpeedAreFound() {
    double late = 0.4e-3;
    Diagnosis diagnosis =
        diagnosed(s -> new Sight(s.time + late * s.speed * s.speed, s.x, s.y, s.speed));
    LearnedTerm found = onlyFound(diagnosis, "speed");
    assertThat(found.valueAt(0, 5, 0) - found.valueAt(0, 2, 0))
        .isCloseTo(1e3 * late * (25 - 4), within(1.0));
    assertThat(diagnosis.unexplained().significant()).isFalse();
  }
}
