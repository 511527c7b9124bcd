package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.Map;

/** Words for what bounces do to a ball. */
final class BounceWords extends MotionText {
  BounceWords(Effect effect, Map<String, Double> errors, ExampleKicks kicks) {
    super(effect, errors, kicks);
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
    return Sentences.extended(
        text("Hard bounces lose %s height than soft ones%s.", loses ? "more" : "less", numbers),
        text(
            "With one damping for all bounces, the first bounces are predicted too %s and the last"
                + " ones too %s.",
            loses ? "high" : "low", loses ? "low" : "high"));
  }

  Sentences bounceSpinCoupling() {
    double coefficient = effect.value("coefficient");
    return Sentences.extended(
        text(
            "A bounce takes %s speed from a ball with topspin than from one without spin: at the"
                + " spin of a rolling ball, %s %% of its horizontal speed.",
            coefficient >= 0 ? "more" : "less", percent(Math.abs(coefficient))),
        chip("if spin did not matter"));
  }

  Sentences contactImpacts() {
    double reversed = effect.value("reversed");
    String slip =
        reversed == 0
            ? "stops the slip of the ball's lowest point"
            : text(
                "%s the slip of the ball's lowest point: %s %% of it %s",
                reversed > 0 ? "reverses" : "does not quite stop",
                percent(Math.abs(reversed)),
                reversed > 0 ? "comes back" : "stays");
    return Sentences.extended(
        text(
            "The carpet grips the ball at a bounce and %s (coefficient of friction %s).",
            slip, Amount.of(effect.value("friction"))),
        "The ball keeps the spin of one bounce until the next, so each bounce takes less speed than"
            + " the one before; two fixed dampings cannot follow that.");
  }
}
