package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.simulation.physics.Ball;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallIntegrator;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.BallTrace;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * Kicks of an ideal ball with known truth, seen by two cameras at 73 Hz: what the benchmark of the fit is measured on. The ball is
 * integrated by the simulation, whose physics shares nothing with the closed forms. Used by the tests of the fit, too.
 */
final class IdealKicks {
  /** What may be wrong with the observations. */
  record Conditions(double noise, double outliers, double lost) {}

  /** A kick as the finder would hand it over, and the truth in the order of the sensitivities. */
  record Sample(Kick kick, KickKind kind, double[] truth, int flights, boolean[] outlier) {}

  /** Its own inertia lets it roll at 0.65 of its speed, so that its spin does more at impacts than a golf ball's. */
  private static final Ball HOLLOW = Ball.GOLF_BALL.withInertiaFactor(1 / 0.65 - 1);

  private static final double RATE = 73;
  private static final double REST = 0.5;
  private static final double LONGEST = 9;
  private static final double FOCAL = 1500;

  private final CameraViews views;
  private double sideSpin;
  private double rollSpin;

  IdealKicks(double noise) {
    views = CameraViews.of(List.of(view(0, -3, noise), view(1, 3, noise)));
  }

  private static CameraView view(int id, double x, double noise) {
    // Looks straight down: half a turn about the x axis, so that the camera sees y mirrored; t =
    // −R·position.
    double height = 6;
    CameraCalibration c =
        new CameraCalibration(
            id, FOCAL, 1000, 1200, 0.12, 1, 0, 0, 0, -x, 0, height, x, 0, height, 2000, 2400);
    return CameraView.of(id, Optional.of(Camera.of(c))).withNoise(noise);
  }

  /** From now on kicks have spin about the direction of travel, as a fraction of rolling spin: they bend. */
  void sideSpin(double fraction) {
    sideSpin = fraction;
  }

  /** From now on kicks have spin about the rolling axis, as a fraction of rolling spin: negative is backspin. */
  void rollSpin(double fraction) {
    rollSpin = fraction;
  }

  CameraViews views() {
    return views;
  }

  Sample draw(KickKind kind, int id, Conditions conditions, SplittableRandom random) {
    return observe(
        kind,
        kind == KickKind.FLAT ? flatTruth(random) : chipTruth(random),
        id,
        conditions,
        random);
  }

  /** The kick with this truth, in the order of the sensitivities. */
  Sample observe(
      KickKind kind, double[] truth, int id, Conditions conditions, SplittableRandom random) {
    BallPhysics physics =
        kind == KickKind.FLAT
            ? BallPhysics.ideal(truth[5], truth[6], truth[7], 0.75, 0.95, 0.5)
            : BallPhysics.ideal(-3.2, truth[9], 0.65, truth[6], truth[7], truth[8])
                .withBall(HOLLOW);
    return observe(kind, truth, physics, id, conditions, random);
  }

  /** A kick of a ball that moves by other laws; of the truth, only position, velocity and time count. */
  Sample observe(
      KickKind kind,
      double[] truth,
      BallPhysics physics,
      int id,
      Conditions conditions,
      SplittableRandom random) {
    Observations.Builder seen = new Observations.Builder();
    BallBody ball = new BallBody();
    ball.place(truth[0], truth[1]);
    double t0 = truth[FlightLayout.timeIndex(kind)];
    double phase = random.nextDouble() / RATE;
    BallIntegrator integrator = new BallIntegrator(physics);
    boolean kicked = false;
    double now = 0;
    double stoppedAt = Double.NaN;
    java.util.ArrayList<Boolean> outliers = new java.util.ArrayList<>();
    for (int k = 0; k < (int) (LONGEST * RATE); k++) {
      for (int camera = 0; camera < 2; camera++) {
        double t = k / RATE + camera * phase;
        if (t >= t0 && !kicked) {
          double side = sideSpin / physics.ball().radius();
          double roll = rollSpin / physics.ball().radius();
          ball.launch(
              truth[2],
              truth[3],
              kind == KickKind.CHIP ? truth[4] : 0,
              side * truth[2] - roll * truth[3],
              side * truth[3] + roll * truth[2],
              0);
          kicked = true;
          now = t0;
        }
        if (kicked) {
          integrator.advance(ball, now, t, BallTrace.NONE);
          now = t;
        }
        observe(camera, t, ball, conditions, random, seen, outliers);
      }
      boolean over = kicked && (Math.abs(ball.x()) > 6 || Math.abs(ball.y()) > 4.5);
      if (kicked && ball.groundSpeed() == 0 && Double.isNaN(stoppedAt)) {
        stoppedAt = now;
      }
      if (over || now > stoppedAt + 0.3) {
        break;
      }
    }
    Observations observations = seen.build();
    boolean[] outlier = new boolean[outliers.size()];
    for (int i = 0; i < outlier.length; i++) {
      outlier[i] = outliers.get(i);
    }
    double found = t0 + 0.004 * gaussian(random);
    double last = observations.time(observations.size() - 1);
    Kick kick =
        new Kick(
            id,
            found,
            truth[0] + 0.003 * gaussian(random),
            truth[1] + 0.003 * gaussian(random),
            truth[2] * (1 + 0.05 * gaussian(random)),
            truth[3] * (1 + 0.05 * gaussian(random)),
            Optional.empty(),
            true,
            KickEnd.STOPPED,
            last,
            observations);
    int flights =
        kind == KickKind.CHIP
            ? ChipTrajectory.flightsByRule(FlightLayout.chipModel(truth), truth[4])
            : 0;
    return new Sample(kick, kind, truth, flights, outlier);
  }

