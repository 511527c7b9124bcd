package fieldcal.simulation;

import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.CameraSettings.Exposure;
import fieldcal.simulation.imaging.Nuisance;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** What visions of real fields and of other simulators are like, beyond this field's good one; may be combined. */
public enum VisionCharacter {
  /** As it is: each camera in its own beat, all agree. */
  IDEAL,
  /** All cameras stamp the same times, as those of other simulators do. */
  SIMULTANEOUS,
  /** Neighbouring cameras report the same object 40 mm apart, as those of a well-known simulator do. */
  DISAGREEING,
  /** Detections have hardly any noise, 0.01 mm, as in simulators without a noise model. */
  NOISELESS,
  /** One frame of twenty is lost, and each camera stalls every ten seconds for 0.05 to 0.4 s, as on a busy network. */
  STALLING,
  /** One of fifty robot patterns is misread, as that of another number or as turned by 90°, as in poor light. */
  MISREADING;

  private static final double DISAGREEMENT = 0.04;
  private static final double LITTLE = 1e-5;
  private static final double LOST = 0.05;
  private static final double STALLS_PER_SECOND = 0.1;
  private static final double MISREAD = 0.02;

  /**
   * Its name on the command line.
   *
   * @return lower case with dashes
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * By their names.
   *
   * @param labels as {@link #label}, separated by commas
   * @return the characters
   * @throws IllegalArgumentException when one is not known; the message names those that are
   */
  public static Set<VisionCharacter> parse(String labels) {
    Set<VisionCharacter> all = EnumSet.noneOf(VisionCharacter.class);
    for (String label : labels.split(",", -1)) {
      all.add(
          Arrays.stream(values())
              .filter(c -> c.label().equals(label.trim()))
              .findFirst()
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          "unknown vision '"
                              + label
                              + "'; known are "
                              + Arrays.stream(values())
                                  .map(VisionCharacter::label)
                                  .collect(Collectors.joining(", ")))));
    }
    return all;
  }

  /**
   * A field with such a vision.
   *
   * @param characters of its vision
   * @param settings of the field
   * @return the changed settings
   */
  public static SimulationSettings apply(
      Collection<VisionCharacter> characters, SimulationSettings settings) {
    SimulationSettings changed = settings;
    for (VisionCharacter character : characters) {
      changed = character.applyTo(changed);
    }
    return changed;
  }

  private SimulationSettings applyTo(SimulationSettings settings) {
    CameraSettings cameras = settings.cameras();
    return switch (this) {
      case IDEAL -> settings;
      case SIMULTANEOUS -> settings.withCameras(cameras.withExposure(Exposure.TOGETHER));
      case DISAGREEING ->
          settings.withCameras(cameras.withRegistration(cameras.ballPlane(), DISAGREEMENT));
      case NOISELESS -> settings.withCameras(cameras.withNoise(LITTLE, LITTLE));
      case STALLING -> {
        Nuisance n = settings.nuisance();
        yield settings.withNuisance(
            new Nuisance(
                n.falseBallRate(),
                n.falseClusterRate(),
                n.ballMiss(),
                n.robotMiss(),
                LOST,
                STALLS_PER_SECOND,
                n.jitter(),
                n.stampNoise(),
                n.duplicates(),
                n.shadows(),
                n.outages(),
                n.robotMisread()));
      }
      case MISREADING -> settings.withNuisance(settings.nuisance().withRobotMisread(MISREAD));
    };
  }
}
