package fieldcal.simulation.physics;

/**
 * Causes that no catalogue names, for studies of what a diagnosis makes of them. Some depend smoothly on one quantity, so that a learned curve can describe them ({@link RestitutionByPlace}, {@link
 * RollBump}, {@link FadingFriction}, {@link FourWays}, {@link LossByImpactSpeed}, {@link SideForce}); for others such a curve would have to be too fine or of too many variables ({@link Ring}, {@link
 * OncePerTurn}, {@link Patches}).
 */
public final class UnnamedCause {
  private UnnamedCause() {}

  /**
   * The floor below the carpet is harder towards one end: e_z·(1 + change·tanh(s / 1 m)), s along the direction from the centre.
   *
   * @param change relative change far out (–)
   * @param direction in which e_z grows, rad
   */
  public record RestitutionByPlace(double change, double direction) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public RestitutionByPlace {
      Check.range("change", change, -0.9, 0.9);
      Check.finite("direction", direction);
    }

    @Override
    public double restitutionFactor(BallMoment m) {
      return 1 + change * Math.tanh(m.x() * Math.cos(direction) + m.y() * Math.sin(direction));
    }
  }

  /**
   * A rolling ball shakes at one speed: rolling deceleration × (1 + height·exp(−½((v − speed)/width)²)).
   *
   * @param height relative (–)
   * @param speed at which it is largest, m/s
   * @param width m/s
   */
  public record RollBump(double height, double speed, double width) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public RollBump {
      Check.range("height", height, -0.9, 10);
      Check.finite("speed", speed);
      Check.range("width", width, 0.05, 10);
    }

    @Override
    public double rollingFactor(BallMoment m) {
      double z = (m.groundSpeed() - speed) / width;
      return 1 + height * Math.exp(-0.5 * z * z);
    }
  }

  /**
   * The ball's skin warms up: sliding friction × (1 + change·exp(−t/duration)), t = time since the kick.
   *
   * @param change relative, right after the kick (–)
   * @param duration s
   */
  public record FadingFriction(double change, double duration) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public FadingFriction {
      Check.range("change", change, -0.9, 10);
      Check.range("duration", duration, 0.01, 100);
    }

    @Override
    public double slidingFactor(BallMoment m) {
      return 1 + change * Math.exp(-m.sinceKick() / duration);
    }
  }

  /**
   * A rough ring around the centre: friction × (1 + change) between two radii, with edges of 5 cm.
   *
   * @param change relative (–)
   * @param inner radius, m
   * @param outer radius, m
   */
  public record Ring(double change, double inner, double outer) implements ExtraLaw {
    private static final double EDGE = 0.05;

    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public Ring {
      Check.range("change", change, -0.9, 10);
      Check.range("inner", inner, 0, 100);
      Check.range("outer", outer, inner, 100);
    }

    private double factor(BallMoment m) {
      double r = Math.hypot(m.x(), m.y());
      return 1 + 0.5 * change * (Math.tanh((r - inner) / EDGE) - Math.tanh((r - outer) / EDGE));
    }

    @Override
    public double slidingFactor(BallMoment m) {
      return factor(m);
    }

    @Override
    public double rollingFactor(BallMoment m) {
      return factor(m);
    }
  }

  /**
   * A ball with a flat spot: rolling deceleration × (1 + amplitude·cos(path/r)), once per turn of the ball.
   *
   * @param amplitude relative (–)
   * @param radius of the ball, m
   */
  public record OncePerTurn(double amplitude, double radius) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public OncePerTurn {
      Check.range("amplitude", amplitude, -50, 50);
      Check.range("radius", radius, 1e-3, 1);
    }

    @Override
    public double rollingFactor(BallMoment m) {
      return 1 + amplitude * Math.cos(m.path() / radius);
    }
  }

  /**
   * A woven carpet: all friction × (1 + amplitude·cos 4(θ − direction)), θ = direction of travel.
   *
   * @param amplitude relative (–)
   * @param direction of one of the four hard ways, rad
   */
  public record FourWays(double amplitude, double direction) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public FourWays {
      Check.range("amplitude", amplitude, -0.9, 0.9);
      Check.finite("direction", direction);
    }

    private double factor(BallMoment m) {
      return 1 + amplitude * Math.cos(4 * (m.heading() - direction));
    }

    @Override
    public double slidingFactor(BallMoment m) {
      return factor(m);
    }

    @Override
    public double rollingFactor(BallMoment m) {
      return factor(m);
    }
  }

  /**
   * Hard impacts cost more along the carpet: velocity after each × (1 − slope·(|v_z| − 2 m/s)).
   *
   * @param slope s/m
   */
  public record LossByImpactSpeed(double slope) implements ExtraLaw {
    /** Speed at which nothing changes, m/s; chosen between a first and a second impact. */
    private static final double REFERENCE = 2;

    /**
     * Checks the number. {@inheritDoc}
     *
     * @throws IllegalArgumentException when it is out of range
     */
    public LossByImpactSpeed {
      Check.range("slope", slope, -0.15, 0.15);
    }

    @Override
    public double alongFactor(BallMoment m) {
      return 1 - slope * (Math.abs(m.vz()) - REFERENCE);
    }
  }

  /**
   * A force to the left of the direction of travel, proportional to the speed.
   *
   * @param rate 1/s
   */
  public record SideForce(double rate) implements ExtraLaw {
    /**
     * Checks the number. {@inheritDoc}
     *
     * @throws IllegalArgumentException when it is out of range
     */
    public SideForce {
      Check.range("rate", rate, -2, 2);
    }

    @Override
    public void push(BallMoment m, double[] acceleration) {
      acceleration[0] -= rate * m.vy();
      acceleration[1] += rate * m.vx();
    }
  }

  /**
   * Sticky patches everywhere, as of spilled drinks: all friction × (1 + change·cos⁸(πx/pitch)·cos⁸(πy/pitch)).
   *
   * @param change relative, in the middle of a patch (–)
   * @param pitch from patch to patch, m
   */
  public record Patches(double change, double pitch) implements ExtraLaw {
    /**
     * Checks the numbers. {@inheritDoc}
     *
     * @throws IllegalArgumentException when one is out of range
     */
    public Patches {
      Check.range("change", change, -0.9, 20);
      Check.range("pitch", pitch, 0.3, 10);
    }

    private double factor(BallMoment m) {
      double c = Math.cos(Math.PI * m.x() / pitch) * Math.cos(Math.PI * m.y() / pitch);
      return 1 + change * Math.pow(c, 8);
    }

    @Override
    public double slidingFactor(BallMoment m) {
      return factor(m);
    }

    @Override
    public double rollingFactor(BallMoment m) {
      return factor(m);
    }
  }
}
