package fieldcal.ball;

/**
 * Where and when a flight ends on the carpet.
 *
 * @param time time of the impact, s
 * @param x place of the impact, m
 * @param y place of the impact, m
 */
public record Landing(double time, double x, double y) {}
