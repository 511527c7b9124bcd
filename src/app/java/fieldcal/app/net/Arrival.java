package fieldcal.app.net;

/**
 * When a packet came, as far as its reader knows: a reader that is busy or paused finds it late.
 *
 * @param earliest when the reader had last found nothing waiting, so that the packet came later, s
 * @param latest when the reader found it, s
 * @param seamless false when others that came between it and the one before were dropped, since nobody took them in time
 */
public record Arrival(double earliest, double latest, boolean seamless) {
  /**
   * The arrival of a packet that was found at once.
   *
   * @param time s
   * @return the arrival
   */
  public static Arrival at(double time) {
    return new Arrival(time, time, true);
  }
}
