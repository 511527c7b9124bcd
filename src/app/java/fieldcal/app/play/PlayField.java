package fieldcal.app.play;

import fieldcal.gamelog.RecordingOrigin;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionPacket;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** A field with robots that obey: simulated in this process, on the network, or real. For one thread. */
public interface PlayField extends Closeable {

  /** Gets what arrives. */
  interface Receiver {
    /**
     * A packet of vision.
     *
     * @param receivedTime when it arrived, s since the epoch
     * @param packet what is in it
     * @param payload its bytes
     */
    void vision(double receivedTime, VisionPacket packet, byte[] payload);

    /**
     * A message of the referee.
     *
     * @param receivedTime when it arrived, s since the epoch
     * @param payload its bytes
     */
    default void referee(double receivedTime, byte[] payload) {}

    /**
     * Packets of vision may have been lost on this side before the next one: nobody took them in time.
     *
     * @param receivedTime of the next one, s since the epoch
     */
    default void lost(double receivedTime) {}
  }

  /**
   * Where times count from.
   *
   * @return the epoch
   */
  Epoch epoch();

  /**
   * Waits for the next tick, some hundredths of a second at most.
   *
   * @param receiver gets what arrives meanwhile
   * @return now, s since the epoch, on the clock of vision
   * @throws IOException when the field is gone; one line for the operator
   */
  double next(Receiver receiver) throws IOException;

  /**
   * By how much vision's clock has jumped in all; less that, what {@link #next} returns is time that has passed.
   *
   * @return s, positive when it jumped forward
   */
  default double clockJumps() {
    return 0;
  }

  /**
   * Tells the robots what to do until the next tick.
   *
   * @param orders for both robots
   * @throws IOException when they cannot be sent
   */
  void order(List<RobotOrder> orders) throws IOException;

  /**
   * The robots cannot get at the ball: somebody has to lay it down. Called in every tick until it lies well.
   *
   * @param request where and why
   * @throws IOException when it cannot be sent
   */
  void layBall(BallRequest request) throws IOException;

  /**
   * What the referee allows now.
   *
   * @return {@code RUN} when there is none
   */
  Permission permission();

  /**
   * Why no robot may drive now, beside what the referee says: whoever drives them is not heard.
   *
   * @return for the operator; empty when they may
   */
  default Optional<String> hold() {
    return Optional.empty();
  }

  /**
   * Why nothing that comes from now on belongs to the same session: vision's clock was set again, for example. What came before is complete.
   *
   * @return for the operator; empty as long as the session can go on
   */
  default Optional<String> over() {
    return Optional.empty();
  }

  /**
   * Whoever moves the robots but is not heard now.
   *
   * @return for the operator, to be read after a reason; empty when all is well
   */
  default Optional<String> silent() {
    return Optional.empty();
  }

  /**
   * Whether time goes on while nobody asks for the next tick.
   *
   * @return false for a simulation that is stepped: then it may wait for whatever takes long, and does the same every time
   */
  default boolean goesOnByItself() {
    return true;
  }

  /**
   * Whether the ball rolls in a simulator.
   *
   * @return where the recording comes from
   */
  default RecordingOrigin origin() {
    return RecordingOrigin.FIELD;
  }

  /**
   * What the operator should know of the connection.
   *
   * @return one line each; empty when there is nothing to say
   */
  default List<String> notes() {
    return List.of();
  }

  /**
   * What is wrong with the other side, as soon as it is known.
   *
   * @return one line each, in the order in which they came up; none ever changes or goes away
   */
  default List<String> complaints() {
    return List.of();
  }
}
