package fieldcal.verdict;

import fieldcal.camera.CameraCalibration;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Where the recordings come from.
 *
 * @param recordings each of them, in order
 * @param vision what vision publishes at the moment; empty when vision was not listened to
 */
public record Surroundings(List<Recorded> recordings, Optional<FieldGeometry> vision) {
  /** Nothing is known of the recordings. */
  public static final Surroundings UNKNOWN = new Surroundings(List.of(), Optional.empty());

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws NullPointerException when the list or an element is null
   */
  public Surroundings {
    recordings = List.copyOf(recordings);
  }

  /**
   * Where one recording comes from.
   *
   * @param simulated whether the field was simulated
   * @param geometry of the field; empty when the recording has none
   * @param faults what it shows of its cameras; empty also when nobody looked
   */
  public record Recorded(
      boolean simulated, Optional<FieldGeometry> geometry, List<VisionFault> faults) {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when the list or an element is null
     */
    public Recorded {
      faults = List.copyOf(faults);
    }

    /**
     * Where a recording comes from, without faults.
     *
     * @param simulated whether the field was simulated
     * @param geometry of the field; empty when the recording has none
     */
    public Recorded(boolean simulated, Optional<FieldGeometry> geometry) {
      this(simulated, geometry, List.of());
    }
  }

  /**
   * What the recordings show of their cameras.
   *
   * @return each fault once
   */
  public List<VisionFault> faults() {
    return recordings.stream().flatMap(r -> r.faults().stream()).distinct().toList();
  }

  /**
   * The fields, vision's included.
   *
   * @return the sizes that differ, each once; empty when no geometry is known
   */
  public List<FieldSize> fields() {
    List<FieldSize> different = new ArrayList<>();
    for (FieldGeometry geometry : geometries()) {
      FieldSize size = FieldSize.of(geometry);
      if (different.stream().noneMatch(size::isLike)) {
        different.add(size);
      }
    }
    return different;
  }

  /** The geometries of the recordings and, last, that of vision. */
  private List<FieldGeometry> geometries() {
    List<FieldGeometry> all = new ArrayList<>();
    recordings.forEach(r -> r.geometry().ifPresent(all::add));
    vision.ifPresent(all::add);
    return all;
  }

  /**
   * Whether two recordings have cameras in common that are all calibrated differently.
   *
   * @return false also when a calibration is not known
   */
  public boolean camerasDiffer() {
    List<FieldGeometry> known =
        recordings.stream().flatMap(r -> r.geometry().stream()).distinct().toList();
    for (FieldGeometry a : known) {
      for (FieldGeometry b : known) {
        if (!shareACamera(a, b)) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Whether two geometries may be of the same set of cameras: one of them has the same calibration in both, or they have none in common to compare.
   *
   * @param a one
   * @param b the other
   * @return false when all cameras that both have are calibrated differently
   */
  public static boolean shareACamera(FieldGeometry a, FieldGeometry b) {
    int compared = 0;
    for (CameraCalibration camera : a.cameras()) {
      Optional<CameraCalibration> other = b.camera(camera.id());
      if (other.isPresent()) {
        compared++;
        if (other.get().equals(camera)) {
          return true;
        }
      }
    }
    return compared == 0;
  }

  /**
   * How many recordings are of a simulated field.
   *
   * @return 0 or more
   */
  public int simulated() {
    return (int) recordings.stream().filter(Recorded::simulated).count();
  }
}
