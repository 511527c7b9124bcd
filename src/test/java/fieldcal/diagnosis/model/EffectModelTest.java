package fieldcal.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SpeedDependentRoll;
import java.util.List;
import org.junit.jupiter.api.Test;

class EffectModelTest {
  private static final double STEP = 1e-3;

  /** The same kick's own value of the random effect everywhere. */
  private static final double[] OWN = {0, 0, 3, 0, 1, 0.1};

  private static Component all(Effect effect) {
    return Component.of(effect, effect.magnitudes());
  }

  /** Only the effect that changes is made again. A random effect between others must not be counted among them. */
  @Test
  void aStepOfOneParameterGivesTheStateThere() {
    FlatModel flat = new FlatModel(-3.1, -0.28, 0.65);
    ChipModel chip = new ChipModel(0.72, 0.92, 0.5, -0.28);
    EffectModel model =
        EffectModel.simple(flat, chip, true, true, List.of())
            .with(
                List.of(
                    all(new AirDrag(0.4)),
                    Component.perKick(new SideSpin(0.05)),
                    all(new FieldSlope(0.3, 1)),
                    all(new SpeedDependentRoll(0.02))));
    double[] values = model.globals().stream().mapToDouble(p -> p.value()).toArray();
    ModelState here = model.at(values);
    for (int i = 0; i < values.length; i++) {
      double[] moved = values.clone();
      moved[i] += STEP;
      ModelState there = model.at(moved);
      ModelState stepped = model.stepped(here, values, i, STEP);
      assertThat(stepped.flat()).as("%d", i).isEqualTo(there.flat());
      assertThat(stepped.chip()).as("%d", i).isEqualTo(there.chip());
      assertThat(stepped.fixed()).as("%d", i).isEqualTo(there.fixed());
      assertThat(stepped.motionOf(OWN).effects())
          .as("%d", i)
          .isEqualTo(there.motionOf(OWN).effects());
    }
  }
}
