package fieldcal.effect.learned;

import fieldcal.effect.Area;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.util.MathArrays;

/**
 * Tensor product of two splines, for what depends on a place. Centred, it is made of the products of both splines' waves without the constant.
 *
 * @param x over the first number, not centred
 * @param y over the second number, not centred
 * @param centred whether the constant is left out
 */
public record Surface(Spline x, Spline y, boolean centred) implements Basis {
  static final String TYPE = "surface";

  /** A fast ball crosses several knots in one step's time: with steps half as long as those of a curve errors stay as small (tested). */
  private static final double STEPS_OF_A_CURVE = 0.5;

  /** Functions of a finer surface at most, as of a map of the carpet: more would be too many for the kicks of any session. */
  private static final int MOST_WHEN_FINER = 120;

  /**
   * Checks the splines. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one of the splines is centred
   */
  public Surface {
    if (x.centred() || y.centred()) {
      throw new IllegalArgumentException("splines of a surface must not be centred on their own");
    }
  }

  @Override
  public String type() {
    return TYPE;
  }

  @Override
  public int dimension() {
    return 2;
  }

  @Override
  public int size() {
    return x.knots() * y.knots() - (centred ? 1 : 0);
  }

  @Override
  public double resolution(int axis) {
    return STEPS_OF_A_CURVE * (axis == 0 ? x.resolution(0) : y.resolution(0));
  }

  @Override
  public void values(double u, double v, double[] values) {
    double[] alongX = new double[x.knots()];
    double[] alongY = new double[y.knots()];
    x.hats(u, alongX);
    y.hats(v, alongY);
    double[] ofX = centred ? waves(x, alongX) : alongX;
    double[] ofY = centred ? waves(y, alongY) : alongY;
    int skipped = centred ? 1 : 0;
    for (int n = skipped; n < ofX.length * ofY.length; n++) {
      values[n - skipped] = ofX[n / ofY.length] * ofY[n % ofY.length];
    }
  }

  /** The places around which any of the functions with a coefficient is not zero; empty where there is none, or all reach everywhere. */
  Optional<Area> support(double[] coefficients) {
    Area area = null;
    for (int n = 0; !centred && n < coefficients.length; n++) {
      if (coefficients[n] != 0) {
        double[] alongX = x.support(n / y.knots());
        double[] alongY = y.support(n % y.knots());
        Area one = new Area(alongX[0], alongX[1], alongY[0], alongY[1]);
        area = area == null ? one : area.and(one);
      }
    }
    return Optional.ofNullable(area);
  }

  private static double[] waves(Spline spline, double[] hats) {
    double[] waves = new double[hats.length];
    for (int j = 0; j < waves.length; j++) {
      for (int i = 0; i < hats.length; i++) {
        waves[j] += spline.cosine(j, i) * hats[i];
      }
    }
    return waves;
  }

  @Override
  public Optional<Surface> finer() {
    return x.finer()
        .flatMap(fx -> y.finer().map(fy -> new Surface(fx, fy, centred)))
        .filter(s -> s.size() <= MOST_WHEN_FINER);
  }

  @Override
  public double[] inFiner(double[] coefficients, int from) {
    RealMatrix control = new Array2DRowRealMatrix(control(coefficients, from));
    RealMatrix finer = ofColumns(ofRows(control, Spline::halved), Spline::halved);
    if (!centred) {
      return MathArrays.concatenate(finer.getData());
    }
    RealMatrix waves = ofColumns(ofRows(finer, Spline::amplitudes), Spline::amplitudes);
    double[] all = MathArrays.concatenate(waves.getData());
    return Arrays.copyOfRange(all, 1, all.length);
  }

  private static RealMatrix ofColumns(RealMatrix m, UnaryOperator<double[]> change) {
    return ofRows(m.transpose(), change).transpose();
  }

  private static RealMatrix ofRows(RealMatrix m, UnaryOperator<double[]> change) {
    double[][] changed = Arrays.stream(m.getData()).map(change).toArray(double[][]::new);
    return new Array2DRowRealMatrix(changed);
  }

  @Override
  public Relief curve(double[] coefficients, int from) {
    return new Cells(this, cubics(control(coefficients, from)));
  }

