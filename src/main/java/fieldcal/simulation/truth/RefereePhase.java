package fieldcal.simulation.truth;

/**
 * A command of the referee, valid until the next one.
 *
 * @param time session time, s
 * @param command as in the league's messages, for example {@code STOP}
 * @param stage as in the league's messages, for example {@code NORMAL_FIRST_HALF}
 * @param yellowScore goals of yellow
 * @param blueScore goals of blue
 * @param yellowOnPositiveHalf whether yellow's goal is at positive x
 */
public record RefereePhase(
    double time,
    String command,
    String stage,
    int yellowScore,
    int blueScore,
    boolean yellowOnPositiveHalf) {}
