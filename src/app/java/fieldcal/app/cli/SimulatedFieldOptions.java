package fieldcal.app.cli;

import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.Preset;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import fieldcal.simulation.robot.RobotCharacter;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Option;

/** What all commands that simulate a field let the operator say of it. */
final class SimulatedFieldOptions {
  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description = "simulated field as it was found: lab, german-open-2026 or robocup-2026")
  private String preset;

  @Option(
      names = "--effect",
      paramLabel = "ID:NAME=VALUE[,NAME=VALUE]",
      description =
          "switches on an effect of the simulated field; may be repeated (simulate --help lists"
              + " them)")
  private final List<String> effects = new ArrayList<>();

  @Option(
      names = "--vision-like",
      paramLabel = "NAME[,NAME]",
      description =
          "simulated field: what its vision is like; ideal, simultaneous (cameras stamp the same"
              + " times), disagreeing (40 mm apart), noiseless, stalling")
  private String vision = "ideal";

  @Option(
      names = "--robots-like",
      paramLabel = "NAME[,NAME]",
      description =
          "simulated field that is played on or served: what its robots are like; ideal,"
              + " slipping-dribbler, late-kicker, drifting")
  private String robots = "ideal";

  Set<RobotCharacter> robots() {
    return RobotCharacter.parse(robots);
  }

  /** The field of the preset, if there is one, with the vision that is wanted. */
  SimulationSettings withPreset(SimulationSettings settings) {
    SimulationSettings found = preset == null ? settings : Preset.of(preset).applyTo(settings);
    return VisionCharacter.apply(VisionCharacter.parse(vision), found);
  }

  /** With the effects, and no others. */
  SimulationSettings withEffects(SimulationSettings settings) {
    return settings.withEffects(effects.stream().map(EffectSetting::parse).toList());
  }
}
