package fieldcal.verdict;

import fieldcal.vision.FieldGeometry;

/**
 * The size of a field.
 *
 * @param length along x, m
 * @param width along y, m
 */
public record FieldSize(double length, double width) {
  /** Sizes that differ by less are the same, m: they are published in whole millimetres. */
  private static final double SAME = 0.005;

  /**
   * The size of a published field.
   *
   * @param geometry of vision
   * @return its size
   */
  public static FieldSize of(FieldGeometry geometry) {
    return new FieldSize(geometry.length(), geometry.width());
  }

  /**
   * Whether it is the same as another one.
   *
   * @param other to compare with
   * @return true when length and width differ by less than 5 mm
   */
  public boolean isLike(FieldSize other) {
    return Math.abs(length - other.length) < SAME && Math.abs(width - other.width) < SAME;
  }
}
