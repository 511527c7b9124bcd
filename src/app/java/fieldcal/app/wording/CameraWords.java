package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/** Words for the effects on what cameras report. */
final class CameraWords {
  /** The speed of a fast ball, m/s; the league's limit of a kick is 6.5 m/s. */
  private static final double FAST = 6;

  /** The height of a usual chip, m. */
  private static final double HOP = 0.5;

  private static final double TEN_MINUTES = 600;

  private static final String CALIBRATE_CAMERA = "Calibrate this camera again.";

  private static final String CALIBRATE_POSITION =
      "Calibrate focal length, height and position in vision again.";

  private final Effect effect;
  private final Map<String, Double> errors;
  private final ReportedShifts shifts;

  CameraWords(Effect effect, Map<String, Double> errors, ReportedShifts shifts) {
    this.effect = effect;
    this.errors = errors;
    this.shifts = shifts;
  }

  Sentences offset() {
    double x = effect.value("x_mm");
    double y = effect.value("y_mm");
    int cameras = shifts.cameras();
    String what =
        text(
            "%s reports everything %s%s.",
            begin(),
            FieldWords.shift(x, y, error("x_mm"), error("y_mm"), "too far "),
            cameras == 1 ? "" : ", measured against the mean of all cameras");
    if (cameras < 2) {
      return new Sentences(what, "", "Correct its calibration.");
    }
    // The others are shifted the opposite way, by 1/(n − 1) of it.
    String jump = Amount.of(Math.hypot(x, y) * cameras / (cameras - 1));
    return shifts
        .otherCamera(camera())
        .map(
            other ->
                new Sentences(
                    what,
                    text(
                        "A ball that rolls from its view into that of %s seems to jump by %s"
                            + " mm.",
                        CameraName.of(other), jump),
                    text(
                        "Correct its calibration or that of %s: kicks cannot show which of the two"
                            + " is right.",
                        CameraName.of(other))))
        .orElseGet(
            () ->
                new Sentences(
                    what,
                    text(
                        "A ball that rolls from its view into another's seems to jump by about %s"
                            + " mm.",
                        jump),
                    "Correct its calibration."));
  }

  Sentences timeOffset() {
    double ms = effect.value("ms");
    return new Sentences(
        text(
            "%s's time stamps are %s ms %s.",
            begin(), Amount.of(Math.abs(ms)), ms >= 0 ? "late" : "early"),
        text(
            "A ball at %s m/s appears %s mm %s its true place.",
            Amount.decimals(FAST, 0),
            Amount.of(FAST * Math.abs(ms)),
            ms >= 0 ? "behind" : "ahead of"),
        "Synchronise the clocks of the vision computers, and give all cameras the same exposure and"
            + " the same kind of time stamp.");
  }

  Sentences poseError() {
    double height = effect.value("height_mm");
    double x = effect.value("shift_x_mm");
    double y = effect.value("shift_y_mm");
    double tilt = effect.value("tilt_mrad");
    List<String> hangs = new ArrayList<>();
    if (isKnownToBeThere("height_mm")) {
      // Published minus true.
      hangs.add(text("%s mm %s", Amount.of(Math.abs(height)), height >= 0 ? "lower" : "higher"));
    }
    if (isKnownToBeThere("shift_x_mm") || isKnownToBeThere("shift_y_mm")) {
      hangs.add(FieldWords.shift(-x, -y, error("shift_x_mm"), error("shift_y_mm"), "farther "));
    }
    List<String> parts = new ArrayList<>();
    if (!hangs.isEmpty()) {
      parts.add("hangs " + String.join(" and ", hangs));
    }
    if (isKnownToBeThere("tilt_mrad")) {
      // Published minus true: reports are shifted towards axis + 90°, so the true camera looks the
      // other way.
      double looks = effect.value("axis") - Math.copySign(Math.PI / 2, tilt);
      parts.add(
          text(
              "looks %s mrad (%s°) farther %s,",
              Amount.of(Math.abs(tilt)),
              Amount.of(Math.toDegrees(Math.abs(tilt) / 1000)),
              FieldWords.direction(looks)));
    }
    String how =
        parts.isEmpty() ? "hangs or looks slightly differently" : String.join(", and ", parts);
    return new Sentences(
        text("%s %s than its calibration says.", begin(), how), reports(), CALIBRATE_CAMERA);
  }

