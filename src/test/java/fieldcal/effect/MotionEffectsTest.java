package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.BallChanged;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.CarpetSeam;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.Drift;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.Magnus;
import fieldcal.effect.motion.RobotKickBias;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SlipDependentFriction;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.effect.motion.Wind;
import fieldcal.effect.motion.WornRegion;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;

/** The contract for every effect on the motion. */
class MotionEffectsTest {
  private static final FlatModel FLAT = new FlatModel(-3.1, -0.28, 0.65);
  private static final ChipModel CHIP = new ChipModel(0.75, 0.95, 0.52, -0.28);

  @Test
  void moreEffectsOneByOneAreAllAtOnce() {
    List<MotionEffect> all =
        List.of(
            new Wind(2, 1),
            new AirDrag(0.4),
            new SideSpin(0.2),
            new WornRegion(0.3, -1, 5, -5, 5),
            new FieldSlope(0.3, 1));
    MotionEffects oneByOne = MotionEffects.NONE;
    for (MotionEffect e : all) {
      oneByOne = oneByOne.plus(List.of(e));
    }
    assertThat(oneByOne.effects()).isEqualTo(all);
    MotionEffects atOnce = MotionEffects.of(all);
    BallTrajectory expected = ExtendedTrajectory.flat(FLAT, atOnce, 0, 0, -2, 0, 4, 1);
    BallTrajectory path = ExtendedTrajectory.flat(FLAT, oneByOne, 0, 0, -2, 0, 4, 1);
    for (double t = 0; t < expected.restTime(); t += 0.1) {
      assertThat(path.stateAt(t)).isEqualTo(expected.stateAt(t));
    }
  }

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
      for (String name : List.of("direction", "normal")) {
        if (effect.parameters().stream().anyMatch(p -> p.name().equals(name))) {
          return effect.with(name, effect.value(name) + angle);
        }
      }
      return effect;
    }

    @Override
    double[] predictTurned(Effect with, double angle) {
      List<MotionEffect> list = new ArrayList<>();
      effect.companions().forEach(e -> list.add((MotionEffect) e));
      if (with != null) {
        list.add((MotionEffect) with);
      }
      MotionEffects effects = MotionEffects.of(list);
      double c = Math.cos(angle);
      double s = Math.sin(angle);
      double x = c - 2 * s;
      double y = s + 2 * c;
      double vx = 4 * c - 1.5 * s;
      double vy = 4 * s + 1.5 * c;
      ExtendedTrajectory[] paths = {
        ExtendedTrajectory.flat(FLAT, effects, -100, 0, x, y, vx, vy),
        ExtendedTrajectory.chipWithHops(
            CHIP, FLAT, effects, -100, 0, x, y, 0.7 * vx, 0.7 * vy, 3.5, 5)
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
  class SpinOfChipsTest extends Paths {
    SpinOfChipsTest() {
      super(new KickSpin(-0.1, -0.3, true));
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
  class WindTest extends Paths {
    WindTest() {
      super(new Wind(0.8, 2));
    }
  }

  @Nested
  class SlipDependentFrictionTest extends Paths {
    SlipDependentFrictionTest() {
      super(new SlipDependentFriction(0.05));
    }
  }

  @Nested
  class BallChangedTest extends Paths {
    BallChangedTest() {
      super(new BallChanged(0.1, -0.05, 60));
    }
  }

  @Nested
  class ContactImpactsTest extends Paths {
    ContactImpactsTest() {
      // The first impact of the chip slips through, the others grip.
      super(new ContactImpacts(-0.2, 0.12, 0, 0, 10));
    }
  }

  @Nested
  class CarpetSeamTest extends Paths {
    CarpetSeamTest() {
      super(new CarpetSeam(0.1, 0.05, 0.4, 3));
    }
  }

  /** The horizontal velocity along x after each impact of a chip along x, m/s. */
  private static List<Double> afterImpacts(MotionEffect... effects) {
    ExtendedTrajectory path =
        ExtendedTrajectory.chipWithHops(
            CHIP, FLAT, MotionEffects.of(List.of(effects)), 0, 0, 0, 0, 3, 0, 4, 4);
    List<Double> speeds = new ArrayList<>();
    double vz = 4;
    double landing = 0;
    for (int i = 0; i < 3; i++) {
      landing += 2 * vz / 9.81;
      vz *= CHIP.dampingZ();
      speeds.add(path.stateAt(landing + 0.01).vx());
    }
    return speeds;
  }

  @Test
  void spinOfTheKickActsAtImpacts() {
    // A ball that already rolls loses nothing at its first impact.
    assertThat(afterImpacts(new KickSpin(1)).get(0)).isEqualTo(3, within(1e-9));
    // Backspin grips more: v' = 0.75·v + 0.25·q, q' = q·(1 − 0.25/0.4), v'' = 0.95·v' + 0.25·q'.
    double first = 0.75 * 3 + 0.25 * -1.2;
    double second = 0.95 * first + 0.25 * -1.2 * 0.375;
    List<Double> speeds = afterImpacts(new KickSpin(-0.4));
    assertThat(speeds.get(0)).isEqualTo(first, within(1e-9));
    assertThat(speeds.get(1)).isEqualTo(second, within(1e-9));
    assertThat(afterImpacts(new KickSpin(0.2, -0.6, true))).isEqualTo(speeds);
    assertThat(afterImpacts().get(0)).isEqualTo(0.75 * 3, within(1e-12));
  }

  @Test
  void contactBuildsUpSpinFromHopToHop() {
    // A soft grip, e_t = −0.6: what is lost shrinks from impact to impact, which fixed dampings
    // cannot do.
    List<Double> speeds = afterImpacts(new ContactImpacts(-0.4, 1, 0, 0, 10));
    double slip = 3;
    double v = 3;
    for (double speed : speeds) {
      v -= 0.6 * 0.4 / 1.4 * slip;
      slip *= 0.4;
      assertThat(speed).isEqualTo(v, within(1e-9));
    }
    // Little friction limits the impulse: Δv = −friction·(1 + e_z)·|v_z|.
    assertThat(afterImpacts(new ContactImpacts(0, 0.05, 0, 0, 10)).get(0))
        .isEqualTo(3 - 0.05 * 1.52 * 4, within(1e-9));
  }

  @Test
  void rollingResistanceActsInImpacts() {
    // The torque brakes the spin while the contact point slides: friction needs so much more of the
    // impulse. The rest of it brakes a rolling ball.
    double sliding = 0.4 / 1.4 * 3 / (1 - 0.03);
    assertThat(afterImpacts(new ContactImpacts(0, 1, 0, 0.03, 10)).get(0))
        .isEqualTo(3 - sliding - 0.03 * (1.52 * 4 - sliding), within(1e-9));
    // A ball that slides to the end loses no more speed at first, but turns less: the torque is
    // 1.4 times the resistance. So the next impact has more slip to take.
    List<Double> slides = afterImpacts(new ContactImpacts(0, 0.15, 0, 0.03, 10));
    double first = 0.15 * 1.52 * 4;
    assertThat(slides.get(0)).isEqualTo(3 - first, within(1e-9));
    double turns = (0.15 - 1.4 * 0.03) * 1.52 * 4 / 0.4;
    double stops = 0.4 / 1.4 * (3 - first - turns) / (1 - 0.03 / 0.15);
    double impulse = 1.52 * 4 * 0.52;
    assertThat(stops / 0.15).isBetween(0.1 * impulse, 0.9 * impulse);
    assertThat(slides.get(1))
        .isEqualTo(3 - first - stops - 0.03 * (impulse - stops / 0.15), within(1e-9));
    // It cannot turn the spin round.
    assertThat(afterImpacts(new ContactImpacts(0, 1, 0, 0.5, 10)).get(0))
        .isEqualTo(0, within(1e-9));
  }

  @Test
  void aSeamTakesSpeedAcrossAndTurns() {
    CarpetSeam seam = new CarpetSeam(0.2, 0.1, 0, 2);
    double[] velocity = {2, 1};
    seam.cross(velocity);
    assertThat(Math.hypot(velocity[0], velocity[1])).isEqualTo(Math.hypot(1.6, 1), within(1e-12));
    assertThat(Math.atan2(velocity[1], velocity[0]))
        .isEqualTo(Math.atan2(1, 1.6) + 0.1, within(1e-12));
    double[] grazing = {0.01, 1};
    seam.cross(grazing);
    assertThat(grazing).containsExactly(new double[] {0, 1}, within(1e-4));
    ExtendedTrajectory path =
        ExtendedTrajectory.flat(FLAT, MotionEffects.of(List.of(seam)), 0, 0, 0, 0, 4, 0);
    double crossing = path.timeAtDistance(2).orElseThrow();
    double before = path.stateAt(crossing - 1e-6).groundSpeed();
    double after = path.stateAt(crossing + 1e-6).groundSpeed();
    assertThat(after).isEqualTo(0.8 * before, within(1e-4));
  }

  @Test
  void aNewBallIsInPlayFromItsTimeOn() {
    MotionEffects changed = MotionEffects.of(List.of(new BallChanged(0.2, 0.1, 60)));
    FlatModel other = new FlatModel(1.1 * FLAT.accSlide(), 1.2 * FLAT.accRoll(), FLAT.kSwitch());
    for (double t : new double[] {59, 61}) {
      ExtendedTrajectory path = ExtendedTrajectory.flat(FLAT, changed, 0, t, 0, 0, 4, 1);
      ExtendedTrajectory plain =
          ExtendedTrajectory.flat(t < 60 ? FLAT : other, MotionEffects.NONE, 0, t, 0, 0, 4, 1);
      assertThat(path.restTime()).isEqualTo(plain.restTime(), within(1e-9));
    }
  }

  @Test
  void factorsActOnTheWholeRollingDeceleration() {
    // Along the nap at 2 m/s: (0.3 + 0.05·2)·(1 + 0.1)·(1 + 0.2·t/600) m/s².
    MotionEffects both =
        MotionEffects.of(
            List.of(new CarpetNap(0.1, 0), new SpeedDependentRoll(0.05), new Drift(20)));
    FlatModel rolls = new FlatModel(-3, -0.3, 0.7);
    ExtendedTrajectory path = ExtendedTrajectory.flat(rolls, both, 0, 60, 0, 0, 5, 0);
    double before = timeAtSpeed(path, 2.01);
    double after = timeAtSpeed(path, 1.99);
    double expected = (0.3 + 0.05 * 2) * 1.1 * (1 + 0.2 * before / 600);
    assertThat(0.02 / (after - before)).isEqualTo(expected, within(1e-3 * expected));
  }

  private static double timeAtSpeed(ExtendedTrajectory path, double speed) {
    double early = path.kickTime();
    double late = path.restTime();
    while (late - early > 1e-9) {
      double middle = (early + late) / 2;
      if (path.stateAt(middle).groundSpeed() > speed) {
        early = middle;
      } else {
        late = middle;
      }
    }
    return early;
  }

  @Test
  void aBallThatMovesWithTheAirFeelsNoDrag() {
    MotionEffects windy = MotionEffects.of(List.of(new AirDrag(0.45), new Wind(3, 0)));
    ExtendedTrajectory path =
        ExtendedTrajectory.chipWithHops(CHIP, FLAT, windy, 0, 0, 0, 0, 3, 0, 0.001, 1);
    assertThat(path.stateAt(1e-4).vx()).isEqualTo(3, within(1e-7));
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
