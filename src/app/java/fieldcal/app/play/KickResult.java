package fieldcal.app.play;

import fieldcal.fit.Estimate;
import fieldcal.fit.KickFit;
import fieldcal.play.PlayedKick;
import java.util.List;
import java.util.Optional;

/**
 * A kick of the session and what its fit says.
 *
 * @param played what was done
 * @param fit of the detections; empty when no kick was found in them, or none yet
 * @param verdict whether it counts; empty while that is open
 * @param reason why it does not count; empty when it does, or while that is open
 * @param used whether a calibration uses it: also one that does not count because it does not determine every parameter is used for those that it determines
 * @param outOfView whether it does not count because its ball left the images of all cameras
 */
public record KickResult(
    PlayedKick played,
    Optional<KickFit> fit,
    Optional<Boolean> verdict,
    String reason,
    boolean used,
    boolean outOfView) {

  static KickResult open(PlayedKick played) {
    return new KickResult(played, Optional.empty(), Optional.empty(), "", false, false);
  }

  /**
   * Whether it counts.
   *
   * @return false also while that is open
   */
  public boolean good() {
    return verdict.orElse(false);
  }

  /**
   * The fit's residual per axis.
   *
   * @return mm; NaN without a fit
   */
  public double rmsMm() {
    return fit.filter(f -> f.failure().isEmpty()).map(KickFit::rmsMm).orElse(Double.NaN);
  }

  /**
   * What the kick determines.
   *
   * @return the parameters that may be averaged
   */
  public List<Estimate> parameters() {
    return fit.map(f -> f.modelEstimates().stream().filter(Estimate::usable).toList())
        .orElse(List.of());
  }

  /**
   * Speed right after the kick, along the ball's path in space.
   *
   * @return m/s; NaN without a fit
   */
  public double speed() {
    return Math.hypot(Math.hypot(value("vx"), value("vy")), lift());
  }

  /**
   * Direction of the kick.
   *
   * @return rad in the field frame; NaN without a fit
   */
  public double direction() {
    return Math.atan2(value("vy"), value("vx"));
  }

  /**
   * Angle of the kick above the carpet.
   *
   * @return rad; 0 for a flat kick, NaN without a fit
   */
  public double elevation() {
    return Math.atan2(lift(), Math.hypot(value("vx"), value("vy")));
  }

  private double lift() {
    boolean chip =
        fit.map(f -> f.estimates().stream().anyMatch(e -> e.name().equals("vz"))).orElse(false);
    return chip ? value("vz") : 0;
  }

  private double value(String name) {
    return fit.filter(f -> f.failure().isEmpty())
        .map(f -> f.estimate(name).value())
        .orElse(Double.NaN);
  }
}
