package fieldcal.movement;

import fieldcal.vision.RobotId;

/** Gathers a path of one robot, and has it cut into manoeuvres block by block. No manoeuvre spans a break. */
final class PathBlocks {
  /** New path after which it is cut again, s; each robot a little else, so that not all of them are due with the same frame. */
  private static final double BLOCK = 1.5;

  private static final double BLOCK_STEP = 0.03;

  /** A piece that has not ended after so long is driven at constant speed, or not at all, and is not waited for, s. */
  private static final double LONGEST = 4;

  /** So much of a neighbour is enough to find the knot, s. */
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
      // What is not finished comes again, with a piece of what was before it.
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
