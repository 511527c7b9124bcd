package fieldcal.movement;

import fieldcal.vision.Team;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * {@link MovementStatistics} as plain cells and back, so that they can be stored, added up elsewhere, and estimated from again. All counts are integers. So cells of any number of matches, added in any order, give the same as {@link MovementStatistics#merge}.
 *
 * <p>Each cell is of one histogram. Of one robot are {@code accelerating} and {@code braking} (x: acceleration, m/s²; y: speed, m/s; the number of the cell also holds error and direction), {@code turning_faster} and {@code
 * turning_slower} (the same in rad/s² and rad/s), {@code cruising} (x: m/s) and {@code turning_steadily} (x: rad/s). Of a team are {@code top_speeds}, {@code sure_speeds} (x: m/s), {@code top_turn_speeds}, {@code sure_turn_speeds} (x:
 * rad/s), {@code league_velocity} (x: m/s), {@code league_acceleration}, {@code league_braking} (x: m/s²), {@code own_frame} (x to the front and y to the left, m/s²), {@code against_speed} (x: m/s, y: m/s²), {@code robots} (x: number),
 * {@code manoeuvres} (one cell). Of no team are {@code standing} (x and y: deviation, mm) and {@code standing_squares} (x: mm²).
 */
public final class MovementCells {
  private static final String ROBOTS = "robots";
  private static final String MANOEUVRES = "manoeuvres";

  /** Takes the cells of one histogram. */
  interface Sink {
    /** One cell: its number, its centre (NaN where it has none), and what it has counted. */
    void cell(int number, double x, double y, long count);
  }

  /**
   * One cell that has counted something.
   *
   * @param team whose; empty for what both share
   * @param histogram its name
   * @param robot number of the robot, where there is a histogram for each
   * @param number of the cell within the histogram; one beyond the last stands for all that lay outside
   * @param x its centre, in the unit of the histogram; NaN when it has none
   * @param y its centre; NaN for a histogram of one dimension
   * @param count how much it has counted, above 0
   */
  public record Cell(
      Optional<Team> team,
      String histogram,
      Optional<Integer> robot,
      int number,
      double x,
      double y,
      long count) {}

  /** Receives cells. */
  public interface Visitor {
    /**
     * Receives one cell.
     *
     * @param cell that has counted something
     */
    void visit(Cell cell);
  }

  private MovementCells() {}

  /**
   * Visits the cells of statistics.
   *
   * @param statistics stay as they are
   * @param visitor receives all cells that have counted something, always in the same order
   */
  public static void of(MovementStatistics statistics, Visitor visitor) {
    for (Team team : Team.values()) {
      TeamStatistics one = statistics.of(team);
      Optional<Team> whose = Optional.of(team);
      tables(one)
          .forEach(
              (name, robots) ->
                  robots
                      .robots()
                      .forEach((robot, table) -> table.cells(sink(visitor, whose, name, robot))));
      grids(one).forEach((name, grid) -> grid.cells(sink(visitor, whose, name)));
      histograms(one).forEach((name, counted) -> counted.cells(sink(visitor, whose, name)));
      speeds(one)
          .forEach(
              (name, table) ->
                  table
                      .cruising()
                      .forEach(
                          (robot, counted) -> counted.cells(sink(visitor, whose, name, robot))));
      one.robotCells(sink(visitor, whose, ROBOTS));
      if (one.manoeuvres() > 0) {
        sink(visitor, whose, MANOEUVRES).cell(0, Double.NaN, Double.NaN, one.manoeuvres());
      }
    }
    statistics.standing().cells(sink(visitor, Optional.empty(), "standing"));
    statistics.standingSquares().cells(sink(visitor, Optional.empty(), "standing_squares"));
  }

  private static Sink sink(Visitor visitor, Optional<Team> team, String histogram) {
    return (number, x, y, count) ->
        visitor.visit(new Cell(team, histogram, Optional.empty(), number, x, y, count));
  }

  private static Sink sink(Visitor visitor, Optional<Team> team, String histogram, int robot) {
    return (number, x, y, count) ->
        visitor.visit(new Cell(team, histogram, Optional.of(robot), number, x, y, count));
  }

  private static Map<String, ManoeuvreTables> tables(TeamStatistics team) {
    Map<String, ManoeuvreTables> tables = new LinkedHashMap<>();
    tables.put("accelerating", team.acceleratingManoeuvres());
    tables.put("braking", team.brakingManoeuvres());
    tables.put("turning_faster", team.turningFaster());
    tables.put("turning_slower", team.turningSlower());
    return tables;
  }

  /** Tables of speeds, by the name of their speeds at constant velocity. */
  private static Map<String, SpeedTable> speeds(TeamStatistics team) {
    Map<String, SpeedTable> speeds = new LinkedHashMap<>();
    speeds.put("cruising", team.speeds());
    speeds.put("turning_steadily", team.turnSpeeds());
    return speeds;
  }

  private static Map<String, Grid> grids(TeamStatistics team) {
    Map<String, Grid> grids = new LinkedHashMap<>();
    grids.put("own_frame", team.ownFrame());
    grids.put("against_speed", team.againstSpeed());
    return grids;
  }

  private static Map<String, Histogram> histograms(TeamStatistics team) {
    Map<String, Histogram> histograms = new LinkedHashMap<>();
    histograms.put("top_speeds", team.speeds().tops());
    histograms.put("sure_speeds", team.speeds().sure());
    histograms.put("top_turn_speeds", team.turnSpeeds().tops());
    histograms.put("sure_turn_speeds", team.turnSpeeds().sure());
    histograms.put("league_velocity", team.league().velocity());
    histograms.put("league_acceleration", team.league().acceleration());
    histograms.put("league_braking", team.league().braking());
    return histograms;
  }

  /**
   * Adds a cell to statistics.
   *
   * @param statistics that count it from now on
   * @param cell what was reported; only the names and numbers matter, not its centre
   * @return false, and nothing added, when there is no such cell
   */
  public static boolean add(MovementStatistics statistics, Cell cell) {
    int number = cell.number();
    long count = cell.count();
    if (cell.team().isEmpty()) {
      return switch (cell.histogram()) {
        case "standing" -> statistics.standing().addCell(number, count);
        case "standing_squares" -> statistics.standingSquares().addCell(number, count);
        default -> false;
      };
    }
    TeamStatistics team = statistics.of(cell.team().get());
    if (cell.robot().isPresent()) {
      int robot = cell.robot().get();
      ManoeuvreTables tables = tables(team).get(cell.histogram());
      SpeedTable speeds = speeds(team).get(cell.histogram());
      return tables != null
          ? tables.of(robot).addCell(number, count)
          : speeds != null && speeds.cruisingOf(robot).addCell(number, count);
    }
    return switch (cell.histogram()) {
      case ROBOTS -> team.addRobot(number);
      case MANOEUVRES -> team.addManoeuvres(count);
      default -> {
        Grid grid = grids(team).get(cell.histogram());
        Histogram histogram = histograms(team).get(cell.histogram());
        yield grid != null
            ? grid.addCell(number, count)
            : histogram != null && histogram.addCell(number, count);
      }
    };
  }
}
