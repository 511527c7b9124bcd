package fieldcal.app.console;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.vision.BallModels;
import java.util.List;
import java.util.Locale;

/** A model as text to be pasted into somebody's configuration. */
final class Snippets {
  private Snippets() {}

  static ObjectNode of(BallModels models) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("text", models.toText());
    node.put("properties", properties(models));
    node.put("java", java(models));
    return node;
  }

  private static String properties(BallModels models) {
    StringBuilder text = new StringBuilder();
    models.flat().map(FlatModel::parameters).ifPresent(p -> append(text, "ball.flat.", p));
    models
        .chip()
        .map(ChipModel::parameters)
        .ifPresent(p -> append(text, "ball.chip.", p.subList(0, 3)));
    return text.toString();
  }

  private static void append(StringBuilder text, String prefix, List<Parameter> parameters) {
    for (Parameter p : parameters) {
      String unit = p.unit().isEmpty() ? "" : "  # " + p.unit();
      text.append(prefix).append(p.name()).append(" = ").append(number(p.value())).append(unit);
      text.append('\n');
    }
  }

  private static String java(BallModels models) {
    StringBuilder text = new StringBuilder();
    models
        .flat()
        .ifPresent(
            m ->
                text.append(
                    "FlatModel flat = new FlatModel(%s, %s, %s);\n"
                        .formatted(
                            number(m.accSlide()), number(m.accRoll()), number(m.kSwitch()))));
    models
        .chip()
        .ifPresent(
            m ->
                text.append(
                    "ChipModel chip = new ChipModel(%s, %s, %s, %s);\n"
                        .formatted(
                            number(m.dampingXyFirstHop()),
                            number(m.dampingXyOtherHops()),
                            number(m.dampingZ()),
                            number(m.accRoll()))));
    return text.toString();
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.5f", value);
  }
}
