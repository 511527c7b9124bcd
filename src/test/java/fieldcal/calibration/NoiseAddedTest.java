package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.BallState;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitSettings;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A simulator without any noise, whose ball slides otherwise than the model says: cleaner data must not give fewer kicks. Of the 20 there were 0, 1, 5, 9, 14, 20
 * when outliers were those far from the path alone.
 *
 * <p>The limit that is nearest is that of the screening, three times the median residual: without noise the fastest kick, in which the law shows most, fits to 4.74 mm, the median kick to 1.64 mm, so that it is used up to 4.92 mm. The
 * margin of 4 % is that of seeds 17 to 20 at all these noises. Another start of the search, detections that are moved by 1e-9 m, and a JVM without fused multiplication, vector instructions and its
 * own sine all change that share of the limit by less than 1e-5, since all end in the same minimum of least squares: another machine is no risk.
 */
class NoiseAddedTest {
  private static CollectedKicks recorded;

  private static CollectedKicks read(String name) throws IOException {
    Path data = Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");
    return new KickCollector((log, read, total) -> {}).collect(List.of(data.resolve(name)));
  }

  @BeforeAll
  static void read() throws IOException {
    recorded = read("grsim-flat.log.gz");
  }

  private static Kick noisy(Kick kick, double noise, Random random) {
    Observations.Builder b = new Observations.Builder();
    Observations seen = kick.observations();
    for (int i = 0; i < seen.size(); i++) {
      b.add(
          seen.time(i),
          seen.camera(i),
          seen.x(i) + noise * random.nextGaussian(),
          seen.y(i) + noise * random.nextGaussian(),
          seen.pixelX(i),
          seen.pixelY(i));
    }
    return with(kick, b.build());
  }

  private static Kick with(Kick kick, Observations seen) {
    return new Kick(
        kick.id(),
        kick.time(),
        kick.x(),
        kick.y(),
        kick.vx(),
        kick.vy(),
        kick.robot(),
        kick.fromRest(),
        kick.end(),
        kick.endTime(),
        seen);
  }

  private static Calibration calibrate(List<Kick> kicks, Optional<KickKind> kind) {
    return calibrate(recorded, kicks, kind);
  }

  private static Calibration calibrate(
      CollectedKicks recorded, List<Kick> kicks, Optional<KickKind> kind) {
    return new Calibrator(FitSettings.defaults())
        .calibrate(
            new CalibrationProblem(
                kicks,
                recorded.epoch(),
                recorded.cameras(),
                recorded.published().flat().orElseThrow(),
                ChipModel.typical(),
                kind,
                HandSelection.none()),
            kick -> {});
  }

  /** The kick as the model says, on a path that is bent sideways by so much, m: what a good camera shows of a small effect. */
  private static Kick bent(Kick kick, FlatModel model, double bend) {
    FlatTrajectory path =
        FlatTrajectory.fromKick(model, kick.time(), kick.x(), kick.y(), kick.vx(), kick.vy());
    double speed = Math.hypot(kick.vx(), kick.vy());
    double lasts = path.restTime() - kick.time();
    Observations.Builder b = new Observations.Builder();
    Observations seen = kick.observations();
    for (int i = 0; i < seen.size(); i++) {
      BallState at = path.stateAt(seen.time(i));
      double share = Math.max(0, Math.min(1, (seen.time(i) - kick.time()) / lasts));
      double side = bend * Math.sin(2 * Math.PI * share);
      b.add(
          seen.time(i),
          seen.camera(i),
          at.x() - side * kick.vy() / speed,
          at.y() + side * kick.vx() / speed,
          seen.pixelX(i),
          seen.pixelY(i));
    }
    return with(kick, b.build());
  }

  /** grSim's fastest kicks fit to 2.7 mm beside others that fit to 0.3 mm. With the noise of a real camera nobody would have noticed. */
  @Test
  void aKickThatFitsToTwoMillimetresIsUsedBesideBetterOnes() {
    FlatModel flat = recorded.published().flat().orElseThrow();
    List<Kick> kicks = new ArrayList<>();
    recorded.kicks().forEach(k -> kicks.add(bent(k, flat, kicks.isEmpty() ? 0.005 : 0)));
    Calibration c = calibrate(kicks, Optional.of(KickKind.FLAT));
    assertThat(c.kicks()).hasSize(20);
    assertThat(c.kicks().get(0).fit().statistics().rmsMm()).isBetween(1.5, 3.0);
    assertThat(c.kicks().get(1).fit().statistics().rmsMm()).isLessThan(0.3);
    assertThat(c.kicks()).allMatch(CalibratedKick::selected);
  }

  /** Centimetres are no good fit with any camera. */
  @Test
  void aKickThatFitsToCentimetresIsNotUsed() {
    FlatModel flat = recorded.published().flat().orElseThrow();
    List<Kick> kicks = new ArrayList<>();
    recorded.kicks().forEach(k -> kicks.add(bent(k, flat, kicks.isEmpty() ? 0.03 : 0)));
    List<CalibratedKick> judged = calibrate(kicks, Optional.of(KickKind.FLAT)).kicks();
    assertThat(judged.get(0).selected()).as("%s", judged.get(0)).isFalse();
    assertThat(judged.subList(1, 20)).allMatch(CalibratedKick::selected);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.0001, 0.0003, 0.0007, 0.0015, 0.003})
  void allKicksAreUsed(double noise) {
    Random random = new Random(17);
    List<Kick> kicks = new ArrayList<>();
    recorded.kicks().forEach(k -> kicks.add(noisy(k, noise, random)));
    Calibration c = calibrate(kicks, Optional.empty());
    assertThat(c.kicks()).hasSize(20);
    assertThat(c.kicks()).allMatch(CalibratedKick::selected);
    // What grSim announces; its ball rolls with -0.7007 m/s².
    assertThat(c.flat().get("accRoll").mean()).isEqualTo(-0.7007, within(0.001));
    assertThat(c.flat().get("kSwitch").mean()).isEqualTo(0.70, within(0.015));
    double expected = Math.max(noise, CameraNoise.FLOOR);
    c.cameras()
        .all()
        .forEach(v -> assertThat(v.noise()).isEqualTo(expected, within(0.1 * expected)));
    if (noise < CameraNoise.FLOOR) {
      assertThat(c.kicks()).anyMatch(k -> k.fit().statistics().lackOfFit() > 0);
    }
  }

  /** Its dampingZ was 0.358 ± 0.023 by the joint fit beside a mean of 0.491. The friction that also brakes a flying ball is not in the model. */
  @Test
  void theJointFitOfChipsAgreesWithTheirMeanWhereTheModelIsWrong() throws IOException {
    CollectedKicks chips = read("grsim-ball-chip.log.gz");
    Calibration c = calibrate(chips, chips.kicks(), Optional.empty());
    assertThat(c.kicks()).hasSize(10).allMatch(CalibratedKick::selected);
    c.chip()
        .forEach(
            (name, mean) -> {
              Estimate joint = c.joint().orElseThrow().chip(name).orElseThrow();
              double errors = 3 * Math.hypot(mean.standardError(), joint.standardError());
              assertThat(joint.value()).as(name).isEqualTo(mean.mean(), within(errors));
              assertThat(joint.value() / mean.mean()).as(name).isEqualTo(1, within(0.02));
            });
    assertThat(c.chip().get("dampingZ").mean()).isEqualTo(0.491, within(0.005));
  }
}
