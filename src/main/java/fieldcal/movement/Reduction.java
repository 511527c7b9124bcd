package fieldcal.movement;

/**
 * How speed and direction reduce a limit: to (1 − torque·v/v_max)·(1 − directional·|sin φ|) of its value at standstill along the front. Coefficients have standard errors; 0 where an effect is not named.
 *
 * @param velocity v_max, m/s; of no meaning without {@code torque}
 */
record Reduction(
    double torque,
    double torqueError,
    double directional,
    double directionalError,
    double velocity) {
  /** No effect. */
  static final Reduction NONE = new Reduction(0, 0, 0, 0, 1);

  /** A robot that is torque limited still accelerates a little at its highest speed. */
  private static final double LEAST_TORQUE = 0.05;

  /** The part of the limit that is left at a speed. */
  double slowed(double speed) {
    return torque == 0 ? 1 : Math.max(LEAST_TORQUE, 1 - torque * speed / velocity);
  }

  /** The part of the limit that is left in a direction, also in an unknown one (NaN) where none matters. */
  double directed(double phi) {
    return directional == 0 ? 1 : 1 - directional * Math.abs(Math.sin(phi));
  }

  /** The manoeuvres as they would be along the front from standstill. Speeds and directions are known to their classes only, which adds to the errors how much the reduction differs within a class. */
  ManoeuvreTable.Columns takenOut(ManoeuvreTable.Columns data) {
    int n = data.count().length;
    double[] factor = new double[n];
    double[] blur = new double[n];
    double perSpeed = torque == 0 ? 0 : torque / velocity;
    for (int i = 0; i < n; i++) {
      double slowed = slowed(data.speed()[i]);
      double directed = directed(data.direction()[i]);
      double perRadian =
          directional == 0 ? 0 : directional * Math.cos(data.direction()[i]) / directed;
      factor[i] = slowed * directed;
      blur[i] =
          Math.hypot(
              ManoeuvreTable.Scale.DRIVING.speedError() * perSpeed / slowed,
              ManoeuvreTable.DIRECTION_ERROR * perRadian);
    }
    return data.without(factor, blur);
  }

  /** Relative standard error that a limit has from those of the coefficients, averaged over the manoeuvres at the limit, from which the reduction was taken out. */
  double errorOf(UpperEdge limit, ManoeuvreTable.Columns takenOut) {
    double bySpeed = 0;
    double byDirection = 0;
    double weights = 0;
    for (int i = 0; i < takenOut.count().length; i++) {
      double width = UpperEdge.HALF_WIDTH * limit.value() + takenOut.error()[i];
      boolean good = takenOut.error()[i] <= UpperEdge.WORST * limit.value();
      if (good && Math.abs(takenOut.acceleration()[i] - limit.value()) < width) {
        double speed = takenOut.speed()[i];
        double sine = Math.abs(Math.sin(takenOut.direction()[i]));
        double weight = takenOut.count()[i] / (width * width);
        weights += weight;
        bySpeed += torque == 0 ? 0 : weight * speed / velocity / slowed(speed);
        byDirection += directional == 0 ? 0 : weight * sine / directed(takenOut.direction()[i]);
      }
    }
    return weights == 0
        ? 0
        : Math.hypot(torqueError * bySpeed, directionalError * byDirection) / weights;
  }
}
