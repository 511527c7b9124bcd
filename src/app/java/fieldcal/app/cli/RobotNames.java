package fieldcal.app.cli;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.Locale;

/** Robots as an operator names them. */
final class RobotNames {
  private RobotNames() {}

  /** Two robots, like {@code yellow3,blue5}. */
  static RobotId[] pair(String text) {
    String[] names = text.split(",", -1);
    if (names.length != 2) {
      throw new IllegalArgumentException(
          "--robots takes two robots, like yellow3,blue5, not '" + text + "'");
    }
    RobotId[] pair = {robot(names[0].trim()), robot(names[1].trim())};
    if (pair[0].equals(pair[1])) {
      throw new IllegalArgumentException(
          "--robots takes two different robots, not " + pair[0] + " twice");
    }
    return pair;
  }

  private static RobotId robot(String name) {
    for (Team team : Team.values()) {
      String digits = name.toLowerCase(Locale.ROOT).replaceFirst("^" + team.label() + "[: ]?", "");
      if (digits.length() < name.length() && digits.matches("\\d{1,3}")) {
        return new RobotId(team, Integer.parseInt(digits));
      }
    }
    throw new IllegalArgumentException("a robot is written like yellow3, not '" + name + "'");
  }
}
