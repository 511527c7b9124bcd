package fieldcal.effect;

import java.util.List;

/**
 * An effect that changes what a camera reports of a ball. The report is made in this order, each step by all effects that concern the camera:
 *
 * <ol>
 *   <li>{@link Timing#timeError}: when the ball was really where the camera saw it;
 *   <li>{@link #moveCamera}: where the camera really hangs, and where vision believes it; the ray goes from the true place to the ball's centre;
 *   <li>{@link #turnRay}: the ray as the published rotation understands it;
 *   <li>{@link Refraction#refractRay}: the ray as the published lens understands it;
 *   <li>{@link #report}: the plane that the ray, drawn from the believed position, is cut with, and what is added afterwards;
 *   <li>{@link Displacement#displace}: what is added depending on where and when the ball is reported.
 * </ol>
 */
public interface MeasurementEffect extends Effect {
  @Override
  MeasurementEffect withParameters(double... values);

  /**
   * Whether it changes what a camera reports.
   *
   * @param camera what is known of the camera
   * @return false for another camera's error, and where it is not {@linkplain #isApplicable applicable}
   */
  boolean concerns(ObservedCamera camera);

  /**
   * Whether what is known of a camera suffices to compute it; some effects need its position, lens or image size.
   *
   * @param camera what is known of the camera
   * @return true unless something is missing
   */
  default boolean isApplicable(ObservedCamera camera) {
    return true;
  }

  /**
   * {@inheritDoc}
   *
   * @return whether it is applicable to one of the cameras
   */
  @Override
  default boolean canShowIn(Arena arena) {
    return arena.cameras().stream().anyMatch(this::isApplicable);
  }

  /**
   * {@inheritDoc} Of an effect that has a {@code camera}, one for each camera to which it is applicable.
   */
  @Override
  default List<Effect> candidates(Arena arena) {
    boolean ofOne = parameters().stream().anyMatch(p -> p.name().equals("camera"));
    if (!ofOne) {
      return List.of(withNone());
    }
    return arena.cameras().stream()
        .filter(this::isApplicable)
        .map(c -> withNone().with("camera", c.id()))
        .toList();
  }

  /**
   * Moves the camera from where it is published to where it is, the same for every ball: asked once.
   *
   * @param sight the sight, its ray not yet drawn
   */
  default void moveCamera(Sight sight) {}

  /**
   * Turns the ray: a rotation, the same for every ball. It is asked once, for a ray along each axis.
   *
   * @param sight the sight
   */
  default void turnRay(Sight sight) {}

  /**
   * Changes the plane or adds to the reported position, the same for every ball: asked once, when there is no ray yet.
   *
   * @param sight the sight
   */
  default void report(Sight sight) {}

  /** An effect on time stamps. */
  interface Timing extends MeasurementEffect {
    /**
     * Time stamp minus the time at which the ball was where it was seen.
     *
     * @param camera the camera
     * @param sessionTime the time stamp, s since the beginning of the session
     * @param pixelRow where in the image the ball was seen, pixels; not above 0 or NaN = unknown
     * @param speed the ball's speed over the ground at the time stamp, m/s; NaN = unknown, then what depends on it is left out
     * @return s, positive = the stamp is late
     */
    double timeError(ObservedCamera camera, double sessionTime, double pixelRow, double speed);

    /**
     * Whether the error depends on how fast the ball is.
     *
     * @return false of most
     */
    default boolean dependsOnSpeed() {
      return false;
    }
  }

  /** An error of the reported position that depends on where and when the ball is reported. */
  interface Displacement extends MeasurementEffect {
    /**
     * Adds the error.
     *
     * @param camera the camera
     * @param x where the ball is reported without such errors, m
     * @param y where the ball is reported without such errors, m
     * @param sessionTime the time stamp, s since the beginning of the session; NaN = unknown, then what depends on it is left out
     * @param ground receives the error; add x to the element {@code at} and y to the next, m
     * @param at index
     */
    void displace(
        ObservedCamera camera, double x, double y, double sessionTime, double[] ground, int at);
  }

  /** An effect of the lens, different for every ray. */
  interface Refraction extends MeasurementEffect {
    /**
     * Bends the ray.
     *
     * @param sight the sight
     */
    void refractRay(Sight sight);
  }
}
