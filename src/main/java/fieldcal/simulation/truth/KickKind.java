package fieldcal.simulation.truth;

import java.util.Locale;

/** What set the ball in motion. */
public enum KickKind {
  /** A kick along the ground. */
  FLAT,
  /** A kick into the air. */
  CHIP,
  /** A robot that the ball bounced off. */
  DEFLECTION;

  /**
   * The name in files.
   *
   * @return lower case
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