  Sentences positionError() {
    double x = effect.value("x_mm");
    double y = effect.value("y_mm");
    double height = effect.value("height_mm");
    List<String> parts = new ArrayList<>();
    if (isKnownToBeThere("x_mm") || isKnownToBeThere("y_mm")) {
      parts.add(FieldWords.shift(x, y, error("x_mm"), error("y_mm"), "too far "));
    }
    if (isKnownToBeThere("height_mm")) {
      parts.add(text("%s mm too %s", Amount.of(Math.abs(height)), height >= 0 ? "high" : "low"));
    }
    String where = parts.isEmpty() ? "slightly off" : String.join(", and ", parts);
    OptionalDouble hangs = shifts.height(camera());
    double off = Math.hypot(x, y) * HOP / (hangs.orElse(Double.NaN) - HOP);
    String far = off > 0 ? text("%s mm off", Amount.of(off)) : "wrongly";
    return new Sentences(
        text(
            "The position that vision publishes for %s is %s.",
            camera() == EffectParameters.ALL_CAMERAS ? "every camera" : CameraName.of(camera()),
            where),
        text(
            "Balls on the carpet are reported where they are. A program that uses the position to"
                + " locate a ball that flies %s m high places it %s.",
            Amount.decimals(HOP, 1), far),
        CALIBRATE_POSITION + " Until then, predict chips with the extended model.",
        CALIBRATE_POSITION);
  }

  Sentences lensDistortion() {
    double delta = effect.value("delta");
    boolean all = camera() == EffectParameters.ALL_CAMERAS;
    return new Sentences(
        text(
            "%s lens distortion is published %s too %s.",
            all ? "Every camera's" : begin() + "'s",
            Amount.of(Math.abs(delta)),
            delta >= 0 ? "large" : "small"),
        reports(),
        all ? "Calibrate the cameras again." : CALIBRATE_CAMERA);
  }

  Sentences moved() {
    double x = effect.value("x_mm");
    double y = effect.value("y_mm");
    return new Sentences(
        text(
            "%s was knocked: %s, it reports everything %s.",
            begin(),
            SessionTime.from(effect.value("at")),
            FieldWords.shift(x, y, error("x_mm"), error("y_mm"), "too far ")),
        text(
            "What it shows now does not fit its calibration: a ball seems to jump by %s mm where"
                + " its view begins.",
            Amount.of(Math.hypot(x, y))),
        "Fasten this camera and calibrate it again.");
  }

  Sentences ballHeight() {
    double mm = effect.value("mm");
    return new Sentences(
        text(
            "Vision takes the centre of a ball on the carpet to be %s mm %s than it is.",
            Amount.of(Math.abs(mm)), mm >= 0 ? "higher" : "lower"),
        text(
            "It reports balls too %s the point below each camera%s.",
            mm >= 0 ? "near to" : "far from",
            shifts
                .of(effect)
                .map(
                    s ->
                        text(
                            ": by %s mm on average, and by up to %s mm far from a camera",
                            Amount.of(s.typical()), Amount.of(s.largest())))
                .orElse("")),
        "Set the ball's radius in vision to that of the ball, 21.5 mm.");
  }

  Sentences clockSkew() {
    double ppm = effect.value("ppm");
    double drift = 1e-6 * TEN_MINUTES * Math.abs(ppm);
    return new Sentences(
        text(
            "%s's clock runs %s ppm %s, %s ms in ten minutes.",
            begin(), Amount.of(Math.abs(ppm)), ppm >= 0 ? "fast" : "slow", Amount.of(1000 * drift)),
        text(
            "After ten minutes, a ball at %s m/s appears %s mm %s its true place.",
            Amount.decimals(FAST, 0),
            Amount.of(1000 * FAST * drift),
            ppm >= 0 ? "behind" : "ahead of"),
        "Synchronise the clocks of the vision computers.");
  }

  Sentences rollingShutter() {
    double ms = effect.value("ms");
    return Sentences.orExtended(
        text(
            "The cameras expose their image rows one after another, the %s row %s ms after the"
                + " %s.",
            ms >= 0 ? "last" : "first", Amount.of(Math.abs(ms)), ms >= 0 ? "first" : "last"),
        text(
            "Low in the image, a ball at %s m/s appears up to %s mm %s its place at the time of the"
                + " stamp.",
            Amount.decimals(FAST, 0),
            Amount.of(FAST * Math.abs(ms)),
            ms >= 0 ? "ahead of" : "behind"),
        "Use cameras with a global shutter",
        "; otherwise");
  }

  private String reports() {
    return shifts
        .of(effect)
        .map(
            s ->
                text(
                    "The reported places of the ball are off by %s mm on average, and by up to %s"
                        + " mm.",
                    Amount.of(s.typical()), Amount.of(s.largest())))
        .orElse("");
  }

  /** The camera's name at the begin of a sentence. */
  private String begin() {
    return Sentences.begin(CameraName.of(camera()));
  }

  private int camera() {
    return (int) effect.value("camera");
  }

  private double error(String name) {
    return errors.getOrDefault(name, Double.NaN);
  }

  private boolean isKnownToBeThere(String name) {
    double size = Math.abs(effect.value(name));
    return size > 0 && !(size < 2 * error(name));
  }
}
