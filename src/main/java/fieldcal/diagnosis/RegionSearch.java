package fieldcal.diagnosis;

import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.motion.WornRegion;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.RealMatrix;

/**
 * Looks for the rectangle of carpet whose friction differs: the score of every rectangle on a coarse grid from those of its cells, then the edges of the best moved in smaller and
 * smaller steps.
 */
final class RegionSearch {
  /** Size of a cell, m. */
  private static final double CELL = 1;

  /** Last step of an edge, m. */
  private static final double FINEST = 0.06;

  /** What freely chosen edges cost in evidence: some thousand rectangles, and four numbers known to a tenth of their range. */
  static final double PRICE = 14;

  /** Smallest side of a region, m. */
  private static final double SMALLEST = 0.3;

  static final int EDGES = 4;

  private final ScoreFrame frame;

  RegionSearch(ScoreFrame frame) {
    this.frame = frame;
  }

  /** The best rectangle and the best half or quarter of the field, their evidence with the price of having been looked for taken off; those above the least. */
  List<Score> best(double least) {
    double[] box = box();
    List<Score> found = new ArrayList<>();
    Score any = anywhere(box, least);
    if (any != null) {
      found.add(any);
    }
    Score part = null;
    for (Chart chart : parts(box)) {
      Score s = frame.score(chart);
      part = part == null || s.gain() > part.gain() ? s : part;
    }
    if (part != null && part.evidence() - PRICE > least) {
      found.add(priced(part));
    }
    return found;
  }

  /** Halves and quarters, which meet at the centre: as fields are laid out and worn. Of two halves one says what the other does. */
  private static List<Chart> parts(double[] box) {
    double left = Math.min(box[0], -SMALLEST);
    double right = Math.max(box[1], SMALLEST);
    double low = Math.min(box[2], -SMALLEST);
    double high = Math.max(box[3], SMALLEST);
    return List.of(
        chart(left, 0, low, high),
        chart(left, right, low, 0),
        chart(left, 0, low, 0),
        chart(left, 0, 0, high),
        chart(0, right, low, 0),
        chart(0, right, 0, high));
  }

  private static Score priced(Score s) {
    return new Score(s.chart(), false, s.gain(), s.evidence() - PRICE, s.coordinates(), 0);
  }

  private double[] box() {
    double[] box = {Double.MAX_VALUE, -Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE};
    for (int k = 0; k < frame.kicks(); k++) {
      double[] one = frame.extent(k);
      box[0] = Math.min(box[0], one[0]);
      box[1] = Math.max(box[1], one[1]);
      box[2] = Math.min(box[2], one[2]);
      box[3] = Math.max(box[3], one[3]);
    }
    return box;
  }

  private Score anywhere(double[] box, double least) {
    int nx = Math.max(1, (int) Math.ceil((box[1] - box[0]) / CELL));
    int ny = Math.max(1, (int) Math.ceil((box[3] - box[2]) / CELL));
    if (nx * ny > 400 || nx * ny < 2) {
      return null;
    }
    Score coarse = coarse(box, nx, ny);
    return coarse == null || coarse.evidence() - PRICE < least ? null : refined(coarse);
  }

  private Score coarse(double[] box, int nx, int ny) {
    Cell[][] cells = new Cell[frame.kicks()][];
    IntStream.range(0, cells.length).parallel().forEach(k -> cells[k] = cellsOf(k, box, nx, ny));
    Score best = null;
    for (int i0 = 0; i0 < nx; i0++) {
      for (int i1 = i0 + 1; i1 <= nx; i1++) {
        for (int j0 = 0; j0 < ny; j0++) {
          for (int j1 = j0 + 1; j1 <= ny; j1++) {
            if ((i1 - i0) * (j1 - j0) * 2 > nx * ny + nx) {
              // A large region that is worn is a small one that is not.
              continue;
            }
            Score s = sum(cells, box, i0, i1, j0, j1);
            if (s != null && (best == null || s.gain() > best.gain())) {
              best = s;
            }
          }
        }
      }
    }
    return best;
  }

  private record Cell(int i, int j, double[] withShared, double score, double[] information) {}

