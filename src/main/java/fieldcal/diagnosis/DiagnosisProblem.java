package fieldcal.diagnosis;

import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * What a diagnosis is made from.
 *
 * @param fits the kicks, each fitted on its own by the calibration: kind, start, number of flights
 * @param cameras noise of each camera, and the offsets that those fits were made with
 * @param observers what is published of each camera, for the measurement effects; one for every camera that saw a kick
 * @param sessionStart beginning of the session on the clock of the kicks, s: the time stamp of the first frame of the first recording
 * @param commands what the robots were commanded, by the number of the kick; kicks without a command are missing
 * @param maxCauses how many causes may be named, 0 or more
 * @param seed of the bootstrap and the choice of kicks that are held out
 */
public record DiagnosisProblem(
    List<KickFit> fits,
    CameraViews cameras,
    List<ObservedCamera> observers,
    double sessionStart,
    Map<Integer, KickCommand> commands,
    int maxCauses,
    long seed) {

  /** How many causes are named unless told otherwise: a field whose cameras all disagree, and some more. */
  public static final int DEFAULT_MAX_CAUSES = 8;

  /**
   * Leaves out failed fits and copies the collections. {@inheritDoc}
   *
   * @throws IllegalArgumentException when {@code maxCauses} is negative
   */
  public DiagnosisProblem {
    fits = fits.stream().filter(f -> f.failure().isEmpty()).toList();
    Objects.requireNonNull(cameras, "cameras");
    observers = List.copyOf(observers);
    commands = Map.copyOf(commands);
    if (maxCauses < 0) {
      throw new IllegalArgumentException("maxCauses must not be negative, but is " + maxCauses);
    }
  }
}
