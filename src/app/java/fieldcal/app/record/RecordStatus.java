package fieldcal.app.record;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * How a recording is going.
 *
 * @param seconds since it was begun, s
 * @param frames of vision so far
 * @param cameras which sent them
 * @param geometry whether vision has published its geometry
 * @param referee the referee's last command; empty when none was heard
 * @param bytes of packets written, before compression
 * @param silent for how long no frame came, s
 * @param notes about the network
 */
public record RecordStatus(
    double seconds,
    long frames,
    Set<Integer> cameras,
    boolean geometry,
    String referee,
    long bytes,
    double silent,
    List<String> notes) {
  /** Vision sends 70 frames a second; who is silent for longer has stopped, s. */
  private static final double SILENCE = 2;

  /** Vision publishes its geometry every few seconds, s. */
  private static final double GEOMETRY = 10;

  private static final double MEGABYTE = 1e6;

  /** Copies the collections. */
  public RecordStatus {
    cameras = Set.copyOf(cameras);
    notes = List.copyOf(notes);
  }

  /**
   * One line for the operator.
   *
   * @param vision where vision is listened to
   * @return without a line break
   */
  public String line(String vision) {
    if (frames == 0) {
      return String.format(
          Locale.ROOT, "%.0f s, no vision heard yet on %s", Math.floor(seconds), vision);
    }
    return String.format(
        Locale.ROOT,
        "%.0f s, %d frames (%s), %.1f MB%s%s%s",
        Math.floor(seconds),
        frames,
        cameraNames(),
        bytes / MEGABYTE,
        referee.isEmpty() ? "" : ", referee " + referee,
        geometry || seconds < GEOMETRY
            ? ""
            : ", no geometry yet: chips cannot be fitted without it",
        silent < SILENCE
            ? ""
            : String.format(Locale.ROOT, ", vision has been silent for %.0f s", silent));
  }

  /**
   * The cameras in words.
   *
   * @return for example "cameras 0, 1"
   */
  public String cameraNames() {
    return (cameras.size() == 1 ? "camera " : "cameras ")
        + new TreeSet<>(cameras).stream().map(String::valueOf).collect(Collectors.joining(", "));
  }
}
