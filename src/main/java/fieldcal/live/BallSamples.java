package fieldcal.live;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/**
 * The samples of all parameters, from one match or several. Immutable.
 *
 * <p>Pooling is exact: merged states give the trees of one long match, in whichever order they are merged, and a state that is merged twice counts once.
 *
 * @param samples by parameter, oldest first; a parameter without samples may be missing
 */
public record BallSamples(Map<BallParameter, List<BallSample>> samples) {
  /** No samples. */
  public static final BallSamples NONE = new BallSamples(Map.of());

  /**
   * Copies and sorts. {@inheritDoc}
   *
   * @throws NullPointerException when the map, a list or an element is null
   */
  public BallSamples {
    Map<BallParameter, List<BallSample>> copy = new EnumMap<>(BallParameter.class);
    samples.forEach(
        (parameter, list) -> {
          if (!list.isEmpty()) {
            copy.put(parameter, list.stream().sorted(BallSample.BY_TIME).toList());
          }
        });
    samples = Map.copyOf(copy);
  }

  /**
   * The samples of one parameter.
   *
   * @param parameter which
   * @return oldest first; may be empty
   */
  public List<BallSample> of(BallParameter parameter) {
    return samples.getOrDefault(parameter, List.of());
  }

  /**
   * These and others.
   *
   * @param other of another match, or an earlier state of the same
   * @return all samples; one that both have counts once
   */
  public BallSamples merged(BallSamples other) {
    Map<BallParameter, List<BallSample>> all = new EnumMap<>(BallParameter.class);
    for (BallParameter parameter : BallParameter.values()) {
      // A kick has one sample of a parameter; the same time, value and error are the same kick.
      TreeSet<BallSample> union = new TreeSet<>(BallSample.BY_TIME);
      union.addAll(of(parameter));
      union.addAll(other.of(parameter));
      all.put(parameter, List.copyOf(union));
    }
    return new BallSamples(all);
  }

  /**
   * How many samples there are of all parameters together.
   *
   * @return count
   */
  public int size() {
    return samples.values().stream().mapToInt(List::size).sum();
  }
}
