package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Protobuf's text format. Read without a message definition, so that fields of newer versions do no harm: protobuf's own parser needs the definition and does not say where a value
 * ends.
 */
final class ProtobufTextForm implements ConfigForm {
  /** Blanks and comments; a name, number or string; any other character (https://protobuf.dev/reference/protobuf/textformat-spec/). */
  private static final Pattern TOKEN =
      Pattern.compile(
          "(?:\\s+|#[^\\n]*)+"
              + "|(?<word>[-+A-Za-z0-9_.]+|\\[[A-Za-z0-9_./-]+\\])"
              + "|(?<string>\"(?:[^\"\\\\\\n]|\\\\.)*+\"|'(?:[^'\\\\\\n]|\\\\.)*+')"
              + "|(?<mark>[:<>{},;\\[\\]])");

  @Override
  public String title() {
    return "protobuf text";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    Reader reader = new Reader(base);
    reader.fields(List.of(), "");
    return reader.leaves;
  }

  /** One token after the other. */
  private static final class Reader {
    /** Deeper messages do not occur in configurations; a file of a million brackets must not end the program. */
    private static final int DEEPEST = 100;

    private final BaseFile base;
    private final Matcher matcher;
    private final List<Leaf> leaves = new ArrayList<>();
    private String token;
    private int start;
    private int end;

    Reader(BaseFile base) throws InputException {
      this.base = base;
      matcher = TOKEN.matcher(base.text());
      next();
    }

    /** Goes to the next token; null at the end. */
    private void next() throws InputException {
      token = null;
      while (token == null && end < base.text().length()) {
        matcher.region(end, base.text().length());
        if (!matcher.lookingAt()) {
          char found = base.text().charAt(end);
          throw base.error(end, "is not protobuf text: unexpected '" + found + "'");
        }
        start = matcher.start();
        end = matcher.end();
        boolean blank =
            matcher.group("word") == null
                && matcher.group("string") == null
                && matcher.group("mark") == null;
        token = blank ? null : matcher.group();
      }
      if (token == null) {
        start = end;
      }
    }

    private boolean is(String mark) {
      return mark.equals(token);
    }

    /** Fields up to the closing mark, which is passed over; of the whole file, up to its end. */
    void fields(List<String> path, String closing) throws InputException {
      if (path.size() > DEEPEST) {
        throw base.error(start, "is not a configuration: nested too deeply");
      }
      while (token != null && !is(closing)) {
        if (token.length() == 1 && ":<>{},;[]".contains(token) || token.matches("[\"'].*")) {
          throw base.error(start, "is not protobuf text: expected a field, found " + token);
        }
        field(YamlForm.and(path, token));
        while (is(",") || is(";")) {
          next();
        }
      }
      if (!closing.isEmpty()) {
        if (token == null) {
          throw base.error(end, "is not protobuf text: '" + closing + "' is missing at the end");
        }
        next();
      }
    }

    private void field(List<String> path) throws InputException {
      next();
      boolean colon = is(":");
      if (colon) {
        next();
      }
      if (is("<") || is("{")) {
        String closing = is("<") ? ">" : "}";
        next();
        fields(path, closing);
      } else if (colon) {
        values(path);
      } else {
        throw base.error(
            start, "is not protobuf text: expected ':' or '{' after " + path.get(path.size() - 1));
      }
    }

    private void values(List<String> path) throws InputException {
      if (is("[")) {
        next();
        while (!is("]")) {
          if (is("<") || is("{")) {
            String closing = is("<") ? ">" : "}";
            next();
            fields(path, closing);
          } else {
            value(path);
          }
          if (is(",")) {
            next();
          }
        }
        next();
      } else {
        value(path);
        // Strings that follow each other are one.
        while (token != null && token.matches("[\"'].*")) {
          next();
        }
      }
    }

    private void value(List<String> path) throws InputException {
      if (token == null || token.length() == 1 && ":<>{},;[]".contains(token)) {
        throw base.error(
            start, "is not protobuf text: " + path.get(path.size() - 1) + " has no value");
      }
      leaves.add(new Leaf(path, start, end));
      next();
    }
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    StringBuilder text = new StringBuilder();
    comments.forEach(comment -> text.append("# ").append(comment).append('\n'));
    append(text, ConfigForm.tree(settings), "");
    return text.toString();
  }

  private static void append(StringBuilder text, Map<?, ?> tree, String indent) {
    tree.forEach(
        (name, value) -> {
          text.append(indent).append(name);
          if (value instanceof Setting setting) {
            text.append(": ").append(setting.text()).append('\n');
          } else {
            text.append(" {\n");
            append(text, (Map<?, ?>) value, indent + "  ");
            text.append(indent).append("}\n");
          }
        });
  }
}
