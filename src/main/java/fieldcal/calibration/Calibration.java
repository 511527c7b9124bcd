package fieldcal.calibration;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The answer to a {@link CalibrationProblem}.
 *
 * @param kicks every kick, used or not, in order of time
 * @param flat average of each flat parameter by name; {@code n} is 0 where no kick determines it
 * @param chip average of each chip parameter by name
 * @param joint fit of all trusted kicks at once; empty when there is none
 * @param cameras noise and offsets that the fits were made with
 * @param seed of the random search
 */
public record Calibration(
    List<CalibratedKick> kicks,
    Map<String, Average> flat,
    Map<String, Average> chip,
    Optional<JointFit> joint,
    CameraViews cameras,
    long seed) {

  /**
   * Copies the collections, keeping their order. {@inheritDoc}
   *
   * @throws NullPointerException when a collection is null
   */
  public Calibration {
    kicks = List.copyOf(kicks);
    flat = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(flat));
    chip = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(chip));
  }

  /**
   * The kicks of one kind.
   *
   * @param kind flat or chip
   * @return in order of time
   */
  public List<CalibratedKick> kicks(KickKind kind) {
    return kicks.stream().filter(k -> k.fit().kind() == kind).toList();
  }

  /**
   * Whether the recordings have usable kicks of a kind. A push among chips, for example, looks like a flat kick but determines no parameter of flat kicks.
   *
   * @param kind flat or chip
   * @return true when there are such kicks, and they determine a parameter or no kick of the other kind does
   */
  public boolean tells(KickKind kind) {
    boolean other = determines(kind == KickKind.FLAT ? KickKind.CHIP : KickKind.FLAT);
    return !kicks(kind).isEmpty() && (determines(kind) || !other);
  }

  private boolean determines(KickKind kind) {
    return (kind == KickKind.FLAT ? flat : chip).values().stream().anyMatch(a -> a.n() > 0);
  }

  /**
   * The value of a parameter in the joint fit. What one kick says on its own is no joint value: nothing shows how far it lies from those of other kicks.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @return empty when there is no joint fit, or fewer than two kicks of that kind are in it; what was not estimated is there all the same
   */
  public Optional<Estimate> joint(KickKind kind, String parameter) {
    boolean several = trusted().stream().filter(f -> f.kind() == kind).count() > 1;
    return joint
        .flatMap(j -> kind == KickKind.FLAT ? j.flat(parameter) : j.chip(parameter))
        .filter(e -> several || !e.parameter().estimated());
  }

  /**
   * The fits that are believed, whether or not the 2σ rule excludes some of their values: what the joint fit was made from, and what a diagnosis starts from.
   *
   * @return in order of time
   */
  public List<KickFit> trusted() {
    return kicks.stream().filter(CalibratedKick::trusted).map(CalibratedKick::fit).toList();
  }

  /**
   * Every kick that has a fit, also one that fits badly: what a diagnosis starts from, since a kick that the model does not fit is what it is about.
   *
   * @return in order of time
   */
  public List<KickFit> fitted() {
    return kicks.stream().map(CalibratedKick::fit).filter(f -> f.failure().isEmpty()).toList();
  }

  /**
   * The averaged flat model: for each parameter the weighted mean of the kicks that determine it.
   *
   * @return accelerations in m/s², negative; empty unless every parameter was determined by a kick
   */
  public Optional<FlatModel> flatModel() {
    double[] v = means(flat, "accSlide", "accRoll", "kSwitch");
    return v == null ? Optional.empty() : Optional.of(new FlatModel(v[0], v[1], v[2]));
  }

  /**
   * The averaged chip model: for each damping the weighted mean of the chips that determine it.
   *
   * @param accRoll acceleration while rolling to go with it, m/s², negative, usually that of the flat kicks
   * @return empty unless every damping was determined by a kick
   */
  public Optional<ChipModel> chipModel(double accRoll) {
    double[] v = means(chip, "dampingXyFirstHop", "dampingXyOtherHops", "dampingZ");
    return v == null ? Optional.empty() : Optional.of(new ChipModel(v[0], v[1], v[2], accRoll));
  }

  /**
   * How well a parameter is known whichever kick is left out: the largest standard error of its average, of all kicks or of all but one, relative to that average. A scatter estimated from few kicks is itself uncertain, so a session that stops as soon as the error is small tends to stop when it is small by chance; leaving out one kick shows this.
   *
   * @param kind of the model
   * @param parameter name as in the model's record
   * @return 0 or more; infinite where two kicks or fewer determine it
   */
  public double leastPrecision(KickKind kind, String parameter) {
    List<Sample> samples =
        kicks(kind).stream()
            .flatMap(k -> k.samples().stream())
            .filter(s -> s.parameter().equals(parameter))
            .map(s -> s.leftForItsValue() ? s.taken() : s)
            .filter(s -> s.dropped().isEmpty())
            .toList();
    return leastPrecision(samples);
  }

  static double leastPrecision(List<Sample> samples) {
    if (samples.size() < 3) {
      return Double.POSITIVE_INFINITY;
    }
    double worst = relative(samples);
    for (int left = 0; left < samples.size(); left++) {
      List<Sample> others = new ArrayList<>(samples);
      others.remove(left);
      worst = Math.max(worst, relative(others));
    }
    return worst;
  }

  private static double relative(List<Sample> samples) {
    Average average = Average.judged(TwoSigma.repeated(samples));
    return average.n() < 2
        ? Double.POSITIVE_INFINITY
        : average.standardError() / Math.abs(average.mean());
  }

  private static double[] means(Map<String, Average> averages, String... names) {
    double[] values = new double[names.length];
    for (int i = 0; i < names.length; i++) {
      Average a = averages.get(names[i]);
      if (a == null || a.n() == 0) {
        return null;
      }
      values[i] = a.mean();
    }
    return values;
  }
}
