package fieldcal.ball;

/** The acceleration of free fall. */
public final class Gravity {
  /** Acceleration of free fall, m/s²; the value of the league's published models (DIN 1305 to two decimals; 9.78–9.83 on earth). */
  public static final double ACCELERATION = 9.81;

  private Gravity() {}
}
