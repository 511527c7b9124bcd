package fieldcal.app.play;

import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.ball.Parameter;
import fieldcal.camera.Camera;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.fit.joint.SharedProblem;
import fieldcal.kick.KickFinderSettings;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * How much a kick will tell of its model's three parameters: Fisher information from the closed form's sensitivities, seen by the cameras that are there, with position, velocity and time of the kick as further
 * unknowns, which the kernel eliminates. Immutable.
 */
final class KickInformation {
  private static final double RATE = 70;

  /** Cameras that are so much farther away than the nearest still see the ball, m. */
  private static final double OVERLAP = 0.6;

  /** Longer nobody lets a ball roll, s. */
  private static final double LONGEST = 12;

  /** What is known of a chip's accRoll beforehand, m/s². */
  private static final double ROLL_KNOWN = 0.05;

  /** Keeps what a kick does not tell of from being singular. */
  private static final double TINY = 1e-9;

  /** Parameters of each model that a play is after. */
  private static final int PARAMETERS = 3;

  private static final double LOST = KickFinderSettings.defaults().lostAfter();

  private final List<SeeingCamera> cameras;
  private final double noise;
  private final double settle;

  /**
   * Of kicks on a field.
   *
   * @param cameras at least one
   * @param noise of a detection, m
   * @param settle how long the ball rests before the kick, s
   */
  KickInformation(Collection<SeeingCamera> cameras, double noise, double settle) {
    this.cameras = List.copyOf(cameras);
    this.noise = noise;
    this.settle = settle;
  }

  /** Information on accSlide, accRoll and kSwitch of a flat kick that rolls so far at most. */
  RealMatrix flat(FlatModel model, double x, double y, double direction, double speed, double run) {
    FlatTrajectory path =
        FlatTrajectory.fromKick(
            model, 0, x, y, speed * Math.cos(direction), speed * Math.sin(direction));
    Sum sum = new Sum(FlatTrajectory.SENSITIVITIES);
    sum.rest(x, y);
    double end =
        Math.min(LONGEST, Math.min(path.restTime(), path.timeAtDistance(run).orElse(LONGEST)));
    double[] dz = new double[FlatTrajectory.SENSITIVITIES];
    for (double t = 0.5 / RATE; t < end && !sum.isLost(t); t += 1 / RATE) {
      path.sensitivitiesAt(t, sum.xyz, sum.dx, sum.dy);
      sum.observe(t, dz);
    }
    return sum.information(FlatTrajectory.ACC_SLIDE);
  }

  /** Information on the three dampings of a chip that comes so far at most. */
  RealMatrix chip(
      ChipModel model,
      double x,
      double y,
      double direction,
      double speed,
      double elevation,
      double run) {
    double along = speed * Math.cos(elevation);
    ChipTrajectory path =
        ChipTrajectory.fromKick(
            model,
            0,
            x,
            y,
            along * Math.cos(direction),
            along * Math.sin(direction),
            speed * Math.sin(elevation));
    Sum sum = new Sum(ChipTrajectory.SENSITIVITIES);
    sum.rest(x, y);
    double end =
        Math.min(LONGEST, Math.min(path.restTime(), path.timeAtDistance(run).orElse(LONGEST)));
    double[] dz = new double[ChipTrajectory.SENSITIVITIES];
    for (double t = 0.5 / RATE; t < end && !sum.isLost(t); t += 1 / RATE) {
      path.sensitivitiesAt(t, sum.xyz, sum.dx, sum.dy, dz);
      sum.observe(t, dz);
    }
    sum.know(ChipTrajectory.ACC_ROLL, ROLL_KNOWN);
    return sum.information(ChipTrajectory.DAMPING_XY_FIRST_HOP);
  }

  /** What is seen of one kick: the rows of its derivatives. */
  private final class Sum {
    private final int size;
    private final double[] xyz = new double[3];
    private final double[] dx;
    private final double[] dy;
    private final List<double[]> rows = new ArrayList<>();
    private final double[] jacobian = new double[6];
    private double seen;

    Sum(int size) {
      this.size = size;
      dx = new double[size];
      dy = new double[size];
    }

    /** The resting ball pins its place. */
    void rest(double x, double y) {
      double n = settle * RATE * seeing(x, y, 0).size();
      know(FlatTrajectory.X0, noise / Math.sqrt(n));
      know(FlatTrajectory.Y0, noise / Math.sqrt(n));
    }

    /** One number is known to an error. */
    void know(int index, double error) {
      double[] row = new double[size];
      row[index] = 1 / error;
      rows.add(row);
    }

    /** A chip that leaves all images is lost, and what comes after is no part of the kick. */
    boolean isLost(double t) {
      return t - seen > LOST;
    }

    void observe(double t, double[] dz) {
      for (SeeingCamera one : seeing(xyz[0], xyz[1], xyz[2])) {
        Camera camera = one.camera();
        seen = t;
        camera.groundJacobian(xyz[0], xyz[1], xyz[2], jacobian);
        for (int axis = 0; axis < 2; axis++) {
          double[] row = new double[size];
          for (int i = 0; i < size; i++) {
            row[i] =
                (jacobian[3 * axis] * dx[i]
                        + jacobian[3 * axis + 1] * dy[i]
                        + jacobian[3 * axis + 2] * dz[i])
                    / noise;
          }
          rows.add(row);
        }
      }
    }

    /** On three global parameters from {@code first} on; all others are per-kick parameters. */
    RealMatrix information(int first) {
      LinearKick kick = new LinearKick(rows, first, PARAMETERS);
      List<Parameter> globals = new ArrayList<>();
      for (int k = 0; k < PARAMETERS; k++) {
        globals.add(new Parameter("model " + k, "", 0, 1, -1, 1, true, "linear"));
      }
      ScoreSystem system =
          ScoreSystem.at(
              new SharedProblem<>(
                  double[]::clone,
                  List.of(kick),
                  List.of(new double[kick.ownSize()]),
                  globals,
                  Collections.nCopies(PARAMETERS, SharedProblem.Prior.NONE),
                  List.of(),
                  new double[] {1}));
      RealMatrix information = new Array2DRowRealMatrix(PARAMETERS, PARAMETERS);
      for (int i = 0; i < PARAMETERS; i++) {
        for (int j = 0; j < PARAMETERS; j++) {
          information.setEntry(i, j, system.curvature(i, j));
        }
        information.addToEntry(i, i, TINY);
      }
      return information;
    }
  }

  /** Cameras with the ball in their image; of those whose image is not known, the near ones. */
  private List<SeeingCamera> seeing(double x, double y, double z) {
    double nearest = Double.POSITIVE_INFINITY;
    for (SeeingCamera c : cameras) {
      nearest = Math.min(nearest, c.distance(x, y));
    }
    List<SeeingCamera> seeing = new ArrayList<>();
    for (SeeingCamera c : cameras) {
      if (c.hasImage() ? c.sees(x, y, z) : c.distance(x, y) < nearest + OVERLAP) {
        seeing.add(c);
      }
    }
    return seeing;
  }

  static RealMatrix inverse(RealMatrix matrix) {
    return new LUDecomposition(matrix, 1e-300).getSolver().getInverse();
  }
}
