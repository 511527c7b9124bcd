package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Cutting and fitting of paths that are known: rest, acceleration, cruise, braking, rest. */
class RampFitTest {
  private static final double DIRECTION = 0.7;
  private static final int DRIVES = 200;

  /** A drive along a line: where it is at a time. */
  private record Drive(double acceleration, double speed, double cruise, double braking) {
    private static final double REST = 0.5;

    double start() {
      return REST;
    }

    double full() {
      return REST + speed / acceleration;
    }

    double brakes() {
      return full() + cruise;
    }

    double end() {
      return brakes() + speed / braking;
    }

    double at(double t) {
      double a = Math.max(0, t - start());
      double b = Math.max(0, t - full());
      double c = Math.max(0, t - brakes());
      double d = Math.max(0, t - end());
      return 0.5
          * (acceleration * a * a - acceleration * b * b - braking * c * c + braking * d * d);
    }

    /** The same with accelerations that change evenly within a time. */
    double rounded(double t, double width) {
      int steps = 16;
      double sum = 0;
      for (int i = 0; i < steps; i++) {
        sum += at(t + width * ((i + 0.5) / steps - 0.5));
      }
      return sum / steps;
    }
  }

  private static Stretch seen(
      Drive drive, double noise, int cameras, double disagreement, long seed) {
    return seen(drive, 0, noise, cameras, disagreement, seed);
  }

  private static Stretch seen(
      Drive drive, double width, double noise, int cameras, double disagreement, long seed) {
    Random random = new Random(seed);
    Stretch stretch = new Stretch();
    double[] next = new double[cameras];
    for (int c = 0; c < cameras; c++) {
      next[c] = random.nextDouble() / 72;
    }
    while (true) {
      int c = 0;
      for (int i = 1; i < cameras; i++) {
        c = next[i] < next[c] ? i : c;
      }
      double t = next[c];
      if (t > drive.end() + 0.5) {
        return stretch;
      }
      double s = drive.rounded(t, width);
      stretch.add(
          t,
          s * Math.cos(DIRECTION) + noise * random.nextGaussian() + c * disagreement,
          s * Math.sin(DIRECTION) + noise * random.nextGaussian() - c * disagreement,
          0.2,
          c);
      next[c] += 1.0 / 72;
    }
  }

  private static List<Manoeuvre> manoeuvres(Stretch... stretches) {
    List<Manoeuvre> found = new ArrayList<>();
    ManoeuvreFinder finder = new ManoeuvreFinder(PathKind.POSITION, found::add);
    for (Stretch stretch : stretches) {
      finder.find(new RobotId(Team.BLUE, 3), stretch);
    }
    return found;
  }

  @Test
  void withoutNoiseEveryNumberComesOut() {
    Drive drive = new Drive(3, 2.5, 0.4, 5);
    List<Manoeuvre> found = manoeuvres(seen(drive, 1e-7, 1, 0, 1));
    assertThat(found).hasSize(3);
    assertThat(found.get(0).acceleration()).isEqualTo(3, within(2e-3));
    assertThat(found.get(0).speedAfter(found.get(0).duration())).isEqualTo(2.5, within(2e-3));
    assertThat(found.get(1).acceleration()).isEqualTo(0, within(1e-2));
    assertThat(found.get(1).speed()).isEqualTo(2.5, within(2e-3));
    assertThat(found.get(2).acceleration()).isEqualTo(5, within(5e-3));
    assertThat(found.get(2).speedGrowth(0.1)).isEqualTo(-5, within(1e-2));
    assertThat(found.get(2).duration()).isEqualTo(0.5, within(2e-3));
    assertThat(Math.atan2(found.get(0).ay(), found.get(0).ax())).isEqualTo(DIRECTION, within(2e-3));
    assertThat(found.get(0).orientation()).isEqualTo(0.2, within(1e-9));
    assertThat(found.get(0).robot()).isEqualTo(new RobotId(Team.BLUE, 3));
  }

  @Test
  void camerasThatDisagreeMakeNoManoeuvre() {
    Drive drive = new Drive(3, 2.5, 0.4, 5);
    List<Manoeuvre> found = manoeuvres(seen(drive, 1e-7, 3, 0.026, 1));
    assertThat(found).hasSize(3);
    assertThat(found.get(0).acceleration()).isEqualTo(3, within(2e-3));
    assertThat(found.get(2).acceleration()).isEqualTo(5, within(5e-3));
  }

  @Test
  void aRobotAtRestDoesNothing() {
    Stretch stretch = new Stretch();
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      stretch.add(i / 72.0, 0.0035 * random.nextGaussian(), 0.0035 * random.nextGaussian(), 0, 0);
    }
    assertThat(manoeuvres(stretch))
        .allSatisfy(m -> assertThat(m.acceleration()).isLessThan(2 * m.accelerationError()));
  }

  /** Short and hard: where a window that slides over the path has nothing but straddling positions. */
  @ParameterizedTest
  @CsvSource({
    "3, 2, 0.5, 5, 0.0035",
    "3, 1.5, 0.4, 8, 0.0035",
    "1.5, 1.5, 0.5, 2, 0.0035",
    "5, 3, 0.5, 8, 0.0013"
  })
  void errorsAreWhatTheySay(
      double acceleration, double speed, double cruise, double braking, double noise) {
    Drive drive = new Drive(acceleration, speed, cruise, braking);
    Stretch[] drives = new Stretch[DRIVES];
    for (int seed = 0; seed < DRIVES; seed++) {
      drives[seed] = seen(drive, noise, 1, 0, seed);
    }
    int within1 = 0;
    int within2 = 0;
    int n = 0;
    double bias = 0;
    for (Manoeuvre m : manoeuvres(drives)) {
      double truth = m.speedGrowth(0.5 * m.duration()) > 0 ? acceleration : braking;
      if (m.acceleration() > 0.5 * truth) {
        double error = (m.acceleration() - truth) / m.accelerationError();
        n++;
        within1 += Math.abs(error) < 1 ? 1 : 0;
        within2 += Math.abs(error) < 2 ? 1 : 0;
        bias += error;
      }
    }
    assertThat(n).isBetween((int) (1.75 * DRIVES), (int) (2.1 * DRIVES));
    assertThat((double) within1 / n).isBetween(0.6, 0.76);
    assertThat((double) within2 / n).isBetween(0.9, 0.99);
    assertThat(bias / n).as("bias in standard errors").isBetween(-0.35, 0.35);
  }

  /** Robots with a limited jerk: sharp corners would find 1 to 2 % less. */
  @ParameterizedTest
  @CsvSource({"4, 2, 5, 0.04", "4, 2, 5, 0.08", "3, 1.5, 6, 0.06"})
  void roundCornersDoNotMatter(double acceleration, double speed, double braking, double width) {
    Drive drive = new Drive(acceleration, speed, 0.5, braking);
    Stretch[] drives = new Stretch[DRIVES];
    for (int seed = 0; seed < DRIVES; seed++) {
      drives[seed] = seen(drive, width, 0.001, 1, 0, seed);
    }
    double[] ratios =
        manoeuvres(drives).stream()
            .skip(DRIVES / 2)
            .filter(m -> m.acceleration() > 2)
            .mapToDouble(
                m ->
                    m.acceleration()
                        / (m.speedGrowth(0.5 * m.duration()) > 0 ? acceleration : braking))
            .sorted()
            .toArray();
    assertThat(ratios[ratios.length / 2]).isEqualTo(1, within(0.004));
  }
}
