package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect.Displacement;
import fieldcal.effect.ObservedCamera;
import java.util.ArrayList;
import java.util.List;

/**
 * One camera was knocked: everything with a time stamp from some instant on is reported shifted. The other cameras do not change.
 *
 * @param xMm shift along x of the field, mm
 * @param yMm shift along y of the field, mm
 * @param at from when on, s since the beginning of the session, by the time stamp
 * @param camera which camera, by id
 */
public record CameraMoved(double xMm, double yMm, double at, int camera) implements Displacement {
  private static final String ID = "camera_moved";
  private static final double MILLI = 1e-3;

  /** How many instants a search begins with, for each camera; chosen. */
  private static final int INSTANTS = 8;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public CameraMoved {
    EffectParameters.requireFinite(ID, xMm, yMm, at);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One camera was knocked during the session and reports everything shifted from then on.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "x_mm", "mm", xMm, 5, -500, 500, true, "a mount that is knocked moves by centimetres"),
        new Parameter("y_mm", "mm", yMm, 5, -500, 500, true, "as x_mm"),
        EffectParameters.instant(at),
        EffectParameters.camera(camera));
  }

  @Override
  public CameraMoved withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 4);
    return new CameraMoved(v[0], v[1], v[2], (int) v[3]);
  }

  @Override
  public boolean isAbsent() {
    return xMm == 0 && yMm == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("x_mm", "y_mm");
  }

  @Override
  public boolean changesWithTime() {
    return true;
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return Displacement.super.canShowIn(arena) && arena.kickTimes().length > 1;
  }

  @Override
  public List<Effect> candidates(Arena arena) {
    List<Effect> all = new ArrayList<>();
    for (ObservedCamera observer : arena.cameras()) {
      for (double instant : arena.instantsBetweenKicks(INSTANTS)) {
        all.add(new CameraMoved(0, 0, instant, observer.id()));
      }
    }
    return List.copyOf(all);
  }

  @Override
  public List<String> places() {
    return List.of("at");
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return observer.id() == camera;
  }

  @Override
  public void displace(
      ObservedCamera observer, double x, double y, double sessionTime, double[] ground, int to) {
    // An unknown time counts as the latest: what changed during the session has happened.
    if (!(sessionTime < at)) {
      ground[to] += MILLI * xMm;
      ground[to + 1] += MILLI * yMm;
    }
  }
}
