package fieldcal.simulation.imaging;

import fieldcal.simulation.physics.Table;
import java.util.List;
import java.util.Locale;
import java.util.Objects;

/**
 * An error of one camera that was measured and has no formula.
 *
 * @param changes what is wrong
 * @param dependsOn on what the error depends
 * @param tables of a shift along x and along y, mm; of time stamps one, ms, positive = late
 */
public record TabulatedError(Quantity changes, Variable dependsOn, List<Table> tables) {
  private static final double MILLI = 1e-3;

  /** What a table may describe of a camera. */
  public enum Quantity {
    /** Everything it reports is shifted, mm. */
    SHIFT(2),
    /** Its time stamps are late, ms. */
    TIME_ERROR(1);

    private final int components;

    Quantity(int components) {
      this.components = components;
    }

    /**
     * Its name in files.
     *
     * @return lower case with underscores
     */
    public String label() {
      return name().toLowerCase(Locale.ROOT);
    }

    /**
     * How many tables it takes.
     *
     * @return 2 of a shift, else 1
     */
    public int components() {
      return components;
    }
  }

  /** On what a table may depend. */
  public enum Variable {
    /** Session time, s. */
    SESSION_TIME,
    /** Reported place relative to the point below the camera, x and y, m. */
    IMAGE_POSITION;

    /**
     * Its name in files.
     *
     * @return lower case with underscores
     */
    public String label() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * Copies the list. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there are more or fewer tables than the quantity takes, or a table has more dimensions than the variable
   */
  public TabulatedError {
    Objects.requireNonNull(changes, "changes");
    Objects.requireNonNull(dependsOn, "dependsOn");
    tables = List.copyOf(tables);
    if (tables.size() != changes.components()) {
      throw new IllegalArgumentException(
          changes.label() + " takes " + changes.components() + " tables, not " + tables.size());
    }
    if (dependsOn == Variable.SESSION_TIME && tables.stream().anyMatch(Table::isSurface)) {
      throw new IllegalArgumentException("session_time is one number, but the table needs two");
    }
    if (changes == Quantity.TIME_ERROR && dependsOn != Variable.SESSION_TIME) {
      throw new IllegalArgumentException("time_error may depend on session_time only");
    }
  }

  void addShift(double time, double dx, double dy, double[] shift) {
    if (changes == Quantity.SHIFT) {
      boolean placed = dependsOn == Variable.IMAGE_POSITION;
      for (int i = 0; i < 2; i++) {
        shift[i] += MILLI * tables.get(i).at(placed ? dx : time, placed ? dy : 0);
      }
    }
  }

  double stampError(double time) {
    return changes == Quantity.TIME_ERROR ? MILLI * tables.get(0).at(time, 0) : 0;
  }
}
