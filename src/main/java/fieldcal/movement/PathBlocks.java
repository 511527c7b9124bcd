package fieldcal.movement;

import fieldcal.vision.RobotId;

/** Gathers a path of one robot, and has it cut into manoeuvres block by block. No manoeuvre spans a break. */
final class PathBlocks {
  /** Length of new path after which it is cut again, s. It differs a little from robot to robot, so that not all are cut with the same frame. */
  private static final double BLOCK = 1.5;

  private static final double BLOCK_STEP = 0.03;

  /** Longest piece that is waited for, s: in a longer one the robot stands or drives at constant speed. */
  private static final double LONGEST = 4;

  /** Length of a neighbouring piece that is enough to find the knot, s. */
  private static final double FLANK = 0.3;

  private final RobotId id;
  private final double block;
  private final ManoeuvreFinder finder;
  private final Stretch stretch = new Stretch();
  private double due;

  PathBlocks(RobotId id, ManoeuvreFinder finder) {
    this.id = id;
    this.finder = finder;
    block = BLOCK + BLOCK_STEP * (id.number() % 16) + 0.5 * BLOCK_STEP * id.team().ordinal();
    due = block;
  }

  /** Adds a point of the path; of an angle y is 0. */
  void add(double at, double x, double y, double orientation, int camera) {
    stretch.add(at, x, y, orientation, camera);
    if (stretch.span() >= due || stretch.full()) {
      // What is not finished is cut again with the next block, together with a piece of the path
      // before
      // it.
      double keep = finder.find(id, stretch) - FLANK;
      boolean tooLong = stretch.full() || stretch.span() - keep > LONGEST;
      stretch.forgetBefore(tooLong ? stretch.span() - FLANK : keep);
      due = stretch.span() + block;
    }
  }

  /** The path breaks off here. */
  void end() {
    if (stretch.size() > 0) {
      finder.find(id, stretch);
    }
    stretch.clear();
    due = block;
  }
}
