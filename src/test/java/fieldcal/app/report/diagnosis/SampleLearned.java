package fieldcal.app.report.diagnosis;

import fieldcal.camera.Camera;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.effect.Arena;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedCurve.Support;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Variable;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.RollScatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Things without a name: a law of the bounce, a curve, a table over the field, the reports of a camera over its image, and what differs from kick to kick by chance. */
public final class SampleLearned {
  private static final double NONE = Double.NaN;
  private static final double ERROR = 0.01;

  private SampleLearned() {}

  /** All of them. */
  public static List<LearnedFinding> findings() {
    return List.of(
        new LearnedFinding(
            new ContactImpacts(-0.2, 0.3, 0.05, 0.02, 10),
            "impact",
            List.of("spin"),
            OptionalInt.empty(),
            List.of(),
            Double.NaN,
            Optional.empty(),
            new Gain(3.2, 20, 2.1, 4.0)),
        learned(Quantity.ACCELERATION_ALONG, Variable.SPEED, Support.of(0, 6)),
        learned(Quantity.VERTICAL_RESTITUTION, Variable.PLACE, new Support(-6, 6, -4.5, 4.5)),
        learned(Quantity.SHIFT, Variable.IMAGE_POSITION, new Support(-3, 3, -3, 3)),
        new LearnedFinding(
            new RollScatter(0),
            "ground",
            List.of("kick"),
            OptionalInt.empty(),
            List.of(),
            0.1,
            Optional.empty(),
            new Gain(5, 40, 4, 6)));
  }

  /** A term of the library with numbers that grow, and its curves. */
  private static LearnedFinding learned(Quantity quantity, Variable variable, Support support) {
    ObservedCamera camera =
        new ObservedCamera(
            1, 2, Optional.of(Camera.ofPosition(1, 3, 0, 5)), NONE, NONE, NONE, NONE, 0);
    Arena arena =
        new Arena(-6, 6, -4.5, 4.5, new double[] {0, 900}, true, true, List.of(camera), List.of());
    LearnedTerm absent =
        LearnedLibrary.of(arena).stream()
            .filter(t -> t.family().quantity() == quantity)
            .filter(t -> t.family().variables().get(0) == variable)
            .findFirst()
            .orElseThrow();
    int size = absent.coefficients().length;
    double[] coefficients = new double[size];
    double[][] covariance = new double[size][size];
    for (int i = 0; i < size; i++) {
      coefficients[i] = quantity.scale() * (i - 0.4 * size) / size;
      covariance[i][i] = Math.pow(ERROR * quantity.scale() * (1 + i), 2);
    }
    LearnedTerm term = absent.withParameters(coefficients);
    List<LearnedCurve> curves = new ArrayList<>();
    for (int c = 0; c < quantity.components(); c++) {
      curves.add(LearnedCurve.of(term, c, covariance, support));
    }
    return new LearnedFinding(
        term,
        term.actsOn(),
        term.dependsOn(),
        term.camera(),
        curves,
        Double.NaN,
        Optional.empty(),
        new Gain(1.4, 12, 0.8, 1.9));
  }
}
