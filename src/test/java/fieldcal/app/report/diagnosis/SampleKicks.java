package fieldcal.app.report.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.ball.FlatTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffects;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Kicks seen by the two cameras of {@link SampleDiagnosis}, with residuals of the simple and of the extended model. */
final class SampleKicks {
  private static final double NOISE = 0.0015;

  private final Random random;
  private final ExtendedModel truth;
  private final boolean found;

  private SampleKicks(long seed, List<Effect> effects, boolean found) {
    random = new Random(seed);
    truth = SampleDiagnosis.model(effects);
    this.found = found;
  }

  static List<KickResiduals> of(int count, long seed, List<Effect> effects, boolean found) {
    SampleKicks kicks = new SampleKicks(seed, effects, found);
    List<KickResiduals> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(i % 4 == 3 ? kicks.chip(i + 1) : kicks.flat(i + 1));
    }
    return all;
  }

  private KickResiduals flat(int id) {
    double t0 = 12.0 * id;
    double angle = (random.nextBoolean() ? 0 : Math.PI) + 0.6 * (random.nextDouble() - 0.5);
    double speed = 2.5 + 3.5 * random.nextDouble();
    double x = -4 * Math.cos(angle);
    double y = -4 * Math.sin(angle) + 2 * (random.nextDouble() - 0.5);
    double vx = speed * Math.cos(angle);
    double vy = speed * Math.sin(angle);
    BallTrajectory real = truth.flatPath(t0, x, y, vx, vy);
    // A fit of the simple model makes up for a part of the drag by a slower kick.
    double slower = truth.motion().effects().isEmpty() ? 1 : 0.985;
    BallTrajectory simple =
        FlatTrajectory.fromKick(truth.flat().get(), t0, x, y, slower * vx, slower * vy);
    return observe(id, KickKind.FLAT, simple, real, t0);
  }

  private KickResiduals chip(int id) {
    double t0 = 12.0 * id;
    double angle = Math.PI * 2 * random.nextDouble();
    double x = -1.5 * Math.cos(angle);
    double y = -1.5 * Math.sin(angle);
    double v = 2 + random.nextDouble();
    ExtendedTrajectory real = truth.chipPath(t0, x, y, v * Math.cos(angle), v * Math.sin(angle), 3);
    double slower = truth.motion().effects().isEmpty() ? v : 0.97 * v;
    BallTrajectory simple =
        SampleDiagnosis.model(List.of())
            .chipPath(t0, x, y, slower * Math.cos(angle), slower * Math.sin(angle), 2.98);
    return observe(id, KickKind.CHIP, simple, real, t0);
  }

  private KickResiduals observe(
      int id, KickKind kind, BallTrajectory simple, BallTrajectory real, double t0) {
    MeasurementEffects published = MeasurementEffects.of(SampleDiagnosis.observers(), List.of());
    MeasurementEffects cameras =
        MeasurementEffects.of(SampleDiagnosis.observers(), truth.measurement());
    Observations.Builder seen = new Observations.Builder();
    List<double[]> residuals = new ArrayList<>();
    double[] ball = new double[3];
    double[] simpleBall = new double[3];
    double[] at = new double[2];
    double[] simpleAt = new double[2];
    double end = Math.min(real.restTime(), t0 + 4);
    int last = 0;
    for (double t = t0 - 0.2; t < end; t += 1 / 140.0) {
      int camera = last++ % 2;
      real.positionAt(t, ball);
      simple.positionAt(t, simpleBall);
      boolean inView = camera == 0 ? ball[0] < 0.6 : ball[0] > -0.6;
      if (!inView || Math.abs(ball[0]) > 6 || Math.abs(ball[1]) > 4.5) {
        continue;
      }
      cameras.report(camera, ball, at);
      published.report(camera, simpleBall, simpleAt);
      double nx = NOISE * random.nextGaussian();
      double ny = NOISE * random.nextGaussian();
      seen.add(t, camera, at[0] + nx, at[1] + ny, 0, 0);
      double beforeX = at[0] + nx - simpleAt[0];
      double beforeY = at[1] + ny - simpleAt[1];
      residuals.add(
          found
              ? new double[] {beforeX, beforeY, nx, ny}
              : new double[] {beforeX, beforeY, beforeX, beforeY});
    }
    BallState start = real.stateAt(t0);
    Kick kick =
        new Kick(
            id,
            t0,
            start.x(),
            start.y(),
            start.vx(),
            start.vy(),
            Optional.of(new RobotId(id % 2 == 0 ? Team.BLUE : Team.YELLOW, id % 5)),
            true,
            KickEnd.STOPPED,
            end,
            seen.build());
    boolean[] used = new boolean[residuals.size()];
    for (int i = 0; i < used.length; i++) {
      used[i] = i % 97 != 50;
    }
    return new KickResiduals(
        kick,
        kind,
        simple,
        found ? real : simple,
        column(residuals, 0),
        column(residuals, 1),
        column(residuals, 2),
        column(residuals, 3),
        used,
        rms(residuals, 0),
        rms(residuals, 2));
  }

  private static double[] column(List<double[]> rows, int column) {
    return rows.stream().mapToDouble(r -> r[column]).toArray();
  }

  private static double rms(List<double[]> rows, int column) {
    double squares =
        rows.stream().mapToDouble(r -> r[column] * r[column] + r[column + 1] * r[column + 1]).sum();
    return 1000 * Math.sqrt(squares / 2 / rows.size());
  }
}
