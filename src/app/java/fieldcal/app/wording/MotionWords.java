package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Words for the effects on the ball's motion and on the kick. */
final class MotionWords {
  /** The example pass: its speed, m/s, and when one looks where it is, s. Chosen: a pass through half of the field. */
  private static final double PASS = 4;

  private static final double PASS_TIME = 2;

  /** The example chip, m/s and s: it has bounced some times. */
  private static final double CHIP = 5;

  private static final double CHIP_TIME = 1.5;

  /** The league's limit of a kick's speed is 6.5 m/s. */
  private static final double HARD_KICK = 6;

  private static final String EXTENDED =
      "There is nothing to repair: predict with the extended model.";

  private final Effect effect;
  private final Map<String, Double> errors;
  private final ExampleKicks kicks;

  MotionWords(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    this.effect = effect;
    this.errors = errors;
    this.kicks = kicks;
  }

  Sentences airDrag() {
    double cd = effect.value("cd");
    return new Sentences(
        cd >= 0
            ? text(
                "The air brakes the ball: drag coefficient %s (a golf ball has about 0.45).",
                Amount.of(cd))
            : text(
                "Fast balls are braked less than the model says, as if the air pushed them (drag"
                    + " coefficient %s); a real drag is positive, so the true cause is another.",
                Amount.of(cd)),
        pass("without air", HARD_KICK, 1),
        "The league's ball model has no air: predict with the extended model, or calibrate with"
            + " kicks as fast as those of your games.");
  }

  Sentences magnus() {
    double cl = effect.value("cl");
    return new Sentences(
        text(
            "The air pushes spinning balls aside, up or down: lift coefficient %s, a ball with"
                + " topspin is %s.",
            Amount.of(cl), cl >= 0 ? "pressed down" : "lifted"),
        pass("without this force", PASS, PASS_TIME),
        EXTENDED);
  }

  Sentences kickSpin() {
    double fraction = effect.value("fraction");
    String sort = fraction < 0 ? "backspin" : "topspin";
    String switching =
        kicks
            .model()
            .flat()
            .map(
                m ->
                    text(
                        " A flat kick rolls from %s %% of its speed on instead of %s %%.",
                        percent(m.kSwitch() + (1 - m.kSwitch()) * fraction), percent(m.kSwitch())))
            .orElse("");
    return new Sentences(
        text(
            "The kickers give the ball %s: %s %% of the spin of a rolling ball.",
            sort, percent(Math.abs(fraction))),
        pass("without spin", PASS, PASS_TIME) + switching,
        "Look at the height at which the kickers hit the ball, and whether the dribblers still turn"
            + " then; until that is mended, predict with the extended model.");
  }

  Sentences sideSpin() {
    double fraction = effect.value("fraction");
    Optional<ExampleKicks.Change> change = kicks.flat(effect, 0, 0, PASS, 0, PASS_TIME);
    return new Sentences(
        text(
            "The kickers give the ball side spin, %s %% of the spin of a rolling ball: while it"
                + " slides, its path curves to the %s.",
            percent(Math.abs(fraction)), fraction >= 0 ? "right" : "left"),
        change
            .map(
                c ->
                    text(
                        "A pass at %s m/s is %s mm to the %s after %s s.",
                        whole(PASS),
                        Amount.of(Math.abs(c.left())),
                        c.left() > 0 ? "left" : "right",
                        whole(PASS_TIME)))
            .orElse(""),
        "Look whether the ball lies in the middle of the kickers and the dribblers are straight;"
            + " until that is mended, predict with the extended model.");
  }

  Sentences fieldSlope() {
    double percent = effect.value("percent");
    double downhill = effect.value("direction") + (percent < 0 ? Math.PI : 0);
    Optional<ExampleKicks.Change> across =
        kicks.flat(effect, 0, 0, PASS, downhill + Math.PI / 2, PASS_TIME);
    return new Sentences(
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
        "Level the floor under the carpet if you can; otherwise predict with the extended model.");
  }

  Sentences carpetNap() {
    double amplitude = effect.value("amplitude");
    double against = effect.value("direction") + (amplitude < 0 ? Math.PI : 0);
    Optional<ExampleKicks.Change> slow = kicks.flat(effect, 0, 0, PASS, against, PASS_TIME);
    Optional<ExampleKicks.Change> fast =
        kicks.flat(effect, 0, 0, PASS, against + Math.PI, PASS_TIME);
    return new Sentences(
        text(
            "The carpet has a direction: balls that roll %s are braked %s %% more than on average,"
                + " those the other way as much less.",
            FieldWords.direction(against), Amount.of(100 * Math.abs(amplitude))),
        slow.isEmpty()
            ? ""
            : text(
                "A pass at %s m/s that way comes %s mm less far in %s s than one the other way.",
                whole(PASS), Amount.of(fast.get().along() - slow.get().along()), whole(PASS_TIME)),
        EXTENDED);
  }

