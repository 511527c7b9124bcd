package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** What words for effects on the motion and on the kick have in common: example kicks, and how numbers are said. */
abstract class MotionText {
  /** The example pass: its speed, m/s, and when one looks where it is, s. Chosen: a pass through half of the field. */
  static final double PASS = 4;

  static final double PASS_TIME = 2;

  /** The example chip, m/s and s: it has bounced some times. */
  private static final double CHIP = 5;

  private static final double CHIP_TIME = 1.5;

  final Effect effect;
  final ExampleKicks kicks;
  final Map<String, Double> errors;

  MotionText(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    this.effect = effect;
    this.errors = errors;
    this.kicks = kicks;
  }

  boolean isKnownToBeThere(String name) {
    double size = Math.abs(effect.value(name));
    return size > 0 && !(size < 2 * errors.getOrDefault(name, Double.NaN));
  }

  /** What a pass does, or where there are no flat kicks, a chip. */
  String pass(String without, double speed, double after) {
    return kicks
        .flat(effect, 0, 0, speed, 0, after)
        .map(
            c ->
                text(
                    "A pass at %s m/s travels %s in %s s than it would %s.",
                    whole(speed), far(c.along()), whole(after), without))
        .orElseGet(() -> chip(without));
  }

  String chip(String without) {
    return kicks
        .chip(effect, CHIP, CHIP_TIME)
        .map(
            c ->
                text(
                    "A chip at %s m/s and an elevation of 45° travels %s in %s s than it would %s.",
                    whole(CHIP), far(c.along()), Amount.decimals(CHIP_TIME, 1), without))
        .orElse("");
  }

  OptionalDouble rollingDeceleration() {
    Optional<Double> roll =
        kicks
            .model()
            .flat()
            .map(FlatModel::accRoll)
            .or(() -> kicks.model().chip().map(ChipModel::accRoll));
    return roll.map(r -> OptionalDouble.of(-r)).orElse(OptionalDouble.empty());
  }

  static String far(double mm) {
    return Amount.of(Math.abs(mm)) + " mm " + (mm < 0 ? "less far" : "farther");
  }

  static String whole(double value) {
    return Amount.decimals(value, 0);
  }

  static String percent(double fraction) {
    return Amount.of(100 * fraction);
  }
}
