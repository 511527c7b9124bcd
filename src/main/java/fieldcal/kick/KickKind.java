package fieldcal.kick;

/** How a ball was kicked. */
public enum KickKind {
  /** Along the carpet. */
  FLAT,
  /** Through the air. */
  CHIP;

  /**
   * The name in files and on the command line.
   *
   * @return lower-case name
   */
  public String id() {
    return name().toLowerCase(java.util.Locale.ROOT);
  }
}
