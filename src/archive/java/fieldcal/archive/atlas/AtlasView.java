package fieldcal.archive.atlas;

import fieldcal.app.report.Rounded;
import java.util.List;

/**
 * What the page shows: plain numbers in SI units, times in s of Unix time, and words. NaN and null are unknown.
 *
 * @param generatedBy program and release
 * @param logs how many, broken ones included
 * @param play minutes between first and last message of all logs
 * @param kicks that were found
 * @param findings in words, one line each
 * @param venues with carpets, changes and cameras
 * @param teams of all tournaments
 * @param binOfSpeeds width of a bin of {@link Speeds}, m/s
 * @param speeds of each team's kicks
 * @param fast kicks near the greatest speed that is allowed
 * @param trackers of each tournament, against the fits of the kicks
 * @param broken logs that could not be read
 * @param problems of the others
 */
public record AtlasView(
    String generatedBy,
    int logs,
    @Rounded(1) double play,
    long kicks,
    List<String> findings,
    List<Venue> venues,
    List<Team> teams,
    double binOfSpeeds,
    List<Speeds> speeds,
    List<Fast> fast,
    List<Tracker> trackers,
    List<Broken> broken,
    List<Problem> problems) {

  /** A value with its error, by the name of a parameter. */
  public record Value(String parameter, @Rounded(6) double value, @Rounded(6) double error) {}

  /** A venue. */
  public record Venue(
      String name,
      List<String> tournaments,
      @Rounded(2) double length,
      @Rounded(2) double width,
      List<Match> matches,
      List<Carpet> carpets,
      List<Change> changes,
      List<Camera> cameras) {}

  /** A match with its model and what was published. */
  public record Match(
      String file,
      @Rounded(0) double start,
      String carpet,
      List<Value> model,
      List<Value> published) {}

  /** A carpet with its pooled parameters. */
  public record Carpet(
      String name,
      @Rounded(0) double first,
      @Rounded(0) double last,
      int matches,
      List<Parameter> parameters) {}

  /** A parameter of a carpet; drift per day. */
  public record Parameter(
      String parameter,
      @Rounded(6) double value,
      @Rounded(6) double error,
      @Rounded(6) double scatter,
      int n,
      @Rounded(6) double drift,
      @Rounded(6) double driftError,
      @Rounded(6) double published) {}

  /** A change between two instants. */
  public record Change(
      @Rounded(0) double after, @Rounded(0) double before, String kind, String words) {}

  /** A camera over all matches of a venue: medians, and the widest range of its offset. */
  public record Camera(
      int id,
      int matches,
      @Rounded(2) double rate,
      @Rounded(5) double noise,
      @Rounded(6) double jitter,
      @Rounded(5) double loss,
      long gaps,
      @Rounded(5) double offset,
      @Rounded(4) double distortion) {}

  /** A team in a tournament. */
  public record Team(
      String tournament,
      String team,
      int matches,
      long manoeuvres,
      List<Quantity> quantities,
      Picture ownFrame,
      Picture againstSpeed,
      Picture standing,
      @Rounded(5) double standingNoise) {}

  /** A quantity of a team's robots, or of one of them; robot −1 stands for all; a direction, rad, only for limits by direction. */
  public record Quantity(
      String name,
      int robot,
      @Rounded(4) double direction,
      @Rounded(4) double value,
      @Rounded(4) double error,
      long samples,
      Boolean reached,
      String note) {}

  /** The cells of a picture that hold something. */
  public record Picture(
      @Rounded(4) double cellX,
      @Rounded(4) double cellY,
      @Rounded(4) double[] x,
      @Rounded(4) double[] y,
      long[] count) {}

  /** Kicks of a team by their speed. */
  public record Speeds(String team, long[] bins, long kicks) {}

  /** A tracker of a tournament, over all matches in which it sent. */
  public record Tracker(
      String tournament,
      String source,
      int matches,
      @Rounded(5) double delay,
      @Rounded(5) double position,
      @Rounded(4) double velocity,
      long kicks,
      long matched,
      long missed,
      long invented,
      @Rounded(4) double speedBias,
      @Rounded(4) double speedScatter,
      long stops,
      @Rounded(4) double stopPosition,
      @Rounded(3) double stopTime) {}

  /** A kick near the greatest speed that is allowed; how fast it is when it begins to roll, and whether the ball was dribbled before. */
  public record Fast(
      String tournament,
      String file,
      @Rounded(1) double time,
      String team,
      int robot,
      String kind,
      @Rounded(3) double speed,
      @Rounded(3) double error,
      @Rounded(3) double odds,
      @Rounded(2) double rolling,
      boolean maySpin) {}

  /** A log that could not be read. */
  public record Broken(String tournament, String file, String why) {}

  /** What was wrong in how many logs. */
  public record Problem(String what, long logs) {}
}
