package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.decision.Judgement;
import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.effect.learned.LearnedCurve;
import fieldcal.effect.learned.LearnedLibrary;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.effect.learned.Quantity;
import fieldcal.effect.learned.Variable;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** What a fitted curve is told over. */
class LearnedFindingsTest {
  private final FittedField field = FittedField.flats("air_drag:cd=0.45");

  private final Component braking = braking();
  private final FittedModel model =
      field
          .fitter()
          .fit(
              field.simple().model().with(List.of(braking)),
              field.simple(),
              Weighing.ALIKE,
              FittedField.SOLVER);

  private Component braking() {
    LearnedTerm absent =
        LearnedLibrary.of(field.arena()).stream()
            .filter(t -> t.family().quantity() == Quantity.ACCELERATION_ALONG)
            .filter(t -> t.family().variables().equals(List.of(Variable.SPEED)))
            .findFirst()
            .orElseThrow();
    return Component.of(absent, absent.magnitudes());
  }

  private LearnedFinding finding(double... gain) {
    Judgement judged =
        new Judgement(
            braking, model.effects().get(0), 0, 100, gain, Optional.empty(), Outcome.NAMED);
    return LearnedFindings.of(model, 0, judged, field.arena());
  }

  /** The fastest kick alone shows what the curve is at its speed; the mean of a curve that ended there would be as uncertain as that end. */
  @Test
  void aCurveEndsWhereThreeKicksShowIt() {
    double[] speeds =
        IntStream.range(0, model.kickCount())
            .mapToDouble(k -> Math.hypot(model.solution().own(k)[2], model.solution().own(k)[3]))
            .sorted()
            .toArray();
    LearnedCurve curve = finding(1, 50, 0.5, 1.5).curves().get(0);
    double end = curve.points().get(curve.points().size() - 1).x();
    assertThat(end).isEqualTo(speeds[speeds.length - 3], within(1e-9));
    assertThat(end).isLessThan(speeds[speeds.length - 1] - 0.1);
    assertThat(curve.lowest().x()).as("drag brakes fast balls most").isGreaterThan(0.9 * end);
  }

  @Test
  void whatIsNotBeyondChanceIsNotShownToHelp() {
    assertThat(finding(1, 50, 0.5, 1.5).isShownToHelp()).isTrue();
    assertThat(finding(0.011, 0.4, -1.2, 1.2).isShownToHelp()).isFalse();
    assertThat(finding(Double.NaN, Double.NaN, Double.NaN, Double.NaN).isShownToHelp()).isFalse();
  }

  /** What has a name but is not to be told as a cause stays in the model, so it is told among what was learned. */
  @Test
  void namesBeyondTheLimitAreNotConcealed() {
    DiagnosisProblem p = field.problem();
    Diagnosis diagnosis =
        new Diagnoser()
            .diagnose(
                new DiagnosisProblem(
                    p.fits(),
                    p.cameras(),
                    p.observers(),
                    p.sessionStart(),
                    p.commands(),
                    0,
                    p.seed()),
                said -> {});
    assertThat(diagnosis.causes()).isEmpty();
    assertThat(diagnosis.learned()).extracting(l -> l.effect().id()).containsExactly("air_drag");
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.PARTLY_EXPLAINED);
  }
}
