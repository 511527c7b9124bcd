package fieldcal.simulation;

import fieldcal.simulation.physics.Region;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/**
 * An effect with values for its parameters, as written in {@code --effect id:name=value,name=value}.
 *
 * @param effect which
 * @param values by parameter name, as written; checked
 */
public record EffectSetting(SimulatedEffect effect, Map<String, String> values) {
  private static final String ALL = "all";

  /**
   * Checks every value. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a name is unknown or a value is not of its kind or range
   */
  public EffectSetting {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
    for (Map.Entry<String, String> entry : values.entrySet()) {
      EffectParameter parameter =
          effect
              .parameter(entry.getKey())
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          effect.id()
                              + " has no parameter '"
                              + entry.getKey()
                              + "'; it has "
                              + effect.parameters().stream()
                                  .map(EffectParameter::name)
                                  .collect(Collectors.joining(", "))));
      check(effect, parameter, entry.getValue());
    }
  }

  /**
   * An effect with one parameter.
   *
   * @param effect which
   * @param name of the parameter
   * @param value its value
   * @return the setting
   * @throws IllegalArgumentException when name or value is wrong
   */
  public static EffectSetting of(SimulatedEffect effect, String name, double value) {
    return new EffectSetting(effect, Map.of(name, Double.toString(value)));
  }

  /**
   * This setting with one more parameter.
   *
   * @param name of the parameter
   * @param value as written
   * @return the changed setting
   * @throws IllegalArgumentException when name or value is wrong
   */
  public EffectSetting with(String name, Object value) {
    Map<String, String> more = new LinkedHashMap<>(values);
    more.put(name, String.valueOf(value));
    return new EffectSetting(effect, more);
  }

  /**
   * Reads a setting.
   *
   * @param text {@code id:name=value,name=value}; the first name may be left out
   * @return the setting
   * @throws IllegalArgumentException when the text cannot be read; the message says what is wrong and what is possible
   */
  public static EffectSetting parse(String text) {
    int colon = text.indexOf(':');
    String id = (colon < 0 ? text : text.substring(0, colon)).trim();
    SimulatedEffect effect = SimulatedEffect.of(id);
    Map<String, String> values = new LinkedHashMap<>();
    for (String part : colon < 0 ? List.<String>of() : split(text.substring(colon + 1))) {
      int equals = part.indexOf('=');
      String name =
          equals < 0 ? effect.parameters().get(0).name() : part.substring(0, equals).trim();
      if (values.put(name, part.substring(equals + 1).trim()) != null) {
        throw new IllegalArgumentException(id + ": " + name + " is given twice");
      }
    }
    if (values.isEmpty()) {
      throw new IllegalArgumentException(
          id
              + " needs a value, for example "
              + id
              + ":"
              + effect.parameters().get(0).name()
              + "=…");
    }
    return new EffectSetting(effect, values);
  }

  /** Splits at commas outside of brackets. */
  private static List<String> split(String text) {
    List<String> parts = new ArrayList<>();
    int depth = 0;
    int start = 0;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      depth += c == '[' ? 1 : c == ']' ? -1 : 0;
      if (c == ',' && depth == 0) {
        parts.add(text.substring(start, i));
        start = i + 1;
      }
    }
    parts.add(text.substring(start));
    return parts;
  }

  private static void check(SimulatedEffect effect, EffectParameter parameter, String value) {
    String what = effect.id() + ": " + parameter.name();
    switch (parameter.kind()) {
      case NUMBER -> number(what, value, parameter.min(), parameter.max());
      case CAMERA, ROBOT -> {
        if (!value.equals(ALL)) {
          double number = number(what, value, parameter.min(), parameter.max());
          if (number != Math.rint(number)) {
            throw new IllegalArgumentException(what + " must be a whole number, but is " + value);
          }
        }
      }
      case TEAM -> {
        if (!value.equals(ALL) && !value.equals("yellow") && !value.equals("blue")) {
          throw new IllegalArgumentException(
              what + " must be yellow, blue or all, but is " + value);
        }
      }
      case REGION -> region(what, value);
    }
  }

  private static double number(String what, String text, double min, double max) {
    double value;
    try {
      value = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(what + " must be a number, but is '" + text + "'", e);
    }
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          what + " must lie in [" + min + ", " + max + "], but is " + text);
    }
    return value;
  }

  private static Region region(String what, String text) {
    String[] parts = text.replace("[", "").replace("]", "").split("[,/]", -1);
    if (parts.length != 4) {
      throw new IllegalArgumentException(
          what + " must be [x0,x1,y0,y1] in metres, but is '" + text + "'");
    }
    double[] bounds = new double[4];
    for (int i = 0; i < 4; i++) {
      bounds[i] = number(what, parts[i].trim(), -100, 100);
    }
    return new Region(bounds[0], bounds[1], bounds[2], bounds[3]);
  }

  /**
   * A number.
   *
   * @param name of the parameter
   * @return its value, 0 when not given
   */
  public double number(String name) {
    String value = values.get(name);
    return value == null ? 0 : Double.parseDouble(value);
  }

  /**
   * A number with another default.
   *
   * @param name of the parameter
   * @param otherwise when not given
   * @return its value
   */
  public double number(String name, double otherwise) {
    return values.containsKey(name) ? number(name) : otherwise;
  }

  /**
   * The rectangle.
   *
   * @return {@link Region#NONE} when not given
   */
  public Region region() {
    String value = values.get("region");
    return value == null ? Region.NONE : region(effect.id(), value);
  }

  /**
   * Whether a camera is meant.
   *
   * @param id the camera
   * @return true when the setting names it or all; if it names none, for camera 0 only, or for all cameras where {@link SimulatedEffect} says so
   */
  public boolean concernsCamera(int id) {
    String value = values.getOrDefault("camera", effect.allCamerasUnlessSaid() ? ALL : "0");
    return value.equals(ALL) || (int) Double.parseDouble(value) == id;
  }

  /**
   * Whether a team is meant.
   *
   * @param team the team
   * @return true when the setting names it, or all, or none
   */
  public boolean concernsTeam(Team team) {
    String value = values.getOrDefault("team", ALL);
    return value.equals(ALL) || value.equals(team.label());
  }

  /**
   * The robot that is meant.
   *
   * @return its number; empty for all
   */
  public OptionalInt robot() {
    String value = values.getOrDefault("robot", ALL);
    return value.equals(ALL)
        ? OptionalInt.empty()
        : OptionalInt.of((int) Double.parseDouble(value));
  }

  /**
   * As written on the command line.
   *
   * @return {@code id:name=value,name=value}
   */
  @Override
  public String toString() {
    return effect.id()
        + values.entrySet().stream()
            .map(e -> e.getKey() + "=" + e.getValue())
            .collect(Collectors.joining(",", ":", ""));
  }
}
