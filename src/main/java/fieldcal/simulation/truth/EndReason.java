package fieldcal.simulation.truth;

import java.util.Locale;

/** Why a kick was over. */
public enum EndReason {
  /** The ball came to rest. */
  STOPPED,
  /** The ball crossed the lines by 0.25 m. */
  LEFT_FIELD,
  /** The ball met a robot. */
  TOUCHED_ROBOT,
  /** A robot kicked the moving ball on. */
  REDIRECTED,
  /** The ball entered a goal. */
  GOAL,
  /** Somebody took the ball. */
  PLACED,
  /** The recording ended first. */
  RECORDING_ENDED;

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
