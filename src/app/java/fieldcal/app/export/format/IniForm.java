package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** INI files as Qt's QSettings reads them: sections, {@code key=value}, comments after a semicolon at the beginning of a line. */
final class IniForm implements ConfigForm {

  @Override
  public String title() {
    return "INI";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    List<Leaf> leaves = new ArrayList<>();
    String section = "General";
    String text = base.text();
    int next;
    for (int start = 0; start < text.length(); start = next) {
      int feed = text.indexOf('\n', start);
      next = feed < 0 ? text.length() : feed + 1;
      String line = text.substring(start, next).strip();
      if (line.isEmpty() || line.startsWith(";") || line.startsWith("#")) {
        continue;
      }
      int equals = text.indexOf('=', start);
      if (line.startsWith("[") && line.endsWith("]")) {
        section = line.substring(1, line.length() - 1);
      } else if (equals < 0 || equals >= next) {
        throw base.error(start, "is not INI: neither [section] nor key=value: " + brief(line));
      } else {
        int from = equals + 1;
        int to = next;
        while (to > from && Character.isWhitespace(text.charAt(to - 1))) {
          to--;
        }
        while (from < to && Character.isWhitespace(text.charAt(from))) {
          from++;
        }
        leaves.add(new Leaf(List.of(section, text.substring(start, equals).strip()), from, to));
      }
    }
    return leaves;
  }

  private static String brief(String line) {
    return line.length() > 40 ? line.substring(0, 40) + "…" : line;
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    StringBuilder text = new StringBuilder();
    comments.forEach(comment -> text.append("; ").append(comment).append('\n'));
    for (Map.Entry<String, Object> section : ConfigForm.tree(settings).entrySet()) {
      text.append('[').append(section.getKey()).append("]\n");
      ((Map<?, ?>) section.getValue())
          .forEach(
              (name, value) ->
                  text.append(name).append('=').append(((Setting) value).text()).append('\n'));
    }
    return text.toString();
  }
}
