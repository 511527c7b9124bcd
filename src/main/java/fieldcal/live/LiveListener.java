package fieldcal.live;

import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;

/**
 * Receives what changes while a match is watched; a host shows it in its own way. All methods do nothing unless overridden.
 *
 * <p>Called from the thread that fits, one call after the other, never from within {@link LiveMonitor#accept} unless the host's executor runs tasks there. An exception, a {@link StackOverflowError} or an {@link AssertionError} of a method is counted
 * ({@link LiveSnapshot#listenerFailures}) and otherwise ignored.
 */
public interface LiveListener {
  /** Ignores everything. */
  LiveListener NONE = new LiveListener() {};

  /**
   * A parameter of the ball has moved too far from the published model. Called once, until the warning is cleared.
   *
   * @param warning what is off and by how much
   */
  default void warningRaised(LiveWarning warning) {}

  /**
   * A parameter that was warned about is near the published model again, or another model is published.
   *
   * @param warning as it is now
   */
  default void warningCleared(LiveWarning warning) {}

  /**
   * A kick was judged.
   *
   * @param kick what became of it
   */
  default void kick(LiveKick kick) {}

  /**
   * A parameter's median changed, with a kick that counts.
   *
   * @param estimate as it is now
   */
  default void estimate(ParameterEstimate estimate) {}

  /**
   * A team's movement limits were estimated again.
   *
   * @param team which
   * @param limits the new estimate
   */
  default void limits(Team team, TeamLimits limits) {}

  /**
   * Robots do not move as they are configured to ({@link LiveMonitor#configured}). Called once, until the warning is cleared. Nothing is changed; that is for the host to decide.
   *
   * @param warning which limit and by how much
   */
  default void limitWarningRaised(LimitWarning warning) {}

  /**
   * A limit that was warned about is near what is configured again, or something else is configured.
   *
   * @param warning as it is now
   */
  default void limitWarningCleared(LimitWarning warning) {}
}
