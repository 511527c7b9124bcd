package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.live.ConfiguredLimits;
import fieldcal.vision.Team;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;

/** Reads what a page says of how robots are configured: {@code yellow_limits} and {@code blue_limits}, each as velocity, acceleration, braking. */
final class RobotLimits {
  private static final int LONGEST = 60;

  private RobotLimits() {}

  /**
   * The limits of the teams that are named.
   *
   * @throws ApiException when they are not three positive numbers
   */
  static Map<Team, ConfiguredLimits> of(JsonNode body) {
    Map<Team, ConfiguredLimits> all = new EnumMap<>(Team.class);
    for (Team team : Team.values()) {
      String text = Requests.text(body, team.label() + "_limits", LONGEST).strip();
      if (!text.isEmpty()) {
        all.put(team, limits(team, text));
      }
    }
    return all;
  }

  private static ConfiguredLimits limits(Team team, String text) {
    try {
      double[] v = Arrays.stream(text.split("[,;\\s]+")).mapToDouble(Double::parseDouble).toArray();
      if (v.length == 3 && Arrays.stream(v).noneMatch(Double::isNaN)) {
        return new ConfiguredLimits(v[0], v[1], v[2]);
      }
    } catch (IllegalArgumentException e) {
      // The message below says what is expected.
    }
    throw ApiException.badRequest(
        "the limits of "
            + team.label()
            + " must be velocity, acceleration and braking, three positive numbers like 3, 3.5, 5");
  }
}
