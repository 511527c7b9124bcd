package fieldcal.calibration;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;

/**
 * Decisions about kicks that a person made; they override the rules: which are dropped, with the reason, which are kept, and how often the 2σ rule is applied. Immutable.
 *
 * <p>Kicks are named by a key that survives another run over the same recordings, see {@link #key}.
 */
public final class HandSelection {
  private static final HandSelection NONE =
      new HandSelection(Map.of(), Set.of(), OptionalInt.empty());

  private final Map<String, String> dropped;
  private final Set<String> kept;
  private final OptionalInt twoSigmaRounds;

  private HandSelection(Map<String, String> dropped, Set<String> kept, OptionalInt twoSigmaRounds) {
    this.dropped = dropped;
    this.kept = kept;
    this.twoSigmaRounds = twoSigmaRounds;
  }

  /**
   * No decisions.
   *
   * @return the empty selection
   */
  public static HandSelection none() {
    return NONE;
  }

  /**
   * The key of a kick: its time to the hundredth of a second, which no two kicks of a recording share and which does not depend on
   * how many kicks were found before it.
   *
   * @param unixTime of the kick, s
   * @return such as {@code 1763712345.12}
   */
  public static String key(double unixTime) {
    return String.format(java.util.Locale.ROOT, "%.2f", unixTime);
  }

  /**
   * These decisions and one more: the kick is not used.
   *
   * @param key of the kick
   * @param reason for people
   * @return the changed copy
   */
  public HandSelection drop(String key, String reason) {
    Map<String, String> d = new LinkedHashMap<>(dropped);
    d.keySet().removeAll(neighbours(key));
    d.put(key, Objects.requireNonNull(reason));
    Set<String> k = new TreeSet<>(kept);
    k.removeAll(neighbours(key));
    return new HandSelection(d, k, twoSigmaRounds);
  }

  /**
   * These decisions and one more: the kick is used, also where the 2σ rule would drop it.
   *
   * @param key of the kick
   * @return the changed copy
   */
  public HandSelection keep(String key) {
    Map<String, String> d = new LinkedHashMap<>(dropped);
    d.keySet().removeAll(neighbours(key));
    Set<String> k = new TreeSet<>(kept);
    k.removeAll(neighbours(key));
    k.add(key);
    return new HandSelection(d, k, twoSigmaRounds);
  }

  /**
   * These decisions without any about one kick: the rules decide.
   *
   * @param key of the kick
   * @return the changed copy
   */
  public HandSelection leaveToRules(String key) {
    Map<String, String> d = new LinkedHashMap<>(dropped);
    d.keySet().removeAll(neighbours(key));
    Set<String> k = new TreeSet<>(kept);
    k.removeAll(neighbours(key));
    return new HandSelection(d, k, twoSigmaRounds);
  }

  /**
   * These decisions with another number of rounds of the 2σ rule.
   *
   * @param rounds 0 or more; empty for as many as it takes until none is excluded
   * @return the changed copy
   * @throws IllegalArgumentException if the number is negative
   */
  public HandSelection withTwoSigmaRounds(OptionalInt rounds) {
    if (rounds.isPresent() && rounds.getAsInt() < 0) {
      throw new IllegalArgumentException(
          "rounds of the 2σ rule must be 0 or more, got " + rounds.getAsInt());
    }
    return new HandSelection(dropped, kept, rounds);
  }

  /**
   * How often the 2σ rule is applied.
   *
   * @return rounds, 0 or more; empty for as many as it takes until none is excluded
   */
  public OptionalInt twoSigmaRounds() {
    return twoSigmaRounds;
  }

  /**
   * Why a kick is dropped.
   *
   * @param key of the kick
   * @return the reason given, or empty
   */
  public Optional<String> droppedBecause(String key) {
    return Optional.ofNullable(lookUp(key));
  }

  /** Times move by a millisecond or two when a fit improves, so a neighbouring key is the same kick. */
  private String lookUp(String key) {
    if (dropped.isEmpty()) {
      return null;
    }
    for (String near : neighbours(key)) {
      if (dropped.containsKey(near)) {
        return dropped.get(near);
      }
    }
    return null;
  }

  /**
   * Whether a kick is kept by hand.
   *
   * @param key of the kick
   * @return true when it is
   */
  public boolean isKept(String key) {
    return !kept.isEmpty() && neighbours(key).stream().anyMatch(kept::contains);
  }

  /**
   * Whether two keys name the same kick: times move by a millisecond or two, and then fall into the next hundredth.
   *
   * @param a key
   * @param b key
   * @return true when they are at most one hundredth of a second apart
   */
  public static boolean same(String a, String b) {
    return neighbours(a).contains(b);
  }

  private static Set<String> neighbours(String key) {
    double time = Double.parseDouble(key);
    return new java.util.LinkedHashSet<>(
        java.util.List.of(key, key(time - 0.01), key(time + 0.01)));
  }

  /**
   * All dropped kicks.
   *
   * @return key and reason, in the order of the decisions; a copy
   */
  public Map<String, String> dropped() {
    return new LinkedHashMap<>(dropped);
  }

  /**
   * All kept kicks.
   *
   * @return keys in order; a copy
   */
  public Set<String> kept() {
    return new TreeSet<>(kept);
  }
}
