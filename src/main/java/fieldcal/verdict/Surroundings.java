package fieldcal.verdict;

import fieldcal.camera.CameraCalibration;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

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
   * @param name what people call it
   * @param simulated whether the field was simulated
   * @param geometry of the field; empty when the recording has none
   * @param faults what it shows of its cameras; empty also when nobody looked
   */
  public record Recorded(
      String name, boolean simulated, Optional<FieldGeometry> geometry, List<VisionFault> faults) {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when name, list or an element is null
     */
    public Recorded {
      Objects.requireNonNull(name, "name");
      faults = List.copyOf(faults);
    }

    /**
     * Where a recording comes from, without faults.
     *
     * @param name what people call it
     * @param simulated whether the field was simulated
     * @param geometry of the field; empty when the recording has none
     */
    public Recorded(String name, boolean simulated, Optional<FieldGeometry> geometry) {
      this(name, simulated, geometry, List.of());
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
   * The recordings that show a fault.
   *
   * @param fault one of {@link #faults}
   * @return their names; empty when all of them show it
   */
  public List<String> showing(VisionFault fault) {
    List<String> names =
        recordings.stream().filter(r -> r.faults().contains(fault)).map(Recorded::name).toList();
    return names.size() == recordings.size() ? List.of() : names;
  }

  /**
   * One field.
   *
   * @param size length and width
   * @param recordings names of those that are from it; empty when only vision publishes it
   */
  public record Field(FieldSize size, List<String> recordings) {
    /**
     * Copies the list. {@inheritDoc}
     *
     * @throws NullPointerException when a component is null
     */
    public Field {
      Objects.requireNonNull(size, "size");
      recordings = List.copyOf(recordings);
    }
  }

  /**
   * The fields, vision's included.
   *
   * @return those that differ in size, each once; empty when no geometry is known
   */
  public List<Field> fields() {
    List<FieldSize> sizes = new ArrayList<>();
    Stream.concat(recordings.stream().flatMap(r -> r.geometry().stream()), vision.stream())
        .map(FieldSize::of)
        .filter(size -> sizes.stream().noneMatch(size::isLike))
        .forEach(sizes::add);
    return sizes.stream().map(size -> new Field(size, of(size))).toList();
  }

  private List<String> of(FieldSize size) {
    return recordings.stream()
        .filter(r -> r.geometry().map(FieldSize::of).filter(size::isLike).isPresent())
        .map(Recorded::name)
        .toList();
  }

  /**
   * The recordings by their cameras: two that have cameras in common, which are all calibrated differently, are in different groups. A recording whose calibrations are not known is in none.
   *
   * @return names; several groups when cameras were calibrated again, or belong to different fields
   */
  public List<List<String>> byCameras() {
    List<List<Recorded>> groups = new ArrayList<>();
    for (Recorded recording : recordings) {
      if (recording.geometry().isPresent()) {
        groups.stream()
            .filter(group -> group.stream().allMatch(other -> shareACamera(other, recording)))
            .findFirst()
            .orElseGet(
                () -> {
                  groups.add(new ArrayList<>());
                  return groups.get(groups.size() - 1);
                })
            .add(recording);
      }
    }
    return groups.stream().map(group -> group.stream().map(Recorded::name).toList()).toList();
  }

  private static boolean shareACamera(Recorded a, Recorded b) {
    return shareACamera(a.geometry().orElseThrow(), b.geometry().orElseThrow());
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
   * The recordings of a simulated field.
   *
   * @return their names
   */
  public List<String> simulated() {
    return recordings.stream().filter(Recorded::simulated).map(Recorded::name).toList();
  }
}
