package fieldcal.app.export;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A kick for which two models are compared.
 *
 * @param kind flat or chip
 * @param time Unix time, s
 * @param x place, m
 * @param y place, m
 * @param vx velocity right after the kick, m/s
 * @param vy velocity right after the kick, m/s
 * @param vz velocity right after the kick, m/s
 */
record ReferenceKick(
    KickKind kind, double time, double x, double y, double vx, double vy, double vz) {
  /** A pass, a hard pass and the fastest kick that the rules allow, m/s. */
  private static final double[] FLAT_SPEEDS = {2, 4, 6.5};

  /** Horizontal and vertical speed of a chip at 45° that lands some two metres away, m/s. */
  private static final double CHIP_SPEED = 3;

  private static final int DIRECTIONS = 8;

  /** A kick of {@code calibration.json}; empty when it could not be fitted. */
  static Optional<ReferenceKick> of(JsonNode kick) {
    JsonNode place = kick.path("kick_position");
    JsonNode velocity = kick.path("kick_velocity");
    if (!kick.path("rms_mm").isNumber() || place.size() < 2 || velocity.size() < 3) {
      return Optional.empty();
    }
    boolean chip = kick.path("kind").asText().equals(KickKind.CHIP.id());
    return Optional.of(
        new ReferenceKick(
            chip ? KickKind.CHIP : KickKind.FLAT,
            kick.path("t").asDouble(),
            place.get(0).asDouble(),
            place.get(1).asDouble(),
            velocity.get(0).asDouble(),
            velocity.get(1).asDouble(),
            Math.max(0, velocity.get(2).asDouble())));
  }

  /** Kicks from the centre in all directions, for models that do not say from which kicks they were made. */
  static List<ReferenceKick> usual(double time) {
    List<ReferenceKick> kicks = new ArrayList<>();
    for (int i = 0; i < DIRECTIONS; i++) {
      double cos = Math.cos(2 * Math.PI * i / DIRECTIONS);
      double sin = Math.sin(2 * Math.PI * i / DIRECTIONS);
      for (double v : FLAT_SPEEDS) {
        kicks.add(new ReferenceKick(KickKind.FLAT, time, 0, 0, v * cos, v * sin, 0));
      }
      kicks.add(
          new ReferenceKick(
              KickKind.CHIP, time, 0, 0, CHIP_SPEED * cos, CHIP_SPEED * sin, CHIP_SPEED));
    }
    return kicks;
  }
}
