package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Words for what the carpet, the floor and the ball itself do on the ground. */
final class CarpetWords extends MotionText {
  /** How far before a seam the example pass begins, m; chosen. */
  private static final double RUN_UP = 0.5;

  CarpetWords(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    super(effect, errors, kicks);
  }

  Sentences fieldSlope() {
    double percent = effect.value("percent");
    double downhill = effect.value("direction") + (percent < 0 ? Math.PI : 0);
    Optional<ExampleKicks.Change> across =
        kicks.flat(effect, 0, 0, PASS, downhill + Math.PI / 2, PASS_TIME);
    return Sentences.orExtended(
        text(
            "The field is not level: it falls by %s mm per metre %s.",
            Amount.of(10 * Math.abs(percent)), FieldWords.direction(downhill)),
        across
            .map(
                c ->
                    text(
                        "A pass at %s m/s across the slope drifts %s mm downhill in %s s.",
                        whole(PASS), Amount.of(Math.abs(c.left())), whole(PASS_TIME)))
            .orElse(""),
        "Level the floor under the carpet if you can",
        "; otherwise");
  }

  Sentences carpetNap() {
    double amplitude = effect.value("amplitude");
    double against = effect.value("direction") + (amplitude < 0 ? Math.PI : 0);
    Optional<ExampleKicks.Change> slow = kicks.flat(effect, 0, 0, PASS, against, PASS_TIME);
    Optional<ExampleKicks.Change> fast =
        kicks.flat(effect, 0, 0, PASS, against + Math.PI, PASS_TIME);
    return Sentences.extended(
        text(
            "The carpet has a direction: balls that roll %s are braked %s %% more than on average,"
                + " and balls that roll the other way that much less.",
            FieldWords.direction(against), Amount.of(100 * Math.abs(amplitude))),
        slow.isEmpty()
            ? ""
            : text(
                "A pass at %s m/s that way travels %s mm less far in %s s than one the other way.",
                whole(PASS), Amount.of(fast.get().along() - slow.get().along()), whole(PASS_TIME)));
  }

  Sentences speedDependentRoll() {
    double slope = effect.value("slope");
    OptionalDouble roll = rollingDeceleration();
    boolean grows = slope >= 0;
    return Sentences.extended(
        text(
            "Rolling brakes a fast ball %s than a slow one: by %s m/s² for every m/s%s.",
            grows ? "more" : "less",
            Amount.of(Math.abs(slope)),
            roll.isEmpty()
                ? ""
                : text(
                    " (%s m/s² at 1 m/s, %s m/s² at 3 m/s)",
                    Amount.decimals(roll.getAsDouble() + slope, 3),
                    Amount.decimals(roll.getAsDouble() + 3 * slope, 3))),
        text(
            "A single rolling deceleration is right at one speed only: slower balls roll %s than it"
                + " predicts, faster ones %s.",
            grows ? "farther" : "less far", grows ? "less far" : "farther"));
  }

  Sentences slipDependentFriction() {
    double slope = effect.value("slope");
    boolean grows = slope >= 0;
    String numbers =
        kicks
            .model()
            .flat()
            .map(
                m ->
                    text(
                        " (%s m/s² at 1 m/s of slip, %s m/s² at 4 m/s)",
                        Amount.decimals(-m.accSlide() * (1 - slope), 2),
                        Amount.decimals(-m.accSlide() * (1 + 2 * slope), 2)))
            .orElse("");
    return Sentences.extended(
        text(
            "Sliding friction %s by %s %% for every m/s with which the ball slips over the"
                + " carpet%s.",
            grows ? "grows" : "falls", percent(Math.abs(slope)), numbers),
        text(
            "A single sliding deceleration is right for kicks of one speed only: hard kicks are"
                + " braked %s than it predicts, soft ones %s.",
            grows ? "more" : "less", grows ? "less" : "more"));
  }

