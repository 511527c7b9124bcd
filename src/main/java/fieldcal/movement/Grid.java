package fieldcal.movement;

import java.io.Serializable;
import java.util.Arrays;
import java.util.stream.IntStream;

/** A two-dimensional histogram of cells of equal size. Two grids with the same cells merge exactly. Mutable, for one thread. */
public final class Grid {
  private final double minX;
  private final double minY;
  private final double widthX;
  private final double widthY;
  private final int columns;
  private final int rows;
  private final long[] counts;
  private long outside;

  /**
   * An empty grid.
   *
   * @param minX lower end in x
   * @param widthX width of a cell in x
   * @param columns cells in x
   * @param minY lower end in y
   * @param widthY width of a cell in y
   * @param rows cells in y
   * @throws IllegalArgumentException when a width or a number of cells is not positive
   */
  public Grid(double minX, double widthX, int columns, double minY, double widthY, int rows) {
    if (!(widthX > 0 && widthY > 0) || columns < 1 || rows < 1) {
      throw new IllegalArgumentException(
          "cells need a positive size and number: %s × %s, %d × %d"
              .formatted(widthX, widthY, columns, rows));
    }
    this.minX = minX;
    this.minY = minY;
    this.widthX = widthX;
    this.widthY = widthY;
    this.columns = columns;
    this.rows = rows;
    counts = new long[columns * rows];
  }

  /** An empty grid about zero with square cells. */
  static Grid centred(double width, int cells) {
    double min = -0.5 * width * cells;
    return new Grid(min, width, cells, min, width, cells);
  }

  /**
   * Counts a point. All points outside of the cells are counted together; NaN is not counted.
   *
   * @param x coordinate
   * @param y coordinate
   * @param weight how many times it counts
   */
  public void add(double x, double y, long weight) {
    double column = Math.floor((x - minX) / widthX);
    double row = Math.floor((y - minY) / widthY);
    if (column >= 0 && column < columns && row >= 0 && row < rows) {
      counts[(int) row * columns + (int) column] += weight;
    } else if (column == column && row == row) {
      outside += weight;
    }
  }

  /**
   * Adds all that another grid has counted.
   *
   * @param other of the same cells; stays as it is
   * @throws IllegalArgumentException when its cells differ
   */
  public void merge(Grid other) {
    boolean same =
        other.minX == minX
            && other.minY == minY
            && other.widthX == widthX
            && other.widthY == widthY
            && other.columns == columns
            && other.rows == rows;
    if (!same) {
      throw new IllegalArgumentException("the cells of the two grids differ");
    }
    for (int i = 0; i < counts.length; i++) {
      counts[i] += other.counts[i];
    }
    outside += other.outside;
  }

  /** Reports each cell that is not empty, and finally the count outside. */
  void cells(MovementCells.Sink sink) {
    for (int i = 0; i < counts.length; i++) {
      if (counts[i] > 0) {
        sink.cell(i, centreX(i % columns), centreY(i / columns), counts[i]);
      }
    }
    if (outside > 0) {
      sink.cell(counts.length, Double.NaN, Double.NaN, outside);
    }
  }

  /** Adds what {@link #cells} reported; false when there is no such cell. */
  boolean addCell(int cell, long count) {
    if (cell < 0 || cell > counts.length || count < 0) {
      return false;
    }
    if (cell == counts.length) {
      outside += count;
    } else {
      counts[cell] += count;
    }
    return true;
  }

  /** Forgets everything. */
  public void clear() {
    Arrays.fill(counts, 0);
    outside = 0;
  }

  /**
   * The count of a cell.
   *
   * @param column 0 … {@link #columns} − 1
   * @param row 0 … {@link #rows} − 1
   * @return the sum of weights
   */
  public long count(int column, int row) {
    return counts[row * columns + column];
  }

  /**
   * The count outside of all cells.
   *
   * @return the sum of weights
   */
  public long outside() {
    return outside;
  }

  /**
   * The count of all cells together.
   *
   * @return the sum of weights, without what lay outside
   */
  public long total() {
    return Arrays.stream(counts).sum();
  }

  /**
   * Number of cells in x.
   *
   * @return columns
   */
  public int columns() {
    return columns;
  }

  /**
   * Number of cells in y.
   *
   * @return rows
   */
  public int rows() {
    return rows;
  }

  /**
   * Centre of a column.
   *
   * @param column 0 … {@link #columns} − 1
   * @return in the unit of x
   */
  public double centreX(int column) {
    return minX + (column + 0.5) * widthX;
  }

  /**
   * Centre of a row.
   *
   * @param row 0 … {@link #rows} − 1
   * @return in the unit of y
   */
  public double centreY(int row) {
    return minY + (row + 0.5) * widthY;
  }

  /**
   * The cells that have counted something.
   *
   * @return by rows, in each by columns
   */
  public Occupied occupied() {
    int[] cells = IntStream.range(0, counts.length).filter(i -> counts[i] > 0).toArray();
    return new Occupied(
        widthX,
        widthY,
        Arrays.stream(cells).mapToDouble(i -> centreX(i % columns)).toArray(),
        Arrays.stream(cells).mapToDouble(i -> centreY(i / columns)).toArray(),
        Arrays.stream(cells).mapToLong(i -> counts[i]).toArray());
  }

  /**
   * Cells that have counted something; arrays of the same length, one entry for each cell.
   *
   * @param widthX width of a cell in x, in the unit of the grid's x axis
   * @param widthY width of a cell in y, in the unit of the grid's y axis
   * @param x centres in x
   * @param y centres in y
   * @param count sums of weights
   * @serial exclude
   */
  public record Occupied(double widthX, double widthY, double[] x, double[] y, long[] count)
      implements Serializable {}
}
