package fieldcal.app.wording;

import static fieldcal.app.wording.Sentences.text;

import fieldcal.diagnosis.decision.Dependence;
import fieldcal.diagnosis.decision.Dependence.Level;
import fieldcal.effect.Effect;
import fieldcal.effect.learned.Variable;
import java.util.Map;
import java.util.Optional;

/** Words for what differs from kick to kick, by chance or following something that was recorded. */
final class ChanceWords {
  /** A form that leaves less than that share of the scatter leaves nothing worth saying. */
  private static final double LEFT = 0.2;

  private static final Map<String, ChanceWords> ALL =
      Map.of(
          "roll_scatter",
          new ChanceWords(
              "rolling",
              "rolling deceleration (acc_roll)",
              "",
              "leave a margin on long passes. Check whether several balls are in play, or one that"
                  + " is dirty or not round."),
          "bounce_scatter",
          new ChanceWords(
              "height of bounces",
              "vertical damping of bounces (damping_z)",
              "",
              "let robots wait for the second bounce of a chip. Check whether the carpet is rough"
                  + " or has seams where the chips land."),
          "pull_scatter",
          new ChanceWords(
              "sideways pull",
              "pull of the rolling ball to its left",
              "m/s²",
              "leave a margin on long passes. Let a ball roll slowly from the same place several"
                  + " times: if it curves a different way each time, its weight is not in its"
                  + " centre; use another ball."));

  private final String name;
  private final String quantity;

  /** Empty where the magnitude is a share. */
  private final String unit;

  private final String advice;

  private ChanceWords(String name, String quantity, String unit, String advice) {
    this.name = name;
    this.quantity = quantity;
    this.unit = unit;
    this.advice = advice;
  }

  static String name(Effect effect) {
    return ALL.get(effect.id()).name + " that differs from kick to kick";
  }

  static CauseText of(Effect effect, double scatter, Optional<Dependence> follows) {
    ChanceWords words = ALL.get(effect.id());
    String strength = text("scatter %s of the %s", words.amount(scatter), words.quantity);
    if (follows.isPresent()) {
      Dependence d = follows.get();
      return new CauseText(
          words.name + " that depends on " + LearnedWords.variable(d.on()),
          words.form(d) + words.rest(d, scatter),
          "",
          advice(d),
          strength);
    }
    return new CauseText(
        name(effect),
        text(
            "The %s differs by %s from kick to kick, and nothing that was recorded says why.",
            words.quantity, words.amount(scatter)),
        "",
        "No model predicts it: " + words.advice,
        strength);
  }

  private String form(Dependence d) {
    return switch (d.form()) {
      case STEP ->
          text(
              "%s, the %s is %s %s.",
              Sentences.begin(SessionTime.from(d.place())),
              quantity,
              amount(Math.abs(d.change())),
              d.change() < 0 ? "lower" : "higher");
      case LINE ->
          text(
              "The %s %s: it is %s its mean %s and %s it %s.",
              quantity,
              d.on() == Variable.SESSION_TIME
                  ? "drifts during the session"
                  : "changes steadily with " + LearnedWords.variable(d.on()),
              from(d.lowest()),
              where(d, d.lowest()),
              from(d.highest()),
              where(d, d.highest()));
      case CURVE ->
          text(
              "The %s follows %s in a smooth curve: it is lowest %s, %s its mean, and highest %s,"
                  + " %s it.",
              quantity,
              LearnedWords.variable(d.on()),
              where(d, d.lowest()),
              from(d.lowest()),
              where(d, d.highest()),
              from(d.highest()));
    };
  }

  private String from(Level level) {
    return amount(Math.abs(level.value())) + (level.value() < 0 ? " below" : " above");
  }

  /** With its unit; a share in per cent. */
  private String amount(double value) {
    return unit.isEmpty() ? Amount.of(100 * value) + " %" : Amount.of(value) + " " + unit;
  }

  private static String where(Dependence d, Level level) {
    return switch (d.on()) {
      case SESSION_TIME -> "at " + SessionTime.at(level.x());
      case HEADING -> FieldWords.direction(level.x());
      case PLACE ->
          text(
              "at x = %s m, y = %s m",
              Amount.decimals(level.x(), 1), Amount.decimals(level.y(), 1));
      default -> text("at %s %s", Amount.of(level.x()), d.on().unit());
    };
  }

  private String rest(Dependence d, double scatter) {
    double left = Math.sqrt(Math.max(0, 1 - d.explained()));
    return left < LEFT
        ? ""
        : text(
            " Beyond that it differs by %s from kick to kick, and nothing that was recorded says"
                + " why.",
            amount(scatter * left));
  }

  private static String advice(Dependence d) {
    if (d.on() != Variable.SESSION_TIME) {
      return text(
          "Record kicks that differ in nothing but %s, and diagnose again.",
          LearnedWords.variable(d.on()));
    }
    return d.form() == Dependence.Form.STEP
        ? "Check whether another ball came into play then, or something was done to the carpet, and"
            + " calibrate the kicks before and after it separately."
        : "Check what changed in the meantime, such as temperature, humidity or the wear of the"
            + " ball, and calibrate again during the session.";
  }
}
