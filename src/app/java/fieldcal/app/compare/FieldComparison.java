package fieldcal.app.compare;

import fieldcal.app.statistics.Comparison;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A field beside a simulator.
 *
 * @param verdict one sentence
 * @param differences of the ball that chance does not explain, the costliest first
 * @param parameters of the ball
 * @param cameras noise, rates, losses and delays of each camera that both have
 * @param others offsets of cameras, kickers, limits of robots
 * @param passReal how far a pass at 5 m/s rolls on the field, m; NaN when not known
 * @param passSim the same in the simulator, m
 * @param predictionError of an AI with the simulator's ball on the field's kicks, m, by seconds ahead
 */
public record FieldComparison(
    String verdict,
    List<Named> differences,
    List<Row> parameters,
    List<Comparison> cameras,
    List<Row> others,
    double passReal,
    double passSim,
    Map<Double, Double> predictionError) {

  /** Speed of the pass that both fields are compared with, m/s. */
  public static final double PASS_SPEED = Cost.PASS;

  /** Largest probability at which the tests name any difference between two recordings of one field, all tables together. A learned term is not tested again; the false alarms of both diagnoses come on top. */
  public static final double ALPHA = 0.01;

  /** Copies the collections. {@inheritDoc} */
  public FieldComparison {
    differences = List.copyOf(differences);
    parameters = List.copyOf(parameters);
    cameras = List.copyOf(cameras);
    others = List.copyOf(others);
    predictionError = new TreeMap<>(predictionError);
  }

  /**
   * A difference of the ball.
   *
   * @param id a parameter's name or an effect's id
   * @param words what it is
   * @param unit of the values
   * @param real the field's value; NaN when the field does not have it
   * @param realError its standard error; NaN when not known
   * @param sim the simulator's value; NaN when the simulator does not have it
   * @param simError its standard error; NaN when not known
   * @param shareOfError of the prediction error 1 s ahead that vanishes without it, 0 … 1; negative when it makes up for another
   * @param shareOfPass of the pass's difference that vanishes without it
   */
  public record Named(
      String id,
      String words,
      String unit,
      double real,
      double realError,
      double sim,
      double simError,
      double shareOfError,
      double shareOfPass) {}
}
