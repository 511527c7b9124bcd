package fieldcal.movement;

/** What the model of one limit for all speeds and directions gets wrong. */
public enum MovementEffect {
  /** The acceleration falls linearly with speed: × (1 − coefficient·|v|/velocity limit). */
  TORQUE_LIMITED("torque_limited", "accelerates less the faster it drives"),
  /** Acceleration and braking depend on the direction: × (1 − coefficient·|sin φ|), φ from the robot's front. */
  DIRECTIONAL("directional", "accelerates less sideways than along its front");

  private final String id;
  private final String sentence;

  MovementEffect(String id, String sentence) {
    this.id = id;
    this.sentence = sentence;
  }

  /**
   * The name in files.
   *
   * @return for example {@code torque_limited}
   */
  public String id() {
    return id;
  }

  /**
   * One sentence for operators, without its subject.
   *
   * @return for example {@code accelerates less sideways than along its front}
   */
  public String sentence() {
    return sentence;
  }
}
