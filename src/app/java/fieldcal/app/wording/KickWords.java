package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Words for what kickers do to a ball. */
final class KickWords extends MotionText {
  KickWords(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    super(effect, errors, kicks);
  }

  Sentences kickSpin() {
    double fraction = effect.value("fraction");
    String switching =
        kicks
            .model()
            .flat()
            .map(
                m ->
                    text(
                        " A flat kick begins to roll at %s %% of its initial speed instead of %s"
                            + " %%.",
                        percent(m.kSwitch() + (1 - m.kSwitch()) * fraction), percent(m.kSwitch())))
            .orElse("");
    return Sentences.orExtended(
        KickerSpin.of(effect, errors).sentence(),
        pass("without spin", PASS, PASS_TIME) + switching,
        "Check at which height the kickers hit the ball, and whether the dribblers still turn then",
        "; until that is corrected,");
  }

  Sentences sideSpin() {
    double fraction = effect.value("fraction");
    Optional<ExampleKicks.Change> change = kicks.flat(effect, 0, 0, PASS, 0, PASS_TIME);
    return Sentences.orExtended(
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
        "Check whether the ball lies in the middle of the kickers, and whether the dribblers are"
            + " straight",
        "; until that is corrected,");
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
              "commanded to kick at 5 m/s, it kicks at %s m/s",
              Amount.decimals(5 * (1 + percent / 100), 2)));
    }
    if (isKnownToBeThere("yaw")) {
      String side = yaw >= 0 ? "left" : "right";
      what.add(text("%s° farther to the %s", Amount.of(Math.toDegrees(Math.abs(yaw))), side));
      then.add(
          text(
              "a pass over 4 m arrives %s mm too far to the %s",
              Amount.of(4000 * Math.abs(Math.tan(yaw))), side));
    }
    return new Sentences(
        what.isEmpty()
            ? text("Robot %s does not kick as commanded.", EffectName.robot(effect))
            : text(
                "Robot %s kicks %s than commanded.",
                EffectName.robot(effect), String.join(" and ", what)),
        then.isEmpty() ? "" : Sentences.begin(String.join(", and ", then)) + ".",
        "Correct this robot's kicker table.");
  }
}
