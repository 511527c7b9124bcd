package fieldcal.play;

import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import java.util.Arrays;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.DoubleStream;

/**
 * What is to be played.
 *
 * @param first one robot
 * @param second the other, of either team
 * @param area where they may be
 * @param line along which the ball is kicked
 * @param otherLine along which it is kicked after the ends were swapped
 * @param kicks how many good kicks are wanted
 * @param limits speeds and time-outs
 */
public record PlayPlan(
    RobotId first,
    RobotId second,
    PlayArea area,
    PlayLine line,
    PlayLine otherLine,
    int kicks,
    PlayLimits limits) {

  /** A ball may lie this far outside of what the lines span and still be kicked from there, m. */
  private static final double ASIDE = 0.7;

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException when one is null
   * @throws IllegalArgumentException when the robots are the same, no kick is wanted, or a line's end is outside the field
   */
  public PlayPlan {
    Objects.requireNonNull(limits, "limits");
    if (first.equals(second)) {
      throw new IllegalArgumentException("the play needs two robots, not " + first + " twice");
    }
    if (kicks < 1) {
      throw new IllegalArgumentException("at least one kick is needed, not " + kicks);
    }
    for (PlayLine l : new PlayLine[] {line, otherLine}) {
      for (int end = 0; end < 2; end++) {
        if (Math.abs(l.x(end)) > area.length() / 2 || Math.abs(l.y(end)) > area.width() / 2) {
          throw new IllegalArgumentException(
              String.format(
                      Locale.ROOT,
                      "the line of kicks leaves the field: its end (%.1f, %.1f) m",
                      l.x(end),
                      l.y(end))
                  .replace('-', '−'));
        }
      }
    }
  }

  /**
   * Flat kicks along the diagonals.
   *
   * @param first one robot
   * @param second the other
   * @param geometry the field
   * @param half which part of the field
   * @param kicks how many good kicks
   * @return the plan, with the usual limits
   */
  public static PlayPlan flat(
      RobotId first, RobotId second, FieldGeometry geometry, PlayLine.Half half, int kicks) {
    return new PlayPlan(
        first,
        second,
        PlayArea.of(geometry),
        PlayLine.diagonal(geometry, half, false),
        PlayLine.diagonal(geometry, half, true),
        kicks,
        PlayLimits.DEFAULT);
  }

  /**
   * Chips along the half-way line.
   *
   * @param first one robot
   * @param second the other
   * @param geometry the field
   * @param kicks how many good kicks
   * @return the plan
   */
  public static PlayPlan chip(RobotId first, RobotId second, FieldGeometry geometry, int kicks) {
    return new PlayPlan(
        first,
        second,
        PlayArea.of(geometry),
        PlayLine.across(geometry, 0, false),
        PlayLine.across(geometry, 0, true),
        kicks,
        PlayLimits.DEFAULT);
  }

  /**
   * The same plan with other limits.
   *
   * @param newLimits speeds and time-outs
   * @return the changed plan
   */
  public PlayPlan withLimits(PlayLimits newLimits) {
    return new PlayPlan(first, second, area, line, otherLine, kicks, newLimits);
  }

  /**
   * The same plan with another area.
   *
   * @param newArea where robots may be
   * @return the changed plan
   */
  public PlayPlan withArea(PlayArea newArea) {
    return new PlayPlan(first, second, newArea, line, otherLine, kicks, limits);
  }

  /**
   * The same plan with other lines.
   *
   * @param newLine before the ends are swapped
   * @param newOtherLine after that
   * @return the changed plan
   */
  public PlayPlan withLines(PlayLine newLine, PlayLine newOtherLine) {
    return new PlayPlan(first, second, area, newLine, newOtherLine, kicks, limits);
  }

  /** Whether a point is in the part of the field that the lines span, or near it. */
  boolean contains(double x, double y) {
    double most = ASIDE;
    double[] xs = {line.x0(), line.x1(), otherLine.x0(), otherLine.x1()};
    double[] ys = {line.y0(), line.y1(), otherLine.y0(), otherLine.y1()};
    Arrays.sort(xs);
    Arrays.sort(ys);
    return x > xs[0] - most && x < xs[3] + most && y > ys[0] - most && y < ys[3] + most;
  }

  /** Whether a place is in the half of the field that the lines keep to, if they do: somebody else may use the other half. */
  boolean keepsTo(double x) {
    DoubleStream ends = DoubleStream.of(line.x0(), line.x1(), otherLine.x0(), otherLine.x1());
    return ends.anyMatch(end -> end * x >= 0);
  }

  RobotId robot(int index) {
    return index == 0 ? first : second;
  }

  PlayLine lineOf(PlannedKick kick) {
    return kick.otherLine() ? otherLine : line;
  }
}
