package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.vision.Epoch;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * {@code extended_model.json} as maps and lists, the form in which every JSON library hands out a document. So the library reads and writes an {@link
 * ExtendedModel} without depending on one: only the step between bytes and maps is the caller's.
 *
 * <p>Fields: {@code schema}; {@code flat} and {@code chip} with the names of the league's messages, null when unknown, {@code chip} with {@code lowest_hop_mm} where that is not the league's 10 mm; {@code effects}, each with {@code effect} (its id) and
 * {@code parameters} (see {@link EffectFields}); {@code session_start_unix}, s. What else is written ({@code needs}, {@code sentence}, and by {@code diagnose} the {@code sources} and {@code recordings} that the model was found in) is not read.
 */
public final class ExtendedModelDocument {
  /** Name and version of the form. */
  public static final String SCHEMA = "fieldcal.extended_model/1";

  private static final Epoch UNIX = new Epoch(0);
  private static final String LOWEST_HOP = "lowest_hop_mm";
  private static final double MM = 1000;

  private ExtendedModelDocument() {}

  /**
   * Writes.
   *
   * @param model what to write
   * @param epoch of the clock of {@link ExtendedModel#sessionStart}
   * @return the document; values are strings, numbers, null, lists and maps
   */
  public static Map<String, Object> of(ExtendedModel model, Epoch epoch) {
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("schema", SCHEMA);
    document.put("flat", model.flat().map(m -> simple(m.parameters())).orElse(null));
    document.put("chip", model.chip().map(ExtendedModelDocument::chip).orElse(null));
    List<Map<String, Object>> effects = new ArrayList<>();
    for (Effect e : model.effects()) {
      Map<String, Object> one = new LinkedHashMap<>();
      one.put("effect", e.id());
      one.put("parameters", EffectFields.of(e));
      one.put("sentence", e.sentence());
      effects.add(one);
    }
    document.put("effects", effects);
    document.put("session_start_unix", epoch.unixSeconds(model.sessionStart()));
    document.put("needs", needs(model));
    return document;
  }

  private static Map<String, Object> chip(ChipModel model) {
    Map<String, Object> fields = simple(model.parameters());
    if (model.lowestHop() != ChipModel.MIN_HOP_HEIGHT) {
      fields.put(LOWEST_HOP, MM * model.lowestHop());
    }
    return fields;
  }

  private static Map<String, Object> simple(List<Parameter> parameters) {
    Map<String, Object> fields = new LinkedHashMap<>();
    parameters.forEach(p -> fields.put(inFiles(p), p.value()));
    return fields;
  }

