package fieldcal.app.cli;

import fieldcal.app.twin.TwinFile;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.Preset;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import fieldcal.simulation.robot.RobotCharacter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Option;

/** What all commands that simulate a field let the operator say of it. */
final class SimulatedFieldOptions {
  @Option(
      names = "--preset",
      paramLabel = "NAME",
      description = "simulated field like a known one: lab, german-open-2026 or robocup-2026")
  private String preset;

  @Option(
      names = "--like",
      paramLabel = "FILE",
      description =
          "simulated field with the ball, cameras, kickers and robots of a twin.json that twin"
              + " wrote")
  private Path like;

  @Option(
      names = "--effect",
      paramLabel = "ID:NAME=VALUE[,NAME=VALUE]",
      description =
          "switches on an effect of the simulated field; may be repeated (docs/effects.md lists"
              + " them)")
  private final List<String> effects = new ArrayList<>();

  @Option(
      names = "--vision-like",
      paramLabel = "NAME[,NAME]",
      description =
          "simulated field: what its vision is like; ideal, simultaneous (cameras stamp the same"
              + " times), disagreeing (40 mm apart), noiseless, stalling, misreading (patterns of"
              + " robots)")
  private String vision = "ideal";

  @Option(
      names = "--robots-like",
      paramLabel = "NAME[,NAME]",
      description =
          "simulated field that is played on or served: what its robots are like; ideal,"
              + " slipping-dribbler, late-kicker, drifting, sluggish, uneven-kicker")
  private String robots = "ideal";

  Set<RobotCharacter> robots() {
    return RobotCharacter.parse(robots);
  }

  /** Whether the field is a twin's: then it says itself what it is made of. */
  boolean likeTwin() {
    return like != null;
  }

  /**
   * The field of the twin or of the preset, if there is one, with the vision that is wanted. The scenario and the seed stay.
   *
   * @throws IOException when the twin's file cannot be read or is none
   */
  SimulationSettings withPreset(SimulationSettings settings) throws IOException {
    if (like != null && preset != null) {
      throw new IllegalArgumentException("give --like or --preset, not both");
    }
    SimulationSettings found = preset == null ? settings : Preset.of(preset).applyTo(settings);
    if (like != null) {
      if (!vision.equals("ideal")) {
        throw new IllegalArgumentException("--vision-like contradicts --like");
      }
      SimulationSettings twin = TwinFile.read(like).settings();
      ScenarioSettings robots = twin.scenario();
      found =
          twin.withSeed(settings.seed())
              .withScenario(settings.scenario().withLimits(robots.yellow(), robots.blue()));
    }
    return VisionCharacter.apply(VisionCharacter.parse(vision), found);
  }

  /** With these effects beside those of the twin; without a twin, with no others. */
  SimulationSettings withEffects(SimulationSettings settings) {
    List<EffectSetting> all = new ArrayList<>(like == null ? List.of() : settings.effects());
    effects.stream().map(EffectSetting::parse).forEach(all::add);
    return settings.withEffects(all);
  }
}
