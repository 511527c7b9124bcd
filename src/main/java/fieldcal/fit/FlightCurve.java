package fieldcal.fit;

import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatTrajectory;
import fieldcal.kick.KickKind;
import java.util.Arrays;

/** A ball's path as a function of the unknowns. Holds one evaluation at a time; not thread-safe. */
abstract class FlightCurve {
  /** Sets the unknowns for the calls that follow. */
  abstract void set(double[] theta);

  abstract void position(double time, double[] xyz);

  abstract void sensitivities(double time, double[] xyz, double[] dx, double[] dy, double[] dz);

  /** Derivatives of the distance over the ground with respect to the damping at each impact, m, that of the first impact first; only for chips, which fly straight on. */
  void byImpact(double time, double[] byImpact) {
    Arrays.fill(byImpact, 0);
  }

  /**
   * The path of a kick.
   *
   * @param flights of a chip; 0 for the 10 mm rule's number
   * @param fromRest whether the ball lay still before
   */
  static FlightCurve of(KickKind kind, int flights, boolean fromRest) {
    FlightCurve curve = kind == KickKind.FLAT ? new Flat() : new Chip(flights);
    return fromRest ? curve : new UnderWay(curve, FlightLayout.timeIndex(kind));
  }

  /** A kick without rest before it. It is not known where the ball was, so the line is extended backwards: a ball that waited at the place of the kick would explain any first detection by a kick after it. */
  private static final class UnderWay extends FlightCurve {
    private static final int X = FlatTrajectory.X0;
    private static final int Y = FlatTrajectory.Y0;
    private static final int VX = FlatTrajectory.VX0;
    private static final int VY = FlatTrajectory.VY0;
    private final FlightCurve after;
    private final int timeIndex;
    private double[] p;

    UnderWay(FlightCurve after, int timeIndex) {
      this.after = after;
      this.timeIndex = timeIndex;
    }

    @Override
    void set(double[] theta) {
      p = theta.clone();
      after.set(theta);
    }

    @Override
    void position(double time, double[] xyz) {
      double since = time - p[timeIndex];
      if (since >= 0) {
        after.position(time, xyz);
        return;
      }
      xyz[0] = p[X] + since * p[VX];
      xyz[1] = p[Y] + since * p[VY];
      xyz[2] = 0;
    }

    @Override
    void sensitivities(double time, double[] xyz, double[] dx, double[] dy, double[] dz) {
      double since = time - p[timeIndex];
      if (since >= 0) {
        after.sensitivities(time, xyz, dx, dy, dz);
        return;
      }
      position(time, xyz);
      Arrays.fill(dx, 0);
      Arrays.fill(dy, 0);
      Arrays.fill(dz, 0);
      dx[X] = 1;
      dy[Y] = 1;
      dx[VX] = since;
      dy[VY] = since;
      dx[timeIndex] = -p[VX];
      dy[timeIndex] = -p[VY];
    }

    @Override
    void byImpact(double time, double[] byImpact) {
      after.byImpact(time, byImpact);
    }
  }

  /** Flat kick without spin. */
  static final class Flat extends FlightCurve {
    private FlatTrajectory path;

    @Override
    void set(double[] p) {
      path =
          FlatTrajectory.fromKick(
              FlightLayout.flatModel(p),
              p[FlatTrajectory.T0],
              p[FlatTrajectory.X0],
              p[FlatTrajectory.Y0],
              p[FlatTrajectory.VX0],
              p[FlatTrajectory.VY0]);
    }

    @Override
    void position(double time, double[] xyz) {
      path.positionAt(time, xyz);
    }

    @Override
    void sensitivities(double time, double[] xyz, double[] dx, double[] dy, double[] dz) {
      path.sensitivitiesAt(time, xyz, dx, dy);
    }
  }

  /** Chip kick; the number of flights is given, or follows from the 10 mm rule when {@code flights} is 0. */
  static final class Chip extends FlightCurve {
    private final int flights;
    private ChipTrajectory path;

    Chip(int flights) {
      this.flights = flights;
    }

    @Override
    void set(double[] p) {
      double t0 = p[ChipTrajectory.T0];
      double x = p[ChipTrajectory.X0];
      double y = p[ChipTrajectory.Y0];
      double vx = p[ChipTrajectory.VX0];
      double vy = p[ChipTrajectory.VY0];
      double vz = p[ChipTrajectory.VZ0];
      path =
          flights == 0
              ? ChipTrajectory.fromKick(FlightLayout.chipModel(p), t0, x, y, vx, vy, vz)
              : ChipTrajectory.fromKickWithHops(
                  FlightLayout.chipModel(p), t0, x, y, vx, vy, vz, flights);
    }

    @Override
    void position(double time, double[] xyz) {
      path.positionAt(time, xyz);
    }

    @Override
    void sensitivities(double time, double[] xyz, double[] dx, double[] dy, double[] dz) {
      path.sensitivitiesAt(time, xyz, dx, dy, dz);
    }

    @Override
    void byImpact(double time, double[] byImpact) {
      path.dampingSensitivitiesAt(time, byImpact);
    }
  }
}
