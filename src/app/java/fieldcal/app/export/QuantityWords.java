package fieldcal.app.export;

import fieldcal.app.wording.ParameterWords;
import java.util.Map;

/** What people call the {@linkplain Quantities quantities} of a model. */
final class QuantityWords {
  private static final Map<String, String> WORDS =
      Map.ofEntries(
          Map.entry("inertia", "inertia of the ball"),
          Map.entry("min_bounce_speed", "lowest speed of an impact that makes the ball hop"),
          Map.entry("roll_slope", "growth of the rolling deceleration with speed"),
          Map.entry("ball_noise", "noise of the cameras"),
          Map.entry("camera_offset", "offsets of the cameras"),
          Map.entry("robot_noise", "noise of robots' positions"),
          Map.entry("robot_angle_noise", "noise of robots' orientations"),
          Map.entry("missed_balls", "share of balls that cameras miss"),
          Map.entry("missed_robots", "share of robots that cameras miss"),
          Map.entry("processing_time", "time from exposure to sending"),
          Map.entry("velocity_max", "largest velocity"),
          Map.entry("acceleration_max", "largest acceleration"),
          Map.entry("braking_max", "largest braking"),
          Map.entry("angular_velocity_max", "largest rate of turning"),
          Map.entry("angular_acceleration_max", "largest angular acceleration"),
          Map.entry("angular_braking_max", "largest angular braking"));

  private QuantityWords() {}

  /**
   * What it is called.
   *
   * @param quantity as descriptors have it, also with a team, for example {@code blue.velocity_max}
   * @return for example "largest velocity of blue"
   */
  static String of(String quantity) {
    int dot = quantity.indexOf('.');
    if (dot >= 0) {
      return of(quantity.substring(dot + 1)) + " of " + quantity.substring(0, dot);
    }
    String known = WORDS.get(quantity);
    return known != null ? known : ParameterWords.ofFileName(quantity);
  }
}
