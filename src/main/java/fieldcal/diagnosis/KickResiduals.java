package fieldcal.diagnosis;

import fieldcal.ball.BallTrajectory;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;

/**
 * One kick under the simple and under the extended model, both fitted jointly.
 *
 * @param kick the observations
 * @param kind flat or chip
 * @param before path by the simple model
 * @param after path by the extended model
 * @param xBefore seen minus predicted x of each observation in the ground plane, simple model, m
 * @param yBefore the same for y, m
 * @param xAfter as {@code xBefore}, extended model, m
 * @param yAfter the same for y, m
 * @param used whether each observation took part
 * @param rmsBeforeMm root mean square residual per axis when the kick is held out, simple model, mm
 * @param rmsAfterMm the same with the extended model, mm
 */
public record KickResiduals(
    Kick kick,
    KickKind kind,
    BallTrajectory before,
    BallTrajectory after,
    double[] xBefore,
    double[] yBefore,
    double[] xAfter,
    double[] yAfter,
    boolean[] used,
    double rmsBeforeMm,
    double rmsAfterMm) {}
