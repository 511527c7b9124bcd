package fieldcal.app.play;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CommandedKick;
import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What one robot makes of its kick commands: measured speed = offset + gain · commanded speed, turned by yaw; what is left scatters from kick to kick. Standard errors assume that this scatter is
 * random and the same at all speeds. A few kicks may agree by chance: their errors also assume that kicks scatter by at least about 1 % and 0.5°, and are widened by Student's t.
 *
 * @param robot who
 * @param kind flat kicks or chips
 * @param kicks how many
 * @param gain (–)
 * @param gainError standard error; NaN with too few kicks to tell
 * @param offset m/s; NaN when the speeds are too few or too alike to tell it from the gain: then the gain is measured over commanded speed
 * @param offsetError m/s; NaN when the offset was not estimated
 * @param speedScatter standard deviation from kick to kick, m/s; NaN with too few kicks to tell: two more than are fitted are needed
 * @param yaw to the left of what was commanded, rad
 * @param yawError rad; NaN with one kick
 * @param yawScatter rad; NaN with one kick
 * @param elevation above what was commanded, rad; 0 for flat kicks
 * @param elevationError rad; NaN with one kick
 * @param elevationScatter rad; NaN with one kick
 */
public record KickStrength(
    RobotId robot,
    KickKind kind,
    int kicks,
    double gain,
    double gainError,
    double offset,
    double offsetError,
    double speedScatter,
    double yaw,
    double yawError,
    double yawScatter,
    double elevation,
    double elevationError,
    double elevationScatter) {

  /** Kicks whose commanded speeds differ less than that, as a standard deviation, cannot tell an offset from a gain, m/s. */
  private static final double LEAST_SPREAD = 0.4;

  /** What kicks scatter by, as far as is known before there are any, as a share of the speed, and rad; chosen: good kickers do. It weighs as much as one kick. */
  private static final double USUAL_SPEED_SCATTER = 0.01;

  private static final double USUAL_ANGLE_SCATTER = Math.toRadians(0.5);

  /** The scatter that standard errors assume, with what usual kicks scatter by, and the squares of what is left with so many degrees of freedom; NaN without any. */
  private static double assumedScatter(double usual, double squares, int free) {
    if (free < 1) {
      return Double.NaN;
    }
    // The usual scatter is one more degree of freedom, samples are another one more.
    return Estimate.student(free + 2) * Math.sqrt((usual * usual + squares) / (free + 1));
  }

  /** Told and measured, of one kick. */
  record Pair(double told, double speed, double yaw, double elevation) {}

  /** Mean, its standard error, if it is one of angles, and the scatter. */
  private record Mean(double value, double error, double scatter) {
    static Mean of(double[] values) {
      double sum = 0;
      for (double v : values) {
        sum += v;
      }
      double mean = sum / values.length;
      double squares = 0;
      for (double v : values) {
        squares += (v - mean) * (v - mean);
      }
      int free = values.length - 1;
      double scatter = free > 0 ? Math.sqrt(squares / free) : Double.NaN;
      double assumed = assumedScatter(USUAL_ANGLE_SCATTER, squares, free);
      return new Mean(mean, assumed / Math.sqrt(values.length), scatter);
    }
  }

  /**
   * From a calibration whose commands are known.
   *
   * @param outcome of a calibration
   * @return one entry for each robot and kind, by name
   */
  public static List<KickStrength> of(CalibrationOutcome outcome) {
    Map<RobotId, Map<KickKind, List<Pair>>> pairs = new TreeMap<>();
    for (KickFit fit : outcome.calibration().trusted()) {
      commanded(outcome, fit)
          .ifPresent(
              kick ->
                  pairs
                      .computeIfAbsent(kick.command().robot(), r -> new TreeMap<>())
                      .computeIfAbsent(kick.kind(), k -> new ArrayList<>())
                      .add(
                          new Pair(
                              kick.command().speed(), kick.speed(), kick.yaw(), kick.elevation())));
    }
    List<KickStrength> all = new ArrayList<>();
    pairs.forEach((robot, kinds) -> kinds.forEach((kind, list) -> all.add(fit(robot, kind, list))));
    return all;
  }

  private static Optional<CommandedKick> commanded(CalibrationOutcome outcome, KickFit fit) {
    return CommandedKick.of(
        outcome.command(fit.kick()),
        fit.kind(),
        fit.estimate("vx").value(),
        fit.estimate("vy").value(),
        fit.kind() == KickKind.CHIP ? fit.estimate("vz").value() : 0);
  }

  /** From one robot's kicks of one kind. */
  static KickStrength fit(RobotId robot, KickKind kind, List<Pair> pairs) {
    int n = pairs.size();
    Mean told = Mean.of(pairs.stream().mapToDouble(Pair::told).toArray());
    Mean yaw = Mean.of(pairs.stream().mapToDouble(Pair::yaw).toArray());
    Mean lift = Mean.of(pairs.stream().mapToDouble(Pair::elevation).toArray());
    boolean line = n >= 3 && told.scatter() > LEAST_SPREAD;
    // Without an offset the line goes through zero.
    double centre = line ? told.value() : 0;
    double squares = 0;
    double products = 0;
    double speeds = 0;
    for (Pair p : pairs) {
      squares += (p.told - centre) * (p.told - centre);
      products += (p.told - centre) * p.speed;
      speeds += p.speed;
    }
    double gain = products / squares;
    double through = line ? speeds / n - gain * centre : 0;
    double offset = line ? through : Double.NaN;
    double rest = 0;
    for (Pair p : pairs) {
      rest += Math.pow(p.speed - through - gain * p.told, 2);
    }
    int free = n - (line ? 2 : 1);
    double scatter = free > 1 ? Math.sqrt(rest / free) : Double.NaN;
    double assumed = assumedScatter(USUAL_SPEED_SCATTER * speeds / n, rest, free);
    double offsetError =
        line ? assumed * Math.sqrt(1.0 / n + centre * centre / squares) : Double.NaN;
    return new KickStrength(
        robot,
        kind,
        n,
        gain,
        assumed / Math.sqrt(squares),
        offset,
        offsetError,
        scatter,
        yaw.value(),
        yaw.error(),
        yaw.scatter(),
        lift.value(),
        lift.error(),
        lift.scatter());
  }
}
