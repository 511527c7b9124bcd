package fieldcal.app.report.diagnosis;

import fieldcal.app.report.Rounded;

/**
 * One kick, before and after.
 *
 * @param id running number, as in {@code calibration.json}
 * @param kind flat or chip
 * @param source the recording it is from
 * @param unix time of the kick, Unix time in s
 * @param robot who kicked, for example "yellow 3"; empty if unknown
 * @param speed right after the kick, m/s
 * @param direction of the kick, degrees
 * @param observations how many
 * @param rejected how many of them took no part
 * @param rmsBeforeMm residual per axis when it is held out, simple model, mm
 * @param rmsAfterMm the same with the extended model, mm
 * @param before the simple model's path
 * @param after the extended model's path
 * @param seen a part of what was seen
 */
public record KickPicture(
    int id,
    String kind,
    String source,
    @Rounded(3) double unix,
    String robot,
    @Rounded(2) double speed,
    @Rounded(1) double direction,
    int observations,
    int rejected,
    @Rounded(2) double rmsBeforeMm,
    @Rounded(2) double rmsAfterMm,
    Path before,
    Path after,
    Seen seen) {

  /**
   * A path on the field, sampled; columns of equal length.
   *
   * @param t time since the kick, s
   * @param x m
   * @param y m
   * @param heading direction of travel, rad
   */
  public record Path(
      @Rounded(3) double[] t,
      @Rounded(3) double[] x,
      @Rounded(3) double[] y,
      @Rounded(3) double[] heading) {}

  /**
   * Residuals along and across the path, in order of time; columns of equal length.
   *
   * @param t time since the kick, s
   * @param camera which camera
   * @param beforeAlong simple model, mm
   * @param beforeAcross simple model, mm, to the left positive
   * @param afterAlong extended model, mm
   * @param afterAcross extended model, mm
   */
  public record Seen(
      @Rounded(3) double[] t,
      int[] camera,
      @Rounded(1) double[] beforeAlong,
      @Rounded(1) double[] beforeAcross,
      @Rounded(1) double[] afterAlong,
      @Rounded(1) double[] afterAcross) {}
}
