package fieldcal.fit;

import fieldcal.fit.SharedView.Difference;
import fieldcal.kick.Kick;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * First estimate of what each camera adds to every position, from balls that two cameras see at once.
 *
 * <p>A ball in the air is projected to different places by two cameras, so only the rest before a kick counts, and stretches of a kick in which the two cameras stay equally far apart: there the ball is
 * on the ground. Cameras that share no such ball are not compared. The joint fit refines the offsets; they are needed before, because with several centimetres of disagreement a flat kick can look like a
 * chip.
 */
public final class OverlapOffsets {
  private OverlapOffsets() {}

  /** Two cameras, the one with the smaller id first. */
  record Pair(int a, int b) {}

  /**
   * Puts the offsets into the views; cameras that share no ball on the ground with another keep none.
   *
   * @param kicks of one recording or several with the same cameras
   * @param views the cameras
   * @return the views with offsets whose mean is zero
   */
  public static CameraViews estimate(List<Kick> kicks, CameraViews views) {
    return estimateFrom(kicks.stream().map(kick -> compare(kick, views)).toList(), views);
  }

  /** What each pair of cameras saw of a kick at the same time. */
  static Map<Pair, SharedView> compare(Kick kick, CameraViews views) {
    Map<Pair, SharedView> shared = new LinkedHashMap<>();
    for (Pair pair : pairs(kick.observations().cameras())) {
      shared.put(pair, SharedView.of(kick, views.get(pair.a), views.get(pair.b)));
    }
    return shared;
  }

  /** The same from what each pair of cameras saw of each kick; only the noise of the views matters. */
  static CameraViews estimateFrom(List<Map<Pair, SharedView>> kicks, CameraViews views) {
    Map<Pair, List<Difference>> found = new LinkedHashMap<>();
    for (Map<Pair, SharedView> kick : kicks) {
      kick.forEach(
          (pair, shared) -> {
            List<Difference> differences = found.computeIfAbsent(pair, p -> new ArrayList<>());
            double noise = Math.hypot(views.get(pair.a).noise(), views.get(pair.b).noise());
            shared.atRest().ifPresent(differences::add);
            shared.onTheGround(noise).ifPresent(differences::add);
          });
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

  private static CameraViews solve(Map<Pair, List<Difference>> found, CameraViews views) {
    List<Integer> ids = views.all().stream().map(CameraView::id).toList();
    Map<Pair, List<Difference>> compared = new LinkedHashMap<>(found);
    compared
        .entrySet()
        .removeIf(
            e ->
                e.getValue().isEmpty()
                    || !ids.contains(e.getKey().a)
                    || !ids.contains(e.getKey().b));
    if (compared.isEmpty()) {
      return views;
    }
    Array2DRowRealMatrix a = new Array2DRowRealMatrix(compared.size(), ids.size());
    ArrayRealVector bx = new ArrayRealVector(compared.size());
    ArrayRealVector by = new ArrayRealVector(compared.size());
    int row = 0;
    for (Map.Entry<Pair, List<Difference>> entry : compared.entrySet()) {
      List<Difference> differences = entry.getValue();
      double weight = Math.sqrt(differences.stream().mapToDouble(Difference::weight).sum());
      a.setEntry(row, ids.indexOf(entry.getKey().a), -weight);
      a.setEntry(row, ids.indexOf(entry.getKey().b), weight);
      bx.setEntry(row, weight * weightedMedian(differences, Difference::x));
      by.setEntry(row, weight * weightedMedian(differences, Difference::y));
      row++;
    }
    // The smallest solution: its mean is zero within each group of cameras that see balls in
    // common.
    SingularValueDecomposition svd = new SingularValueDecomposition(a);
    RealVector x = svd.getSolver().solve(bx);
    RealVector y = svd.getSolver().solve(by);
    return views.map(
        v -> v.withOffset(x.getEntry(ids.indexOf(v.id())), y.getEntry(ids.indexOf(v.id()))));
  }

  /** The first value with at least half of all weight up to it. */
  private static double weightedMedian(
      List<Difference> differences, ToDoubleFunction<Difference> coordinate) {
    List<Difference> sorted = new ArrayList<>(differences);
    sorted.sort(Comparator.comparingDouble(coordinate));
    double half = 0.5 * sorted.stream().mapToDouble(Difference::weight).sum();
    double below = 0;
    for (Difference d : sorted) {
      below += d.weight();
      if (below >= half) {
        return coordinate.applyAsDouble(d);
      }
    }
    return coordinate.applyAsDouble(sorted.get(sorted.size() - 1));
  }
}
