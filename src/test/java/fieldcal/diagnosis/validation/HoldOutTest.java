package fieldcal.diagnosis.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.validation.HoldOut.Ahead;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.RollScatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What kicks say of a model that was not fitted to them. */
class HoldOutTest {
  private static final long SEED = 1;

  private final FittedField field = FittedField.flats("air_drag:cd=0.45");
  private final FittedModel drag = with(field, Component.of(new AirDrag(0), List.of("cd")));

  private static FittedModel with(FittedField field, Component component) {
    return field
        .fitter()
        .fit(
            field.simple().model().with(List.of(component)),
            field.simple(),
            Weighing.ALIKE,
            FittedField.SOLVER);
  }

  /** The step is exact where the model is linear; a ball's is nearly so over a standard error. */
  @Test
  void leavingKicksOutByOneStepIsFittingAgainWithoutThem() {
    boolean[] without = new boolean[drag.kickCount()];
    for (int k = 0; k < 5; k++) {
      without[k] = true;
    }
    double[] stepped = drag.solution().valuesWithout(without);
    List<KickRecord> rest = new ArrayList<>();
    for (int k = 0; k < without.length; k++) {
      if (!without[k]) {
        rest.add(drag.kick(k).record());
      }
    }
    double[] refitted =
        field
            .fitter(rest)
            .fit(drag.model(), drag.restrictedTo(rest), Weighing.ALIKE, FittedField.SOLVER)
            .solution()
            .values();
    double[][] covariance = drag.solution().covariance().orElseThrow();
    double moved = 0;
    for (int i = 0; i < stepped.length; i++) {
      double error = Math.sqrt(covariance[i][i]);
      if (drag.model().globals().get(i).estimated()) {
        assertThat(stepped[i])
            .as(drag.model().globals().get(i).name())
            .isCloseTo(refitted[i], within(0.1 * error));
        moved = Math.max(moved, Math.abs(refitted[i] - drag.solution().values()[i]) / error);
      }
    }
    assertThat(moved).as("standard errors that the kicks make a difference of").isGreaterThan(0.2);
  }

  @Test
  void whatPredictsWorseIsKnownBeyondTheChoiceOfKicks() {
    HoldOut with = HoldOut.of(drag, true, SEED);
    HoldOut without = HoldOut.of(field.simple(), true, SEED);
    assertThat(without.predictsWorseThan(with, SEED)).isTrue();
    assertThat(with.predictsWorseThan(without, SEED)).isFalse();
    assertThat(with.predictsWorseThan(with, SEED)).isFalse();
  }

  @Test
  void theRightModelPredictsWhatItHasNotSeen() {
    HoldOut with = HoldOut.of(drag, true, SEED);
    HoldOut without = HoldOut.of(field.simple(), true, SEED);
    double[] gain = with.gainOn(without, SEED);
    assertThat(gain[0]).isCloseTo(without.rmsMm() - with.rmsMm(), within(1e-9));
    assertThat(gain[2]).isPositive().isLessThan(gain[0]);
    assertThat(gain[3]).isGreaterThan(gain[0]);
    Map<Double, Double> predicted = with.predictionMm();
    assertThat(predicted).containsOnlyKeys(0.5, 1.0, 2.0);
    predicted.forEach(
        (horizon, mm) -> assertThat(mm).isLessThan(without.predictionMm().get(horizon)));
  }

  /** A root mean square over thirty kicks is that of the worst, if one is metres off. */
  @Test
  void noSingleKickDecidesWhatIsTypical() {
    double[] squares = new double[30];
    int[] counts = new int[30];
    for (int k = 0; k < 29; k++) {
      // Two detections of 8 to 12 mm each; the last kick has none at that horizon.
      double error = 1e-3 * (8 + 4 * k / 28.0);
      counts[k] = 2;
      squares[k] = 2 * error * error;
    }
    HoldOut even = new HoldOut(squares, counts, Map.of(1.0, new Ahead(squares, counts)));
    double rms = even.predictionMm().get(1.0);
    assertThat(even.typicalMm().get(1.0)).isEqualTo(rms, within(1e-9));
    squares[0] = 2 * 5.5 * 5.5;
    HoldOut stray = new HoldOut(squares, counts, Map.of(1.0, new Ahead(squares, counts)));
    assertThat(stray.predictionMm().get(1.0)).isGreaterThan(1000);
    double counted = 3 * 10;
    assertThat(stray.typicalMm().get(1.0))
        .isEqualTo(Math.sqrt((29 * rms * rms - 64 + counted * counted) / 29), within(0.1));
  }

