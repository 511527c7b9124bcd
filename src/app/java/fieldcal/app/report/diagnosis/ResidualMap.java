package fieldcal.app.report.diagnosis;

import fieldcal.app.report.Rounded;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Mean residuals over the field, one cell for each place and camera: what two cameras do in opposite ways would be nothing on average. Columns of equal length.
 *
 * @param cell side of a cell, m
 * @param camera which camera
 * @param x middle of the cell, m
 * @param y middle of the cell, m
 * @param count how many observations
 * @param beforeX mean residual of the simple model, mm
 * @param beforeY the same in y
 * @param afterX mean residual of the extended model, mm
 * @param afterY the same in y
 */
public record ResidualMap(
    double cell,
    int[] camera,
    @Rounded(2) double[] x,
    @Rounded(2) double[] y,
    int[] count,
    @Rounded(1) double[] beforeX,
    @Rounded(1) double[] beforeY,
    @Rounded(1) double[] afterX,
    @Rounded(1) double[] afterY) {
  /** Chosen: arrows every half metre can be told apart on a field of 12 m. */
  private static final double CELL = 0.5;

  /** Fewer observations in a cell show noise. */
  private static final int FEWEST = 4;

  private record Place(int camera, long column, long row) implements Comparable<Place> {
    @Override
    public int compareTo(Place other) {
      int byCamera = Integer.compare(camera, other.camera);
      int byColumn = byCamera != 0 ? byCamera : Long.compare(column, other.column);
      return byColumn != 0 ? byColumn : Long.compare(row, other.row);
    }
  }

  /** The map of some kicks, of what was used of them since the kick. */
  static ResidualMap of(List<KickResiduals> kicks) {
    Map<Place, double[]> sums = new TreeMap<>();
    for (KickResiduals k : kicks) {
      Observations o = k.kick().observations();
      for (int i = 0; i < o.size(); i++) {
        if (k.used()[i] && o.time(i) >= k.after().kickTime()) {
          long column = (long) Math.floor(o.x(i) / CELL);
          long row = (long) Math.floor(o.y(i) / CELL);
          double[] sum =
              sums.computeIfAbsent(new Place(o.camera(i), column, row), p -> new double[5]);
          sum[0]++;
          sum[1] += k.xBefore()[i];
          sum[2] += k.yBefore()[i];
          sum[3] += k.xAfter()[i];
          sum[4] += k.yAfter()[i];
        }
      }
    }
    List<Map.Entry<Place, double[]>> cells = new ArrayList<>(sums.entrySet());
    cells.removeIf(c -> c.getValue()[0] < FEWEST);
    return new ResidualMap(
        CELL,
        cells.stream().mapToInt(c -> c.getKey().camera()).toArray(),
        cells.stream().mapToDouble(c -> CELL * (c.getKey().column() + 0.5)).toArray(),
        cells.stream().mapToDouble(c -> CELL * (c.getKey().row() + 0.5)).toArray(),
        cells.stream().mapToInt(c -> (int) c.getValue()[0]).toArray(),
        mean(cells, 1),
        mean(cells, 2),
        mean(cells, 3),
        mean(cells, 4));
  }

  private static double[] mean(List<Map.Entry<Place, double[]>> cells, int column) {
    return cells.stream().mapToDouble(c -> 1000 * c.getValue()[column] / c.getValue()[0]).toArray();
  }
}
