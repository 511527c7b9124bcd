package fieldcal.fit;

import fieldcal.kick.Kick;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * First estimate of what each camera adds to every position, from balls that two cameras see at once.
 *
 * <p>A ball in the air is projected to different places by two cameras, so only the rest before a kick and the last part of a
 * kick count, when the ball is on the ground; medians keep those chips out that are not. The joint fit refines the offsets; they
 * are needed before, because with several centimetres of disagreement a flat kick can look like a chip.
 */
public final class OverlapOffsets {
  /** With so many kicks seen at rest by both cameras, those alone decide. */
  private static final int ENOUGH_AT_REST = 3;

  private OverlapOffsets() {}

  private record Pair(int a, int b) {}

  private static final class Differences {
    final List<double[]> resting = new ArrayList<>();
    final List<double[]> late = new ArrayList<>();

    double[] median() {
      List<double[]> chosen = new ArrayList<>(resting);
      if (resting.size() < ENOUGH_AT_REST) {
        chosen.addAll(late);
      }
      return chosen.isEmpty() ? null : medianOf(chosen);
    }
  }

  /**
   * Puts the offsets into the views; cameras that share no ball with another keep none.
   *
   * @param kicks of one recording or several with the same cameras
   * @param views the cameras
   * @return the views with offsets whose mean is zero
   */
  public static CameraViews estimate(List<Kick> kicks, CameraViews views) {
    Map<Integer, Map<Integer, Differences>> found = new TreeMap<>();
    for (Kick kick : kicks) {
      Observations seen = kick.observations();
      double late = kick.time() + 0.6 * (kick.endTime() - kick.time());
      for (Pair pair : pairs(seen.cameras())) {
        Differences d =
            found
                .computeIfAbsent(pair.a, a -> new TreeMap<>())
                .computeIfAbsent(pair.b, b -> new Differences());
        compare(seen, pair, Double.NEGATIVE_INFINITY, kick.time() - 0.02, d.resting);
        compare(seen, pair, late, Double.POSITIVE_INFINITY, d.late);
      }
    }
    return solve(found, views);
  }

  private static List<Pair> pairs(int[] cameras) {
    List<Pair> pairs = new ArrayList<>();
    for (int i = 0; i < cameras.length; i++) {
      for (int j = i + 1; j < cameras.length; j++) {
        pairs.add(new Pair(cameras[i], cameras[j]));
      }
    }
    return pairs;
  }

  /** The median of (b − a) over a kick, with a's position interpolated to the times of b. */
  private static void compare(
      Observations seen, Pair pair, double from, double to, List<double[]> medians) {
    List<double[]> differences = new ArrayList<>();
    int before = -1;
    for (int i = 0; i < seen.size(); i++) {
      if (seen.time(i) < from || seen.time(i) > to) {
        continue;
      }
      if (seen.camera(i) == pair.a) {
        before = i;
      } else if (seen.camera(i) == pair.b && before >= 0) {
        int after = i + 1;
        while (after < seen.size() && seen.camera(after) != pair.a) {
          after++;
        }
        if (after < seen.size() && seen.time(after) - seen.time(before) < 0.035) {
          double f = (seen.time(i) - seen.time(before)) / (seen.time(after) - seen.time(before));
          differences.add(
              new double[] {
                seen.x(i) - seen.x(before) - f * (seen.x(after) - seen.x(before)),
                seen.y(i) - seen.y(before) - f * (seen.y(after) - seen.y(before))
              });
        }
      }
    }
    if (differences.size() >= 5) {
      medians.add(medianOf(differences));
    }
  }

  private static double[] medianOf(List<double[]> points) {
    double[] x = points.stream().mapToDouble(p -> p[0]).sorted().toArray();
    double[] y = points.stream().mapToDouble(p -> p[1]).sorted().toArray();
    return new double[] {x[x.length / 2], y[y.length / 2]};
  }

  private static CameraViews solve(
      Map<Integer, Map<Integer, Differences>> found, CameraViews views) {
    List<Integer> ids = views.all().stream().map(CameraView::id).toList();
    List<double[]> rows = new ArrayList<>();
    found.forEach(
        (a, others) ->
            others.forEach(
                (b, d) -> {
                  double[] median = d.median();
                  if (median != null && ids.contains(a) && ids.contains(b)) {
                    rows.add(new double[] {ids.indexOf(a), ids.indexOf(b), median[0], median[1]});
                  }
                }));
    if (rows.isEmpty()) {
      return views;
    }
    Array2DRowRealMatrix a = new Array2DRowRealMatrix(rows.size(), ids.size());
    ArrayRealVector bx = new ArrayRealVector(rows.size());
    ArrayRealVector by = new ArrayRealVector(rows.size());
    for (int r = 0; r < rows.size(); r++) {
      double[] row = rows.get(r);
      a.setEntry(r, (int) row[0], -1);
      a.setEntry(r, (int) row[1], 1);
      bx.setEntry(r, row[2]);
      by.setEntry(r, row[3]);
    }
    // The smallest solution: its mean is zero within each group of cameras that see balls in
    // common.
    SingularValueDecomposition svd = new SingularValueDecomposition(a);
    RealVector x = svd.getSolver().solve(bx);
    RealVector y = svd.getSolver().solve(by);
    return views.map(
        v -> v.withOffset(x.getEntry(ids.indexOf(v.id())), y.getEntry(ids.indexOf(v.id()))));
  }
}
