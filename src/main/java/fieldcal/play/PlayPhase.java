package fieldcal.play;

/** What the play is busy with. */
public enum PlayPhase {
  /** Looks at field and robots and decides what comes next. */
  CHECK("checking field and robots"),
  /** A robot drives to a ball that cannot be kicked from where it lies, or waits for it to be laid down. */
  FETCH("fetching the ball"),
  /** A robot carries the ball to its place and lets go. */
  PLACE("placing the ball"),
  /** Both robots drive to where they kick and receive. */
  POSITION("moving into position"),
  /** The kicker drives up to the ball. */
  KICK("kicking"),
  /** The ball is left alone until it stops, leaves the field or reaches the receiver. */
  WATCH("leaving the ball alone"),
  /** All kicks are made. */
  FINISHED("finished"),
  /** Ended before that; the state says why. */
  STOPPED("stopped");

  private final String text;

  PlayPhase(String text) {
    this.text = text;
  }

  /**
   * For people.
   *
   * @return in words
   */
  public String text() {
    return text;
  }

  /**
   * Whether the play is over.
   *
   * @return true when no more orders come
   */
  public boolean over() {
    return this == FINISHED || this == STOPPED;
  }
}
