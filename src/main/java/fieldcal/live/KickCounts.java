package fieldcal.live;

/**
 * What became of the kicks so far.
 *
 * @param found kicks that were found
 * @param outsidePlay of these, those outside of play, which are not fitted
 * @param dropped of these, those that were not fitted because too many waited, because the cameras' geometry changed meanwhile, or because their processing failed
 * @param waiting of these, those that wait now
 * @param used of these, those of which at least one sample counts
 * @param unused of these, those of which the fit failed or determines no parameter
 * @param possiblySpinning of the fitted ones, those after dribbling
 */
public record KickCounts(
    long found,
    long outsidePlay,
    long dropped,
    int waiting,
    long used,
    long unused,
    long possiblySpinning) {}
