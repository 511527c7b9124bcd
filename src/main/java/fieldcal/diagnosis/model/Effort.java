package fieldcal.diagnosis.model;

import java.util.concurrent.atomic.LongAdder;

/**
 * How much work a diagnosis has done, and how much it may do. Integrating paths takes most of the time, so their pieces are counted. Unlike a clock this gives the same answer on every machine. Thread-safe; the limit is checked between fits.
 */
public final class Effort {
  private final long most;
  private final LongAdder pieces = new LongAdder();

  /**
   * An effort.
   *
   * @param most pieces of paths after which nothing is begun that can be left out
   */
  public Effort(long most) {
    this.most = most;
  }

  /**
   * Whether nothing more should be begun.
   *
   * @return true from the limit on
   */
  public boolean isSpent() {
    return pieces.sum() >= most;
  }

  /** A path was integrated. */
  void add(int piecesOfPath) {
    pieces.add(piecesOfPath);
  }
}
