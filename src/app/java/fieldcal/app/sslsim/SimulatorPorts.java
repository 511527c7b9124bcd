package fieldcal.app.sslsim;

/**
 * Where a simulator listens: three ports in a row.
 *
 * @param control for simulator control; the ports of the blue and the yellow team follow
 */
public record SimulatorPorts(int control) {
  /** The ports that the league has agreed on. */
  public static final SimulatorPorts LEAGUE = new SimulatorPorts(10300);

  /**
   * Checks the range. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there is no room for three ports
   */
  public SimulatorPorts {
    if (control < 1 || control > 65533) {
      throw new IllegalArgumentException("port must lie in [1, 65533], but is " + control);
    }
  }

  /**
   * For the robots of the blue team.
   *
   * @return a port
   */
  public int blue() {
    return control + 1;
  }

  /**
   * For the robots of the yellow team.
   *
   * @return a port
   */
  public int yellow() {
    return control + 2;
  }
}
