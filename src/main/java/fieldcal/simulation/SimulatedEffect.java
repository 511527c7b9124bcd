package fieldcal.simulation;

import static fieldcal.simulation.EffectParameter.camera;
import static fieldcal.simulation.EffectParameter.number;
import static fieldcal.simulation.EffectParameter.region;
import static fieldcal.simulation.EffectParameter.robot;
import static fieldcal.simulation.EffectParameter.team;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What can be switched on in the simulated field: the causes of the design's table with its names and parameters, the two of robots, and some that are in no catalogue. A parameter that is not
 * given is zero (camera: 0) unless stated otherwise.
 */
public enum SimulatedEffect {
  /** Drag on the ground and in flight. */
  AIR_DRAG(number("cd", -5, 5)),
  /** Lift of a spinning ball. */
  MAGNUS(number("cl", -5, 5)),
  /** Spin right after the kick about the rolling axis; its mean and its scatter from kick to kick. */
  KICK_SPIN(number("fraction", -5, 5), number("scatter", 0, 5), number("chips", -5, 5)),
  /** Spin right after the kick about the direction of travel; its mean and its scatter from kick to kick. */
  SIDE_SPIN(number("fraction", -5, 5), number("scatter", 0, 5)),
  /** The field is not level; a flying or sliding ball feels all of it, a rolling one 1/(1+β). */
  FIELD_SLOPE(number("percent", -20, 20), number("direction", -10, 10)),
  /** Rolling resistance depends on the direction of travel. */
  CARPET_NAP(number("amplitude", -0.9, 0.9), number("direction", -10, 10)),
  /** Rolling resistance grows with speed. */
  SPEED_DEPENDENT_ROLL(number("slope", -0.2, 2)),
  /** Friction differs in a rectangle. */
  WORN_REGION(number("change", -0.9, 10), region("region")),
  /** One camera reports everything shifted, relative to the mean of all cameras. */
  CAMERA_OFFSET(number("x_mm", -500, 500), number("y_mm", -500, 500), camera()),
  /** One camera's time stamps are late. */
  CAMERA_TIME_OFFSET(number("ms", -100, 100), camera()),
  /** One camera's published pose differs from the true one. */
  CAMERA_POSE_ERROR(
      number("tilt_mrad", -100, 100),
      number("axis", -10, 10),
      number("height_mm", -1000, 1000),
      number("shift_x_mm", -500, 500),
      number("shift_y_mm", -500, 500),
      camera()),
  /** One camera's position is published wrong, while vision itself computes with the true one; of all cameras if none is given. */
  CAMERA_POSITION_ERROR(
      number("x_mm", -1000, 1000),
      number("y_mm", -1000, 1000),
      number("height_mm", -1000, 1000),
      camera()),
  /** One camera's published distortion differs from the true one; of all cameras if none is given. */
  LENS_DISTORTION_ERROR(number("delta", -0.2, 0.2), camera()),
  /** Vision projects balls onto a plane that is too high. */
  BALL_HEIGHT_ERROR(number("mm", -100, 100)),
  /** Vertical restitution depends on the impact's speed. */
  SPEED_DEPENDENT_RESTITUTION(number("slope", -0.5, 0.5)),
  /** Tangential restitution depends on spin. */
  BOUNCE_SPIN_COUPLING(number("coefficient", -2, 2)),
  /** Rolling resistance changes over the session. */
  DRIFT(number("percent_per_10min", -500, 500)),
  /** One robot kicks faster than its command, or off from it. */
  ROBOT_KICK_BIAS(number("percent", -90, 200), number("yaw", -1, 1), team(), robot()),
  /** One camera's clock runs fast. */
  CLOCK_SKEW(number("ppm", -100_000, 100_000), camera()),
  /** Image rows are exposed one after another. */
  ROLLING_SHUTTER(number("ms", -50, 50)),
  /** Robots accelerate less the faster they drive. */
  TORQUE_LIMITED(number("coefficient", 0, 0.95), team()),
  /** Robots accelerate less sideways. */
  DIRECTIONAL(number("coefficient", 0, 0.95), team()),
  /** The air moves towards a direction; without drag this has no effect. */
  WIND(number("speed", -20, 20), number("direction", -10, 10)),
  /** Sliding friction depends on the speed of slipping. */
  SLIP_DEPENDENT_FRICTION(number("slope", -0.45, 1)),
  /** One camera was knocked at a time of the session. */
  CAMERA_MOVED(
      number("x_mm", -500, 500), number("y_mm", -500, 500), number("at", 0, 1e6), camera()),
  /** Another ball from a time of the session on. */
  BALL_CHANGED(number("roll", -0.9, 5), number("slide", -0.9, 5), number("at", 0, 1e6)),
  /** Impacts are contacts: the part 1 + reversed of the slip is undone, as far as friction can; speed and spin lose a share, and rolling resistance brakes a spinning ball; hops end at the league's 10 mm unless stated otherwise; without friction this has no effect. */
  CONTACT_IMPACTS(
      number("reversed", -1, 1),
      number("friction", 0, 5),
      number("loss", -0.1, 0.9),
      number("rolling", -0.05, 0.9),
      number("lowest_hop_mm", 0.1, 1000)),
  /** A seam of the carpet takes speed and turns paths. */
  CARPET_SEAM(
      number("loss", -0.5, 0.9),
      number("turn", -1, 1),
      number("normal", -10, 10),
      number("distance", -100, 100)),
  /** Not in the catalogue: strips of carpet, 1 m wide each unless said otherwise, roll differently. */
  CARPET_WAVES(number("amplitude", -0.9, 0.9), number("wavelength", 0.05, 100)),
  /** Not in the catalogue: one camera's mount swings, at 1 Hz unless said otherwise. */
  CAMERA_SHAKE(number("amplitude_mm", -100, 100), number("hz", 0.01, 30), camera()),
  /** Not in the catalogue: vertical restitution depends on the place. */
  UNNAMED_RESTITUTION_PLACE(number("change", -0.9, 0.9), number("direction", -10, 10)),
  /** Not in the catalogue: rolling resistance grows with the square of the speed, 1/m. */
  UNNAMED_ROLL_SQUARE(number("slope", -0.05, 2)),
  /** Not in the catalogue: rolling resistance is larger at one speed, 1.5 m/s and 0.4 m/s wide unless said otherwise. */
  UNNAMED_ROLL_BUMP(number("height", -0.9, 10), number("speed", 0, 10), number("width", 0.05, 10)),
  /** Not in the catalogue: sliding friction fades after the kick, within 0.3 s unless said otherwise. */
  UNNAMED_FADING_FRICTION(number("change", -0.9, 10), number("duration", 0.01, 100)),
  /** Not in the catalogue: a rough ring around the centre, from 1.5 m to 2.5 m unless said otherwise. */
  UNNAMED_RING(number("change", -0.9, 10), number("inner", 0, 100), number("outer", 0, 100)),
  /** Not in the catalogue: resistance varies once per turn of the rolling ball. */
  UNNAMED_ONCE_PER_TURN(number("amplitude", -50, 50)),
  /** Not in the catalogue: friction is larger along four directions. */
  UNNAMED_FOUR_WAYS(number("amplitude", -0.9, 0.9), number("direction", -10, 10)),
  /** Not in the catalogue: what an impact takes along the carpet depends on its speed. */
  UNNAMED_IMPACT_SPEED(number("slope", -0.15, 0.15)),
  /** Not in the catalogue: a force to the left, proportional to the speed. */
  UNNAMED_SIDE_FORCE(number("rate", -2, 2)),
  /** Not in the catalogue: sticky patches in a grid, 0.8 m apart unless said otherwise. */
  UNNAMED_PATCHES(number("change", -0.9, 20), number("pitch", 0.3, 10)),
  /** Not in the catalogue: an error of one camera's lens that is not radial: x is shifted by this length times ξ²η (see {@link fieldcal.simulation.imaging.CameraErrors#shear}). */
  UNNAMED_LENS_SHEAR(number("mm", -500, 500), camera());

