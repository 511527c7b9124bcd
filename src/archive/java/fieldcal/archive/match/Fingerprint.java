package fieldcal.archive.match;

import fieldcal.camera.CameraCalibration;
import fieldcal.vision.FieldGeometry;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.stream.Collectors;

/** Equal for equal contents, and for nothing else that will ever be seen: the first 16 hexadecimal digits of a SHA-256. */
public final class Fingerprint {
  private static final int DIGITS = 16;

  private Fingerprint() {}

  /**
   * Of a file's content.
   *
   * @param file to be read
   * @return 16 hexadecimal digits
   * @throws IOException when it cannot be read
   */
  public static String of(Path file) throws IOException {
    MessageDigest digest = sha256();
    byte[] buffer = new byte[1 << 16];
    try (InputStream in = Files.newInputStream(file)) {
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        digest.update(buffer, 0, n);
      }
    }
    return digits(digest);
  }

  /** Of a camera's calibration. */
  static String of(CameraCalibration camera) {
    return of(camera.toString());
  }

  /** Of field size and cameras; what vision publishes beside, such as models and lines, does not matter. */
  static String of(FieldGeometry geometry) {
    String cameras =
        geometry.cameras().stream()
            .sorted(Comparator.comparingInt(CameraCalibration::id))
            .map(CameraCalibration::toString)
            .collect(Collectors.joining("\n"));
    return of(geometry.length() + " " + geometry.width() + "\n" + cameras);
  }

  /**
   * Of a text.
   *
   * @param text any
   * @return 16 hexadecimal digits
   */
  public static String of(String text) {
    MessageDigest digest = sha256();
    digest.update(text.getBytes(StandardCharsets.UTF_8));
    return digits(digest);
  }

  private static String digits(MessageDigest digest) {
    return HexFormat.of().formatHex(digest.digest()).substring(0, DIGITS);
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
