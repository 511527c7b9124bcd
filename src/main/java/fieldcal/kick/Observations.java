package fieldcal.kick;

import java.util.Arrays;

/**
 * Detections of one ball by any number of cameras, in order of time; immutable.
 *
 * <p>Positions are as the camera reported them, on the plane of a resting ball's centre, field frame. Stored as columns because
 * the fit runs over them thousands of times.
 */
public final class Observations {
  private final double[] time;
  private final double[] x;
  private final double[] y;
  private final double[] pixelX;
  private final double[] pixelY;
  private final int[] camera;

  private Observations(Builder b, Integer[] order) {
    int n = order.length;
    time = new double[n];
    x = new double[n];
    y = new double[n];
    pixelX = new double[n];
    pixelY = new double[n];
    camera = new int[n];
    for (int i = 0; i < n; i++) {
      int from = order[i];
      time[i] = b.time[from];
      x[i] = b.x[from];
      y[i] = b.y[from];
      pixelX[i] = b.pixelX[from];
      pixelY[i] = b.pixelY[from];
      camera[i] = b.camera[from];
    }
  }

  /**
   * How many detections there are.
   *
   * @return count, 0 or more
   */
  public int size() {
    return time.length;
  }

  /**
   * When detection {@code i} was captured.
   *
   * @param i index, 0 to size − 1
   * @return s since the recording's epoch
   */
  public double time(int i) {
    return time[i];
  }

  /**
   * Reported position.
   *
   * @param i index, 0 to size − 1
   * @return x, m
   */
  public double x(int i) {
    return x[i];
  }

  /**
   * Reported position.
   *
   * @param i index, 0 to size − 1
   * @return y, m
   */
  public double y(int i) {
    return y[i];
  }

  /**
   * Column in the camera's image.
   *
   * @param i index, 0 to size − 1
   * @return pixels; NaN where the source omits it, and often 0 where the source does not know it
   */
  public double pixelX(int i) {
    return pixelX[i];
  }

  /**
   * Row in the camera's image.
   *
   * @param i index, 0 to size − 1
   * @return pixels; NaN where the source omits it, and often 0 where the source does not know it
   */
  public double pixelY(int i) {
    return pixelY[i];
  }

  /**
   * Which camera saw it.
   *
   * @param i index, 0 to size − 1
   * @return camera id
   */
  public int camera(int i) {
    return camera[i];
  }

  /**
   * The cameras that saw anything.
   *
   * @return ids, ascending, each once
   */
  public int[] cameras() {
    return Arrays.stream(camera).distinct().sorted().toArray();
  }

  /** How many detections there are from a time on. */
  int count(double from) {
    int n = 0;
    while (n < size() && time[size() - 1 - n] >= from) {
      n++;
    }
    return n;
  }

  /**
   * The detections of a time span.
   *
   * @param from s, inclusive
   * @param to s, inclusive
   * @return those with {@code from <= time <= to}
   */
  public Observations between(double from, double to) {
    Builder b = new Builder();
    for (int i = 0; i < size(); i++) {
      if (time[i] >= from && time[i] <= to) {
        b.add(time[i], camera[i], x[i], y[i], pixelX[i], pixelY[i]);
      }
    }
    return b.build();
  }

  /** Collects detections in any order. */
  public static final class Builder {
    private double[] time = new double[256];
    private double[] x = new double[256];
    private double[] y = new double[256];
    private double[] pixelX = new double[256];
    private double[] pixelY = new double[256];
    private int[] camera = new int[256];
    private int size;

    /** Starts empty. */
    public Builder() {}

    /**
     * Adds a detection.
     *
     * @param t s since the recording's epoch
     * @param cameraId id of the camera
     * @param px reported x, m
     * @param py reported y, m
     * @param u column in the image, pixels
     * @param v row in the image, pixels
     * @return this
     * @throws IllegalArgumentException when time or position is not finite
     */
    public Builder add(double t, int cameraId, double px, double py, double u, double v) {
      if (!Double.isFinite(t) || !Double.isFinite(px) || !Double.isFinite(py)) {
        throw new IllegalArgumentException(
            "observation not finite: t=" + t + " x=" + px + " y=" + py);
      }
      if (size == time.length) {
        grow();
      }
      time[size] = t;
      x[size] = px;
      y[size] = py;
      pixelX[size] = u;
      pixelY[size] = v;
      camera[size++] = cameraId;
      return this;
    }

    /** Removes a camera's detections from a time on. */
    void drop(int cameraId, double from) {
      int kept = 0;
      for (int i = 0; i < size; i++) {
        if (camera[i] == cameraId && time[i] >= from) {
          continue;
        }
        time[kept] = time[i];
        x[kept] = x[i];
        y[kept] = y[i];
        pixelX[kept] = pixelX[i];
        pixelY[kept] = pixelY[i];
        camera[kept++] = camera[i];
      }
      size = kept;
    }

    private void grow() {
      int n = 2 * size;
      time = Arrays.copyOf(time, n);
      x = Arrays.copyOf(x, n);
      y = Arrays.copyOf(y, n);
      pixelX = Arrays.copyOf(pixelX, n);
      pixelY = Arrays.copyOf(pixelY, n);
      camera = Arrays.copyOf(camera, n);
    }

    /**
     * Sorts by time, then by camera, and builds.
     *
     * @return the observations added so far
     */
    public Observations build() {
      Integer[] order = new Integer[size];
      Arrays.setAll(order, i -> i);
      Arrays.sort(
          order,
          (a, b) -> {
            int c = Double.compare(time[a], time[b]);
            return c != 0 ? c : Integer.compare(camera[a], camera[b]);
          });
      return new Observations(this, order);
    }
  }
}