  private static String inFiles(Parameter p) {
    return p.name().replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT);
  }

  /** What the AI must know to use each effect: times, cameras, commands. */
  private static List<String> needs(ExtendedModel model) {
    Map<String, Set<String>> needs = new LinkedHashMap<>();
    for (Effect e : model.effects()) {
      if (e instanceof KickerEffect) {
        need(needs, e, "what each robot is commanded when it kicks");
      } else if (e instanceof MeasurementEffect m) {
        need(needs, e, "which camera made a detection, and its time stamp");
        if (!m.isApplicable(ObservedCamera.unknown(0, 1))) {
          need(needs, e, "the published geometry of the cameras");
        }
      } else {
        need(needs, e, "place and velocity right after the kick in vision's field frame");
      }
      if (e.changesWithTime()) {
        need(needs, e, "the time since session_start_unix");
      }
    }
    List<String> lines = new ArrayList<>();
    needs.forEach((what, ids) -> lines.add(what + " (" + String.join(", ", ids) + ")"));
    return lines;
  }

  private static void need(Map<String, Set<String>> needs, Effect e, String what) {
    needs.computeIfAbsent(what, w -> new LinkedHashSet<>()).add(e.id());
  }

  /**
   * Reads for a clock that shows Unix time.
   *
   * @param document the whole document
   * @return the model
   * @throws IllegalArgumentException when a field is missing, of the wrong type or out of its range; the message begins with the field
   */
  public static ExtendedModel read(Map<?, ?> document) {
    return read(document, UNIX);
  }

  /**
   * Reads.
   *
   * @param document the whole document
   * @param epoch of the clock in which the times of kicks will be given
   * @return the model
   * @throws IllegalArgumentException when a field is missing, of the wrong type or out of its range; the message begins with the field
   */
  public static ExtendedModel read(Map<?, ?> document, Epoch epoch) {
    if (!SCHEMA.equals(document.get("schema"))) {
      throw new IllegalArgumentException(
          "schema: must be \"" + SCHEMA + "\", but is " + document.get("schema"));
    }
    FlatModel aFlat = FlatModel.typical();
    ChipModel aChip = lowest(document.get("chip"));
    Optional<FlatModel> flat = simple(document, "flat", aFlat.parameters(), aFlat::withParameters);
    Optional<ChipModel> chip = simple(document, "chip", aChip.parameters(), aChip::withParameters);
    if (flat.isEmpty() && chip.isEmpty()) {
      throw new IllegalArgumentException("flat: must be there, or chip, but both are missing");
    }
    if (!(document.get("effects") instanceof List<?> list)) {
      throw new IllegalArgumentException("effects: must be a list");
    }
    List<Effect> effects = new ArrayList<>();
    for (Object entry : list) {
      effects.add(effect("effects[" + effects.size() + "]", entry));
    }
    double start = EffectFields.number("session_start_unix", document.get("session_start_unix"));
    return new ExtendedModel(flat, chip, effects, epoch.seconds(start));
  }

  /** A model of chips with the lowest hop of a document, if that has one. */
  private static ChipModel lowest(Object chip) {
    ChipModel typical = ChipModel.typical();
    if (!(chip instanceof Map<?, ?> fields) || !fields.containsKey(LOWEST_HOP)) {
      return typical;
    }
    double height = EffectFields.number("chip." + LOWEST_HOP, fields.get(LOWEST_HOP)) / MM;
    try {
      return typical.withLowestHop(height);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("chip." + LOWEST_HOP + ": must be positive", e);
    }
  }

  /** Empty when the whole model is missing or null. */
  private static <M> Optional<M> simple(
      Map<?, ?> document, String kind, List<Parameter> parameters, Function<double[], M> maker) {
    Object found = document.get(kind);
    if (found == null) {
      return Optional.empty();
    }
    if (!(found instanceof Map<?, ?> fields)) {
      throw new IllegalArgumentException(kind + ": must be an object or null");
    }
    Set<Object> unknown = new HashSet<>(fields.keySet());
    if (kind.equals("chip")) {
      unknown.remove(LOWEST_HOP);
    }
    double[] values = new double[parameters.size()];
    for (int i = 0; i < values.length; i++) {
      String name = inFiles(parameters.get(i));
      unknown.remove(name);
      values[i] = EffectFields.number(kind + "." + name, fields.get(name));
    }
    if (!unknown.isEmpty()) {
      throw new IllegalArgumentException(
          kind + "." + unknown.iterator().next() + ": is not a known field");
    }
    try {
      return Optional.of(maker.apply(values));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(kind + ": " + e.getMessage(), e);
    }
  }

  private static Effect effect(String place, Object entry) {
    if (!(entry instanceof Map<?, ?> fields)) {
      throw new IllegalArgumentException(place + ": must be an object");
    }
    if (!(fields.get("effect") instanceof String id) || !EffectFields.isKnown(id)) {
      throw new IllegalArgumentException(
          place + ".effect: there is no effect '" + fields.get("effect") + "'");
    }
    if (!(fields.get("parameters") instanceof Map<?, ?> parameters)) {
      throw new IllegalArgumentException(place + ".parameters: must be an object (" + id + ")");
    }
    try {
      return EffectFields.read(id, parameters);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          place + ".parameters." + e.getMessage() + " (" + id + ")", e);
    }
  }
}
