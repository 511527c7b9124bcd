package fieldcal.live;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The newest samples of one parameter, sorted by value, with their median. When it is full, the oldest sample is removed. Equal values all count.
 *
 * <p>The league's teams remove the smallest and the largest sample instead. Then the samples of an old carpet stay too long: those of a new one all lie on one side, so every other one is removed at once. Measured on series of
 * samples that scatter by 12 % from kick to kick, one in twenty wrong, on a carpet whose rolling deceleration grows by 30 % (300 series each; samples until the median is 20 % off): removing the smallest and the largest takes 64 (in 5 % more than 96), the same with none older than 45 samples 29 (40), none older than 62 samples 37 (57), a ring of 61 samples 40 (49), of 31 samples 21 (27). None of them was ever 20 % off
 * without a change, where the published model was up to 8 % off. So the ring of 31 is used. Outliers need not be removed, since they hardly move a median. {@code ./gradlew benchmark
 * -PbenchmarkArgs=sample-tree} prints the table.
 *
 * <p>The order of adding does not matter: samples of several matches that are pooled give the same tree as one long match. Mutable; for one thread.
 */
public final class SampleTree {
  /** From this many samples on the median is an estimate, by the rule of the league's teams: the median of 31 samples that scatter by 12 % has an error of 2.7 %. */
  public static final int ENOUGH = 31;

  private final BallSample[] byTime;
  private final double[] sorted;
  private int size;

  /**
   * Creates an empty tree.
   *
   * @param capacity how many samples are kept, at least {@link #ENOUGH}
   * @throws IllegalArgumentException when it is less
   */
  public SampleTree(int capacity) {
    if (capacity < ENOUGH) {
      throw new IllegalArgumentException(
          "at least " + ENOUGH + " samples must be kept, not " + capacity);
    }
    byTime = new BallSample[capacity];
    sorted = new double[capacity];
  }

  /**
   * Adds a sample; when this exceeds the capacity, the oldest one is removed, which may be this one.
   *
   * @param sample any
   */
  public void add(BallSample sample) {
    int place = size;
    while (place > 0 && BallSample.BY_TIME.compare(byTime[place - 1], sample) > 0) {
      place--;
    }
    if (size == byTime.length) {
      if (place == 0) {
        return;
      }
      unsort(byTime[0].value());
      System.arraycopy(byTime, 1, byTime, 0, size - 1);
      size--;
      place--;
    }
    System.arraycopy(byTime, place, byTime, place + 1, size - place);
    byTime[place] = sample;
    sort(sample.value());
    size++;
  }

  private void sort(double value) {
    int found = Arrays.binarySearch(sorted, 0, size, value);
    int at = found < 0 ? -found - 1 : found;
    System.arraycopy(sorted, at, sorted, at + 1, size - at);
    sorted[at] = value;
  }

  private void unsort(double value) {
    int at = Arrays.binarySearch(sorted, 0, size, value);
    System.arraycopy(sorted, at + 1, sorted, at, size - at - 1);
  }

  /**
   * How many samples there are.
   *
   * @return 0 to the capacity
   */
  public int size() {
    return size;
  }

  /**
   * Whether there are enough for the median to be an estimate.
   *
   * @return true from {@link #ENOUGH} samples on
   */
  public boolean enough() {
    return size >= ENOUGH;
  }

  /**
   * The median.
   *
   * @return of an even number the mean of the middle two; NaN when empty
   */
  public double median() {
    return size == 0 ? Double.NaN : 0.5 * (sorted[(size - 1) / 2] + sorted[size / 2]);
  }

  /**
   * The value below which a share of the samples lies.
   *
   * @param share 0 … 1
   * @return the sample at that place; NaN when empty
   * @throws IllegalArgumentException when the share is not between 0 and 1
   */
  public double quantile(double share) {
    if (!(share >= 0 && share <= 1)) {
      throw new IllegalArgumentException("share must lie in [0, 1], but is " + share);
    }
    return size == 0 ? Double.NaN : sorted[(int) Math.round(share * (size - 1))];
  }

  /**
   * The samples.
   *
   * @return a copy, oldest first
   */
  public List<BallSample> samples() {
    return List.copyOf(new ArrayList<>(Arrays.asList(byTime).subList(0, size)));
  }
}
