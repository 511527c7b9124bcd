package fieldcal.simulation.physics;

/**
 * What the carpet does to a ball that touches it. Coulomb friction μ·N acts against the slip of the contact point until the ball rolls; then the rolling resistance acts against the velocity.
 * N is the weight less the upward part of the forces of the air. A tilted field and air drag accelerate a sliding ball fully and a rolling one by 1/(1+β), because friction has to turn it; a flying ball feels them fully, too.
 *
 * @param slidingFriction μ (–)
 * @param rollingDeceleration deceleration of a rolling ball at low speed, m/s², positive
 * @param rollingPerSpeed growth of the rolling deceleration with speed, 1/s
 * @param rollingPerSpeedSquared growth of the rolling deceleration with the square of speed, 1/m
 * @param slopeX field slope: acceleration along x over g (–), positive = downhill along +x
 * @param slopeY field slope: acceleration along y over g (–)
 * @param napAmplitude rolling deceleration is multiplied by 1 + napAmplitude·cos(θ − napDirection), θ = direction of travel
 * @param napDirection direction of travel in the field frame with the largest deceleration (for a positive amplitude), rad, 0 = along x, counter-clockwise
 * @param worn rectangle in which all friction is multiplied by 1 + wornChange
 * @param wornChange relative change of friction in the rectangle (–)
 * @param driftPerSecond relative change of the rolling deceleration per second of session time, 1/s
 * @param verticalSpinDecay deceleration of spin about the vertical while on the ground, 1/s
 * @param slipSlope growth of μ with the slip speed about {@link #REFERENCE_SLIP}, relative, s/m
 * @param waveAmplitude rolling deceleration is multiplied by 1 + waveAmplitude·sin(2π·x/waveLength): strips of carpet laid side by side
 * @param waveLength length of a period of the strips along x, m
 */
