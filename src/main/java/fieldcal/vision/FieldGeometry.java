package fieldcal.vision;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The field, its cameras and the ball models in use, as vision publishes them.
 *
 * @param length along x, between the goal lines, m
 * @param width along y, between the touch lines, m
 * @param goalWidth between the posts, m
 * @param goalDepth behind the goal line, m
 * @param boundaryWidth outside the touch lines, m
 * @param lines straight lines; may be empty
 * @param arcs curved lines; may be empty
 * @param cameras the published calibrations, one per camera, in the message's order
 * @param flat the published model of flat kicks
 * @param chip the published model of chip kicks; its {@code accRoll}, which the message does not have, is that of the flat model or,
 *     without one, the typical one
 */
public record FieldGeometry(
    double length,
    double width,
    double goalWidth,
    double goalDepth,
    double boundaryWidth,
    List<FieldLine> lines,
    List<FieldArc> arcs,
    List<CameraCalibration> cameras,
    Optional<FlatModel> flat,
    Optional<ChipModel> chip) {

  /**
   * Checks the field's size and copies the lists. {@inheritDoc}
   *
   * @throws IllegalArgumentException if length or width is not positive and finite, another size is negative or not finite, or two
   *     calibrations are of the same camera
   * @throws NullPointerException if a list, an element or a model is null
   */
  public FieldGeometry {
    if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("field length must be positive, got " + length);
    }
    if (!(width > 0 && width < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("field width must be positive, got " + width);
    }
    requireSize("goal width", goalWidth);
    requireSize("goal depth", goalDepth);
    requireSize("boundary width", boundaryWidth);
    lines = List.copyOf(lines);
    arcs = List.copyOf(arcs);
    cameras = List.copyOf(cameras);
    Objects.requireNonNull(flat, "flat");
    Objects.requireNonNull(chip, "chip");
    if (cameras.stream().mapToInt(CameraCalibration::id).distinct().count() != cameras.size()) {
      throw new IllegalArgumentException("two calibrations of one camera: " + cameras);
    }
  }

  /**
   * A geometry without painted lines and without models.
   *
   * @param length along x, m
   * @param width along y, m
   * @param goalWidth between the posts, m
   * @param goalDepth behind the goal line, m
   * @param boundaryWidth outside the touch lines, m
   * @param cameras the cameras
   * @return the geometry
   * @throws IllegalArgumentException as the constructor
   */
  public static FieldGeometry of(
      double length,
      double width,
      double goalWidth,
      double goalDepth,
      double boundaryWidth,
      List<CameraCalibration> cameras) {
    return new FieldGeometry(
        length,
        width,
        goalWidth,
        goalDepth,
        boundaryWidth,
        List.of(),
        List.of(),
        cameras,
        Optional.empty(),
        Optional.empty());
  }

  /**
   * The calibration of one camera.
   *
   * @param id the camera
   * @return its calibration, or nothing if none is published
   */
  public Optional<CameraCalibration> camera(int id) {
    return cameras.stream().filter(camera -> camera.id() == id).findFirst();
  }

  /**
   * The geometry that is known after another message. Some sources put one camera's calibration into each message (grSim, a vision with one process for each camera): a message
   * of the same field that names one camera is a part, which replaces what was known of that camera and leaves the others. Any other message is the whole.
   *
   * @param message the next one
   * @return the geometry from then on; this object itself when nothing is new
   */
  public FieldGeometry updated(FieldGeometry message) {
    if (message.cameras.size() != 1 || !isSameField(message)) {
      return message.equals(this) ? this : message;
    }
    CameraCalibration part = message.cameras.get(0);
    List<CameraCalibration> all = new ArrayList<>(cameras);
    all.removeIf(camera -> camera.id() == part.id());
    all.add(part);
    all.sort(Comparator.comparingInt(CameraCalibration::id));
    FieldGeometry next =
        message
            .withCameras(all)
            .withModels(message.flat.or(() -> flat), message.chip.or(() -> chip));
    return next.equals(this) ? this : next;
  }

  /**
   * Whether this geometry only adds cameras to an earlier one.
   *
   * @param earlier the geometry before
   * @return true when everything in the earlier geometry still holds
   */
  public boolean completes(FieldGeometry earlier) {
    return isSameField(earlier)
        && flat.equals(earlier.flat)
        && chip.equals(earlier.chip)
        && cameras.containsAll(earlier.cameras);
  }

  private boolean isSameField(FieldGeometry other) {
    return withCameras(List.of())
        .withModels(Optional.empty(), Optional.empty())
        .equals(other.withCameras(List.of()).withModels(Optional.empty(), Optional.empty()));
  }

  /**
   * The same field with other cameras.
   *
   * @param newCameras the cameras
   * @return the changed geometry
   */
  public FieldGeometry withCameras(List<CameraCalibration> newCameras) {
    return new FieldGeometry(
        length, width, goalWidth, goalDepth, boundaryWidth, lines, arcs, newCameras, flat, chip);
  }

  /**
   * The same field with other models.
   *
   * @param newFlat model of flat kicks
   * @param newChip model of chip kicks
   * @return the changed geometry
   */
  public FieldGeometry withModels(Optional<FlatModel> newFlat, Optional<ChipModel> newChip) {
    return new FieldGeometry(
        length, width, goalWidth, goalDepth, boundaryWidth, lines, arcs, cameras, newFlat, newChip);
  }

  /**
   * The same field with painted lines.
   *
   * @param newLines straight lines
   * @param newArcs curved lines
   * @return the changed geometry
   */
  public FieldGeometry withLines(List<FieldLine> newLines, List<FieldArc> newArcs) {
    return new FieldGeometry(
        length, width, goalWidth, goalDepth, boundaryWidth, newLines, newArcs, cameras, flat, chip);
  }

  private static void requireSize(String name, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " must not be negative, got " + value);
    }
  }
}
