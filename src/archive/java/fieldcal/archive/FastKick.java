package fieldcal.archive;

import java.io.Serializable;

/**
 * A kick near the rule's greatest speed.
 *
 * @param tournament in which
 * @param file log
 * @param time Unix time, µs
 * @param team name; null when unknown
 * @param robot number; −1 when unknown
 * @param kind flat or chip
 * @param speed right after the kick, m/s
 * @param error its standard error
 * @param odds chance that it was faster than allowed, 0 … 1
 * @param rolling how fast it is when it begins to roll, m/s; NaN for chips and where unknown
 * @param maySpin whether the ball was dribbled before
 */
record FastKick(
    String tournament,
    String file,
    long time,
    String team,
    int robot,
    String kind,
    double speed,
    double error,
    double odds,
    double rolling,
    boolean maySpin)
    implements Serializable {}
