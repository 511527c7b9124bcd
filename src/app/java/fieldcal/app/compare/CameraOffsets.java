package fieldcal.app.compare;

import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.KickResiduals;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * Offsets of cameras from where the extended model has the ball. The simple model's own offsets would not do, since what a ball on a sloping field does otherwise than that model says looks like cameras that disagree, always the
 * same way.
 *
 * <p>Only balls on the ground count, as one in the air is seen at another place by each camera. The errors come from what the offsets change by when a kick is left out (jackknife): what the model still lacks makes all
 * residuals of one kick wrong together, and counting detections would not see that.
 */
final class CameraOffsets {
  /** A camera is judged from at least so many kicks that another camera saw, too: fewer do not show how much they scatter. */
  private static final int FEWEST = 3;

  /** Singular values below that share of the largest belong to what no kick determines, such as a shift of all cameras together. */
  private static final double NOTHING = 1e-9;

  private final List<Integer> cameras;
  private final List<OffsetTerm> kicks = new ArrayList<>();

  private CameraOffsets(Diagnosis diagnosis, Set<Integer> wanted) {
    cameras = List.copyOf(new TreeSet<>(wanted));
    for (KickResiduals kick : diagnosis.kicks()) {
      OffsetTerm term = OffsetTerm.of(kick, cameras);
      if (term.camerasSeen() > 1) {
        kicks.add(term);
      }
    }
  }

  /**
   * One camera's offset from the mean of all.
   *
   * @param x m
   * @param y m
   * @param errorX standard error, m
   * @param errorY standard error, m
   * @param kicks that it is known from
   */
  record Offset(double x, double y, double errorX, double errorY, int kicks) {}

  /**
   * Estimates.
   *
   * @param diagnosis of one side
   * @param wanted cameras whose mean the offsets count from
   * @return by camera, those that the kicks determine; empty when they do not connect the cameras
   */
  static Map<Integer, Offset> of(Diagnosis diagnosis, Set<Integer> wanted) {
    return new CameraOffsets(diagnosis, wanted).estimated();
  }

  /** The cameras that saw a kick. */
  static Set<Integer> seen(Diagnosis diagnosis) {
    Set<Integer> seen = new TreeSet<>();
    diagnosis
        .kicks()
        .forEach(k -> Arrays.stream(k.kick().observations().cameras()).boxed().forEach(seen::add));
    return seen;
  }

  private Map<Integer, Offset> estimated() {
    Map<Integer, Offset> offsets = new TreeMap<>();
    if (kicks.size() < FEWEST || !connected(-1)) {
      return offsets;
    }
    double[] all = solved(-1);
    double[][] without = new double[kicks.size()][];
    for (int k = 0; k < without.length; k++) {
      if (!connected(k)) {
        return offsets;
      }
      without[k] = solved(k);
    }
    for (int c = 0; c < cameras.size(); c++) {
      int slot = c;
      int seen = (int) kicks.stream().filter(k -> k.saw(slot)).count();
      if (seen >= FEWEST) {
        offsets.put(
            cameras.get(c),
            new Offset(
                all[2 * c],
                all[2 * c + 1],
                jackknife(without, 2 * c),
                jackknife(without, 2 * c + 1),
                seen));
      }
    }
    return offsets;
  }

  /** Standard error from the estimates without one kick each (Tukey 1958). */
  private static double jackknife(double[][] without, int of) {
    int n = without.length;
    double mean = Arrays.stream(without).mapToDouble(v -> v[of]).average().orElseThrow();
    double squares = Arrays.stream(without).mapToDouble(v -> (v[of] - mean) * (v[of] - mean)).sum();
    return Math.sqrt((n - 1.0) / n * squares);
  }

  /** Whether the kicks but one connect all cameras. */
  private boolean connected(int but) {
    Set<Integer> reached = new TreeSet<>(Set.of(0));
    for (int before = 0; before < reached.size(); ) {
      before = reached.size();
      for (int k = 0; k < kicks.size(); k++) {
        int[] seen = kicks.get(k).slotsSeen();
        if (k != but && Arrays.stream(seen).anyMatch(reached::contains)) {
          Arrays.stream(seen).forEach(reached::add);
        }
      }
    }
    return reached.size() == cameras.size();
  }

  /** Offsets from their mean by least squares, x and y of each camera, without one kick. */
  private double[] solved(int but) {
    int n = 2 * cameras.size();
    RealMatrix normal = new Array2DRowRealMatrix(n, n);
    RealVector right = new ArrayRealVector(n);
    for (int k = 0; k < kicks.size(); k++) {
      if (k != but) {
        normal = normal.add(kicks.get(k).normal());
        right = right.add(kicks.get(k).right());
      }
    }
    double[] offsets = new SharedShiftFree(normal).solve(right).toArray();
    for (int axis = 0; axis < 2; axis++) {
      int of = axis;
      double mean =
          IntStream.range(0, n / 2).mapToDouble(c -> offsets[2 * c + of]).average().orElseThrow();
      IntStream.range(0, n / 2).forEach(c -> offsets[2 * c + of] -= mean);
    }
    return offsets;
  }

  /** Solves equations that leave a shift of all cameras open: by the smallest solution. */
  private record SharedShiftFree(RealMatrix normal) {
    RealVector solve(RealVector right) {
      SingularValueDecomposition svd = new SingularValueDecomposition(normal);
      double[] values = svd.getSingularValues();
      RealVector rotated = svd.getU().transpose().operate(right);
      for (int i = 0; i < values.length; i++) {
        boolean open = values[i] <= NOTHING * values[0];
        rotated.setEntry(i, open ? 0 : rotated.getEntry(i) / values[i]);
      }
      return svd.getV().operate(rotated);
    }
  }
}
