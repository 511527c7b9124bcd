package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Asks of the kicks that a joint fit explains badly whether they are of the other kind. Each is fitted as that once, however many hypotheses ask. */
final class OtherKind {
  /** A kick that fits better than that, in variances of noise, is not questioned. */
  private static final double FITS = 2;

  /** A model that fewer kicks determine judges no others. */
  private static final int FEWEST = 3;

  private final CameraViews cameras;
  private final NoiseCalibration noise;
  private final FlatModel flat;
  private final ChipModel chip;
  private final KickFitter fitter = new KickFitter(FitSettings.defaults());

  /** How kicks look as flat ones and as chips. */
  private final Map<KickKind, Map<Kick, KickFit>> fits =
      Map.of(
          KickKind.FLAT, Collections.synchronizedMap(new IdentityHashMap<>()),
          KickKind.CHIP, Collections.synchronizedMap(new IdentityHashMap<>()));

  /**
   * Nothing fitted yet.
   *
   * @param flat where fits as flat kicks start
   * @param chip where fits as chips start
   */
  OtherKind(CameraViews cameras, NoiseCalibration noise, FlatModel flat, ChipModel chip) {
    this.cameras = cameras;
    this.noise = noise;
    this.flat = flat;
    this.chip = chip;
  }

  /** The kicks under a joint fit, some of them as the other kind; the same list when none changes. */
  List<KickData> settle(HypothesisFitter joint, FittedHypothesis at) {
    SharedState state = SharedState.of(at.hypothesis(), at.shared(), joint.observers);
    KickData[] settled = joint.kicks.toArray(KickData[]::new);
    IntStream.range(0, settled.length)
        .parallel()
        .forEach(k -> settled[k] = settle(joint, at, state, k));
    List<KickData> all = List.of(settled);
    return all.equals(joint.kicks) ? joint.kicks : all;
  }

  private KickData settle(HypothesisFitter joint, FittedHypothesis at, SharedState state, int k) {
    KickData data = joint.kicks.get(k);
    KickKind other = data.kind == KickKind.FLAT ? KickKind.CHIP : KickKind.FLAT;
    double now = Cleaning.variance(joint, at, state, k);
    boolean judged = joint.kicks.stream().filter(d -> d.kind == other).count() >= FEWEST;
    if (!judged || now < FITS) {
      return data;
    }
    KickFit fit = fit(data.kick, other);
    if (fit.failure().isPresent()) {
      return data;
    }
    int random = at.hypothesis().random().size();
    double[] means =
        Arrays.copyOfRange(at.shared(), at.shared().length - random, at.shared().length);
    KickData changed = new KickData(fit, noise.cameras(), noise.stampNoise());
    KickModel model = new KickModel(changed, random, joint.sessionStart);
    model.startFrom(changed.start, changed.flights, means);
    OwnFit own = new OwnFit(model, state, at.scatter());
    double cost = own.minimize();
    if (other == KickKind.CHIP && own.chooseFlights()) {
      cost = own.minimize();
    }
    double run = Math.hypot(model.own[2], model.own[3]);
    boolean flies = other == KickKind.FLAT || model.own[4] > Kinds.STEEP * run;
    return flies && cost / (2.0 * changed.usedCount) < Kinds.BETTER * now ? changed : data;
  }

  private KickFit fit(Kick kick, KickKind as) {
    Map<Kick, KickFit> known = fits.get(as);
    KickFit fit = known.get(kick);
    if (fit == null) {
      fit = fitter.fit(FitProblem.of(kick, cameras, flat, chip), as);
      known.put(kick, fit);
    }
    return fit;
  }
}
