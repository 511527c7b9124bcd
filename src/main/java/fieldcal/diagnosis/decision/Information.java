package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.fit.joint.ScoreSystem;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.SingularValueDecomposition;

/**
 * What the equations of a fitted model determine of its components when all other parameters are fitted again: the efficient information (van der Vaart, Asymptotic Statistics, 1998, section 25.4), in units of chi-square. Immutable.
 */
final class Information {
  private final EffectModel model;
  private final double[] values;
  private final double[][] all;

  private Information(FittedModel fitted) {
    model = fitted.model();
    values = fitted.solution().values();
    double[] weights = Weighing.ALIKE.of(fitted);
    ScoreSystem equations = fitted.solution().scores(List.of(), weights);
    int n = equations.size();
    all = new double[n][n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        all[i][j] = equations.curvature(i, j);
      }
    }
    for (int g = 0; g < model.globals().size(); g++) {
      if (model.globals().get(g).estimated()) {
        int i = model.freeIndex(g);
        all[i][i] += model.priors().get(g).precision();
      }
    }
  }

  static Information of(FittedModel fitted) {
    return new Information(fitted);
  }

  /** The share of a component's effect that other components have in common with it; negative where they act against it. */
  double shared(int component, int[] others) {
    int[] kept =
        IntStream.concat(
                Arrays.stream(columns(component)),
                Arrays.stream(others).flatMap(o -> Arrays.stream(columns(o))))
            .toArray();
    double[] change = whole(component, kept);
    double own = product(change, part(component));
    double both = 0;
    for (int o : others) {
      both += product(change, part(o));
    }
    return own > 0 ? both / own : 0;
  }

  private int[] columns(int component) {
    int from = model.offset(component);
    int size = model.components().get(component).magnitudeCount();
    return IntStream.range(from, from + size).map(model::freeIndex).toArray();
  }

  /** The component's numbers in their columns. */
  private double[] part(int component) {
    double[] part = new double[all.length];
    int from = model.offset(component);
    int[] columns = columns(component);
    for (int i = 0; i < columns.length; i++) {
      part[columns[i]] = values[from + i];
    }
    return part;
  }

  /** The same, with all parameters that are not kept fitted again when the component is added. */
  private double[] whole(int component, int[] kept) {
    double[] change = part(component);
    boolean[] held = new boolean[change.length];
    for (int i : kept) {
      held[i] = true;
    }
    int[] rest = IntStream.range(0, change.length).filter(i -> !held[i]).toArray();
    double[] pull = new double[rest.length];
    double[][] matrix = new double[rest.length][rest.length];
    for (int i = 0; i < rest.length; i++) {
      double scale = Math.sqrt(all[rest[i]][rest[i]]);
      for (int j = 0; j < change.length; j++) {
        pull[i] += all[rest[i]][j] * change[j];
      }
      pull[i] = scale > 0 ? pull[i] / scale : 0;
      for (int j = 0; j < rest.length; j++) {
        double both = scale * Math.sqrt(all[rest[j]][rest[j]]);
        matrix[i][j] = both > 0 ? all[rest[i]][rest[j]] / both : 0;
      }
    }
    if (rest.length > 0) {
      double[] follow =
          new SingularValueDecomposition(new Array2DRowRealMatrix(matrix, false))
              .getSolver()
              .solve(new ArrayRealVector(pull, false))
              .toArray();
      for (int i = 0; i < rest.length; i++) {
        double scale = Math.sqrt(all[rest[i]][rest[i]]);
        change[rest[i]] = scale > 0 ? -follow[i] / scale : 0;
      }
    }
    return change;
  }

  private double product(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      for (int j = 0; a[i] != 0 && j < b.length; j++) {
        sum += a[i] * all[i][j] * b[j];
      }
    }
    return sum;
  }
}
