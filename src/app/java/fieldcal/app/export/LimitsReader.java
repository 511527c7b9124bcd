package fieldcal.app.export;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.ExportModel.RobotLimits;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads {@code limits.json}. */
final class LimitsReader {
  private static final List<String> NAMES =
      List.of("velocity_max", "acceleration_max", "braking_max");

  private LimitsReader() {}

  static ExportModel read(Path file, JsonNode root) throws InputException {
    List<RobotLimits> teams = new ArrayList<>();
    Quantities quantities = Quantities.none();
    for (Team team : Team.values()) {
      JsonNode node = root.path("teams").path(team.label());
      Map<String, Double> values = new LinkedHashMap<>();
      List<String> unreached = new ArrayList<>();
      for (String name : NAMES) {
        JsonNode value = node.path(name);
        if (value.isNumber()) {
          values.put(name, value.asDouble());
          quantities = quantities.with(team.label() + "." + name, value.asDouble());
          if (!node.path("reached").path(name).asBoolean(true)) {
            unreached.add(name);
          }
        } else if (!value.isNull() && !value.isMissingNode()) {
          throw new InputException(
              file + ", teams." + team.label() + "." + name + ": must be a number or null");
        }
      }
      for (String name : NAMES) {
        // A lower bound would only make simulated robots slower than they are.
        JsonNode turning = node.path("angular");
        if (turning.path(name).isNumber() && turning.path("reached").path(name).asBoolean(false)) {
          values.put("angular_" + name, turning.path(name).asDouble());
          quantities =
              quantities.with(team.label() + ".angular_" + name, turning.path(name).asDouble());
        }
      }
      Map<String, Double> effects = new LinkedHashMap<>();
      for (JsonNode effect : node.path("effects")) {
        effects.put(
            effect.path("effect").asText(),
            effect.path("parameters").path("coefficient").asDouble());
      }
      if (!values.isEmpty()) {
        teams.add(new RobotLimits(team.label(), values, unreached, effects));
      }
    }
    if (teams.isEmpty()) {
      throw new InputException(file + ": has no limits of any team");
    }
    List<String> sources = new ArrayList<>();
    root.path("sources").forEach(source -> sources.add(source.asText()));
    return ExportModel.withoutBall(file, quantities, teams, sources);
  }
}
