package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.fit.CameraView;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.simulation.ScenarioKind;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;

/** Noise of a ball that moves, also where errors of successive detections are alike. */
class MovingNoiseTest {
  /** Standard deviation of what is added to each coordinate, m; well above the simulated cameras' own noise. */
  private static final double ADDED = 0.004;

  /** A part of each error is that of the detection before. */
  private static final double SHARED = 0.6;

  /** Scale of heavy-tailed noise, in units of what is added else: the cameras' own noise has no such tails. */
  private static final double TAILS = 5;

  /** A part of each error that the next one keeps. */
  private static final double KEPT = 0.4;

  private final FittedField plain =
      FittedField.of(FittedField.SOUND.withScenario(ScenarioKind.FLAT, 60));

  /** What the errors of a camera's detections have in common. */
  private enum Memory {
    /** Each has a part of what was new in the one before. */
    OF_WHAT_WAS_NEW {
      @Override
      double deviation(double shared) {
        return Math.sqrt(1 + shared * shared);
      }

      @Override
      double kept(double fresh, double error) {
        return fresh;
      }
    },
    /** Each has a part of the one before. */
    OF_ALL {
      @Override
      double deviation(double shared) {
        return 1 / Math.sqrt(1 - shared * shared);
      }

      @Override
      double kept(double fresh, double error) {
        return error;
      }
    };

    abstract double deviation(double shared);

    abstract double kept(double fresh, double error);
  }

  /** The kicks with noise that a camera's successive detections share a part of. */
  private FittedField noisy(Memory memory, double shared) {
    SplittableRandom random = new SplittableRandom(20261125);
    return noisy(memory, shared, random::nextGaussian);
  }

  private FittedField noisy(Memory memory, double shared, DoubleSupplier random) {
    List<KickFit> fits =
        plain.problem().fits().stream()
            .map(f -> plain.fit(noisy(f.kick(), memory, shared, random), KickKind.FLAT))
            .toList();
    return FittedField.of(plain.problem(fits));
  }

  private static Kick noisy(Kick kick, Memory memory, double shared, DoubleSupplier random) {
    Observations seen = kick.observations();
    Observations.Builder moved = new Observations.Builder();
    Map<Integer, double[]> before = new HashMap<>();
    double scale = ADDED / memory.deviation(shared);
    for (int i = 0; i < seen.size(); i++) {
      double[] fresh = {random.getAsDouble(), random.getAsDouble()};
      double[] last = before.getOrDefault(seen.camera(i), new double[2]);
      double[] error = {fresh[0] + shared * last[0], fresh[1] + shared * last[1]};
      moved.add(
          seen.time(i),
          seen.camera(i),
          seen.x(i) + scale * error[0],
          seen.y(i) + scale * error[1],
          seen.pixelX(i),
          seen.pixelY(i));
      before.put(
          seen.camera(i),
          new double[] {memory.kept(fresh[0], error[0]), memory.kept(fresh[1], error[1])});
    }
    return kick.withObservations(moved.build());
  }

  private static double noise(MovingNoise of, int camera) {
    CameraView view = of.cameras().get(camera);
    return view.noise();
  }

  @Test
  void independentErrorsAreNotCorrelated() {
    assertThat(plain.noise().correlation()).isZero();
    assertThat(plain.noise().inflation(4)).isEqualTo(1);
    assertThat(noisy(Memory.OF_ALL, 0).noise().correlation()).isZero();
  }

  @Test
  void whatSuccessiveErrorsShareIsNoiseAndNoStructure() {
    assertNoise(noisy(Memory.OF_WHAT_WAS_NEW, SHARED), SHARED / (1 + SHARED * SHARED), 0);
  }

  @Test
  void soIsWhatErrorsKeepOfAllBefore() {
    assertNoise(noisy(Memory.OF_ALL, KEPT), KEPT, KEPT);
  }

  private void assertNoise(FittedField field, double correlation, double decay) {
    double expected = 0;
    for (int camera : new int[] {0, 1}) {
      double both = Math.hypot(ADDED, noise(plain.noise(), camera));
      expected += 0.5 * correlation * Math.pow(ADDED / both, 2);
      assertThat(noise(field.noise(), camera)).isCloseTo(both, within(0.08 * both));
    }
    double rho = field.noise().correlation();
    assertThat(rho).isCloseTo(expected, within(0.06));
    assertThat(field.noise().decay()).isCloseTo(decay, within(0.2));
    assertThat(field.noise().inflation(4))
        .isCloseTo(1 + rho * (1.5 + decay * (1 + 0.5 * decay)), within(0.2));
    assertThat(field.simple().solution().reducedChiSquare()).isCloseTo(1, within(0.1));
    assertThat(Leftover.of(field.simple()).isSignificant()).isFalse();
  }

  /** Student's distribution with four degrees of freedom. */
  @Test
  void heavyTailsAreNoStructure() {
    SplittableRandom random = new SplittableRandom(20261126);
    FittedField field =
        noisy(
            Memory.OF_ALL,
            0,
            () -> {
              double squares = 0;
              for (int i = 0; i < 4; i++) {
                squares += Math.pow(random.nextGaussian(), 2);
              }
              return TAILS * random.nextGaussian() / Math.sqrt(squares);
            });
    assertThat(field.noise().correlation()).isZero();
    assertThat(field.simple().solution().reducedChiSquare())
        .as("they are there")
        .isGreaterThan(1.05);
    Leftover left = Leftover.of(field.simple());
    assertThat(left.isSignificant()).isFalse();
    assertThat(left.deviation()).isLessThan(3);
  }
}
