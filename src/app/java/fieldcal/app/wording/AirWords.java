package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.Map;

/** Words for what the air does to a ball. */
final class AirWords extends MotionText {
  /** The league's limit of a kick's speed is 6.5 m/s. */
  private static final double HARD_KICK = 6;

  AirWords(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    super(effect, errors, kicks);
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
        "The league's ball model has no air: predict with the extended model; otherwise calibrate"
            + " with kicks as fast as those of your games.",
        "The league's ball model has no air: calibrate with kicks as fast as those of your games.");
  }

  Sentences magnus() {
    double cl = effect.value("cl");
    return Sentences.extended(
        text(
            "The air pushes spinning balls sideways, up or down: lift coefficient %s, a ball with"
                + " topspin is %s.",
            Amount.of(cl), cl >= 0 ? "pressed down" : "lifted"),
        pass("without this force", PASS, PASS_TIME));
  }

  Sentences wind() {
    double speed = effect.value("speed");
    double towards = effect.value("direction") + (speed < 0 ? Math.PI : 0);
    return Sentences.orExtended(
        text(
            "The air over the field moves at %s m/s %s.",
            Amount.of(Math.abs(speed)), FieldWords.direction(towards)),
        kicks
            .flat(effect, 0, 0, PASS, towards, PASS_TIME)
            .map(
                c ->
                    text(
                        "A pass at %s m/s that way travels %s in %s s than in still air.",
                        whole(PASS), far(c.along()), whole(PASS_TIME)))
            .orElseGet(() -> chip("in still air")),
        "Close the doors and switch off fans near the field",
        "; otherwise");
  }
}
