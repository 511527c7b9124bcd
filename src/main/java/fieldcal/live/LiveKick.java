package fieldcal.live;

import fieldcal.kick.KickEnd;
import fieldcal.kick.KickKind;
import fieldcal.vision.RobotId;
import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A kick and the parameters that it determines.
 *
 * @param id running number within the watched match, from 1
 * @param time Unix time, s
 * @param x place of the kick, m
 * @param y place of the kick, m
 * @param vx velocity after the kick, m/s; of a chip over the ground
 * @param vy velocity after the kick, m/s
 * @param endX where the ball was seen last, m
 * @param endY where the ball was seen last, m
 * @param robot who kicked, if known
 * @param kind flat or chip; empty when it could not be fitted
 * @param end why it ended
 * @param possiblySpinning whether the kicker dribbled or caught the ball before; see {@link BallParameter#spinSensitive} for what that means
 * @param rmsMm residual of the fit per axis, mm; NaN without a fit
 * @param samples the samples that count, by parameter; empty when none does
 * @param unused why no sample counts; empty when one does
 */
public record LiveKick(
    int id,
    double time,
    double x,
    double y,
    double vx,
    double vy,
    double endX,
    double endY,
    Optional<RobotId> robot,
    Optional<KickKind> kind,
    KickEnd end,
    boolean possiblySpinning,
    double rmsMm,
    Map<BallParameter, BallSample> samples,
    Optional<String> unused) {

  /**
   * Copies the map. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   */
  public LiveKick {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(end, "end");
    Objects.requireNonNull(unused, "unused");
    Map<BallParameter, BallSample> copy = new EnumMap<>(BallParameter.class);
    copy.putAll(samples);
    samples = Collections.unmodifiableMap(copy);
  }

  /**
   * Speed after the kick over the ground.
   *
   * @return m/s
   */
  public double speed() {
    return Math.hypot(vx, vy);
  }
}
