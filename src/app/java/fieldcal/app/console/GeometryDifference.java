package fieldcal.app.console;

import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** What is different about the field and its cameras since the kicks were recorded, in sentences for the operator. */
final class GeometryDifference {
  /** Sizes are published in whole millimetres; less than that much nobody means, m. */
  private static final double SAME_SIZE = 0.005;

  /** Published numbers are 32-bit; a camera that was calibrated again moves by far more, m. */
  private static final double SAME_PLACE = 0.002;

  /** Angle between two published rotations that says the camera was calibrated again, rad: 1 mm on the ground below a camera at 4 m. */
  private static final double SAME_ROTATION = 0.00025;

  /** Relative change of the focal length, and change of the distortion, that rounding does not make. */
  private static final double SAME_LENS = 1e-4;

  private GeometryDifference() {}

  /**
   * The differences.
   *
   * @param recorded of the recordings
   * @param now of vision
   * @return one sentence each; empty when nothing that matters is different
   */
  static List<String> between(FieldGeometry recorded, FieldGeometry now) {
    List<String> all = new ArrayList<>();
    if (Math.abs(recorded.length() - now.length()) > SAME_SIZE
        || Math.abs(recorded.width() - now.width()) > SAME_SIZE) {
      all.add(
          String.format(
              Locale.ROOT,
              "Vision's field is %.2f × %.2f m, that of the recordings %.2f × %.2f m: these kicks"
                  + " are from another field.",
              now.length(),
              now.width(),
              recorded.length(),
              recorded.width()));
    }
    if (Math.abs(recorded.goalWidth() - now.goalWidth()) > SAME_SIZE) {
      all.add(
          String.format(
              Locale.ROOT,
              "Vision's goals are %.2f m wide, those of the recordings %.2f m.",
              now.goalWidth(),
              recorded.goalWidth()));
    }
    missing(recorded, now)
        .ifPresent(ids -> all.add("Vision no longer has " + ids + ", which the recordings have."));
    missing(now, recorded)
        .ifPresent(ids -> all.add("Vision has " + ids + ", which the recordings lack."));
    for (CameraCalibration camera : now.cameras()) {
      recorded
          .camera(camera.id())
          .flatMap(before -> change(before, camera))
          .ifPresent(how -> all.add("Camera " + camera.id() + " was calibrated again: " + how));
    }
    return List.copyOf(all);
  }

  private static Optional<String> missing(FieldGeometry of, FieldGeometry in) {
    TreeSet<Integer> ids =
        of.cameras().stream()
            .map(CameraCalibration::id)
            .filter(id -> in.camera(id).isEmpty())
            .collect(Collectors.toCollection(TreeSet::new));
    String list = ids.stream().map(String::valueOf).collect(Collectors.joining(", "));
    return ids.isEmpty()
        ? Optional.empty()
        : Optional.of((ids.size() == 1 ? "camera " : "cameras ") + list);
  }

  private static Optional<String> change(CameraCalibration before, CameraCalibration now) {
    List<String> how = new ArrayList<>();
    double moved = moved(before, now);
    if (moved > SAME_PLACE) {
      how.add(String.format(Locale.ROOT, "it has moved by %.0f mm", 1000 * moved));
    }
    double turned = turned(before, now);
    if (turned > SAME_ROTATION) {
      how.add(String.format(Locale.ROOT, "it is turned by %.2f°", Math.toDegrees(turned)));
    }
    boolean focal =
        Math.abs(now.focalLength() - before.focalLength())
            > SAME_LENS * Math.abs(before.focalLength());
    if (focal || Math.abs(now.distortion() - before.distortion()) > SAME_LENS) {
      how.add("its lens is different");
    }
    return how.isEmpty()
        ? Optional.empty()
        : Optional.of(
            String.join(", ", how) + ". Its offset in the recordings is no longer valid.");
  }

  private static double moved(CameraCalibration before, CameraCalibration now) {
    try {
      Camera a = Camera.of(before);
      Camera b = Camera.of(now);
      return Math.hypot(
          Math.hypot(a.positionX() - b.positionX(), a.positionY() - b.positionY()),
          a.positionZ() - b.positionZ());
    } catch (IllegalArgumentException e) {
      // A source that publishes placeholders: nothing is known of where it hangs.
      return 0;
    }
  }

  /** The angle between two rotations; 0 when one is none. */
  private static double turned(CameraCalibration a, CameraCalibration b) {
    double lengths =
        Math.sqrt(a.q0() * a.q0() + a.q1() * a.q1() + a.q2() * a.q2() + a.q3() * a.q3())
            * Math.sqrt(b.q0() * b.q0() + b.q1() * b.q1() + b.q2() * b.q2() + b.q3() * b.q3());
    if (!(lengths > 0)) {
      return 0;
    }
    double dot =
        Math.abs(a.q0() * b.q0() + a.q1() * b.q1() + a.q2() * b.q2() + a.q3() * b.q3()) / lengths;
    // Through the sine of half the angle: the cosine of a small one has no digits left.
    double cross = Math.sqrt(Math.max(0, 1 - dot * dot));
    return 2 * Math.atan2(cross, dot);
  }
}