  private void observe(
      int camera,
      double t,
      BallBody ball,
      Conditions conditions,
      SplittableRandom random,
      Observations.Builder seen,
      java.util.List<Boolean> outliers) {
    CameraView view = views.get(camera);
    Camera model = view.camera().orElseThrow();
    double[] at = new double[2];
    model.worldToPixel(ball.x(), ball.y(), ball.z(), at);
    boolean visible = at[0] > 0 && at[0] < 2000 && at[1] > 0 && at[1] < 2400;
    // The order of draws does not depend on what is visible, so that conditions can be compared
    // kick by kick.
    double nu = gaussian(random);
    double nv = gaussian(random);
    boolean lost = random.nextDouble() < conditions.lost();
    boolean wild = random.nextDouble() < conditions.outliers();
    double angle = 2 * Math.PI * random.nextDouble();
    double far = 0.3 * Math.sqrt(random.nextDouble());
    if (!visible || lost) {
      return;
    }
    double pixels = conditions.noise() * FOCAL / model.heightAboveBallPlane();
    double u = at[0] + pixels * nu;
    double v = at[1] + pixels * nv;
    model.pixelToPlane(u, v, 0, at);
    if (wild) {
      at[0] += far * Math.cos(angle);
      at[1] += far * Math.sin(angle);
    }
    seen.add(t, camera, at[0], at[1], u, v);
    outliers.add(wild);
  }

  static double[] flatTruth(SplittableRandom r) {
    double speed = 2 + 4.5 * r.nextDouble();
    double side = r.nextBoolean() ? 1 : -1;
    double direction = (side > 0 ? 0 : Math.PI) + 0.9 * (r.nextDouble() - 0.5);
    return new double[] {
      -side * (3 + 2 * r.nextDouble()),
      -2 * Math.sin(direction) + 0.5 * (r.nextDouble() - 0.5),
      speed * Math.cos(direction),
      speed * Math.sin(direction),
      REST + 0.01 * r.nextDouble(),
      -3.6 + 1.2 * r.nextDouble(),
      -0.36 + 0.16 * r.nextDouble(),
      0.58 + 0.12 * r.nextDouble()
    };
  }

  static double[] chipTruth(SplittableRandom r) {
    double speed = 3 + 3.5 * r.nextDouble();
    double elevation = Math.toRadians(40 + 10 * r.nextDouble());
    double side = r.nextBoolean() ? 1 : -1;
    double direction = side * Math.PI / 2 + 0.3 * (r.nextDouble() - 0.5);
    double ground = speed * Math.cos(elevation);
    return new double[] {
      0.8 * (r.nextDouble() - 0.5),
      -side * 4,
      ground * Math.cos(direction),
      ground * Math.sin(direction),
      speed * Math.sin(elevation),
      REST + 0.01 * r.nextDouble(),
      0.7 + 0.12 * r.nextDouble(),
      0.85 + 0.12 * r.nextDouble(),
      0.45 + 0.15 * r.nextDouble(),
      -0.36 + 0.16 * r.nextDouble()
    };
  }

  static double gaussian(SplittableRandom r) {
    return Math.sqrt(-2 * Math.log(1 - r.nextDouble())) * Math.cos(2 * Math.PI * r.nextDouble());
  }

  /** The true flat model, 15 % off in a direction drawn per kick: what somebody published. */
  static FlatModel publishedFlat(double[] truth, SplittableRandom r) {
    return new FlatModel(off(truth[5], r), off(truth[6], r), off(truth[7], r));
  }

  static ChipModel publishedChip(double[] truth, SplittableRandom r) {
    return new ChipModel(
        Math.min(1, off(truth[6], r)), Math.min(1, off(truth[7], r)), off(truth[8], r), truth[9]);
  }

  private static double off(double value, SplittableRandom r) {
    return value * (r.nextBoolean() ? 1.15 : 0.85);
  }
}
