package fieldcal.play;

import java.util.List;
import java.util.Optional;

/**
 * The play's answer to one tick.
 *
 * @param orders what the two robots are to do, in the order of the plan
 * @param request where somebody is asked to place the ball, when the robots cannot reach it
 */
public record PlayAnswer(List<RobotOrder> orders, Optional<BallRequest> request) {

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when the list or an element is null
   */
  public PlayAnswer {
    orders = List.copyOf(orders);
  }

  /**
   * Somebody should place the ball: a person on a real field, the simulator elsewhere. The robots stand still meanwhile.
   *
   * @param x where, m
   * @param y where, m
   * @param reason why the robots cannot reach it
   */
  public record BallRequest(double x, double y, String reason) {}
}
