package fieldcal.movement;

/**
 * A robot that never drives faster than a speed clearly below its team's limit, and drives at it.
 *
 * @param robot number
 * @param speed m/s
 * @param standardError m/s
 * @param samples how many manoeuvres at constant speed lie there
 */
public record SpeedCap(int robot, double speed, double standardError, long samples) {}
