package fieldcal.app.twin;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.InputException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;

/** One object of a JSON file; every error names the file and the field. A field that nobody asked for is an error: a misspelt one must not count as absent. */
final class Fields {
  private final Path file;
  private final String place;
  private final JsonNode node;
  private final Set<String> asked = new HashSet<>();

  private Fields(Path file, String place, JsonNode node) {
    this.file = file;
    this.place = place;
    this.node = node;
  }

  static Fields of(Path file, JsonNode root) throws InputException {
    if (!root.isObject()) {
      throw new InputException(file + ": must be a JSON object");
    }
    return new Fields(file, "", root);
  }

  InputException wrong(String name, String what) {
    return new InputException(file + ", field " + place + name + ": " + what);
  }

  private InputException notA(String name, String wanted) {
    JsonNode value = node.get(name);
    return wrong(
        name, "must be " + wanted + ", but is " + (value == null ? "missing" : value.toString()));
  }

  private JsonNode get(String name) {
    asked.add(name);
    JsonNode value = node.get(name);
    return value == null || value.isNull() ? null : value;
  }

  boolean has(String name) {
    return get(name) != null;
  }

  Fields object(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isObject()) {
      throw notA(name, "an object");
    }
    return new Fields(file, place + name + ".", value);
  }

  List<Fields> objects(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isArray()) {
      throw notA(name, "a list");
    }
    List<Fields> list = new ArrayList<>();
    for (int i = 0; i < value.size(); i++) {
      if (!value.get(i).isObject()) {
        throw notA(name, "a list of objects");
      }
      list.add(new Fields(file, place + name + "[" + i + "].", value.get(i)));
    }
    return list;
  }

  double number(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isNumber() || !Double.isFinite(value.doubleValue())) {
      throw notA(name, "a number");
    }
    return value.doubleValue();
  }

  int whole(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isIntegralNumber() || !value.canConvertToInt()) {
      throw notA(name, "a whole number");
    }
    return value.intValue();
  }

  boolean flag(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isBoolean()) {
      throw notA(name, "true or false");
    }
    return value.booleanValue();
  }

  String text(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isTextual()) {
      throw notA(name, "a text");
    }
    return value.textValue();
  }

  List<String> texts(String name) throws InputException {
    JsonNode value = get(name);
    List<String> list = new ArrayList<>();
    if (value == null || !value.isArray()) {
      throw notA(name, "a list");
    }
    for (JsonNode element : value) {
      if (!element.isTextual()) {
        throw notA(name, "a list of texts");
      }
      list.add(element.textValue());
    }
    return list;
  }

  double[] numbers(String name) throws InputException {
    JsonNode value = get(name);
    if (value == null || !value.isArray()) {
      throw notA(name, "a list of numbers");
    }
    double[] list = new double[value.size()];
    for (int i = 0; i < list.length; i++) {
      if (!value.get(i).isNumber()) {
        throw notA(name, "a list of numbers");
      }
      list[i] = value.get(i).doubleValue();
    }
    return list;
  }

  /** Names of all fields, in their order; what is asked for by name later is the caller's business. */
  List<String> names() {
    List<String> names = new ArrayList<>();
    for (Iterator<String> i = node.fieldNames(); i.hasNext(); ) {
      names.add(i.next());
    }
    return names;
  }

  /** A value as written, for parameters of causes, which their own type checks. */
  String written(String name) {
    JsonNode value = get(name);
    return value == null ? "" : value.isTextual() ? value.textValue() : value.toString();
  }

  void close() throws InputException {
    for (String name : names()) {
      if (!asked.contains(name)) {
        throw wrong(name, "unknown");
      }
    }
  }

  /** Somebody that makes a value and may refuse the numbers. */
  interface Maker<T> {
    T make() throws InputException;
  }

  /** Makes a value; what it refuses is an error of this object. */
  <T> T made(Maker<T> maker) throws InputException {
    try {
      T value = maker.make();
      close();
      return value;
    } catch (IllegalArgumentException e) {
      String at = place.isEmpty() ? "" : ", field " + place.substring(0, place.length() - 1);
      throw new InputException(file + at + ": " + e.getMessage());
    }
  }
}
