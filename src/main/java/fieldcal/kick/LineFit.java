package fieldcal.kick;

/** Least-squares line through positions over time: where a ball was and how fast it moved. Reused, to keep the frame loop free of garbage. */
final class LineFit {
  private double origin;
  private int n;
  private double st;
  private double stt;
  private double sx;
  private double sy;
  private double stx;
  private double sty;
  private double sxx;
  private double syy;
  private double x0;
  private double y0;
  private double vx;
  private double vy;
  private double velocityError;
  private double rms;

  void clear(double origin) {
    this.origin = origin;
    n = 0;
    st = 0;
    stt = 0;
    sx = 0;
    sy = 0;
    stx = 0;
    sty = 0;
    sxx = 0;
    syy = 0;
    originX = Double.NaN;
  }

  private double originX = Double.NaN;
  private double originY;

  void add(double t, double x, double y) {
    if (n == 0) {
      // Sums of squares are taken about the first point, or they would cancel.
      originX = x;
      originY = y;
    }
    double dt = t - origin;
    double dx = x - originX;
    double dy = y - originY;
    n++;
    st += dt;
    stt += dt * dt;
    sx += dx;
    sy += dy;
    stx += dt * dx;
    sty += dt * dy;
    sxx += dx * dx;
    syy += dy * dy;
  }

  /** Solves for the line; false with fewer than two different times. */
  boolean solve() {
    double spread = stt - st * st / Math.max(n, 1);
    if (n < 2 || !(spread > 1e-9)) {
      return false;
    }
    double cx = stx - st * sx / n;
    double cy = sty - st * sy / n;
    vx = cx / spread;
    vy = cy / spread;
    x0 = originX + (sx - vx * st) / n;
    y0 = originY + (sy - vy * st) / n;
    double chi2 = sxx - sx * sx / n - vx * cx + syy - sy * sy / n - vy * cy;
    rms = Math.sqrt(Math.max(0, chi2) / (2.0 * n));
    // Per axis, with two degrees of freedom per axis taken by the line; a floor keeps two exact
    // points
    // from claiming certainty.
    double variance = n > 2 ? Math.max(0, chi2) / (2.0 * (n - 2)) : 0;
    velocityError = Math.sqrt(Math.max(variance, 1e-7) / spread);
    return true;
  }

  int count() {
    return n;
  }

  double x(double t) {
    return x0 + vx * (t - origin);
  }

  double y(double t) {
    return y0 + vy * (t - origin);
  }

  double vx() {
    return vx;
  }

  double vy() {
    return vy;
  }

  double speed() {
    return Math.hypot(vx, vy);
  }

  /** Standard error of one component of the velocity, m/s. */
  double velocityError() {
    return velocityError;
  }

  /** Residual per axis, m. */
  double rms() {
    return rms;
  }
}
