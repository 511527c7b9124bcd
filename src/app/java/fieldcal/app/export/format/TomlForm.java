package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.tomlj.Toml;
import org.tomlj.TomlParseError;
import org.tomlj.TomlParseResult;
import org.tomlj.TomlPosition;

/** TOML. */
final class TomlForm implements ConfigForm {
  /** From a key to the end of a value without blanks. */
  private static final Pattern VALUE = Pattern.compile("[^=\\n]*=[ \\t]*([^\\s,#}]+)");

  @Override
  public String title() {
    return "TOML";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    TomlParseResult toml;
    try {
      toml = Toml.parse(base.text());
    } catch (TomlParseError e) {
      // Most errors are gathered; a wrong escape in the name of a table is thrown.
      throw invalid(base, e);
    }
    if (toml.hasErrors()) {
      throw invalid(base, toml.errors().get(0));
    }
    List<Leaf> leaves = new ArrayList<>();
    for (List<String> path : toml.keyPathSet(false)) {
      int key = index(base.text(), toml.inputPositionOf(path));
      Matcher value = VALUE.matcher(base.text()).region(key, base.text().length());
      if (value.lookingAt()) {
        leaves.add(new Leaf(path, value.start(1), value.end(1)));
      }
    }
    return leaves;
  }

  private static InputException invalid(BaseFile base, TomlParseError error) {
    return new InputException(
        base.name()
            + ", line "
            + error.position().line()
            + ": is not valid TOML: "
            + error.getMessage());
  }

  private static int index(String text, TomlPosition position) {
    int index = 0;
    for (int line = 1; line < position.line(); line++) {
      index = text.indexOf('\n', index) + 1;
    }
    return text.offsetByCodePoints(index, position.column() - 1);
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    StringBuilder text = new StringBuilder();
    comments.forEach(comment -> text.append("# ").append(comment).append('\n'));
    append(text, ConfigForm.tree(settings), "");
    return text.toString();
  }

  private static void append(StringBuilder text, Map<?, ?> tree, String table) {
    boolean values = tree.values().stream().anyMatch(Setting.class::isInstance);
    if (values && !table.isEmpty()) {
      text.append("\n[").append(table).append("]\n");
    }
    tree.forEach(
        (name, value) -> {
          if (value instanceof Setting setting) {
            text.append(name).append(" = ").append(setting.text()).append('\n');
          }
        });
    tree.forEach(
        (name, value) -> {
          if (value instanceof Map<?, ?> nested) {
            append(text, nested, table.isEmpty() ? name.toString() : table + "." + name);
          }
        });
  }
}