  /** The control values with one more at each end: folding is mirroring them. */
  private double[][] control(double[] coefficients, int from) {
    int nx = x.knots();
    int ny = y.knots();
    double[][] control = new double[nx + 2][ny + 2];
    if (centred) {
      addWaves(coefficients, from, control);
    } else {
      for (int i = 0; i < nx; i++) {
        System.arraycopy(coefficients, from + i * ny, control[i + 1], 1, ny);
      }
    }
    for (int i = 1; i <= nx; i++) {
      control[i][0] = control[i][2];
      control[i][ny + 1] = control[i][ny - 1];
    }
    control[0] = control[2];
    control[nx + 1] = control[nx - 1];
    return control;
  }

  /** The sums of all waves at the knots: first along y, then along x. */
  private void addWaves(double[] coefficients, int from, double[][] control) {
    int nx = x.knots();
    int ny = y.knots();
    double[] alongY = new double[ny];
    for (int m = 0; m < nx; m++) {
      Arrays.fill(alongY, 0);
      // The first wave of all is the constant, which has no coefficient.
      for (int n = m == 0 ? 1 : 0; n < ny; n++) {
        double c = coefficients[from + m * ny + n - 1];
        for (int j = 0; j < ny; j++) {
          alongY[j] += c * y.cosine(n, j);
        }
      }
      for (int i = 0; i < nx; i++) {
        double alongX = x.cosine(m, i);
        for (int j = 0; j < ny; j++) {
          control[i + 1][j + 1] += alongX * alongY[j];
        }
      }
    }
  }

  /** Sixteen coefficients for each cell, of the powers of its shares along x and y. */
  private double[] cubics(double[][] control) {
    int cellsX = x.knots() - 1;
    int cellsY = y.knots() - 1;
    double[][] ofY = new double[control.length][];
    for (int i = 0; i < control.length; i++) {
      ofY[i] = Spline.cubics(control[i]);
    }
    double[] cubics = new double[16 * cellsX * cellsY];
    for (int i = 0; i < cellsX; i++) {
      for (int c = 0; c < 4 * cellsY; c++) {
        int at = 16 * (i * cellsY + c / 4) + c % 4;
        Spline.cubic(ofY[i][c], ofY[i + 1][c], ofY[i + 2][c], ofY[i + 3][c], cubics, at, 4);
      }
    }
    return cubics;
  }

  /** A curve over a place, with its slopes. Immutable. */
  interface Relief extends Curve {
    /**
     * Adds a multiple of how much it rises along x and along y; 0 beyond the ends of the ranges, where it is constant.
     *
     * @param u first number
     * @param v second number
     * @param factor by which the slopes are multiplied, which are in the unit of the coefficients over that of the number
     * @param sum to whose first two numbers they are added
     */
    void addGradient(double u, double v, double factor, double[] sum);
  }

  /** The cells between four knots, each with sixteen coefficients of the powers of its shares. */
  private record Cells(Surface of, double[] cubics) implements Relief {
    @Override
    public double at(double u, double v) {
      double p = of.x.position(u);
      double q = of.y.position(v);
      int i = of.x.interval(p);
      int j = of.y.interval(q);
      int cell = first(i, j);
      double s = p - i;
      double t = q - j;
      return along(cell, t)
          + s * (along(cell + 4, t) + s * (along(cell + 8, t) + s * along(cell + 12, t)));
    }

    @Override
    public void addGradient(double u, double v, double factor, double[] sum) {
      double p = of.x.position(u);
      double q = of.y.position(v);
      int i = of.x.interval(p);
      int j = of.y.interval(q);
      int cell = first(i, j);
      double s = p - i;
      double t = q - j;
      double ofX = along(cell + 4, t) + s * (2 * along(cell + 8, t) + s * 3 * along(cell + 12, t));
      double ofY =
          slope(cell, t)
              + s * (slope(cell + 4, t) + s * (slope(cell + 8, t) + s * slope(cell + 12, t)));
      sum[0] += factor * ofX * of.x.perUnit();
      sum[1] += factor * ofY * of.y.perUnit();
    }

    private int first(int i, int j) {
      return 16 * (i * (of.y.knots() - 1) + j);
    }

    /** The cubic along y that belongs to one power of the share along x. */
    private double along(int n, double t) {
      return cubics[n] + t * (cubics[n + 1] + t * (cubics[n + 2] + t * cubics[n + 3]));
    }

    /** How it rises along y. */
    private double slope(int n, double t) {
      return cubics[n + 1] + t * (2 * cubics[n + 2] + t * 3 * cubics[n + 3]);
    }
  }
}
