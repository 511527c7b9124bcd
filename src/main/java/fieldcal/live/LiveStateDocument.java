package fieldcal.live;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * {@link BallSamples} as maps and lists, the form in which every JSON library hands out a document. So the library reads and writes its state without depending on one: only the step between bytes and maps
 * is the caller's.
 *
 * <p>Fields: {@code schema}; {@code samples} by the parameter's name ({@code acc_roll} …), each a list of objects with {@code t} (Unix time of the kick, s), {@code value} (SI), {@code
 * standard_error}, {@code possibly_spinning} (may be missing, then false) and {@code speed} (m/s, may be missing).
 */
public final class LiveStateDocument {
  /** Name and version of the document's format. */
  public static final String SCHEMA = "fieldcal.live_state/1";

  /** A document with more samples was not written by this class. */
  private static final int MOST_SAMPLES = 10_000;

  private LiveStateDocument() {}

  /**
   * Writes.
   *
   * @param state what to write
   * @return the document; values are strings, numbers, lists and maps
   */
  public static Map<String, Object> of(BallSamples state) {
    Map<String, Object> byParameter = new LinkedHashMap<>();
    for (BallParameter parameter : BallParameter.values()) {
      List<Map<String, Object>> list = new ArrayList<>();
      for (BallSample sample : state.of(parameter)) {
        Map<String, Object> one = new LinkedHashMap<>();
        one.put("t", sample.time());
        one.put("value", sample.value());
        one.put("standard_error", sample.standardError());
        one.put("possibly_spinning", sample.possiblySpinning());
        if (!Double.isNaN(sample.speed())) {
          one.put("speed", sample.speed());
        }
        list.add(one);
      }
      byParameter.put(parameter.id(), list);
    }
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("schema", SCHEMA);
    document.put("samples", byParameter);
    return document;
  }

  /**
   * Reads.
   *
   * @param document the whole document
   * @return the state
   * @throws IllegalArgumentException when a field is missing, of the wrong type or out of its range; the message begins with the field
   */
  public static BallSamples read(Map<?, ?> document) {
    if (!SCHEMA.equals(document.get("schema"))) {
      throw new IllegalArgumentException(
          "schema: must be \"" + SCHEMA + "\", but is " + document.get("schema"));
    }
    if (!(document.get("samples") instanceof Map<?, ?> byParameter)) {
      throw new IllegalArgumentException("samples: must be an object");
    }
    Map<BallParameter, List<BallSample>> all = new EnumMap<>(BallParameter.class);
    for (Map.Entry<?, ?> entry : byParameter.entrySet()) {
      String place = "samples." + entry.getKey();
      BallParameter parameter =
          BallParameter.ofId(String.valueOf(entry.getKey()))
              .orElseThrow(() -> new IllegalArgumentException(place + ": is not a parameter"));
      if (!(entry.getValue() instanceof List<?> list)) {
        throw new IllegalArgumentException(place + ": must be a list");
      }
      if (list.size() > MOST_SAMPLES) {
        throw new IllegalArgumentException(place + ": has more than " + MOST_SAMPLES + " entries");
      }
      List<BallSample> samples = new ArrayList<>();
      for (Object one : list) {
        samples.add(sample(place + "[" + samples.size() + "]", one));
      }
      all.put(parameter, samples);
    }
    return new BallSamples(all);
  }

  private static BallSample sample(String place, Object entry) {
    if (!(entry instanceof Map<?, ?> fields)) {
      throw new IllegalArgumentException(place + ": must be an object");
    }
    try {
      return new BallSample(
          number(fields, "t"),
          number(fields, "value"),
          number(fields, "standard_error"),
          flag(fields, "possibly_spinning"),
          fields.get("speed") == null ? Double.NaN : number(fields, "speed"));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(place + ": " + e.getMessage(), e);
    }
  }

  private static double number(Map<?, ?> fields, String name) {
    if (fields.get(name) instanceof Number number) {
      return number.doubleValue();
    }
    throw new IllegalArgumentException(
        name + " must be a number, but is " + shortened(fields.get(name)));
  }

  private static boolean flag(Map<?, ?> fields, String name) {
    Object value = fields.get(name);
    if (value == null || value instanceof Boolean) {
      return Boolean.TRUE.equals(value);
    }
    throw new IllegalArgumentException(name + " must be true or false, but is " + shortened(value));
  }

  private static String shortened(Object value) {
    String text = String.valueOf(value);
    return text.length() > 40 ? text.substring(0, 40) + "…" : text;
  }
}
