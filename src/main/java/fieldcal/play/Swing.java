package fieldcal.play;

/** Whether a robot turns past the direction that it should face, again and again: then what it is commanded comes later than its gains allow. */
final class Swing {
  /** A robot that turns past its target by less may be pushed or badly seen, rad. */
  private static final double WIDE = 0.5;

  /** So often no robot turns past its target that only comes from another direction. */
  private static final int OFTEN = 4;

  private double side;
  private int turns;

  /** Takes how far the robot faces to the left of its target, rad. */
  void look(double error) {
    double now = Math.signum(error);
    if (Math.abs(error) > WIDE && now != side) {
      turns += side == 0 ? 0 : 1;
      side = now;
    }
  }

  boolean swings() {
    return turns >= OFTEN;
  }
}
