package fieldcal.app.calibrate;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.wording.EffectName;
import fieldcal.calibration.ExtendedCalibration;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.MeasurementEffect;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * What a calibration under an extended model must say of itself: the league's message carries the five or six numbers of the simple model and none of the
 * effects that they hold together with.
 */
final class ExtendedModelNotes {
  /** Less is lost in the noise of one kick. */
  private static final double NOTABLE_MOVE_MM = 0.5;

  private final ExtendedCalibration extended;
  private final CollectedKicks data;

  ExtendedModelNotes(ExtendedCalibration extended, CollectedKicks data) {
    this.extended = extended;
    this.data = data;
  }

  /** The effects for which the message has no field, each with its numbers. */
  static List<String> notInMessage(ExtendedModel model) {
    return model.effects().stream()
        .map(e -> EffectName.of(e) + " (" + EffectName.strength(e, Map.of()) + ")")
        .toList();
  }

  /** Comment lines for the text form of the message. */
  static String comments(ExtendedModel model) {
    StringBuilder text = new StringBuilder();
    text.append(
        "# These numbers are valid only together with effects that this message has no field"
            + " for:\n");
    notInMessage(model).forEach(e -> text.append("#   ").append(e).append('\n'));
    text.append("# A program that knows this message alone predicts better with the numbers of\n");
    text.append("# calibrate without --model.\n");
    return text.toString();
  }

  /** Sentences for the operator, the most important first. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    ExtendedModel model = extended.model();
    if (!model.effects().isEmpty()) {
      sentences.add(
          "The league's message carries the parameters, but not the effects they are valid with: "
              + String.join("; ", notInMessage(model))
              + ". Use these parameters only in programs that use the extended model; for others"
              + " calibrate without --model.");
    }
    if (extended.lastMoveMm() > NOTABLE_MOVE_MM) {
      sentences.add(
          String.format(
              Locale.ROOT,
              "After %d rounds the effects still move a kick by %.2f mm: the model may not fit"
                  + " these recordings.",
              extended.rounds(),
              extended.lastMoveMm()));
    }
    strangers(sentences);
    String growing =
        model.effects().stream()
            .filter(Effect::changesWithTime)
            .map(EffectName::of)
            .collect(Collectors.joining(", "));
    if (!growing.isEmpty()) {
      sentences.add(
          "These effects depend on the time, which is counted from the beginning of these"
              + " recordings: "
              + growing
              + ".");
    }
    return sentences;
  }

  /** Effects of cameras that are not here, or of which too little is known, do nothing. */
  private void strangers(List<String> sentences) {
    for (Effect effect : extended.model().effects()) {
      boolean idle =
          effect instanceof MeasurementEffect m
              && data.observers().stream().noneMatch(o -> m.isApplicable(o) && isAbout(m, o.id()));
      if (idle) {
        sentences.add(
            "Of the extended model, "
                + EffectName.of(effect)
                + " was left out: these recordings have no such camera, or lack its geometry.");
      }
    }
  }

  private static boolean isAbout(MeasurementEffect effect, int camera) {
    return effect.parameters().stream()
        .filter(p -> p.name().equals("camera"))
        .allMatch(p -> (int) p.value() == camera || p.value() == EffectParameters.ALL_CAMERAS);
  }
}
