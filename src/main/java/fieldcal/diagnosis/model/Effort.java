package fieldcal.diagnosis.model;

import java.util.concurrent.atomic.LongAdder;

/**
 * How much a diagnosis has worked, and how much it may: what takes the time is integrating paths, so that their pieces are counted. Unlike a clock this gives the same answer on every machine. Thread-safe; what may still be done is asked between fits.
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
