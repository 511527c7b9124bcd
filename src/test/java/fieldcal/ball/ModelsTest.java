package fieldcal.ball;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModelsTest {
  private static final int CASES = 200;

  private static double[] values(List<Parameter> parameters) {
    return parameters.stream().mapToDouble(Parameter::value).toArray();
  }

  @Test
  void surviveTheWayThroughTheirParameters() {
    FlatModel flat = new FlatModel(-3, -0.3, 0.6);
    ChipModel chip = new ChipModel(0.7, 0.8, 0.5, -0.3);
    assertThat(flat.withParameters(values(flat.parameters()))).isEqualTo(flat);
    assertThat(chip.withParameters(values(chip.parameters()))).isEqualTo(chip);
    assertThat(flat.parameters())
        .extracting(Parameter::name)
        .containsExactly("accSlide", "accRoll", "kSwitch");
    assertThat(chip.parameters())
        .extracting(Parameter::name)
        .containsExactly("dampingXyFirstHop", "dampingXyOtherHops", "dampingZ", "accRoll");
  }

  @Test
  void acceptEveryNumberWithinTheirBounds() {
    check(FlatModel.typical().parameters(), n -> FlatModel.typical().withParameters(n));
    check(ChipModel.typical().parameters(), n -> ChipModel.typical().withParameters(n));
  }

  /** Friction with a coefficient of 1 along each axis of the field, as grSim has it, is √2·g along a diagonal; its rolling friction acts besides. */
  @Test
  void aSimulatorsFrictionIsWithinTheBoundsAndItsScaleFollows() {
    double diagonal = -(Math.sqrt(2) + 0.05) * Gravity.ACCELERATION;
    FlatModel sticky = new FlatModel(1.15 * diagonal, -0.7, 0.7);
    assertThat(sticky.parameters()).allMatch(Parameter::isWithinBounds);
    // A published value that is 15 % off is within a search's spread, 0.7 scales.
    assertThat(sticky.parameters().subList(0, 2))
        .allSatisfy(
            p -> assertThat(0.7 * p.scale()).isGreaterThan(0.15 * Math.abs(p.value()) / 1.15));
    assertThat(FlatModel.typical().parameters())
        .extracting(Parameter::scale)
        .containsExactly(1.0, 0.1, 0.1);
  }

  private static void check(List<Parameter> parameters, Consumer<double[]> model) {
    assertThat(parameters).allMatch(Parameter::isWithinBounds);
    model.accept(parameters.stream().mapToDouble(Parameter::min).toArray());
    model.accept(parameters.stream().mapToDouble(Parameter::max).toArray());
    for (int i = 0; i < parameters.size(); i++) {
      for (double bad : new double[] {Double.NaN, Double.NEGATIVE_INFINITY}) {
        double[] numbers = values(parameters);
        numbers[i] = bad;
        assertThatThrownBy(() -> model.accept(numbers))
            .isInstanceOf(IllegalArgumentException.class)
            .hasMessageContaining(parameters.get(i).name())
            .hasMessageContaining("" + bad);
      }
    }
    assertThatThrownBy(() -> model.accept(new double[parameters.size() + 1]))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void refuseWhatABallCannotDo() {
    assertThatThrownBy(() -> new FlatModel(3, -0.3, 0.6)).hasMessageContaining("accSlide");
    assertThatThrownBy(() -> new FlatModel(-3, 0, 0.6)).hasMessageContaining("accRoll");
    assertThatThrownBy(() -> new FlatModel(-3, -0.3, 1)).hasMessageContaining("1.0");
    assertThatThrownBy(() -> new FlatModel(-3, -0.3, 0)).hasMessageContaining("0.0");
    assertThatThrownBy(() -> new ChipModel(0, 1, 0.5, -1)).hasMessageContaining("FirstHop");
    assertThatThrownBy(() -> new ChipModel(1, -1, 0.5, -1)).hasMessageContaining("OtherHops");
    assertThatThrownBy(() -> new ChipModel(1, 1, 1, -1)).hasMessageContaining("dampingZ");
    assertThatThrownBy(() -> new ChipModel(1, 1, 0.5, 1)).hasMessageContaining("accRoll");
    assertThatThrownBy(() -> FlatModel.fromInertia(-3, -1, 0)).hasMessageContaining("inertia");
  }

  @Test
  void knowInertiaAndSwitchAsOneQuantity() {
    // A solid ball rolls at 5/7 of its sliding speed, a thin shell at 3/5.
    assertThat(FlatModel.fromInertia(-3, -0.3, 0.4).kSwitch()).isCloseTo(5.0 / 7, within(1e-15));
    assertThat(new FlatModel(-3, -0.3, 0.6).inertiaFactor()).isCloseTo(2.0 / 3, within(1e-15));
  }

  @ParameterizedTest
  @ValueSource(longs = {61, 62, 63})
  void tellTheKickThatArrivesWithTheWantedSpeed(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    for (int i = 0; i < CASES; i++) {
      FlatModel model = kicks.flatModel();
      double distance = kicks.uniform(0.1, 10);
      double arrival = kicks.uniform(0, 6);
      double kick = model.kickSpeedToArrive(distance, arrival);
      FlatTrajectory path = FlatTrajectory.fromKick(model, 0, 0, 0, kick, 0);
      assertThat(path.speedAtDistance(distance).orElseThrow())
          .as("seed %d case %d", seed, i)
          .isCloseTo(arrival, within(1e-9));
      assertThat(model.restDistance(kick)).isCloseTo(path.restDistance(), within(1e-10));
      double toRest = model.kickSpeedToArrive(distance, 0);
      assertThat(model.restDistance(toRest)).isCloseTo(distance, within(1e-12));
    }
  }

  @Test
  void tellTheKickThatArrivesByHand() {
    // Slides 4 → 2 m/s in 1.5 m, then rolls 4 m.
    FlatModel model = new FlatModel(-4, -0.5, 0.5);
    assertThat(model.kickSpeedToArrive(5.5, 0)).isCloseTo(4, within(1e-14));
    assertThat(model.kickSpeedToArrive(1.5, 2)).isCloseTo(4, within(1e-14));
    assertThat(model.kickSpeedToArrive(0.875, 3)).isCloseTo(4, within(1e-14));
    assertThat(model.kickSpeedToArrive(4.5, 1)).isCloseTo(4, within(1e-14));
    assertThat(model.kickSpeedToArrive(0, 3)).isCloseTo(3, within(1e-14));
    assertThat(model.kickSpeedToArrive(0, 0)).isZero();
    assertThat(model.restDistance(4)).isCloseTo(5.5, within(1e-14));
    assertThatThrownBy(() -> model.kickSpeedToArrive(-1, 0)).hasMessageContaining("-1.0");
    assertThatThrownBy(() -> model.kickSpeedToArrive(1, Double.NaN)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> model.restDistance(-1)).hasMessageContaining("-1.0");
  }

  @ParameterizedTest
  @ValueSource(longs = {71, 72, 73})
  void tellTheChipThatLandsAtTheDistance(long seed) {
    RandomKicks kicks = new RandomKicks(seed);
    int found = 0;
    for (int i = 0; i < CASES; i++) {
      ChipModel model = kicks.chipModel();
      double distance = kicks.uniform(0.1, 6);
      double elevation = kicks.uniform(0.1, 1.4);
      int landing = kicks.integer(1, 4);
      OptionalDouble speed = model.kickSpeedToLand(distance, elevation, landing);
      if (speed.isEmpty()) {
        continue;
      }
      found++;
      double v = speed.getAsDouble();
      double vx = v * Math.cos(elevation);
      double vz = v * Math.sin(elevation);
      ChipTrajectory path = ChipTrajectory.fromKick(model, 0, 0, 0, vx, 0, vz);
      assertThat(path.landings().get(landing - 1).x())
          .as("seed %d case %d landing %d", seed, i, landing)
          .isCloseTo(distance, within(1e-10));
    }
    assertThat(found).isGreaterThan(CASES / 2);
  }

  @Test
  void tellThatNoChipLandsWhereTheBallWouldRoll() {
    ChipModel model = ChipModel.typical();
    double elevation = Math.PI / 4;
    // vz²/(2g) = 9 mm: the flight of 36 mm does not take place, one of 44 mm (11 mm high) does.
    assertThat(model.kickSpeedToLand(0.036, elevation, 1)).isEmpty();
    assertThat(model.kickSpeedToLand(0.044, elevation, 1)).isPresent();
    assertThat(model.kickSpeedToLand(0.044, elevation, 2)).isEmpty();
    assertThatThrownBy(() -> model.kickSpeedToLand(1, 0, 1)).hasMessageContaining("elevation");
    assertThatThrownBy(() -> model.kickSpeedToLand(1, 2, 1)).hasMessageContaining("2.0");
    assertThatThrownBy(() -> model.kickSpeedToLand(-1, 1, 1)).hasMessageContaining("-1.0");
    assertThatThrownBy(() -> model.kickSpeedToLand(1, 1, 0)).hasMessageContaining("landing");
  }
}
