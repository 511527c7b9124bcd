package fieldcal.fit.joint;

/** The damping of Levenberg–Marquardt steps: a fifth after one that was accepted, more and more after those that were not (Nielsen 1999, "Damping parameter in Marquardt's method"). Not thread-safe. */
final class Damping {
  /** With more than that no step changes anything. */
  private static final double LARGEST = 1e10;

  private static final double SMALLEST = 1e-9;
  private static final double FIRST = 1e-5;
  private static final double RELIEF = 5;
  private static final double GROWTH = 2;
  private static final double SINGULAR_GROWTH = 10;

  private double lambda = FIRST;
  private double growth = GROWTH;

  double lambda() {
    return lambda;
  }

  boolean isLargest() {
    return lambda > LARGEST;
  }

  void accepted() {
    lambda = Math.max(SMALLEST, lambda / RELIEF);
    growth = GROWTH;
  }

  void rejected() {
    lambda *= growth;
    growth *= GROWTH;
  }

  /** The equations were not positive definite. */
  void singular() {
    lambda = Math.max(FIRST, SINGULAR_GROWTH * lambda);
  }

  /** A descent begins: what earlier steps needed says little about how fast to grow. */
  void restarted() {
    growth = GROWTH;
  }
}