  /** The cells that a kick crosses, with their products with each other. */
  private Cell[] cellsOf(int kick, double[] box, int nx, int ny) {
    boolean[] crossed = new boolean[nx * ny];
    ExtendedTrajectory path = frame.path(kick);
    double[] at = new double[3];
    for (double t = path.kickTime();
        t < Math.min(path.restTime(), frame.lastSeen(kick));
        t += 0.02) {
      path.positionAt(t, at);
      int i = (int) Math.floor((at[0] - box[0]) / CELL);
      int j = (int) Math.floor((at[1] - box[2]) / CELL);
      if (i >= 0 && i < nx && j >= 0 && j < ny) {
        crossed[i * ny + j] = true;
      }
    }
    List<int[]> cells = new ArrayList<>();
    List<Chart> charts = new ArrayList<>();
    for (int c = 0; c < crossed.length; c++) {
      if (crossed[c]) {
        int i = c / ny;
        int j = c % ny;
        cells.add(new int[] {i, j});
        charts.add(
            chart(
                box[0] + i * CELL,
                box[0] + (i + 1) * CELL,
                box[2] + j * CELL,
                box[2] + (j + 1) * CELL));
      }
    }
    if (charts.isEmpty()) {
      return new Cell[0];
    }
    ScoreFrame.Part part = frame.part(kick, charts);
    Cell[] found = new Cell[charts.size()];
    RealMatrix information = part.information();
    for (int c = 0; c < found.length; c++) {
      found[c] =
          new Cell(
              cells.get(c)[0],
              cells.get(c)[1],
              part.withShared().getColumn(c),
              part.score()[c],
              information.getRow(c));
    }
    return found;
  }

  private Score sum(Cell[][] cells, double[] box, int i0, int i1, int j0, int j1) {
    double information = 0;
    double score = 0;
    double[] withShared = null;
    for (Cell[] kick : cells) {
      for (int a = 0; a < kick.length; a++) {
        Cell cell = kick[a];
        if (cell.i < i0 || cell.i >= i1 || cell.j < j0 || cell.j >= j1) {
          continue;
        }
        score += cell.score;
        if (withShared == null) {
          withShared = new double[cell.withShared.length];
        }
        for (int q = 0; q < withShared.length; q++) {
          withShared[q] += cell.withShared[q];
        }
        for (int b = 0; b < kick.length; b++) {
          Cell other = kick[b];
          if (other.i >= i0 && other.i < i1 && other.j >= j0 && other.j < j1) {
            information += cell.information[b];
          }
        }
      }
    }
    if (withShared == null) {
      return null;
    }
    Chart chart =
        chart(box[0] + i0 * CELL, box[0] + i1 * CELL, box[2] + j0 * CELL, box[2] + j1 * CELL);
    return frame.combine(chart, information, withShared, score);
  }

  private Score refined(Score coarse) {
    Score best = frame.score(coarse.chart());
    for (double step = CELL / 2; step > FINEST / 2; step /= 2) {
      boolean improved = true;
      for (int round = 0; round < 3 && improved; round++) {
        improved = false;
        for (Chart moved : moved(best.chart(), step)) {
          Score s = frame.score(moved);
          if (s.gain() > best.gain()) {
            best = s;
            improved = true;
          }
        }
      }
    }
    return priced(best);
  }

  /** The same region with one edge moved, in all ways. */
  private static List<Chart> moved(Chart region, double step) {
    List<Chart> all = new ArrayList<>();
    for (double d : new double[] {-step, step}) {
      for (int edge = 0; edge < EDGES; edge++) {
        moved(region, edge, d).ifPresent(all::add);
      }
    }
    return all;
  }

  /**
   * The same region with one edge moved.
   *
   * @param edge 0 to 3: least x, largest x, least y, largest y
   * @return empty when it would be too small
   */
  static Optional<Chart> moved(Chart region, int edge, double step) {
    double[] e = edges(region);
    e[edge] += step;
    return chart(e);
  }

  /** The same region with edges that are fitted, too: their coordinates are where they are, m, after the one of the change. */
  static Chart withFreeEdges(Chart region) {
    return Chart.of(
        region.template(), "change", "region_x0", "region_x1", "region_y0", "region_y1");
  }

  /** Where the edges of a region are, m: least x, largest x, least y, largest y. */
  static double[] edges(Chart region) {
    WornRegion r = (WornRegion) region.template();
    return new double[] {r.x0(), r.x1(), r.y0(), r.y1()};
  }

  /** A region of given edges; empty when it would be too small. */
  static Optional<Chart> chart(double[] edges) {
    boolean large = edges[1] - edges[0] >= SMALLEST && edges[3] - edges[2] >= SMALLEST;
    return large ? Optional.of(chart(edges[0], edges[1], edges[2], edges[3])) : Optional.empty();
  }

  private static Chart chart(double x0, double x1, double y0, double y1) {
    return Chart.of(new WornRegion(0, x0, x1, y0, y1));
  }
}
