package fieldcal.fit;

import fieldcal.ball.ChipTrajectory;
import fieldcal.kick.KickKind;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.QRDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * How the bounces of one chip may differ from each other. The closed form damps all of them but the first alike. A ball that spins does not bounce like that: its spin fades from bounce to bounce (Cross 2002), and it changes the horizontal dampings of a kick relative to each other by as much as it changes their mean. If this is ignored, it biases {@code dampingZ}, since the place of a landing determines the length of a flight.
 *
 * <p>So the damping of each bounce after the first differs from their mean, which is the kick's own {@code dampingXyOtherHops}, by a normal scatter. These deviations are nuisance parameters: of a single kick they enlarge its errors, in a joint fit they are estimated with the rest. Immutable.
 */
final class UnevenBounces {
  /** All bounces alike. */
  static final UnevenBounces NONE = new UnevenBounces(new double[0][], 1);

  /** Deviations of the usual size must change chi-square by more than this: a smaller change moves no unknown by a tenth of its error. */
  private static final double VISIBLE = 0.01;

  private static final int OTHER = ChipTrajectory.DAMPING_XY_OTHER_HOPS;

  /** Orthonormal; each the deviations at the second impact, the third and so on, that leave the kick's own damping as it is. */
  private final double[][] shapes;

  private final double scatter;

  private UnevenBounces(double[][] shapes, double scatter) {
    this.shapes = shapes;
    this.scatter = scatter;
  }

  /** How many parameters describe the deviations: at most one less than there are bounces after the first. */
  int size() {
    return shapes.length;
  }

  /** How well each of them is known beforehand, 1/variance. */
  double precision() {
    return 1 / (scatter * scatter);
  }

  /**
   * By how much the damping at each impact deviates.
   *
   * @param values of the parameters
   * @return at the second impact, the third and so on
   */
  double[] deviations(double[] values) {
    double[] deviations = new double[shapes.length == 0 ? 0 : shapes[0].length];
    for (int k = 0; k < shapes.length; k++) {
      for (int n = 0; n < deviations.length; n++) {
        deviations[n] += values[k] * shapes[k][n];
      }
    }
    return deviations;
  }

  /**
   * By how much a path is longer with the deviations than without, m.
   *
   * @param deviations of the damping at the second impact, the third and so on
   * @param byImpact derivatives of the distance with respect to the damping at each impact, that of the first impact first
   */
  static double longer(double[] deviations, double[] byImpact) {
    double sum = 0;
    for (int n = 0; n < deviations.length && n + 1 < byImpact.length; n++) {
      sum += deviations[n] * byImpact[n + 1];
    }
    return sum;
  }

  /** Derivative of the distance with respect to one of the parameters. */
  double along(int k, double[] byImpact) {
    return longer(shapes[k], byImpact);
  }

  /**
   * A fit whose errors cover uneven bounces. Its values stay: the errors are the root of the mean square that remains once the deviations are estimated, which contains what they would have moved the values by.
   *
   * @param fit of a chip; others are returned as they are
   * @param cameras with which it was made
   * @param scatter of the damping from bounce to bounce, 0 or more
   */
  static KickFit cover(KickFit fit, CameraViews cameras, double scatter) {
    boolean bounces =
        fit.failure().isEmpty()
            && fit.kind() == KickKind.CHIP
            && fit.statistics().flights() > 2
            && fit.estimates().get(OTHER).usable();
    return bounces && scatter > 0 ? new Cover(fit, cameras).with(scatter) : fit;
  }

  /** The sums over the detections of one fit; used once. */
  private static final class Cover {
    private final KickFit fit;
    private final double factor;
    private final RealMatrix covariance;

    /** Products of the whitened derivatives with respect to the bounces: with those with respect to the unknowns, with each other, and with the residuals. */
    private final RealMatrix withUnknowns;

    private final RealMatrix information;
    private final RealMatrix withResiduals;

    Cover(KickFit fit, CameraViews cameras) {
      this.fit = fit;
      int size = fit.estimates().size();
      int bounces = fit.statistics().flights() - 1;
      factor = fit.statistics().varianceFactor();
      covariance = new Array2DRowRealMatrix(size, size);
      for (int i = 0; i < size; i++) {
        for (int j = 0; j < size; j++) {
          covariance.setEntry(i, j, fit.covariance(i, j) / factor);
        }
      }
      withUnknowns = new Array2DRowRealMatrix(bounces, size);
      information = new Array2DRowRealMatrix(bounces, bounces);
      withResiduals = new Array2DRowRealMatrix(bounces, 1);
      sum(FlightData.of(fit.kick().observations(), cameras));
    }