  private static final Set<SimulatedEffect> ALL_CAMERAS_UNLESS_SAID =
      EnumSet.of(LENS_DISTORTION_ERROR, CAMERA_POSITION_ERROR);

  private static final Set<SimulatedEffect> UNKNOWN_TO_THE_CATALOGUE =
      EnumSet.of(
          CARPET_WAVES,
          CAMERA_SHAKE,
          UNNAMED_RESTITUTION_PLACE,
          UNNAMED_ROLL_SQUARE,
          UNNAMED_ROLL_BUMP,
          UNNAMED_FADING_FRICTION,
          UNNAMED_RING,
          UNNAMED_ONCE_PER_TURN,
          UNNAMED_FOUR_WAYS,
          UNNAMED_IMPACT_SPEED,
          UNNAMED_SIDE_FORCE,
          UNNAMED_PATCHES,
          UNNAMED_LENS_SHEAR);

  private final List<EffectParameter> parameters;

  SimulatedEffect(EffectParameter... parameters) {
    this.parameters = List.of(parameters);
  }

  /**
   * The effect's name in commands and files.
   *
   * @return lower case with underscores
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Whether the design's table lists it. The others exist to show that a diagnosis does not name a known cause for an unknown one.
   *
   * @return false for causes that no diagnosis can name
   */
  public boolean catalogued() {
    return !UNKNOWN_TO_THE_CATALOGUE.contains(this);
  }

  /** Whether it concerns all cameras when none is given; else camera 0. */
  boolean allCamerasUnlessSaid() {
    return ALL_CAMERAS_UNLESS_SAID.contains(this);
  }

  /**
   * What can be set.
   *
   * @return the magnitude first
   */
  public List<EffectParameter> parameters() {
    return parameters;
  }

  /**
   * A parameter by name.
   *
   * @param name its name
   * @return the parameter, if there is one
   */
  public Optional<EffectParameter> parameter(String name) {
    return parameters.stream().filter(p -> p.name().equals(name)).findFirst();
  }

  /**
   * The effect of an id.
   *
   * @param id as in {@link #id}
   * @return the effect
   * @throws IllegalArgumentException when there is none; the message lists all
   */
  public static SimulatedEffect of(String id) {
    return Arrays.stream(values())
        .filter(e -> e.id().equals(id))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "unknown effect '"
                        + id
                        + "'; known are "
                        + Arrays.stream(values())
                            .map(SimulatedEffect::id)
                            .collect(Collectors.joining(", "))));
  }
}
