package fieldcal.app.twin;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.simulation.KickBehaviour.SpinTable;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.TabulatedError;
import fieldcal.simulation.physics.Table;
import fieldcal.simulation.physics.TabulatedLaw;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The list {@code learned} of {@code twin.json}: what changes ({@code quantity}), on what it depends ({@code depends_on}), the camera of a measurement, and the table: {@code x}, {@code y} of a
 * surface, {@code values} row by row (of a shift those of x first), {@code period} of a repeating curve.
 *
 * @param laws of the ball
 * @param spins of the kickers
 * @param errors of the cameras, by id
 */
record LearnedDocument(
    List<TabulatedLaw> laws, List<SpinTable> spins, Map<Integer, CameraErrors> errorsById) {
  private static final String SPIN = "spin";

  CameraErrors errors(int camera) {
    return errorsById.getOrDefault(camera, CameraErrors.NONE);
  }

  static void add(TabulatedLaw law, ArrayNode list) {
    write(law.changes().label(), law.dependsOn().label(), List.of(law.table()), list.addObject());
  }

  static void add(SpinTable spin, ArrayNode list) {
    write(SPIN, spin.byHeading() ? "heading" : "speed", List.of(spin.table()), list.addObject());
  }

  static void add(TabulatedError error, int camera, ArrayNode list) {
    ObjectNode node = list.addObject();
    write(error.changes().label(), error.dependsOn().label(), error.tables(), node);
    node.put("camera", camera);
  }

  private static void write(
      String quantity, String dependsOn, List<Table> tables, ObjectNode node) {
    node.put("quantity", quantity);
    node.put("depends_on", dependsOn);
    Table first = tables.get(0);
    node.put("period", first.period());
    add(first.x(), node.putArray("x"));
    if (first.isSurface()) {
      add(first.y(), node.putArray("y"));
    }
    ArrayNode values = node.putArray("values");
    tables.forEach(t -> add(t.values(), values));
  }

  private static void add(double[] numbers, ArrayNode array) {
    for (double number : numbers) {
      array.add(number);
    }
  }

  static LearnedDocument read(List<Fields> list) throws InputException {
    List<TabulatedLaw> laws = new ArrayList<>();
    List<SpinTable> spins = new ArrayList<>();
    Map<Integer, CameraErrors> errors = new LinkedHashMap<>();
    for (Fields f : list) {
      f.made(
          () -> {
            String quantity = f.text("quantity");
            String dependsOn = f.text("depends_on");
            if (f.has("camera")) {
              TabulatedError error = error(f, quantity, dependsOn);
              errors.merge(
                  f.whole("camera"), CameraErrors.NONE.withTable(error), CameraErrors::plus);
            } else if (quantity.equals(SPIN)) {
              if (!dependsOn.equals("heading") && !dependsOn.equals("speed")) {
                throw f.wrong("depends_on", "must be speed or heading, but is " + dependsOn);
              }
              spins.add(new SpinTable(dependsOn.equals("heading"), tables(f, 1).get(0)));
            } else {
              laws.add(
                  new TabulatedLaw(
                      constant(f, "quantity", quantity, TabulatedLaw.Quantity.class),
                      constant(f, "depends_on", dependsOn, TabulatedLaw.Variable.class),
                      tables(f, 1).get(0)));
            }
            return f;
          });
    }
    return new LearnedDocument(laws, spins, errors);
  }

  private static TabulatedError error(Fields f, String quantity, String dependsOn)
      throws InputException {
    TabulatedError.Quantity what = constant(f, "quantity", quantity, TabulatedError.Quantity.class);
    return new TabulatedError(
        what,
        constant(f, "depends_on", dependsOn, TabulatedError.Variable.class),
        tables(f, what.components()));
  }

  private static <E extends Enum<E>> E constant(Fields f, String name, String label, Class<E> type)
      throws InputException {
    for (E value : type.getEnumConstants()) {
      if (value.name().toLowerCase(Locale.ROOT).equals(label)) {
        return value;
      }
    }
    throw f.wrong(name, "unknown: " + label);
  }

  private static List<Table> tables(Fields f, int count) throws InputException {
    double[] x = f.numbers("x");
    double[] y = f.has("y") ? f.numbers("y") : null;
    double[] values = f.numbers("values");
    double period = f.number("period");
    int each = values.length / count;
    List<Table> tables = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double[] own = java.util.Arrays.copyOfRange(values, i * each, (i + 1) * each);
      tables.add(y == null ? Table.curve(x, own, period) : Table.surface(x, y, own));
    }
    return tables;
  }
}
