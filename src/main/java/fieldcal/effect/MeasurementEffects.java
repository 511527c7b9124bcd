package fieldcal.effect;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the cameras of a recording report of a ball under given effects. Immutable; safe for many threads. A camera that is not listed
 * reports balls where they are, at the time of its stamp.
 */
public final class MeasurementEffects {
  private final Map<Integer, View> views = new HashMap<>();
  private final List<MeasurementEffect> effects;

  private record View(ObservedCamera camera, MeasurementEffect[] effects) {}

  private MeasurementEffects(
      Collection<ObservedCamera> cameras, List<? extends MeasurementEffect> effects) {
    this.effects = List.copyOf(effects);
    for (ObservedCamera camera : cameras) {
      MeasurementEffect[] concerning =
          this.effects.stream()
              .filter(e -> !e.isAbsent() && e.isApplicable(camera) && e.concerns(camera))
              .toArray(MeasurementEffect[]::new);
      views.put(camera.id(), new View(camera, concerning));
    }
  }

  /**
   * Effects on cameras.
   *
   * @param cameras one each
   * @param effects in any order; several of one id add up
   * @return the bundle
   */
  public static MeasurementEffects of(
      Collection<ObservedCamera> cameras, List<? extends MeasurementEffect> effects) {
    return new MeasurementEffects(cameras, effects);
  }

  /**
   * What is wrong.
   *
   * @return as given, absent ones included
   */
  public List<MeasurementEffect> effects() {
    return effects;
  }

  /**
   * When the ball was where a camera saw it.
   *
   * @param camera camera id
   * @param stamp the detection's time stamp, s since the session's begin
   * @param pixelRow the detection's row in the image, pixels; not above 0 or NaN = unknown, then nothing that depends on the row is corrected
   * @return session time, s
   */
  public double ballTime(int camera, double stamp, double pixelRow) {
    View view = views.get(camera);
    if (view == null) {
      return stamp;
    }
    double error = 0;
    for (MeasurementEffect effect : view.effects) {
      error += effect.timeError(view.camera, stamp, pixelRow);
    }
    return stamp - error;
  }

  /**
   * Where a camera reports a ball.
   *
   * @param camera camera id
   * @param ball x, y and height (0 = on the carpet) at {@link #ballTime}, m
   * @param ground receives x and y, m; NaN when the ball is not below the camera
   */
  public void report(int camera, double[] ball, double[] ground) {
    View view = views.get(camera);
    if (view == null || view.effects.length == 0) {
      if (view == null || view.camera.camera().isEmpty()) {
        ground[0] = ball[0];
        ground[1] = ball[1];
      } else {
        view.camera.camera().get().projectToGround(ball[0], ball[1], ball[2], ground);
      }
      return;
    }
    Sight sight = new Sight(view.camera);
    for (MeasurementEffect effect : view.effects) {
      effect.moveCamera(sight);
    }
    sight.look(ball);
    for (MeasurementEffect effect : view.effects) {
      effect.turnRay(sight);
    }
    for (MeasurementEffect effect : view.effects) {
      effect.refractRay(sight);
    }
    for (MeasurementEffect effect : view.effects) {
      effect.report(sight);
    }
    sight.land(ball, ground);
  }
}
