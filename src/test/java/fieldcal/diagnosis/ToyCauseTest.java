package fieldcal.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.Parameter;
import fieldcal.effect.BallMotion;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.MotionEffect.RollingResistance;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallMoment;
import fieldcal.simulation.physics.ExtraLaw;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A cause that nobody knew of is one class: given to a diagnoser beside the catalogue, it is searched, judged and named as all others are. */
class ToyCauseTest {
  private static final double ROLL = 0.28;
  private static final double GROWTH = 0.06;

  /**
   * A carpet that brakes more towards the touch lines: rolling deceleration −accRoll + growth·|y|.
   *
   * @param growth m/s² per m
   */
  private record EdgeRoll(double growth) implements RollingResistance {
    @Override
    public String id() {
      return "edge_roll";
    }

    @Override
    public String sentence() {
      return "The carpet brakes more towards the touch lines.";
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(
          new Parameter("growth", "1/s²", growth, 0.02, -0.5, 0.5, true, "chosen for a test"));
    }

    @Override
    public EdgeRoll withParameters(double... values) {
      return new EdgeRoll(EffectParameters.require("edge_roll", values, 1)[0]);
    }

    @Override
    public boolean isAbsent() {
      return growth == 0;
    }

    @Override
    public double addend(BallMotion motion) {
      return growth * Math.abs(motion.y());
    }
  }

  /** The same as the simulation has it. */
  private record Edges(double growth) implements ExtraLaw {
    @Override
    public double rollingFactor(BallMoment m) {
      return 1 + growth / ROLL * Math.abs(m.y());
    }
  }

  private static final SimulationSettings WORLD =
      FittedField.SOUND
          .withScenario(ScenarioKind.FLAT, 12)
          .withPhysics(FittedField.SOUND.physics().withExtra(new Edges(GROWTH)));

  private static List<Effect> known() {
    List<Effect> effects = new ArrayList<>(EffectCatalogue.all());
    effects.add(new EdgeRoll(0));
    return effects;
  }

  @Test
  void isFoundAndNamed() {
    Diagnosis diagnosis =
        new Diagnoser(known()).diagnose(FittedField.of(WORLD).problem(), said -> {});
    assertThat(diagnosis.problems()).isEmpty();
    assertThat(diagnosis.causes())
        .as("%s", diagnosis.trace())
        .extracting(c -> c.effect().id())
        .containsExactly("edge_roll");
    Cause cause = diagnosis.causes().get(0);
    double error = cause.standardErrors().get("growth");
    assertThat(error).isBetween(0.0, 0.01);
    assertThat(cause.effect().value("growth")).isCloseTo(GROWTH, within(3 * error + 0.001));
    assertThat(cause.gain().lowMm()).isPositive();
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
    assertThat(diagnosis.model().effects()).contains(cause.effect());
  }

  @Test
  void isNotNamedWhereItIsNot() {
    Diagnosis diagnosis =
        new Diagnoser(known()).diagnose(FittedField.flats().problem(), said -> {});
    assertThat(diagnosis.causes()).as("%s", diagnosis.trace()).isEmpty();
    assertThat(diagnosis.verdict()).isEqualTo(Verdict.MODEL_ADEQUATE);
  }
}
