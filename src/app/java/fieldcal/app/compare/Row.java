package fieldcal.app.compare;

/**
 * One number of the field beside that of the simulator.
 *
 * @param id for files
 * @param words what it is
 * @param unit its unit; empty when it has none
 * @param real the field's; NaN when not known
 * @param realError its standard error; NaN when not known
 * @param sim the simulator's; NaN when not known
 * @param simError its standard error; NaN when not known
 * @param differs whether they differ by more than chance makes likely, all rows of its table considered
 */
public record Row(
    String id,
    String words,
    String unit,
    double real,
    double realError,
    double sim,
    double simError,
    boolean differs) {

  /** The same with another judgement. */
  Row judged(boolean different) {
    return new Row(id, words, unit, real, realError, sim, simError, different);
  }
}
