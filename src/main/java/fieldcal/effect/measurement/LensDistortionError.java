package fieldcal.effect.measurement;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MeasurementEffect.Refraction;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.Sight;
import java.util.ArrayList;
import java.util.List;

/**
 * Published minus true radial distortion of one camera, or the same of all: the true lens (published − delta) draws the ball at radius rd, ru = rd·(1 + k·rd²) (SSL-Vision's model, radii in
 * focal lengths), and the published lens takes this for another angle to the optical axis. The effect needs the camera's rotation and lens.
 *
 * @param delta published minus true radial distortion (–)
 * @param camera which camera, by id; {@link #ALL_CAMERAS} = the same in all cameras
 */
public record LensDistortionError(double delta, int camera) implements Refraction {
  /** In place of a camera's id: the error is the same in all cameras. Files leave the camera out then. */
  public static final int ALL_CAMERAS = EffectParameters.ALL_CAMERAS;

  private static final String ID = "lens_distortion_error";

  /** The error after a step of Halley's method is about the cube of the one before: that of a step shorter than this is below the rounding of a double. */
  private static final double LAST_STEP = 1e-5;

  /** Enough far from the fold of any lens; nearer to it no radius is found. */
  private static final int MOST_STEPS = 30;

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public LensDistortionError {
    EffectParameters.requireFinite(ID, delta);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "The lens distortion in a camera's calibration is wrong.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "delta",
            "",
            delta,
            0.005,
            -0.1,
            0.1,
            true,
            "published distortions are within ±0.2; calibrations err by a few hundredths"),
        EffectParameters.cameraOrAll(camera));
  }

  @Override
  public LensDistortionError withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 2);
    return new LensDistortionError(v[0], (int) v[1]);
  }

  /** Each camera by itself and, from two on, all at once. */
  @Override
  public List<Effect> candidates(Arena arena) {
    List<Effect> all = new ArrayList<>(Refraction.super.candidates(arena));
    if (all.size() > 1) {
      all.add(new LensDistortionError(0, ALL_CAMERAS));
    }
    return List.copyOf(all);
  }

  @Override
  public boolean isAbsent() {
    return delta == 0;
  }

  @Override
  public boolean concerns(ObservedCamera observer) {
    return camera == ALL_CAMERAS || observer.id() == camera;
  }

  @Override
  public boolean isApplicable(ObservedCamera observer) {
    return observer.camera().isPresent() && observer.hasLens();
  }

  @Override
  public void refractRay(Sight sight) {
    ObservedCamera o = sight.camera();
    double depth = sight.rayX() * o.axisX() + sight.rayY() * o.axisY() + sight.rayZ() * o.axisZ();
    double acrossX = sight.rayX() - depth * o.axisX();
    double acrossY = sight.rayY() - depth * o.axisY();
    double acrossZ = sight.rayZ() - depth * o.axisZ();
    double square = (acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ) / (depth * depth);
    if (!(depth > 0 && square > 0)) {
      return;
    }
    double drawn = drawn((o.distortion() - delta) * square);
    double stretch = drawn * (1 + o.distortion() * square * drawn * drawn);
    sight.turnRay(
        depth * o.axisX() + stretch * acrossX,
        depth * o.axisY() + stretch * acrossY,
        depth * o.axisZ() + stretch * acrossZ);
  }

  /**
   * How far from the centre of the image a lens draws a point, as a share of where it would be drawn without distortion: solves s·(1 + u·s²) = 1 with u the distortion times the squared tangent, by a step of Newton's method from s = 1 and then Halley's.
   *
   * @return NaN beyond the fold of a lens with u &lt; 0
   */
  private static double drawn(double u) {
    double s = (1 + 2 * u) / (1 + 3 * u);
    for (int i = 0; i < MOST_STEPS; i++) {
      double us = u * s;
      double slope = 1 + 3 * us * s;
      if (!(slope > 0)) {
        return Double.NaN;
      }
      double miss = s * (1 + us * s) - 1;
      double step = miss * slope / (slope * slope - 3 * us * miss);
      s -= step;
      if (Math.abs(step) < LAST_STEP) {
        return s;
      }
    }
    return Double.NaN;
  }
}
