package fieldcal.fit.joint;

import fieldcal.ball.Parameter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * Many kicks that share a model.
 *
 * @param <S> what the global parameters amount to
 * @param model turns global parameters into what kicks predict with
 * @param kicks at least one
 * @param starts own parameters of each kick
 * @param globals the global parameters with scale, bounds and start; those that are not estimated are held
 * @param priors Gaussian knowledge of each global parameter
 * @param randoms magnitudes that differ from kick to kick; the last own parameters of each kick are its values
 * @param weights weight of each kick's residuals, 1 unless the model is known not to fit a kick
 */
public record SharedProblem<S>(
    SharedModel<S> model,
    List<? extends KickTerm<S>> kicks,
    List<double[]> starts,
    List<Parameter> globals,
    List<Prior> priors,
    List<RandomEffect> randoms,
    double[] weights) {

  /**
   * What is known of a global parameter before any data.
   *
   * @param mean expected value
   * @param precision 1/variance; 0 = nothing is known
   */
  public record Prior(double mean, double precision) {
    /** Nothing is known. */
    public static final Prior NONE = new Prior(0, 0);
  }

  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there is no kick or the lengths differ
   */
  public SharedProblem {
    Objects.requireNonNull(model, "model");
    kicks = List.copyOf(kicks);
    starts = starts.stream().map(double[]::clone).toList();
    globals = List.copyOf(globals);
    priors = List.copyOf(priors);
    randoms = List.copyOf(randoms);
    weights = weights.clone();
    if (kicks.isEmpty()) {
      throw new IllegalArgumentException("a joint fit needs at least one kick");
    }
    if (starts.size() != kicks.size() || weights.length != kicks.size()) {
      throw new IllegalArgumentException(
          "%d kicks, but %d starts and %d weights"
              .formatted(kicks.size(), starts.size(), weights.length));
    }
    if (priors.size() != globals.size()) {
      throw new IllegalArgumentException(
          globals.size() + " global parameters, but " + priors.size() + " priors");
    }
  }

  /**
   * The same with other weights.
   *
   * @param newWeights one for each kick
   * @return the changed copy
   */
  public SharedProblem<S> withWeights(double[] newWeights) {
    return new SharedProblem<>(model, kicks, starts, globals, priors, randoms, newWeights);
  }

  /** The same for some of the kicks only. */
  SharedProblem<S> restrictedTo(int[] kept) {
    List<KickTerm<S>> some = new ArrayList<>();
    List<double[]> own = new ArrayList<>();
    double[] weight = new double[kept.length];
    for (int i = 0; i < kept.length; i++) {
      some.add(kicks.get(kept[i]));
      own.add(starts.get(kept[i]));
      weight[i] = weights[kept[i]];
    }
    return new SharedProblem<>(model, some, own, globals, priors, randoms, weight);
  }

  /** Values of the global parameters. */
  double[] values() {
    return globals.stream().mapToDouble(Parameter::value).toArray();
  }

  /** Indices of the global parameters that are estimated. */
  int[] free() {
    return IntStream.range(0, globals.size()).filter(k -> globals.get(k).estimated()).toArray();
  }

  /** Scales of some of the global parameters. */
  double[] scales(int[] of) {
    return Arrays.stream(of).mapToDouble(k -> globals.get(k).scale()).toArray();
  }

  /** Means of the random effects. */
  double[] means(double[] at) {
    return randoms.stream().mapToDouble(r -> at[r.mean()]).toArray();
  }

  /** For each random effect, the column of its mean among the free global parameters; −1 when that is held. */
  int[] meanColumns(int[] free) {
    return randoms.stream()
        .mapToInt(r -> Math.max(-1, Arrays.binarySearch(free, r.mean())))
        .toArray();
  }
}
