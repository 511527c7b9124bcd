package fieldcal.effect;

/** Goes along a path from one time to the next, which are near each other: then the piece that holds is the last one or its neighbour. Not thread-safe. */
final class PathFollower {
  private final Path path;
  private final double kickTime;
  private final double kickX;
  private final double kickY;
  private int piece;
  private double time;
  private double x;
  private double y;
  private double z;

  PathFollower(Path path, double kickTime, double kickX, double kickY) {
    this.path = path;
    this.kickTime = kickTime;
    this.kickX = kickX;
    this.kickY = kickY;
  }

  void goTo(double t) {
    time = t;
    if (t < kickTime || path.count() == 0) {
      x = kickX;
      y = kickY;
      z = 0;
      return;
    }
    piece = path.indexAt(t, piece);
    double s = path.share(piece, t);
    x = path.position(piece, 0, s);
    y = path.position(piece, 1, s);
    z = path.height(piece, s);
  }

  /** Speed over the ground at a time near the last one, m/s. */
  double speedAt(double t) {
    if (t < kickTime || path.count() == 0) {
      return 0;
    }
    int at = path.indexAt(t, piece);
    return path.groundSpeed(at, path.share(at, t));
  }

  /** When it is there, s. */
  double time() {
    return time;
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }

  /** Height of the ball, 0 on the carpet. */
  double z() {
    return z;
  }
}
