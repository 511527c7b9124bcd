package fieldcal.diagnosis;

import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.KickerEffect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.RollingShutter;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Every effect of the catalogue at every place where the data could show it. Effects that the data cannot show (a time offset of the only camera, bounces without chips) are left out;
 * a region of the carpet is looked for by {@link RegionSearch}, kickers by {@link KickerBias}.
 */
final class Candidates {
  /** A camera must have seen that many detections to be blamed. */
  private static final int FEWEST_SEEN = 60;

  /** What has a place to be found, or needs company: this search has no way to it. */
  private static final Set<String> UNKNOWN_HERE =
      Set.of(
          "worn_region",
          "wind",
          "slip_dependent_friction",
          "camera_moved",
          "ball_changed",
          "contact_impacts",
          "carpet_seam");

  private final List<Chart> fixed = new ArrayList<>();
  private final List<Chart> random = new ArrayList<>();

  Candidates(HypothesisFitter fitter) {
    boolean flats = fitter.kicks.stream().anyMatch(k -> k.kind == KickKind.FLAT);
    boolean chips = fitter.kicks.stream().anyMatch(k -> k.kind == KickKind.CHIP);
    List<ObservedCamera> cameras = seen(fitter);
    for (Effect effect : EffectCatalogue.all()) {
      if (effect instanceof KickerEffect || UNKNOWN_HERE.contains(effect.id())) {
        continue;
      }
      if (effect instanceof MeasurementEffect m) {
        measurement(m, cameras);
        continue;
      }
      boolean bounces =
          effect instanceof SpeedDependentRestitution || effect instanceof BounceSpinCoupling;
      boolean spins = effect instanceof KickSpin || effect instanceof SideSpin;
      if (bounces && !chips || spins && !flats) {
        continue;
      }
      if (spins) {
        random.add(Chart.of(effect));
      }
      if (!(effect instanceof KickSpin)) {
        fixed.add(Chart.of(effect));
      }
    }
  }

  private static List<ObservedCamera> seen(HypothesisFitter fitter) {
    return fitter.observers.stream()
        .filter(
            c ->
                fitter.kicks.stream()
                        .mapToLong(
                            k -> {
                              long n = 0;
                              for (int i = 0; i < k.size; i++) {
                                n += k.used[i] && k.camera[i] == c.id() ? 1 : 0;
                              }
                              return n;
                            })
                        .sum()
                    >= FEWEST_SEEN)
        .toList();
  }

  private void measurement(MeasurementEffect effect, List<ObservedCamera> cameras) {
    boolean several = cameras.size() > 1;
    if (effect instanceof BallHeightError || effect instanceof RollingShutter) {
      if (cameras.stream().anyMatch(effect::isApplicable)) {
        fixed.add(Chart.of(effect));
      }
      return;
    }
    for (ObservedCamera camera : cameras) {
      Effect here = effect.with("camera", camera.id());
      if (!((MeasurementEffect) here).isApplicable(camera)) {
        continue;
      }
      if (effect instanceof CameraPoseError) {
        // A shift alone is a camera offset.
        fixed.add(Chart.of(here, "height_mm"));
        fixed.add(Chart.of(here, "tilt_mrad"));
        fixed.add(Chart.of(here, "tilt_mrad", "height_mm"));
        if (several) {
          fixed.add(Chart.of(here, "height_mm", "shift_x_mm", "shift_y_mm"));
          fixed.add(Chart.of(here, "tilt_mrad", "shift_x_mm", "shift_y_mm"));
        }
      } else if (several || !(effect instanceof CameraOffset) && !isTiming(effect)) {
        fixed.add(Chart.of(here));
      }
    }
  }

  private static boolean isTiming(Effect effect) {
    return effect.id().equals("camera_time_offset") || effect.id().equals("clock_skew");
  }

  /** Effects that are the same for all kicks. */
  List<Chart> fixed() {
    return fixed;
  }

  /** Effects that differ from kick to kick. */
  List<Chart> random() {
    return random;
  }
}
