package fieldcal.simulation.physics;

/** Receives the ball's motion as it is integrated. */
public interface BallTrace {

  /** Listens to nothing. */
  BallTrace NONE =
      new BallTrace() {
        @Override
        public void node(double time, BallBody ball) {}

        @Override
        public void event(BallEvent event) {}
      };

  /**
   * The ball's state at the end of an integration step, and after each impact at the time of the impact once more. Between two nodes the motion is smooth.
   *
   * @param time session time, s
   * @param ball its state now; read it, do not keep it
   */
  void node(double time, BallBody ball);

  /**
   * Something happened.
   *
   * @param event what, when and where
   */
  void event(BallEvent event);
}
