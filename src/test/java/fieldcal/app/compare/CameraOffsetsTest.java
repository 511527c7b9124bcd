package fieldcal.app.compare;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.compare.CameraOffsets.Offset;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.ball.BallState;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Observations;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Offsets of cameras that count what the model explains, and errors that count what it does not. */
class CameraOffsetsTest {
  private static final Set<Integer> BOTH = Set.of(0, 1);
  private static final int KICKS = 24;

  /** What is added to an observation, m, x and y. */
  private interface Added {
    double[] to(KickResiduals kick, int observation);
  }

  private static Map<Integer, Offset> offsets(Diagnosis d) {
    return CameraOffsets.of(d, BOTH);
  }

  private static Diagnosis with(Diagnosis d, Added added) {
    return SampleDiagnosis.of(d, d.kicks().stream().map(k -> with(k, added)).toList());
  }

  private static KickResiduals with(KickResiduals k, Added added) {
    Observations seen = k.kick().observations();
    Observations.Builder moved = new Observations.Builder();
    for (int i = 0; i < seen.size(); i++) {
      double[] more = added.to(k, i);
      moved.add(
          seen.time(i),
          seen.camera(i),
          seen.x(i) + more[0],
          seen.y(i) + more[1],
          seen.pixelX(i),
          seen.pixelY(i));
    }
    return new KickResiduals(
        k.kick().withObservations(moved.build()),
        k.kind(),
        k.before(),
        k.after(),
        k.xBefore(),
        k.yBefore(),
        k.xAfter(),
        k.yAfter(),
        k.used(),
        k.rmsBeforeMm(),
        k.rmsAfterMm());
  }

  private static double[] ofCamera(KickResiduals kick, int i, double x, double y) {
    boolean other = kick.kick().observations().camera(i) == 1;
    return other ? new double[] {x, y} : new double[2];
  }

  @Test
  void anOffsetCountsFromTheMean() {
    Map<Integer, Offset> found = offsets(SampleDiagnosis.explained(KICKS));
    // Truth: camera 1 by 21.2 mm, the other by as much to the other side.
    assertThat(found.get(1).x()).isCloseTo(0.0212, within(0.0003));
    assertThat(found.get(0).x()).isCloseTo(-0.0212, within(0.0003));
    assertThat(found.get(1).y()).isCloseTo(-0.0004, within(0.0003));
  }

  @Test
  void anOffsetIsFoundWhetherTheDiagnosisNamedItOrNot() {
    Diagnosis plain = SampleDiagnosis.adequate(KICKS);
    Map<Integer, Offset> none = offsets(plain);
    Map<Integer, Offset> found = offsets(with(plain, (k, i) -> ofCamera(k, i, 0.002, -0.001)));
    // Half of it on each side of the mean.
    assertThat(found.get(1).x() - none.get(1).x()).isCloseTo(0.001, within(1e-9));
    assertThat(found.get(0).x() - none.get(0).x()).isCloseTo(-0.001, within(1e-9));
    assertThat(found.get(1).y() - none.get(1).y()).isCloseTo(-0.0005, within(1e-9));
  }

  @Test
  void anotherPlaceDirectionAndSpeedOfKicksAreNoOffsets() {
    Diagnosis plain = SampleDiagnosis.adequate(KICKS);
    Map<Integer, Offset> before = offsets(plain);
    Map<Integer, Offset> after = offsets(with(plain, CameraOffsetsTest::movedKick));
    assertThat(after.get(1).x()).isCloseTo(before.get(1).x(), within(1e-9));
    assertThat(after.get(1).y()).isCloseTo(before.get(1).y(), within(1e-9));
    assertThat(after.get(1).errorX()).isCloseTo(before.get(1).errorX(), within(1e-9));
  }

  private static double[] movedKick(KickResiduals kick, int i) {
    double size = 0.01 * Math.sin(kick.kick().id());
    BallState start = kick.after().stateAt(kick.after().kickTime());
    BallState s = kick.after().stateAt(kick.kick().observations().time(i));
    double dx = s.x() - start.x();
    double dy = s.y() - start.y();
    return new double[] {size * (1 + dx - dy), size * (-1 + dy + dx)};
  }

  @Test
  void errorsCoverWhatMakesWholeKicksWrong() {
    Diagnosis plain = SampleDiagnosis.adequate(KICKS);
    double squares = 0;
    int seeds = 60;
    for (int seed = 1; seed <= seeds; seed++) {
      Random random = new Random(seed);
      double[] wrong = random.doubles(2 * KICKS + 2).map(u -> 0.004 * (u - 0.5)).toArray();
      Map<Integer, Offset> found =
          offsets(
              with(
                  plain,
                  (k, i) ->
                      ofCamera(k, i, wrong[2 * k.kick().id()], wrong[2 * k.kick().id() + 1])));
      double sigmas = found.get(1).x() / found.get(1).errorX();
      squares += sigmas * sigmas;
    }
    // Independent draws, of which the mean square scatters by √(2/60); four of that.
    assertThat(squares / seeds).isBetween(0.4, 1.8);
  }

  @Test
  void camerasThatNoKickConnectAreNotCompared() {
    assertThat(CameraOffsets.of(SampleDiagnosis.adequate(KICKS), Set.of(0, 1, 2))).isEmpty();
    assertThat(offsets(SampleDiagnosis.adequate(2))).isEmpty();
  }
}
