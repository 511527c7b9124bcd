package fieldcal.vision;

import java.util.Locale;

/** The colour a team plays in. */
public enum Team {
  /** The team with yellow markers. */
  YELLOW,
  /** The team with blue markers. */
  BLUE;

  /**
   * The other team.
   *
   * @return blue for yellow and yellow for blue
   */
  public Team opponent() {
    return this == YELLOW ? BLUE : YELLOW;
  }

  /**
   * The team's name as written in files.
   *
   * @return {@code yellow} or {@code blue}
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
