package fieldcal.movement;

import fieldcal.vision.Team;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * {@link MovementStatistics} as plain cells and back, so that they can be stored, added up by anybody, and estimated from again. Integers all the way: what was taken apart and put together
 * again, of however many matches and in whatever order, is what {@link MovementStatistics#merge} would give.
 *
 * <p>Each cell is of one histogram: {@code accelerating} and {@code braking} (x: acceleration, m/s²; y: speed, m/s; the number of the cell also holds error and direction), {@code top_speeds}, {@code
 * sure_speeds}, {@code cruising} of one robot, {@code league_velocity} (x: m/s), {@code league_acceleration}, {@code league_braking} (x: m/s²), {@code own_frame} (x to the front and y to the left,
 * m/s²), {@code against_speed} (x: m/s, y: m/s²), {@code robots} (x: number), {@code manoeuvres} (one cell), {@code standing} (x and y: deviation, mm) and {@code standing_squares} (x: mm²), which
 * are of no team.
 */
public final class MovementCells {
  private static final String CRUISING = "cruising";
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

  /** Takes cells. */
  public interface Visitor {
    /**
     * One more.
     *
     * @param cell that has counted something
     */
    void visit(Cell cell);
  }

  private MovementCells() {}

  /**
   * Takes statistics apart.
   *
   * @param statistics stay as they are
   * @param visitor is told all cells that have counted something, always in the same order
   */
  public static void of(MovementStatistics statistics, Visitor visitor) {
    for (Team team : Team.values()) {
      TeamStatistics one = statistics.of(team);
      Optional<Team> whose = Optional.of(team);
      one.acceleratingManoeuvres().cells(sink(visitor, whose, "accelerating"));
      one.brakingManoeuvres().cells(sink(visitor, whose, "braking"));
      grids(one).forEach((name, grid) -> grid.cells(sink(visitor, whose, name)));
      histograms(one).forEach((name, counted) -> counted.cells(sink(visitor, whose, name)));
      one.cruising()
          .forEach(
              (robot, speeds) ->
                  speeds.cells(
                      (number, x, y, count) ->
                          visitor.visit(
                              new Cell(whose, CRUISING, Optional.of(robot), number, x, y, count))));
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

  private static Map<String, Grid> grids(TeamStatistics team) {
    Map<String, Grid> grids = new LinkedHashMap<>();
    grids.put("own_frame", team.ownFrame());
    grids.put("against_speed", team.againstSpeed());
    return grids;
  }

  private static Map<String, Histogram> histograms(TeamStatistics team) {
    Map<String, Histogram> histograms = new LinkedHashMap<>();
    histograms.put("top_speeds", team.topSpeeds());
    histograms.put("sure_speeds", team.sureSpeeds());
    histograms.put("league_velocity", team.league().velocity());
    histograms.put("league_acceleration", team.league().acceleration());
    histograms.put("league_braking", team.league().braking());
    return histograms;
  }

  /**
   * Adds a cell to statistics.
   *
   * @param statistics that count it from now on
   * @param cell what was told; only the names and numbers matter, not its centre
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
    return switch (cell.histogram()) {
      case "accelerating" -> team.acceleratingManoeuvres().addCell(number, count);
      case "braking" -> team.brakingManoeuvres().addCell(number, count);
      case CRUISING ->
          cell.robot().isPresent() && team.cruisingOf(cell.robot().get()).addCell(number, count);
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
