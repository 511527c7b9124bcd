package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.effect.Effect;
import java.util.Map;

/** Words for what differs from kick to kick by chance. */
final class ChanceWords {
  private static final Map<String, ChanceWords> ALL =
      Map.of(
          "roll_scatter",
          new ChanceWords(
              "rolling that differs from kick to kick",
              "rolling deceleration (acc_roll)",
              "leave a margin on long passes. See whether several balls are in play, or one that is"
                  + " dirty or out of round."),
          "bounce_scatter",
          new ChanceWords(
              "bounces that differ from kick to kick",
              "vertical damping of bounces (damping_z)",
              "let robots wait for the second bounce of a chip. See whether the carpet is rough or"
                  + " has seams where the chips come down."));

  private final String name;
  private final String quantity;
  private final String advice;

  private ChanceWords(String name, String quantity, String advice) {
    this.name = name;
    this.quantity = quantity;
    this.advice = advice;
  }

  static String name(Effect effect) {
    return ALL.get(effect.id()).name;
  }

  static CauseText of(Effect effect, double scatter) {
    ChanceWords words = ALL.get(effect.id());
    String percent = Amount.of(100 * scatter);
    return new CauseText(
        words.name,
        text(
            "The %s differs by %s %% from kick to kick, and nothing that was recorded says why.",
            words.quantity, percent),
        "",
        "No model predicts it: " + words.advice,
        text("scatter %s %% of the %s", percent, words.quantity));
  }
}