    private void sum(FlightData data) {
      double[] theta = fit.values();
      double speed = Math.hypot(theta[ChipTrajectory.VX0], theta[ChipTrajectory.VY0]);
      double ux = theta[ChipTrajectory.VX0] / speed;
      double uy = theta[ChipTrajectory.VY0] / speed;
      FlightCurve curve =
          FlightCurve.of(fit.kind(), fit.statistics().flights(), fit.kick().fromRest());
      curve.set(theta);
      int bounces = withUnknowns.getRowDimension();
      double[] byImpact = new double[bounces + 1];
      double[] xyz = new double[3];
      double[][] d = new double[3][theta.length];
      for (int i = 0; i < data.size; i++) {
        curve.byImpact(data.time[i], byImpact);
        if (!fit.used(i) || byImpact[1] == 0) {
          continue;
        }
        curve.sensitivities(data.time[i], xyz, d[0], d[1], d[2]);
        double f = data.stretch(i, xyz[2]);
        double fz = f * f / data.cameraHeight[i];
        double px = xyz[0] - data.cameraX[i];
        double py = xyz[1] - data.cameraY[i];
        double[] along = whitened(data, i, f * ux, f * uy);
        for (int k = 0; k < theta.length; k++) {
          double gx = f * d[0][k] + px * fz * d[2][k];
          double gy = f * d[1][k] + py * fz * d[2][k];
          add(withUnknowns, k, byImpact, dot(along, whitened(data, i, gx, gy)));
        }
        for (int m = 0; m < bounces; m++) {
          add(information, m, byImpact, byImpact[m + 1] * dot(along, along));
        }
        double[] residual = whitened(data, i, fit.residualX(i), fit.residualY(i));
        add(withResiduals, 0, byImpact, dot(along, residual));
      }
    }

    /** Adds the derivatives with respect to the bounces, times a factor, to a column. */
    private static void add(RealMatrix to, int column, double[] byImpact, double times) {
      for (int n = 0; n < to.getRowDimension(); n++) {
        to.addToEntry(n, column, byImpact[n + 1] * times);
      }
    }

    private static double[] whitened(FlightData data, int i, double x, double y) {
      return new double[] {data.w11[i] * x, data.w21[i] * x + data.w22[i] * y};
    }

    KickFit with(double scatter) {
      RealMatrix response = covariance.multiply(withUnknowns.transpose());
      double[][] rows = visible(complement(response.getRow(OTHER)), scatter);
      if (rows.length == 0) {
        return fit;
      }
      RealMatrix shapes = new Array2DRowRealMatrix(rows, false);
      RealMatrix unknowns = shapes.multiply(withUnknowns);
      RealMatrix known =
          shapes
              .multiply(information)
              .multiply(shapes.transpose())
              .subtract(unknowns.multiply(covariance).multiply(unknowns.transpose()))
              .add(
                  MatrixUtils.createRealIdentityMatrix(rows.length)
                      .scalarMultiply(factor / (scatter * scatter)));
      RealMatrix left = MatrixUtils.inverse(known);
      RealMatrix best = left.multiply(shapes).multiply(withResiduals);
      RealMatrix square = left.scalarMultiply(factor).add(best.multiply(best.transpose()));
      RealMatrix moves = covariance.multiply(unknowns.transpose());
      RealMatrix more = moves.multiply(square).multiply(moves.transpose());
      return fit.with(more.getData(), new UnevenBounces(rows, scatter));
    }

    /** The shapes that the detections determine, turned so that they do not depend on each other. A hundred low hops in which a wrong fit may end show a few. */
    private double[][] visible(double[][] rows, double scatter) {
      if (rows.length == 0) {
        return rows;
      }
      RealMatrix shapes = new Array2DRowRealMatrix(rows, false);
      // Symmetric and not negative: the singular values are the eigenvalues.
      SingularValueDecomposition axes =
          new SingularValueDecomposition(shapes.multiply(information).multiply(shapes.transpose()));
      double least = VISIBLE * factor / (scatter * scatter);
      return IntStream.range(0, rows.length)
          .filter(k -> axes.getSingularValues()[k] > least)
          .mapToObj(k -> shapes.preMultiply(axes.getU().getColumn(k)))
          .toArray(double[][]::new);
    }

    /** An orthonormal basis of the space perpendicular to a vector; empty for an empty vector. */
    private static double[][] complement(double[] vector) {
      if (!(dot(vector, vector) > 0)) {
        return new double[0][];
      }
      RealMatrix q = new QRDecomposition(new Array2DRowRealMatrix(vector)).getQ();
      return IntStream.range(1, vector.length).mapToObj(q::getColumn).toArray(double[][]::new);
    }

    private static double dot(double[] a, double[] b) {
      double sum = 0;
      for (int i = 0; i < a.length; i++) {
        sum += a[i] * b[i];
      }
      return sum;
    }
  }
}