  Sentences wornRegion() {
    double change = effect.value("change");
    double x0 = effect.value("region_x0");
    double x1 = effect.value("region_x1");
    double y0 = effect.value("region_y0");
    double y1 = effect.value("region_y1");
    boolean alongX = x1 - x0 >= y1 - y0;
    // Rolls through the middle, along the longer side.
    Optional<ExampleKicks.Change> through =
        kicks.flat(
            effect,
            alongX ? x0 : (x0 + x1) / 2,
            alongX ? (y0 + y1) / 2 : y0,
            PASS,
            alongX ? 0 : Math.PI / 2,
            PASS_TIME);
    return Sentences.orExtended(
        text(
            "%s the carpet brakes %s %% %s than elsewhere.",
            Sentences.begin(FieldWords.region(x0, x1, y0, y1)),
            percent(Math.abs(change)),
            change >= 0 ? "more" : "less"),
        through
            .map(
                c ->
                    text(
                        "A pass at %s m/s that begins there and goes through it travels %s in %s s"
                            + " than elsewhere.",
                        whole(PASS), far(c.along()), whole(PASS_TIME)))
            .orElse(""),
        "Check the carpet there for wear, moisture, dust and seams",
        "; until it is repaired,");
  }

  Sentences carpetSeam() {
    double loss = effect.value("loss");
    double turn = effect.value("turn");
    double normal = effect.value("normal");
    double distance = effect.value("distance");
    List<String> what = new ArrayList<>();
    if (isKnownToBeThere("loss")) {
      what.add(
          text(
              "%s %s %% of the speed across it",
              loss >= 0 ? "takes" : "adds", percent(Math.abs(loss))));
    }
    if (isKnownToBeThere("turn")) {
      what.add(
          text(
              "turns the path by %s° to the %s",
              Amount.of(Math.toDegrees(Math.abs(turn))), turn >= 0 ? "left" : "right"));
    }
    // A pass that begins just before the seam and goes straight across.
    double start = distance - RUN_UP;
    return Sentences.orExtended(
        text(
            "A seam of the carpet %s %s.",
            FieldWords.line(normal, distance),
            what.isEmpty() ? "hardly changes a path" : String.join(" and ", what)),
        kicks
            .flat(
                effect, start * Math.cos(normal), start * Math.sin(normal), PASS, normal, PASS_TIME)
            .map(
                c ->
                    text(
                        "A pass at %s m/s straight across it travels %s in %s s than without the"
                            + " seam, and %s mm to the %s.",
                        whole(PASS),
                        far(c.along()),
                        whole(PASS_TIME),
                        Amount.of(Math.abs(c.left())),
                        c.left() >= 0 ? "left" : "right"))
            .orElse(""),
        "Press or tape the seam flat",
        "; until then,");
  }

  Sentences drift() {
    double percent = effect.value("percent_per_10min");
    OptionalDouble roll = rollingDeceleration();
    String numbers =
        roll.isEmpty()
            ? ""
            : text(
                " (from %s to %s m/s²)",
                Amount.decimals(roll.getAsDouble(), 3),
                Amount.decimals(roll.getAsDouble() * (1 + percent / 100), 3));
    return new Sentences(
        text(
            "The carpet changes: in ten minutes rolling balls are braked %s %% %s%s.",
            Amount.of(Math.abs(percent)), percent >= 0 ? "more" : "less", numbers),
        text(
            "With a model from the beginning of the session, later passes are %s.",
            percent >= 0 ? "too short" : "too long"),
        "Calibrate again shortly before the match, and look for what changes: dust, humidity, a"
            + " ball that warms up or wears.");
  }

  Sentences ballChanged() {
    List<String> what = new ArrayList<>();
    for (String part : List.of("roll", "slide")) {
      if (isKnownToBeThere(part)) {
        double change = effect.value(part);
        what.add(
            text(
                "brakes %s %% %s when it %ss",
                percent(Math.abs(change)), change >= 0 ? "more" : "less", part));
      }
    }
    return new Sentences(
        text(
            "%s, another ball is in play, which %s.",
            Sentences.begin(SessionTime.from(effect.value("at"))),
            what.isEmpty() ? "hardly differs" : String.join(" and ", what)),
        kicks
            .flat(effect.with("at", 0), 0, 0, PASS, 0, PASS_TIME)
            .map(
                c ->
                    text(
                        "A pass at %s m/s travels %s in %s s than with the ball before.",
                        whole(PASS), far(c.along()), whole(PASS_TIME)))
            .orElse(""),
        "Keep to balls of one make and wear, and calibrate again with the ball of the match.");
  }
}
