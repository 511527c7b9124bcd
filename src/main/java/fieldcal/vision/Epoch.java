package fieldcal.vision;

/**
 * The instant at which a recording's time is zero.
 *
 * <p>Unix time in a {@code double} is good to 0.24 µs only, and differences of such times inherit that. Seconds counted
 * from an epoch near the recording are good to far below a nanosecond. All times of one recording share one epoch.
 *
 * @param unixNanos the epoch as Unix time, ns
 */
public record Epoch(long unixNanos) {
  private static final long NANOS_PER_SECOND = 1_000_000_000L;

  /**
   * The epoch at the full second at or before a Unix time, so that printed times stay readable.
   *
   * @param unixNanos Unix time, ns
   * @return the epoch
   */
  public static Epoch atSecondOf(long unixNanos) {
    return new Epoch(Math.floorDiv(unixNanos, NANOS_PER_SECOND) * NANOS_PER_SECOND);
  }

  /**
   * The epoch at the full second at or before a Unix time.
   *
   * @param unixSeconds Unix time, s; finite and within ±9.2e9
   * @return the epoch
   * @throws IllegalArgumentException if the time is not finite or out of the range of 64-bit nanoseconds
   */
  public static Epoch atSecondOf(double unixSeconds) {
    if (!(Math.abs(unixSeconds) <= 9.2e9)) {
      throw new IllegalArgumentException("no Unix time in seconds: " + unixSeconds);
    }
    return new Epoch((long) Math.floor(unixSeconds) * NANOS_PER_SECOND);
  }

  /**
   * Unix time to the recording's time. The full seconds are subtracted exactly before anything is rounded.
   *
   * @param unixSeconds Unix time, s
   * @return time since the epoch, s; not finite when the argument is not
   */
  public double seconds(double unixSeconds) {
    return unixSeconds - Math.floorDiv(unixNanos, NANOS_PER_SECOND) - fraction();
  }

  /**
   * Unix time to the recording's time.
   *
   * @param unixTimeNanos Unix time, ns
   * @return time since the epoch, s
   */
  public double secondsOfNanos(long unixTimeNanos) {
    return (unixTimeNanos - unixNanos) * 1e-9;
  }

  /**
   * The recording's time to Unix time.
   *
   * @param seconds time since the epoch, s
   * @return Unix time, s, with the 0.24 µs grain of a double of that size
   */
  public double unixSeconds(double seconds) {
    return Math.floorDiv(unixNanos, NANOS_PER_SECOND) + (seconds + fraction());
  }

  /**
   * The recording's time to Unix time.
   *
   * @param seconds time since the epoch, s
   * @return Unix time, ns, rounded to the nearest
   */
  public long unixNanosOf(double seconds) {
    return unixNanos + Math.round(seconds * 1e9);
  }

  private double fraction() {
    return Math.floorMod(unixNanos, NANOS_PER_SECOND) * 1e-9;
  }
}
