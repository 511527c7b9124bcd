package fieldcal.fit.joint;

/** What is known of a kick's own parameters: priors of the plain ones, and the means that its values of random effects differ from by their scatters. */
final class OwnPriors {
  private OwnPriors() {}

  /** Adds what is known to a kick's equations; {@code meanColumns} are the free columns of the random effects' means, or null when those are held. */
  static <S> void tie(
      KickBlock block,
      KickTerm<S> term,
      double[] own,
      double[] means,
      int[] meanColumns,
      double[] scatters) {
    int first = own.length - scatters.length;
    for (int i = 0; i < first; i++) {
      double precision = term.ownPrecision(i);
      if (precision > 0) {
        block.tieOwn(i, own[i] - term.ownPrior(i), precision);
      }
    }
    for (int r = 0; r < scatters.length; r++) {
      double precision = 1 / (scatters[r] * scatters[r]);
      int column = meanColumns == null ? -1 : meanColumns[r];
      block.tieToShared(first + r, column, own[first + r] - means[r], precision);
    }
  }

  /** What it adds to the kick's chi-square. */
  static <S> double cost(KickTerm<S> term, double[] own, double[] means, double[] scatters) {
    int first = own.length - scatters.length;
    double cost = 0;
    for (int i = 0; i < first; i++) {
      double precision = term.ownPrecision(i);
      double d = precision > 0 ? own[i] - term.ownPrior(i) : 0;
      cost += precision * d * d;
    }
    for (int r = 0; r < scatters.length; r++) {
      double d = (own[first + r] - means[r]) / scatters[r];
      cost += d * d;
    }
    return cost;
  }
}
