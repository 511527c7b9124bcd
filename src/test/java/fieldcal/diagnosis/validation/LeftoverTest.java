package fieldcal.diagnosis.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.MovedBall;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.screening.KickScreen;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What is no noise. */
class LeftoverTest {
  /** One of so many standard deviations happens once in 30 000 times. */
  private static final double CHANCE = 4;

  private static Leftover bump(double metres) {
    FittedField field = FittedField.flats();
    List<KickRecord> moved =
        field.fitter().kicks().stream()
            .map(
                k ->
                    field.again(
                        MovedBall.shifted(
                            k.kick(), t -> metres * Math.exp(-0.5 * Math.pow((t - 1) / 0.2, 2))),
                        k.kind()))
            .toList();
    return Leftover.of(field.simple(moved));
  }

  @Test
  void noiseAloneIsNotSignificant() {
    for (FittedField field : List.of(FittedField.flats(), FittedField.chips())) {
      Leftover left = Leftover.of(field.simple());
      assertThat(left.isSignificant()).isFalse();
      assertThat(left.deviation()).isBetween(-CHANCE, CHANCE);
      assertThat(left.systematic()).isCloseTo(0, within(0.04));
    }
  }

  @Test
  void aBumpInThePathIsSignificant() {
    assertThat(bump(0).isSignificant()).isFalse();
    Leftover left = bump(0.005);
    assertThat(left.isSignificant()).isTrue();
    assertThat(left.deviation()).isGreaterThan(10);
    assertThat(bump(0.01).systematic()).isGreaterThan(2 * left.systematic());
  }

  @Test
  void whatTheSimpleModelLeavesOutIsSignificant() {
    assertThat(Leftover.of(FittedField.flats("air_drag:cd=0.45").simple()).isSignificant())
        .isTrue();
  }

  /** What a kick's own noise is taken for hides what the model leaves, but not from who asks for the cameras' noise. */
  @Test
  void moreNoiseHidesItFromTheFitAlone() {
    FittedField field = FittedField.flats("air_drag:cd=0.45");
    FittedModel plain = field.simple();
    List<KickRecord> louder = plain.records().stream().map(k -> k.withNoise(20)).toList();
    FittedModel deaf = field.simple(louder);
    Leftover seen = Leftover.ofSeen(deaf);
    assertThat(Leftover.of(deaf).isSignificant()).isFalse();
    assertThat(seen.isSignificant()).isTrue();
    assertThat(seen.systematic()).isCloseTo(Leftover.of(plain).systematic(), withinPercentage(5));
    assertThat(Leftover.ofSeen(plain)).isEqualTo(Leftover.of(plain));
  }

  /** A cause at a place is not to be named for a small part of what is only called noise. */
  @Test
  void whatMostKicksCallNoiseIsConcealed() {
    FittedModel plain = FittedField.flats("air_drag:cd=0.45").simple();
    assertThat(Leftover.concealed(plain)).isZero();
    FittedField field = FittedField.flats("air_drag:cd=0.45");
    FittedModel deaf = field.simple(KickScreen.withWhatIsLeftAsNoise(plain));
    assertThat(Leftover.concealed(deaf)).isGreaterThan(0.5 * deaf.solution().rows());
    FittedField sound = FittedField.flats();
    FittedModel same = sound.simple(KickScreen.withWhatIsLeftAsNoise(sound.simple()));
    assertThat(Leftover.concealed(same)).isLessThan(0.1 * same.solution().rows());
  }

  @Test
  void aTouchedKickConcealsNothingThatTheModelLacks() {
    FittedField sound = FittedField.flats();
    List<KickRecord> kicks = new ArrayList<>(sound.simple().records());
    kicks.set(0, kicks.get(0).withNoise(5));
    assertThat(Leftover.concealed(sound.simple(kicks))).isZero();
  }
}
