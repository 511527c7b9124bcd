package fieldcal.live;

/**
 * A parameter's median at one time.
 *
 * @param time of the kick, Unix time, s
 * @param median in the parameter's unit
 * @param samples how many it is from
 */
public record MedianPoint(double time, double median, int samples) {}
