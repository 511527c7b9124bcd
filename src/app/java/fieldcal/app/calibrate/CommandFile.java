package fieldcal.app.calibrate;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What the robots were told: a CSV file with the columns {@value #HEADER}. */
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
   * @param robot who was told
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
    List<String> lines;
    try {
      lines = Files.readAllLines(file);
    } catch (NoSuchFileException e) {
      throw new InputException(file + ": no such file");
    } catch (MalformedInputException e) {
      throw new InputException(file + ": no text file");
    }
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
    try {
      Team team = Team.valueOf(f[1].toUpperCase(Locale.ROOT));
      double[] v = {
        Double.parseDouble(f[0]),
        Double.parseDouble(f[4]),
        Double.parseDouble(f[5]),
        Double.parseDouble(f[6])
      };
      if (!Double.isFinite(v[0] + v[1] + v[2] + v[3])) {
        throw new InputException(place + ": not finite: " + line);
      }
      RobotId robot = new RobotId(team, Integer.parseInt(f[2]));
      return new Command(v[0], robot, f[3], v[1], Math.toRadians(v[2]), Math.toRadians(v[3]));
    } catch (IllegalArgumentException e) {
      throw new InputException(place + ": " + e.getMessage());
    }
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
