package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.camera.Camera;
import fieldcal.effect.Arena;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedCurve.Point;
import fieldcal.effect.learned.LearnedFamily;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.SimpleFormula;
import fieldcal.effect.learned.Spline;
import fieldcal.effect.learned.Variable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class LearnedWordsTest {
  private static final double NONE = Double.NaN;
  private static final ObservedCamera CAMERA =
      new ObservedCamera(
          2, 4, Optional.of(Camera.ofPosition(2, 3, 2, 5)), NONE, NONE, NONE, NONE, 0);

  static List<LearnedTerm> terms() {
    return LearnedLibrary.of(
        new Arena(-6, 6, -4, 4, new double[] {0, 900}, true, true, List.of(CAMERA), List.of()));
  }

  @ParameterizedTest
  @MethodSource("terms")
  void everyFormOfEveryTermHasWords(LearnedTerm term) {
    assertThat(EffectName.of(term)).isEqualTo(LearnedWords.name(term)).doesNotContain("_");
    for (int component = 0; component < term.family().quantity().components(); component++) {
      List<Point> points = List.of(new Point(1, 0, -0.1, 0.01), new Point(2, 1, 0.2, 0.01));
      LearnedCurve curve = new LearnedCurve(term.family(), component, points);
      for (SimpleFormula.Kind kind : SimpleFormula.Kind.values()) {
        for (double amount : new double[] {-0.1, 0.1}) {
          SimpleFormula formula = new SimpleFormula(kind, amount, 0.01, 1.5, 0, 1, "text");
          String sentence = LearnedWords.sentence(curve, formula).orElseThrow();
          assertThat(sentence).endsWith(".").doesNotContain("NaN", "null", "%s", "_", "<", "  ");
          assertThat(Character.isUpperCase(sentence.charAt(0))).isTrue();
        }
      }
      CauseText text = LearnedWords.of(term, List.of(curve), true, true);
      assertThat(text.sentences()).endsWith(".").doesNotContain("_");
      assertThat(text.strength()).doesNotContain("_");
      CauseText doubted = LearnedWords.of(term, List.of(curve), true, false);
      assertThat(doubted.advice()).doesNotContain("extended model").matches("|.+\\.");
    }
  }

  private static String sentence(LearnedFamily family, int component, DoubleUnaryOperator law) {
    List<Point> points = new ArrayList<>();
    for (double x = 0.5; x <= 6; x += 0.25) {
      points.add(new Point(x, 0, law.applyAsDouble(x), 0.004));
    }
    LearnedCurve curve = new LearnedCurve(family, component, points);
    return LearnedWords.sentence(curve, SimpleFormula.of(curve)).orElseThrow();
  }

  @Test
  void saysWhatHappens() {
    Spline basis = new Spline(0, 6, 6, true);
    Quantity along = Quantity.ACCELERATION_ALONG;
    assertThat(sentence(LearnedFamily.of(along, Variable.SLIP, basis), 0, s -> s < 4 ? 0 : 0.3))
        .isEqualTo(
            "From 3.9 m/s on, the sliding ball is braked less than the model says: by 0.30 m/s².");
    LearnedFamily speed = LearnedFamily.of(along, Variable.SPEED, basis);
    assertThat(sentence(speed, 0, v -> -0.05 * Math.max(0, v - 2)))
        .isEqualTo(
            "From 2.0 m/s on, the ball is braked more than the model says: by 0.050 m/s² for each"
                + " further m/s.");
    assertThat(sentence(speed, 0, v -> 0.1 * v))
        .isEqualTo(
            "The ball is braked less than the model says: by 0.10 m/s² for each m/s of the speed.");
    LearnedFamily friction = LearnedFamily.of(Quantity.FRICTION, Variable.SESSION_TIME, basis);
    assertThat(sentence(friction, 0, t -> t < 3 ? 0 : 0.08))
        .isEqualTo("From minute 0.0 on, the carpet brakes the ball more: by 8.0 %.");
    LearnedFamily rolling = LearnedFamily.of(Quantity.ROLLING, Variable.SESSION_TIME, basis);
    assertThat(sentence(rolling, 0, t -> t < 3 ? 0 : -0.08))
        .isEqualTo("From minute 0.0 on, the rolling ball is braked less: by 8.0 %.");
    LearnedFamily bounce =
        LearnedFamily.of(Quantity.VERTICAL_RESTITUTION, Variable.GROUND_SPEED, basis);
    assertThat(sentence(bounce, 0, v -> v < 3 ? 0 : -0.1))
        .isEqualTo("From 2.9 m/s on, the ball bounces lower: by 10 % of the speed of its fall.");
    LearnedFamily shift = LearnedFamily.of(Quantity.SHIFT, Variable.SESSION_TIME, basis, 2);
    assertThat(sentence(shift, 1, t -> t < 3 ? 0 : -8))
        .isEqualTo(
            "From minute 0.0 on, the reports of camera 2 are too far to the right"
                + " (−y): by 8.0 mm.");
  }

  private static LearnedTerm term(Quantity quantity, Variable variable) {
    return terms().stream()
        .filter(t -> t.family().quantity() == quantity)
        .filter(t -> t.family().variables().get(0) == variable)
        .findFirst()
        .orElseThrow();
  }

  /** Of a real recording: the largest value is that of the fastest kick alone, with a sign that all others contradict. */
  @Test
  void theUncertainEndOfACurveIsNotTold() {
    LearnedTerm pull = term(Quantity.ACCELERATION_ACROSS, Variable.SPEED);
    List<Point> points =
        List.of(
            new Point(0.5, 0, 0.010, 0.012),
            new Point(2, 0, -0.020, 0.008),
            new Point(3, 0, -0.055, 0.006),
            new Point(4, 0, -0.030, 0.006),
            new Point(5, 0, 0.040, 0.012),
            new Point(5.5, 0, 0.060, 0.029),
            new Point(6.3, 0, 0.230, 0.125));
    LearnedCurve curve = new LearnedCurve(pull.family(), 0, points);
    SimpleFormula none = formula(SimpleFormula.Kind.CURVE, curve);
    assertThat(LearnedWords.sentence(curve, none))
        .hasValue(
            "The error of the model depends on the speed: at 3.0 m/s the ball is pulled to its"
                + " right by 0.055 m/s², and at 5.0 m/s the ball is pulled to its left by 0.040"
                + " m/s².");
    LearnedCurve slow = new LearnedCurve(pull.family(), 0, points.subList(0, 4));
    assertThat(LearnedWords.sentence(slow, none))
        .hasValue(
            "The error of the model depends on the speed: at 3.0 m/s the ball is pulled to its"
                + " right by 0.055 m/s².");
    assertThat(none.text())
        .isEqualTo(
            "acceleration to the ball's left varies between −0.055 and 0.040 m/s² with the speed");
  }

  private static SimpleFormula formula(SimpleFormula.Kind kind, LearnedCurve curve) {
    SimpleFormula best = SimpleFormula.of(curve);
    assertThat(best.kind()).isEqualTo(kind);
    return best;
  }

  /** Values may be uncertain one by one, as their errors go together, and the whole curve be needed. */
  @Test
  void aCurveThatHelpsIsNotSaidToChangeNothing() {
    LearnedTerm braking = term(Quantity.ACCELERATION_ALONG, Variable.SPEED);
    List<Point> points = new ArrayList<>();
    for (double v = 0; v <= 6; v += 0.2) {
      points.add(new Point(v, 0, 0.05 * Math.sin(v), 0.08));
    }
    LearnedCurve curve = new LearnedCurve(braking.family(), 0, points);
    String strength = formula(SimpleFormula.Kind.NONE, curve).text();
    assertThat(strength).isEqualTo("deceleration: its errors are too large for a formula");
    assertThat(LearnedWords.of(braking, List.of(curve), true, true).what())
        .isEqualTo(
            "Braking that depends on the speed: held-out kicks show that the effect exists, but not"
                + " its shape; every value of the curve is within two standard errors of zero.");
  }

  /** Its shape may be that of anything else that is left. */
  @Test
  void ofACurveThatIsNotShownToHelpOnlyTheNameIsTold() {
    LearnedTerm pull = term(Quantity.ACCELERATION_ACROSS, Variable.SPEED);
    List<Point> points = List.of(new Point(1, 0, -0.1, 0.01), new Point(6, 0, 0.2, 0.01));
    LearnedCurve curve = new LearnedCurve(pull.family(), 0, points);
    assertThat(LearnedWords.of(pull, List.of(curve), true, true).what()).contains("m/s²");
    assertThat(LearnedWords.of(pull, List.of(curve), false, true).what())
        .isEqualTo("Sideways pull that depends on the speed.");
  }

  /** The best formula may be none although a value is beyond its error: then that value is told. */
  @Test
  void aValueBeyondItsErrorIsTold() {
    LearnedTerm braking = term(Quantity.ACCELERATION_ALONG, Variable.SPEED);
    List<Point> points = new ArrayList<>();
    for (double v = 0; v <= 6; v += 0.2) {
      points.add(new Point(v, 0, v == 0 ? -0.14 : 0.02 * Math.sin(v), v == 0 ? 0.06 : 0.08));
    }
    LearnedCurve curve = new LearnedCurve(braking.family(), 0, points);
    formula(SimpleFormula.Kind.NONE, curve);
    assertThat(LearnedWords.of(braking, List.of(curve), true, true).what())
        .isEqualTo(
            "The error of the model depends on the speed: at 0 m/s the ball is braked more than the"
                + " model says by 0.14 m/s².");
  }
}