  /** Unlike the median, it shows what few kicks gain: those that one camera sees, for example. */
  @Test
  void whatAFifthOfTheKicksGainShows() {
    double[] before = new double[20];
    double[] after = new double[20];
    int[] counts = new int[20];
    for (int k = 0; k < 20; k++) {
      counts[k] = 1;
      after[k] = 1e-4;
      before[k] = k % 5 == 0 ? 25e-4 : 1e-4;
    }
    HoldOut with = new HoldOut(after, counts, Map.of(1.0, new Ahead(after, counts)));
    HoldOut without = new HoldOut(before, counts, Map.of(1.0, new Ahead(before, counts)));
    assertThat(with.typicalMm().get(1.0)).isEqualTo(10, within(1e-9));
    assertThat(without.typicalMm().get(1.0))
        .isEqualTo(Math.sqrt(0.8 * 100 + 0.2 * 900), within(1e-9));
  }

  @Test
  void aModelGainsNothingOnItself() {
    HoldOut held = HoldOut.of(drag, false, SEED);
    assertThat(held.gainOn(held, SEED)).containsExactly(0, 0, 0, 0);
    assertThat(held.predictionMm()).isEmpty();
  }

  @Test
  void heldOutKicksAreNeverFittedBetterThanTheirOwnFitDoes() {
    HoldOut held = HoldOut.of(drag, false, SEED);
    double sum = 0;
    double n = 0;
    for (int k = 0; k < drag.kickCount(); k++) {
      KickRecord record = drag.kick(k).record();
      double[] rx = new double[record.size()];
      double[] ry = new double[record.size()];
      drag.kick(k).plainResiduals(drag.solution().own(k), drag.solution().state(), rx, ry);
      for (int i = 0; i < rx.length; i++) {
        if (record.used()[i]) {
          sum += rx[i] * rx[i] + ry[i] * ry[i];
          n += 2;
        }
      }
    }
    double fitted = 1000 * Math.sqrt(sum / n);
    // Four parameters from ten kicks cost some thousandths of the residual.
    assertThat(held.rmsMm()).isBetween(0.9999 * fitted, 1.02 * fitted);
  }

  /** A value of its own explains a kick that was held out; the mean of all does not. */
  @Test
  void whatDiffersByChanceExplainsNothingWithoutItsValues() {
    FittedField spun = FittedField.flats("kick_spin:fraction=-0.3,scatter=0.1");
    FittedModel chance = with(spun, Component.perKick(new RollScatter(0)));
    double own = HoldOut.of(chance, false, SEED).rmsMm();
    double mean = HoldOut.withoutChance(chance, SEED).rmsMm();
    assertThat(mean).isGreaterThan(1.5 * own);
    assertThat(mean).isCloseTo(HoldOut.of(spun.simple(), false, SEED).rmsMm(), within(0.3 * mean));
    FittedModel kickers = with(spun, Component.perKick(new KickSpin(0)));
    assertThat(HoldOut.withoutChance(kickers, SEED).squares())
        .isEqualTo(HoldOut.of(kickers, false, SEED).squares());
  }

  @Test
  void theSameSeedDealsTheSameKicks() {
    assertThat(HoldOut.of(drag, false, SEED).squares())
        .isEqualTo(HoldOut.of(drag, false, SEED).squares());
  }

  /** Twenty kicks, of which one is lost whatever the model: of the others one model leaves half. */
  @Test
  void oneLostKickDoesNotDecideWhichModelFollowsAUsualOne() {
    int[] counts = new int[20];
    Arrays.fill(counts, 100);
    double[] far = new double[20];
    Arrays.fill(far, 100 * 4e-3 * 4e-3);
    double[] near = new double[20];
    Arrays.fill(near, 100 * 2e-3 * 2e-3);
    far[7] = 100 * 0.1 * 0.1;
    near[7] = 100 * 0.11 * 0.11;
    HoldOut before = new HoldOut(far, counts, Map.of());
    HoldOut after = new HoldOut(near, counts, Map.of());
    assertThat(after.rmsMm()).isGreaterThan(before.rmsMm());
    assertThat(after.usualMm()).isLessThan(0.6 * before.usualMm());
    assertThat(after.followsMostBetterThan(before, 1)).isTrue();
    assertThat(before.followsMostBetterThan(after, 1)).isFalse();
    assertThat(before.followsMostBetterThan(before, 1)).isFalse();
  }

  @Test
  void kicksWithMoreNoiseCountLessWhereTheyAreHeard() {
    FittedField field = FittedField.flats();
    List<KickRecord> kicks = new ArrayList<>(field.fitter().kicks());
    kicks.set(0, kicks.get(0).withNoise(5));
    FittedModel model = field.simple(kicks);
    HoldOut seen = HoldOut.of(model, false, SEED);
    HoldOut heard = seen.heardBy(model);
    assertThat(heard.rmsMm(0)).isCloseTo(seen.rmsMm(0) / 5, within(1e-9));
    assertThat(heard.rmsMm(1)).isEqualTo(seen.rmsMm(1));
    HoldOut plain = HoldOut.of(field.simple(), false, SEED);
    assertThat(plain.heardBy(field.simple())).isSameAs(plain);
  }
}
