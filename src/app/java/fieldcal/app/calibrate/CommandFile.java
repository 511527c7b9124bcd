package fieldcal.app.calibrate;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What the robots were commanded: a CSV file with the columns {@value #HEADER}. */
public final class CommandFile {
  /** Its first line. */
  public static final String HEADER = "t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg";

  /** A kick follows its command within that time: reaction of the robot and delay of the cameras, s. */
  private static final double LONGEST_DELAY = 0.5;

  /** Clocks of vision and AI may differ by that much, s. */
  private static final double CLOCKS = 0.1;

  private CommandFile() {}

  /**
   * One command.
   *
   * @param unixTime s
   * @param robot who was commanded
   * @param kind "flat" or "chip"
   * @param speed absolute speed, m/s
   * @param direction in the plane, rad
   * @param elevation above it, rad
   */
  public record Command(
      double unixTime,
      RobotId robot,
      String kind,
      double speed,
      double direction,
      double elevation) {}

  /**
   * Reads.
   *
   * @param file from where
   * @return the commands in order of the file
   * @throws InputException with file and line when a line is not as it should be
   * @throws IOException when it cannot be read
   */
  public static List<Command> read(Path file) throws IOException {
    List<String> lines = new String(JsonFiles.bytes(file), StandardCharsets.UTF_8).lines().toList();
    if (lines.isEmpty() || !lines.get(0).trim().equals(HEADER)) {
      throw new InputException(file + ", line 1: the columns must be " + HEADER);
    }
    List<Command> commands = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      if (!lines.get(i).isBlank()) {
        commands.add(parse(lines.get(i), file + ", line " + (i + 1)));
      }
    }
    return commands;
  }

  private static Command parse(String line, String place) throws InputException {
    String[] f = line.split(",", -1);
    if (f.length != 7) {
      throw new InputException(place + ": 7 columns expected, found " + f.length);
    }
    Arrays.setAll(f, i -> f[i].trim());
    Optional<Team> team =
        Arrays.stream(Team.values()).filter(t -> t.name().equalsIgnoreCase(f[1])).findFirst();
    if (team.isEmpty()) {
      throw new InputException(place + ": team must be yellow or blue, not \"" + f[1] + "\"");
    }
    if (!f[3].equals("flat") && !f[3].equals("chip")) {
      throw new InputException(place + ": kind must be flat or chip, not \"" + f[3] + "\"");
    }
    double time = number(f[0], "t_unix", place);
    double robot = number(f[2], "id", place);
    double speed = number(f[4], "speed_mps", place);
    double direction = number(f[5], "direction_deg", place);
    double elevation = number(f[6], "elevation_deg", place);
    if (robot != Math.rint(robot) || robot < 0 || robot > 255) {
      throw new InputException(place + ": id must be a robot's number, not \"" + f[2] + "\"");
    }
    if (!(speed >= 0)) {
      throw new InputException(place + ": speed_mps must not be negative, but is " + f[4]);
    }
    RobotId id = new RobotId(team.get(), (int) robot);
    return new Command(time, id, f[3], speed, Math.toRadians(direction), Math.toRadians(elevation));
  }

  private static double number(String text, String column, String place) throws InputException {
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // Reported below, with the column's name.
    }
    throw new InputException(place + ": " + column + " must be a number, not \"" + text + "\"");
  }

  /**
   * The command that a kick followed.
   *
   * @param commands all of them
   * @param unixTime of the kick, s
   * @param robot who kicked; empty when unknown
   * @return the nearest command of that robot that fits in time
   */
  public static Optional<Command> of(
      List<Command> commands, double unixTime, Optional<RobotId> robot) {
    Command best = null;
    for (Command c : commands) {
      double delay = unixTime - c.unixTime;
      boolean fits =
          delay > -CLOCKS
              && delay < LONGEST_DELAY
              && (robot.isEmpty() || robot.get().equals(c.robot));
      if (fits && (best == null || Math.abs(delay) < Math.abs(unixTime - best.unixTime))) {
        best = c;
      }
    }
    return Optional.ofNullable(best);
  }
}