public record GroundLaw(
    double slidingFriction,
    double rollingDeceleration,
    double rollingPerSpeed,
    double rollingPerSpeedSquared,
    double slopeX,
    double slopeY,
    double napAmplitude,
    double napDirection,
    Region worn,
    double wornChange,
    double driftPerSecond,
    double verticalSpinDecay,
    double slipSlope,
    double waveAmplitude,
    double waveLength) {

  /** Speed of slip at which {@code slipSlope} changes nothing, m/s (the value that DESIGN fixes). */
  public static final double REFERENCE_SLIP = 2;

  /** What is left of friction at least, however steep the dependence on slip is (–). */
  private static final double LEAST_FRICTION = 0.05;

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when friction is not positive or a value lies outside what keeps the ball slowing down
   */
  public GroundLaw {
    Check.range("slidingFriction", slidingFriction, 1e-3, 2);
    Check.range("rollingDeceleration", rollingDeceleration, 1e-3, 5);
    Check.range("rollingPerSpeed", rollingPerSpeed, -0.2, 2);
    Check.range("rollingPerSpeedSquared", rollingPerSpeedSquared, -0.2, 2);
    Check.range("slopeX", slopeX, -0.2, 0.2);
    Check.range("slopeY", slopeY, -0.2, 0.2);
    Check.range("napAmplitude", napAmplitude, -0.9, 0.9);
    Check.finite("napDirection", napDirection);
    Check.range("wornChange", wornChange, -0.9, 10);
    Check.range("driftPerSecond", driftPerSecond, -0.1, 0.1);
    Check.range("verticalSpinDecay", verticalSpinDecay, 0, 1000);
    Check.range("slipSlope", slipSlope, -0.45, 1);
    Check.range("waveAmplitude", waveAmplitude, -0.9, 0.9);
    Check.range("waveLength", waveLength, 0.05, 100);
  }

  /**
   * A level, uniform carpet.
   *
   * @param slidingFriction μ (–)
   * @param rollingDeceleration m/s², positive
   * @return the law
   */
  public static GroundLaw uniform(double slidingFriction, double rollingDeceleration) {
    return new GroundLaw(
        slidingFriction, rollingDeceleration, 0, 0, 0, 0, 0, 0, Region.NONE, 0, 0, 8, 0, 0, 1);
  }

  /**
   * Makes rolling resistance depend on speed.
   *
   * @param perSpeed 1/s
   * @param perSpeedSquared 1/m
   * @return the changed law
   */
  public GroundLaw withSpeedDependentRoll(double perSpeed, double perSpeedSquared) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        perSpeed,
        perSpeedSquared,
        slopeX,
        slopeY,
        napAmplitude,
        napDirection,
        worn,
        wornChange,
        driftPerSecond,
        verticalSpinDecay,
        slipSlope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Tilts the field.
   *
   * @param percent 100 × acceleration over g
   * @param direction downhill, rad
   * @return the changed law
   */
  public GroundLaw withSlope(double percent, double direction) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        percent / 100 * Math.cos(direction),
        percent / 100 * Math.sin(direction),
        napAmplitude,
        napDirection,
        worn,
        wornChange,
        driftPerSecond,
        verticalSpinDecay,
        slipSlope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Gives the carpet a direction.
   *
   * @param amplitude relative change of the rolling deceleration (–)
   * @param direction direction of travel in which it is largest, rad
   * @return the changed law
   */
  public GroundLaw withNap(double amplitude, double direction) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        slopeX,
        slopeY,
        amplitude,
        direction,
        worn,
        wornChange,
        driftPerSecond,
        verticalSpinDecay,
        slipSlope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Wears a part of the carpet.
   *
   * @param change relative change of all friction (–)
   * @param region where
   * @return the changed law
   */
  public GroundLaw withWornRegion(double change, Region region) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        slopeX,
        slopeY,
        napAmplitude,
        napDirection,
        region,
        change,
        driftPerSecond,
        verticalSpinDecay,
        slipSlope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Lets the carpet change over the session.
   *
   * @param perSecond relative change of the rolling deceleration, 1/s
   * @return the changed law
   */
  public GroundLaw withDrift(double perSecond) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        slopeX,
        slopeY,
        napAmplitude,
        napDirection,
        worn,
        wornChange,
        perSecond,
        verticalSpinDecay,
        slipSlope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Lets sliding friction depend on how fast the contact point slips.
   *
   * @param slope relative growth per m/s of slip, s/m
   * @return the changed law
   */
  public GroundLaw withSlipSlope(double slope) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        slopeX,
        slopeY,
        napAmplitude,
        napDirection,
        worn,
        wornChange,
        driftPerSecond,
        verticalSpinDecay,
        slope,
        waveAmplitude,
        waveLength);
  }

  /**
   * Lets rolling resistance vary across strips of carpet; in no catalogue of causes, so a diagnosis must not name one.
   *
   * @param amplitude relative change (–)
   * @param length from strip to strip, m
   * @return the changed law
   */
  public GroundLaw withWaves(double amplitude, double length) {
    return new GroundLaw(
        slidingFriction,
        rollingDeceleration,
        rollingPerSpeed,
        rollingPerSpeedSquared,
        slopeX,
        slopeY,
        napAmplitude,
        napDirection,
        worn,
        wornChange,
        driftPerSecond,
        verticalSpinDecay,
        slipSlope,
        amplitude,
        length);
  }

  /** Factor on the sliding friction at a speed of slip. */
  double slipFactor(double slip) {
    return slipSlope == 0 ? 1 : Math.max(LEAST_FRICTION, 1 + slipSlope * (slip - REFERENCE_SLIP));
  }

  /** Factor on the rolling deceleration at a place. */
  double waveAt(double x) {
    return waveAmplitude == 0 ? 1 : 1 + waveAmplitude * Math.sin(2 * Math.PI * x / waveLength);
  }

  /** Whether friction differs at a place. */
  boolean wornAt(double x, double y) {
    return wornChange != 0 && worn.contains(x, y);
  }

  /** Rolling deceleration at a velocity and a session time, m/s². */
  double rollingDecelerationAt(double vx, double vy, double sessionTime) {
    double speed = Math.sqrt(vx * vx + vy * vy);
    double nap =
        napAmplitude == 0 ? 1 : 1 + napAmplitude * Math.cos(Math.atan2(vy, vx) - napDirection);
    double atSpeed =
        rollingDeceleration + rollingPerSpeed * speed + rollingPerSpeedSquared * speed * speed;
    return atSpeed * (1 + driftPerSecond * sessionTime) * nap;
  }
}
