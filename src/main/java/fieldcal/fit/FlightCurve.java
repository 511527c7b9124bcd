package fieldcal.fit;

import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatTrajectory;

/** A ball's path as a function of the unknowns. Holds one evaluation at a time; not thread-safe. */
abstract class FlightCurve {
  /** Puts the unknowns in place for the calls that follow. */
  abstract void set(double[] theta);

  abstract void position(double time, double[] xyz);

  abstract void sensitivities(double time, double[] xyz, double[] dx, double[] dy, double[] dz);

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
  }
}
