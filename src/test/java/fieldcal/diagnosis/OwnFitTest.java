package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A single chip under a model that is known: the height of one hop and the number of all are nearly exchangeable for it. */
class OwnFitTest {
  private final ChipsField field = ChipsField.fitted();

  private double cost(KickModel model) {
    return model.residuals(
        field.state(), model.path(field.state(), model.own), new double[2 * model.data.size]);
  }

  private OwnFit fit(KickModel model) {
    return new OwnFit(model, field.state(), new double[0]);
  }

  @Test
  void aFitThatIsDoneStaysWhereItIs() {
    for (int k = 0; k < field.fitter.kicks.size(); k++) {
      KickModel model = field.model(field.simple, k);
      double before = cost(model);
      fit(model).minimize();
      assertThat(cost(model)).isCloseTo(before, within(0.5));
      assertThat(model.own).containsExactly(field.simple.own().get(k), within(0.01));
    }
  }

  @Test
  void aRestartLeavesTheValleyThatAFitCannotLeave() {
    int trapped = 0;
    for (int k = 0; k < field.fitter.kicks.size(); k++) {
      double right = cost(field.model(field.simple, k));
      KickModel model = field.model(field.withConfused(k), k);
      fit(model).minimize();
      double astray = cost(model);
      if (astray < right + 100) {
        continue;
      }
      trapped++;
      assertThat(fit(model).restart()).as("kick %d starts anew", k).isTrue();
      assertThat(cost(model)).as("kick %d", k).isLessThan(right + 1);
      assertThat(model.flights).as("hops of kick %d", k).isEqualTo(field.simple.flights()[k]);
    }
    System.out.printf("%d of %d confused chips were trapped%n", trapped, field.fitter.kicks.size());
    assertThat(trapped).isPositive();
  }

  @Test
  void aRightFitIsNotRestarted() {
    assertThat(IntStream.range(0, field.fitter.kicks.size()))
        .noneMatch(k -> fit(field.model(field.simple, k)).restart());
  }

  @Test
  void oneHopMoreOrLessIsSeen() {
    for (int more : new int[] {-1, 1}) {
      for (int k = 0; k < field.fitter.kicks.size(); k++) {
        KickModel model = field.model(field.simple, k);
        model.flights += more;
        if (model.flights < 1) {
          continue;
        }
        fit(model).minimize();
        double wrong = cost(model);
        fit(model).chooseFlights();
        assertThat(cost(model)).as("kick %d", k).isLessThanOrEqualTo(wrong);
      }
    }
  }
}
