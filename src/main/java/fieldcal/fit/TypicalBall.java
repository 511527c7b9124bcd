package fieldcal.fit;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.kick.KickKind;
import java.util.List;

/** What is typical of a recording's kicks, each fitted on its own: where a joint fit starts. */
public final class TypicalBall {
  private TypicalBall() {}

  /**
   * The flat model.
   *
   * @param fits kicks, none failed
   * @return medians; typical of the league without flat kicks
   */
  public static FlatModel flat(List<KickFit> fits) {
    FlatModel typical = FlatModel.typical();
    return new FlatModel(
        median(fits, KickKind.FLAT, "accSlide", typical.accSlide()),
        median(fits, KickKind.FLAT, "accRoll", typical.accRoll()),
        median(fits, KickKind.FLAT, "kSwitch", typical.kSwitch()));
  }

  /**
   * The chip model.
   *
   * @param fits kicks, none failed
   * @return medians, rolling as the flat kicks do; typical of the league without chips
   */
  public static ChipModel chip(List<KickFit> fits) {
    ChipModel typical = ChipModel.typical();
    boolean flats = fits.stream().anyMatch(f -> f.kind() == KickKind.FLAT);
    return new ChipModel(
        median(fits, KickKind.CHIP, "dampingXyFirstHop", typical.dampingXyFirstHop()),
        median(fits, KickKind.CHIP, "dampingXyOtherHops", typical.dampingXyOtherHops()),
        median(fits, KickKind.CHIP, "dampingZ", typical.dampingZ()),
        flats ? flat(fits).accRoll() : median(fits, KickKind.CHIP, "accRoll", typical.accRoll()));
  }

  private static double median(List<KickFit> fits, KickKind kind, String name, double otherwise) {
    double[] sorted =
        fits.stream()
            .filter(f -> f.kind() == kind)
            .map(f -> f.estimate(name))
            .filter(Estimate::usable)
            .mapToDouble(Estimate::value)
            .sorted()
            .toArray();
    return sorted.length == 0 ? otherwise : sorted[sorted.length / 2];
  }
}
