package fieldcal.app.report;

/**
 * What one camera saw of one kick, in the order of time; columns of equal length. The arrays are the report's own:
 * do not change them.
 *
 * @param camera number of the camera
 * @param t time since the kick, s; negative while the ball still rests
 * @param x where vision saw the ball (for a ball in the air: where its ray meets the ground), m
 * @param y the same, m
 * @param residualXMm seen minus predicted for this camera and time, mm; NaN if there is no fit
 * @param residualYMm the same in y, mm
 * @param height height that the ray implies in the vertical plane of the fitted path, m; an empty array if not known
 * @param used false for an outlier that the fit put aside
 */
public record Observations(
    int camera,
    @Rounded(4) double[] t,
    @Rounded(4) double[] x,
    @Rounded(4) double[] y,
    @Rounded(2) double[] residualXMm,
    @Rounded(2) double[] residualYMm,
    @Rounded(3) double[] height,
    boolean[] used) {

  /**
   * Copies the arrays.
   *
   * @throws IllegalArgumentException if the lengths differ
   */
  public Observations {
    Columns.requireLength("x", t.length, x.length);
    Columns.requireLength("y", t.length, y.length);
    Columns.requireLength("residualXMm", t.length, residualXMm.length);
    Columns.requireLength("residualYMm", t.length, residualYMm.length);
    Columns.requireLength("used", t.length, used.length);
    if (height.length > 0) {
      Columns.requireLength("height", t.length, height.length);
    }
    t = t.clone();
    x = x.clone();
    y = y.clone();
    residualXMm = residualXMm.clone();
    residualYMm = residualYMm.clone();
    height = height.clone();
    used = used.clone();
  }

  /**
   * How many there are.
   *
   * @return the length of every column
   */
  public int size() {
    return t.length;
  }
}
