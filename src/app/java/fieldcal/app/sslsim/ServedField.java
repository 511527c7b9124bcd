package fieldcal.app.sslsim;

import fieldcal.simulation.FieldTrouble;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import java.util.List;

/** A field to be served whose clock is the machine's. */
public final class ServedField {
  private ServedField() {}

  /**
   * A field that begins now.
   *
   * @param settings field, physics, cameras, effects, seed
   * @param first one robot
   * @param second the other
   * @param troubles what goes wrong
   * @param unixNanos now, ns
   * @return the field at time 0, which is now
   * @throws IllegalArgumentException when an effect leaves the range of the physics, or two robots have one name
   */
  public static InteractiveField now(
      SimulationSettings settings,
      RobotId first,
      RobotId second,
      List<FieldTrouble> troubles,
      long unixNanos) {
    long usual = InteractiveField.of(settings, first, second, troubles).epoch().unixNanos();
    return InteractiveField.later(settings, first, second, troubles, (unixNanos - usual) * 1e-9);
  }
}
