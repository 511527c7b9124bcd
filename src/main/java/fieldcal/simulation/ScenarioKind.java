package fieldcal.simulation;

import java.util.Locale;

/** What the robots do. */
public enum ScenarioKind {
  /** Two robots pass the ball along the diagonals. */
  FLAT,
  /** Two robots chip the ball along the half-way line. */
  CHIP,
  /** First flat, then chip kicks. */
  MIXED,
  /** Two teams play. */
  MATCH;

  /**
   * The name on the command line.
   *
   * @return lower case
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
