package fieldcal.app.compare;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Observations;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/** What one kick determines of the cameras' offsets; its own position, direction, speed and time are eliminated. */
final class OffsetTerm {
  /** A column of which less than this share remains after projection onto the others depends on them. */
  private static final double DEPENDENT = 1e-6;

  /** Directions in which a kick's own parameters move its path. */
  private static final int OWN = 7;

  private final RealMatrix normal;
  private final RealVector right;
  private final int[] slotsSeen;

  private OffsetTerm(RealMatrix normal, RealVector right, int[] slotsSeen) {
    this.normal = normal;
    this.right = right;
    this.slotsSeen = slotsSeen;
  }

  static OffsetTerm of(KickResiduals kick, List<Integer> cameras) {
    Observations seen = kick.kick().observations();
    BallTrajectory path = kick.after();
    int[] rows = rows(kick, cameras);
    double[][] own = new double[OWN][2 * rows.length];
    double[][] offsets = new double[2 * cameras.size()][2 * rows.length];
    double[] residuals = new double[2 * rows.length];
    BallState start = path.stateAt(path.kickTime());
    BallState last = rows.length == 0 ? start : path.stateAt(seen.time(rows[rows.length - 1]));
    double towards = Math.atan2(last.y() - start.y(), last.x() - start.x());
    for (int i = 0; i < rows.length; i++) {
      double time = seen.time(rows[i]);
      BallState ball = path.stateAt(time);
      own(ball, start, Math.max(0, time - path.kickTime()), towards, own, i);
      int slot = cameras.indexOf(seen.camera(rows[i]));
      offsets[2 * slot][2 * i] = 1;
      offsets[2 * slot + 1][2 * i + 1] = 1;
      // What the causes of the extended model shift reports by is not taken out: an offset may bear
      // another name, such as that of a wrong height of the ball.
      residuals[2 * i] = seen.x(rows[i]) - ball.x();
      residuals[2 * i + 1] = seen.y(rows[i]) - ball.y();
    }
    orthogonal(own);
    for (double[] column : offsets) {
      Arrays.stream(own).forEach(unit -> subtract(column, unit));
    }
    int[] slots =
        Arrays.stream(rows).map(r -> cameras.indexOf(seen.camera(r))).distinct().toArray();
    return new OffsetTerm(
        products(offsets),
        new ArrayRealVector(Arrays.stream(offsets).mapToDouble(c -> dot(c, residuals)).toArray()),
        slots);
  }

  /** Detections that took part, of these cameras, of a ball on the ground. */
  private static int[] rows(KickResiduals kick, List<Integer> cameras) {
    Observations seen = kick.kick().observations();
    return IntStream.range(0, seen.size())
        .filter(i -> kick.used()[i] && cameras.contains(seen.camera(i)))
        .filter(i -> kick.after().stateAt(seen.time(i)).z() <= 0)
        .toArray();
  }

  /** How the place moves with the kick's own position, direction, speed and time; speed makes the path longer in proportion, or with the time, in part of each law, and the height of a chip moves what comes after it. */
  private static void own(
      BallState s, BallState start, double since, double towards, double[][] own, int i) {
    double dx = s.x() - start.x();
    double dy = s.y() - start.y();
    double after = since > 0 ? 1 : 0;
    double ux = Math.cos(towards);
    double uy = Math.sin(towards);
    double[] x = {1, 0, dx, -dy, s.vx(), since * ux, after * ux};
    double[] y = {0, 1, dy, dx, s.vy(), since * uy, after * uy};
    for (int k = 0; k < own.length; k++) {
      own[k][2 * i] = x[k];
      own[k][2 * i + 1] = y[k];
    }
  }

  /** Makes columns orthogonal and of length 1, one that depends on those before zero. */
  private static void orthogonal(double[][] columns) {
    for (int k = 0; k < columns.length; k++) {
      double before = Math.sqrt(dot(columns[k], columns[k]));
      for (int j = 0; j < k; j++) {
        subtract(columns[k], columns[j]);
      }
      double left = Math.sqrt(dot(columns[k], columns[k]));
      double factor = left > DEPENDENT * before ? 1 / left : 0;
      for (int i = 0; i < columns[k].length; i++) {
        columns[k][i] *= factor;
      }
    }
  }

  private static void subtract(double[] from, double[] unit) {
    double share = dot(from, unit);
    for (int i = 0; i < from.length; i++) {
      from[i] -= share * unit[i];
    }
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  private static RealMatrix products(double[][] columns) {
    RealMatrix all = new Array2DRowRealMatrix(columns.length, columns.length);
    for (int a = 0; a < columns.length; a++) {
      for (int b = 0; b < columns.length; b++) {
        all.setEntry(a, b, dot(columns[a], columns[b]));
      }
    }
    return all;
  }

  /** How many cameras saw the ball on the ground. */
  int camerasSeen() {
    return slotsSeen.length;
  }

  int[] slotsSeen() {
    return slotsSeen.clone();
  }

  /** Whether a camera, by its place in the list, saw the ball on the ground. */
  boolean saw(int slot) {
    return Arrays.stream(slotsSeen).anyMatch(s -> s == slot);
  }

  /** Coefficients of the normal equations. */
  RealMatrix normal() {
    return normal;
  }

  /** Their right-hand side, m. */
  RealVector right() {
    return right;
  }
}
