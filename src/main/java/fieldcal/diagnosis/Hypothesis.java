package fieldcal.diagnosis;

import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;

/**
 * What may be the case: which effects act, with unknown magnitudes. Effects that differ from kick to kick (spin) have a mean among the shared unknowns and a value of each kick's own,
 * tied to the mean by the scatter. Immutable.
 *
 * @param fixed effects that are the same for all kicks
 * @param random effects with one coordinate that differs from kick to kick
 */
record Hypothesis(List<Chart> fixed, List<Chart> random) {
  static final Hypothesis SIMPLE = new Hypothesis(List.of(), List.of());

  Hypothesis {
    fixed = List.copyOf(fixed);
    random = List.copyOf(random);
  }

  boolean isSimple() {
    return fixed.isEmpty() && random.isEmpty();
  }

  int size() {
    return fixed.size() + random.size();
  }

  /** All charts, those of fixed effects first. */
  List<Chart> charts() {
    List<Chart> all = new ArrayList<>(fixed);
    all.addAll(random);
    return all;
  }

  Hypothesis with(Chart chart, boolean perKick) {
    List<Chart> f = new ArrayList<>(fixed);
    List<Chart> r = new ArrayList<>(random);
    (perKick ? r : f).add(chart);
    return new Hypothesis(f, r);
  }

  Hypothesis without(Chart chart) {
    List<Chart> f = new ArrayList<>(fixed);
    List<Chart> r = new ArrayList<>(random);
    if (!f.remove(chart)) {
      r.remove(chart);
    }
    return new Hypothesis(f, r);
  }

  boolean isRandom(Chart chart) {
    return random.contains(chart);
  }

  boolean hasCause(Chart chart) {
    return charts().stream().anyMatch(c -> c.sameCause(chart));
  }

  boolean hasEffect(String id) {
    return charts().stream().anyMatch(c -> c.id().equals(id));
  }

  /** How many coordinates of effects are shared by all kicks, means of random effects included. */
  int coordinates() {
    return charts().stream().mapToInt(Chart::size).sum();
  }

  /** Unknowns of one kick. */
  int ownSize(KickKind kind) {
    return KickData.ownSize(kind) + random.size();
  }

  /** The same causes, in whatever order and with whatever magnitudes free. */
  boolean sameCauses(Hypothesis other) {
    return size() == other.size()
        && charts().stream().allMatch(other::hasCause)
        && other.charts().stream().allMatch(this::hasCause)
        && other.coordinates() == coordinates();
  }

  @Override
  public String toString() {
    return isSimple() ? "simple model" : charts().toString();
  }
}
