package fieldcal.movement;

/** What a path describes, and the usual values for it. */
enum PathKind {
  /** Where a robot is: two coordinates, m. */
  POSITION(2, 0.0025, 1e-5, 1, 0),
  /**
   * A robot's orientation: an unwrapped angle, rad. Its noise is 5 to 15 mrad: that of the five patches of colour, 3 mm each, over their distances of 80 mm. Robots that face a moving ball turn all the time. A turn by less than half a radian does not reach a robot's limits.
   */
  ORIENTATION(1, 0.01, 1e-4, 8, 0.5);

  private final int dimensions;
  private final double usualNoise;
  private final double leastNoise;
  private final double plain;
  private final double leastExtent;

  PathKind(int dimensions, double usualNoise, double leastNoise, double plain, double leastExtent) {
    this.dimensions = dimensions;
    this.usualNoise = usualNoise;
    this.leastNoise = leastNoise;
    this.plain = plain;
    this.leastExtent = leastExtent;
  }

  /** Coordinates that are not 0. */
  int dimensions() {
    return dimensions;
  }

  /** Noise of a coordinate that is assumed before it is measured, m or rad. */
  double usualNoise() {
    return usualNoise;
  }

  /** Less noise than this is not distinguished, m or rad. */
  double leastNoise() {
    return leastNoise;
  }

  /** Corners of weaker manoeuvres show nothing of their rounding, m/s² or rad/s². */
  double plain() {
    return plain;
  }

  /** A stretch that stays within this range of x is not cut, m or rad. */
  double leastExtent() {
    return leastExtent;
  }
}
