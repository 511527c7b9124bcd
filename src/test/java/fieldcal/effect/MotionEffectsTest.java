package fieldcal.effect;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.Drift;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.Magnus;
import fieldcal.effect.motion.RobotKickBias;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.effect.motion.WornRegion;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.List;
import org.junit.jupiter.api.Nested;

/** The contract for every effect on the motion. */
class MotionEffectsTest {
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.95, 0.52, -0.28);

  /** Positions of a flat kick and of a chip, both from (1, 2), kicked at session time 100 s. */
  abstract static class Paths extends EffectContract {
    private final Effect effect;

    Paths(Effect effect) {
      this.effect = effect;
    }

    @Override
    Effect effect() {
      return effect;
    }

    @Override
    double[] predict(Effect with) {
      return predictTurned(with, 0);
    }

    /** The same effect for a world turned about the origin; effects without a direction of their own stay as they are. */
    @Override
    Effect turned(double angle) {
      boolean directed = effect.parameters().stream().anyMatch(p -> p.name().equals("direction"));
      return directed ? effect.with("direction", effect.value("direction") + angle) : effect;
    }

    @Override
    double[] predictTurned(Effect with, double angle) {
      List<MotionEffect> list = with == null ? List.of() : List.of((MotionEffect) with);
      MotionEffects effects = MotionEffects.of(list);
      double c = Math.cos(angle);
      double s = Math.sin(angle);
      double x = c - 2 * s;
      double y = s + 2 * c;
      double vx = 4 * c - 1.5 * s;
      double vy = 4 * s + 1.5 * c;
      ExtendedTrajectory[] paths = {
        ExtendedTrajectory.flat(FLAT, effects, -100, 0, x, y, vx, vy),
        ExtendedTrajectory.chipWithHops(CHIP, effects, -100, 0, x, y, 0.7 * vx, 0.7 * vy, 3.5, 5)
      };
      double[] result = new double[2 * 3 * 60];
      double[] xyz = new double[3];
      int n = 0;
      for (ExtendedTrajectory path : paths) {
        for (int i = 0; i < 60; i++) {
          path.positionAt(0.1 * i + 0.01, xyz);
          result[n++] = c * xyz[0] + s * xyz[1];
          result[n++] = c * xyz[1] - s * xyz[0];
          result[n++] = xyz[2];
        }
      }
      return result;
    }
  }

  @Nested
  class AirDragTest extends Paths {
    AirDragTest() {
      super(new AirDrag(0.45));
    }
  }

  @Nested
  class MagnusTest extends Paths {
    MagnusTest() {
      super(new Magnus(0.5));
    }
  }

  @Nested
  class KickSpinTest extends Paths {
    KickSpinTest() {
      super(new KickSpin(-0.4));
    }
  }

  @Nested
  class SideSpinTest extends Paths {
    SideSpinTest() {
      super(new SideSpin(0.3));
    }
  }

  @Nested
  class FieldSlopeTest extends Paths {
    FieldSlopeTest() {
      super(new FieldSlope(0.3, 1));
    }
  }

  @Nested
  class CarpetNapTest extends Paths {
    CarpetNapTest() {
      super(new CarpetNap(0.1, 1));
    }
  }

  @Nested
  class SpeedDependentRollTest extends Paths {
    SpeedDependentRollTest() {
      super(new SpeedDependentRoll(0.05));
    }
  }

  @Nested
  class WornRegionTest extends Paths {
    WornRegionTest() {
      super(new WornRegion(0.3, 2, 5, 0, 4));
    }

    /** Its sides stay along the axes. */
    @Override
    Effect turned(double angle) {
      return null;
    }
  }

  @Nested
  class SpeedDependentRestitutionTest extends Paths {
    SpeedDependentRestitutionTest() {
      super(new SpeedDependentRestitution(0.05));
    }
  }

  @Nested
  class BounceSpinCouplingTest extends Paths {
    BounceSpinCouplingTest() {
      super(new BounceSpinCoupling(0.1));
    }
  }

  @Nested
  class DriftTest extends Paths {
    DriftTest() {
      super(new Drift(20));
    }
  }

  @Nested
  class RobotKickBiasTest extends EffectContract {
    @Override
    Effect effect() {
      return new RobotKickBias(5, 0.03, Team.BLUE, 7);
    }

    @Override
    double[] predict(Effect with) {
      double[] velocity = {4, 1.5, 2};
      if (with != null) {
        ((KickerEffect) with).kick(new RobotId(Team.BLUE, 7), velocity);
      }
      return velocity;
    }
  }
}