  Sentences speedDependentRoll() {
    double slope = effect.value("slope");
    OptionalDouble roll = rollingDeceleration();
    boolean grows = slope >= 0;
    return new Sentences(
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
            "One accRoll is right at one speed only: slower balls roll %s than it predicts, faster"
                + " ones %s.",
            grows ? "farther" : "less far", grows ? "less far" : "farther"),
        EXTENDED);
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
    return new Sentences(
        text(
            "%s the carpet brakes %s %% %s than elsewhere.",
            Sentences.begin(FieldWords.region(x0, x1, y0, y1)),
            percent(Math.abs(change)),
            change >= 0 ? "more" : "less"),
        through
            .map(
                c ->
                    text(
                        "A pass at %s m/s that begins there and goes through it comes %s in %s s"
                            + " than elsewhere.",
                        whole(PASS), far(c.along()), whole(PASS_TIME)))
            .orElse(""),
        "Look at the carpet there (worn, wet, a seam, dust); until it is mended, predict with the"
            + " extended model.");
  }

  Sentences speedDependentRestitution() {
    double slope = effect.value("slope");
    boolean loses = slope >= 0;
    String numbers =
        kicks
            .model()
            .chip()
            .map(
                m ->
                    text(
                        ": an impact at 3 m/s leaves %s %% of the vertical speed, one at 1 m/s"
                            + " %s %%",
                        percent(m.dampingZ() * (1 - slope * 1.5)),
                        percent(m.dampingZ() * (1 + slope * 0.5))))
            .orElse(text(" by %s %% per m/s", percent(Math.abs(slope))));
    return new Sentences(
        text("Hard bounces lose %s height than soft ones%s.", loses ? "more" : "less", numbers),
        text(
            "With one damping for all, the first bounces are predicted too %s and the last ones too"
                + " %s.",
            loses ? "high" : "low", loses ? "low" : "high"),
        EXTENDED);
  }

  Sentences bounceSpinCoupling() {
    double coefficient = effect.value("coefficient");
    return new Sentences(
        text(
            "A bounce takes %s speed from a ball with topspin: %s %% for the spin of a rolling"
                + " ball.",
            coefficient >= 0 ? "more" : "less", percent(Math.abs(coefficient))),
        chip("if spin did not matter"),
        EXTENDED);
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
            "A model of the session's begin lets balls come out %s later on.",
            percent >= 0 ? "too short" : "too long"),
        "Calibrate again shortly before the match, and look for what changes: dust, humidity, a"
            + " ball that warms up or wears.");
  }

  Sentences robotKickBias() {
    double percent = effect.value("percent");
    double yaw = effect.value("yaw");
    List<String> what = new ArrayList<>();
    List<String> then = new ArrayList<>();
    if (isKnownToBeThere("percent")) {
      what.add(text("%s %% %s", Amount.of(Math.abs(percent)), percent >= 0 ? "faster" : "slower"));
      then.add(
          text(
              "told to kick at 5 m/s it kicks at %s m/s",
              Amount.decimals(5 * (1 + percent / 100), 2)));
    }
    if (isKnownToBeThere("yaw")) {
      String side = yaw >= 0 ? "left" : "right";
      what.add(text("%s° to the %s", Amount.of(Math.toDegrees(Math.abs(yaw))), side));
      then.add(
          text(
              "a pass over 4 m arrives %s mm too far to the %s",
              Amount.of(4000 * Math.abs(Math.tan(yaw))), side));
    }
    return new Sentences(
        text(
            "Robot %s kicks %s than it is told.",
            EffectName.robot(effect), what.isEmpty() ? "aside" : String.join(" and ", what)),
        then.isEmpty() ? "" : Sentences.begin(String.join(", and ", then)) + ".",
        "Correct this robot's kicker table.");
  }

  private boolean isKnownToBeThere(String name) {
    double size = Math.abs(effect.value(name));
    return size > 0 && !(size < 2 * errors.getOrDefault(name, Double.NaN));
  }

  /** What a pass does, or where there are no flat kicks, a chip. */
  private String pass(String without, double speed, double after) {
    return kicks
        .flat(effect, 0, 0, speed, 0, after)
        .map(
            c ->
                text(
                    "A pass at %s m/s comes %s in %s s than it would %s.",
                    whole(speed), far(c.along()), whole(after), without))
        .orElseGet(() -> chip(without));
  }

  private String chip(String without) {
    return kicks
        .chip(effect, CHIP, CHIP_TIME)
        .map(
            c ->
                text(
                    "A chip at %s m/s, 45° steep, comes %s in %s s than it would %s.",
                    whole(CHIP), far(c.along()), Amount.decimals(CHIP_TIME, 1), without))
        .orElse("");
  }

  private OptionalDouble rollingDeceleration() {
    Optional<Double> roll =
        kicks
            .model()
            .flat()
            .map(FlatModel::accRoll)
            .or(() -> kicks.model().chip().map(ChipModel::accRoll));
    return roll.map(r -> OptionalDouble.of(-r)).orElse(OptionalDouble.empty());
  }

  private static String far(double mm) {
    return Amount.of(Math.abs(mm)) + " mm " + (mm < 0 ? "less far" : "farther");
  }

  private static String whole(double value) {
    return Amount.decimals(value, 0);
  }

  private static String percent(double fraction) {
    return Amount.of(100 * fraction);
  }
}
