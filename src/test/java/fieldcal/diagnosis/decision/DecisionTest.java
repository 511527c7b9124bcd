package fieldcal.diagnosis.decision;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.diagnosis.FittedField;
import fieldcal.diagnosis.MovedBall;
import fieldcal.diagnosis.decision.Judgement.Outcome;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.FreshFit;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.diagnosis.search.Alternatives;
import fieldcal.diagnosis.search.Dictionary;
import fieldcal.diagnosis.validation.HoldOut;
import fieldcal.effect.Effect;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.Drift;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.RollScatter;
import fieldcal.effect.motion.WornRegion;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.BallMoment;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.ExtraLaw;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Which components of a model are causes. */
class DecisionTest {
  private static final long SEED = 1;

  private static List<Judgement> judge(
      FittedField field, List<KickRecord> kicks, Effect... effects) {
    ModelFitter fitter = field.fitter(kicks);
    FittedModel simple = field.simple(kicks);
    List<Component> components =
        Arrays.stream(effects)
            .map(
                e ->
                    e.differsFromKickToKick()
                        ? Component.perKick(e)
                        : Component.of(e, e.magnitudes()))
            .toList();
    FittedModel model =
        fitter.fit(simple.model().with(components), simple, Weighing.ALIKE, FittedField.SOLVER);
    Alternatives alternatives =
        new Alternatives(fitter, new Dictionary(List.of(effects), field.arena()));
    FreshFit fresh = new FreshFit(fitter, simple, FittedField.SOLVER);
    return new Decision(DecisionSettings.defaults(), fresh, alternatives, SEED)
        .judge(model, HoldOut.of(model, false, SEED));
  }

  private static List<Judgement> judge(FittedField field, Effect... effects) {
    return judge(field, field.fitter().kicks(), effects);
  }

  private static List<Outcome> outcomes(List<Judgement> judged) {
    return judged.stream().map(Judgement::outcome).toList();
  }

  @Test
  void causesThatAreThereAreNamed() {
    FittedField field =
        FittedField.flats("air_drag:cd=0.45", "camera_offset:x_mm=10,y_mm=-4,camera=1");
    List<Judgement> judged = judge(field, new AirDrag(0), new CameraOffset(0, 0, 1));
    assertThat(outcomes(judged)).as("%s", judged).containsOnly(Outcome.NAMED);
    assertThat(judged.get(0).gain()[2]).isPositive();
  }

  @Test
  void whatIsNotThereIsChance() {
    FittedField field = FittedField.flats();
    List<Judgement> judged =
        judge(field, new AirDrag(0), new CarpetNap(0, 0), new CameraOffset(0, 0, 1));
    assertThat(judged).allMatch(j -> j.outcome() != Outcome.NAMED);
    assertThat(outcomes(judged)).as("%s", judged).contains(Outcome.CHANCE);
  }

  /** Noise reaches neither, but what changes less than the least noise of a camera may as well be an error of the model. */
  @Test
  void whatChangesLessThanAnyModelIsRightToIsTooSmallForAName() {
    String[] offsets = {
      "camera_offset:x_mm=0.6,y_mm=0,camera=1", "camera_offset:x_mm=3,y_mm=0,camera=1"
    };
    List<List<Judgement>> judged = new ArrayList<>();
    for (String offset : offsets) {
      CameraSettings quiet = CameraSettings.DEFAULT.withCount(2).withNoise(3e-4, 3e-4);
      FittedField field =
          FittedField.of(
              FittedField.SOUND
                  .withScenario(ScenarioKind.FLAT, 10)
                  .withCameras(quiet)
                  .withEffects(offset));
      judged.add(judge(field, new CameraOffset(0, 0, 1)));
    }
    assertThat(outcomes(judged.get(0))).as("%s", judged).containsExactly(Outcome.TOO_SMALL);
    assertThat(outcomes(judged.get(1))).as("%s", judged).containsExactly(Outcome.NAMED);
  }

  /** A nap of that strength is a cause by itself; beside a drag that explains a thousand times as much it may be how well the drag's law is known. */
  @Test
  void aSmallMotionBesideALargeOneIsItsForm() {
    String small = "carpet_nap:amplitude=0.002,direction=1";
    assertThat(outcomes(judge(FittedField.flats(small), new CarpetNap(0, 0))))
        .containsExactly(Outcome.NAMED);
    FittedField both = FittedField.flats("air_drag:cd=0.9", small);
    List<Judgement> judged = judge(both, new AirDrag(0), new CarpetNap(0, 0));
    assertThat(outcomes(judged)).as("%s", judged).containsExactly(Outcome.NAMED, Outcome.FORM);
    assertThat(judged.get(1).evidence()).isLessThan(0.01 * judged.get(0).evidence());
  }

  /** A value for each kick may make up for the form of a large cause; then the values scatter, or leave something. Those of these kickers have much in common. */
  @Test
  void spinThatAllKicksHaveIsNamedBesideALargeCause() {
    FittedField field =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 16)
                .withEffects(
                    "field_slope:percent=2,direction=1", "kick_spin:fraction=-0.4,scatter=0.05"));
    List<Judgement> judged = judge(field, new FieldSlope(0, 0), new KickSpin(0));
    assertThat(judged.get(1).evidence()).isLessThan(0.03 * judged.get(0).evidence());
    assertThat(outcomes(judged)).as("%s", judged).containsExactly(Outcome.NAMED, Outcome.NAMED);
  }

  /** Cameras do not take the form of what the ball does. */
  @Test
  void aSmallErrorOfACameraBesideALargeMotionIsACause() {
    FittedField field =
        FittedField.flats("air_drag:cd=0.9", "camera_offset:x_mm=1,y_mm=0.5,camera=1");
    List<Judgement> judged = judge(field, new AirDrag(0), new CameraOffset(0, 0, 1));
    assertThat(judged.get(1).evidence()).isLessThan(0.01 * judged.get(0).evidence());
    assertThat(outcomes(judged)).as("%s", judged).containsExactly(Outcome.NAMED, Outcome.NAMED);
  }

  /** It helps to follow the kicks, but of so many effects some always take up a part of a strong one that is missing. */
  @Test
  void whatExplainsMuchLessThanIsLeftIsItsForm() {
    FittedField field =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.FLAT, 24)
                .withEffects(
                    "drift:percent_per_10min=60", "camera_offset:x_mm=6,y_mm=-6,camera=1"));
    Judgement judged = judge(field, new CameraOffset(0, 0, 1)).get(0);
    assertThat(judged.gain()[1]).as("per cent gained").isGreaterThan(3);
    assertThat(judged.gain()[2]).as("certainly").isPositive();
    assertThat(judged.outcome()).isEqualTo(Outcome.FORM);
    assertThat(outcomes(judge(field, new Drift(0), new CameraOffset(0, 0, 1))))
        .containsOnly(Outcome.NAMED);
  }

  /** One kick rolls through a rough patch that no other kick comes to. */
  @Test
  void whatOneKickAloneGainsByIsNoCause() {
    FittedField field = FittedField.flats();
    FittedModel simple = field.simple();
    int which = -1;
    double longest = 0;
    for (int k = 0; k < simple.kickCount(); k++) {
      double left = timeAfter(simple, k, patchOf(simple, k));
      if (left > longest) {
        longest = left;
        which = k;
      }
    }
    assertThat(longest).as("s that a kick rolls where no other comes to").isGreaterThan(0.5);
    Effect patch = patchOf(simple, which);
    List<KickRecord> kicks = new ArrayList<>(field.fitter().kicks());
    kicks.set(which, field.again(through(simple, which, patch), KickKind.FLAT));
    List<Judgement> judged = judge(field, kicks, patch.with("change", 0));
    assertThat(judged.get(0).evidence()).isGreaterThan(100);
    assertThat(outcomes(judged)).as("%s", judged).containsExactly(Outcome.FEW_KICKS);
  }

  /** What a kick would have looked like with an effect. */
  private static Kick through(FittedModel simple, int k, Effect effect) {
    double[] own = simple.solution().own(k);
    EffectKick term = simple.kick(k);
    ExtendedTrajectory plain = term.path(own, simple.solution().state());
    ExtendedTrajectory changed =
        ExtendedTrajectory.flat(
            simple.solution().state().flat(),
            MotionEffects.of(List.of((WornRegion) effect)),
            0,
            own[4],
            own[0],
            own[1],
            own[2],
            own[3]);
    double[] a = new double[3];
    double[] b = new double[3];
    return MovedBall.moved(
        term.record().kick(),
        (t, xy) -> {
          plain.positionAt(t, a);
          changed.positionAt(t, b);
          xy[0] += b[0] - a[0];
          xy[1] += b[1] - a[1];
        });
  }

  /** How long a kick is seen after the middle of a patch, s; the longer, the better its friction shows. */
  private static double timeAfter(FittedModel simple, int k, Effect patch) {
    if (patch == null) {
      return 0;
    }
    KickRecord kick = simple.kick(k).record();
    double x = 0.5 * (patch.value("region_x0") + patch.value("region_x1"));
    double y = 0.5 * (patch.value("region_y0") + patch.value("region_y1"));
    int nearest = 0;
    for (int i = 0; i < kick.size(); i++) {
      boolean nearer =
          Math.hypot(kick.x(i) - x, kick.y(i) - y)
              < Math.hypot(kick.x(nearest) - x, kick.y(nearest) - y);
      nearest = nearer ? i : nearest;
    }
    return kick.time(kick.size() - 1) - kick.time(nearest);
  }

  /** A square metre on the way of a kick that no other kick comes near to; null when there is none. */
  private static Effect patchOf(FittedModel simple, int k) {
    KickRecord kick = simple.kick(k).record();
    for (int i = 0; i < kick.size(); i += 5) {
      if (kick.time(i) < kick.kick().time() + 0.7) {
        continue;
      }
      double x = kick.x(i);
      double y = kick.y(i);
      boolean alone = true;
      for (int other = 0; other < simple.kickCount(); other++) {
        KickRecord o = simple.kick(other).record();
        for (int j = 0; other != k && j < o.size(); j++) {
          alone &= Math.abs(o.x(j) - x) > 0.45 || Math.abs(o.y(j) - y) > 0.45;
        }
      }
      if (alone) {
        return new WornRegion(0.5, x - 0.4, x + 0.4, y - 0.4, y + 0.4);
      }
    }
    return null;
  }

  /** One kick runs a curve: a slope would have to be steep for it and level for all others. */
  @Test
  void whatHelpsOneKickAndHarmsTheOthersIsNoCause() {
    FittedField field = FittedField.flats();
    List<KickRecord> kicks = new ArrayList<>(field.fitter().kicks());
    kicks.set(
        2,
        field.again(
            MovedBall.shifted(kicks.get(2).kick(), t -> 0.02 * Math.max(0, t) * Math.max(0, t)),
            KickKind.FLAT));
    List<Judgement> judged = judge(field, kicks, new FieldSlope(0, 0));
    assertThat(judged.get(0).evidence()).isGreaterThan(30);
    assertThat(judged.get(0).outcome()).as("%s", judged).isIn(Outcome.FEW_KICKS, Outcome.UNSTEADY);
  }

  /** Kicks differ, too, where a ball bobs before it slides, and a resistance in the slide looks like backspin: only what is larger is a kicker's. */
  @Test
  void aSpinThatTheBallItselfMayBeHasNoName() {
    FittedField weak = FittedField.flats("kick_spin:fraction=-0.05,scatter=0.006");
    Judgement little = judge(weak, new KickSpin(0)).get(0);
    assertThat(little.outcome()).isEqualTo(Outcome.BALL_ITSELF);
    assertThat(little.isName()).isFalse();
    FittedField clear = FittedField.flats("kick_spin:fraction=-0.2,scatter=0.1");
    assertThat(judge(clear, new KickSpin(0)).get(0).isName()).isTrue();
  }

  /** Each ball rolls more or less far by chance, and the carpet resists its turning as much while it slides: which looks like another backspin in each kick. */
  @Test
  void aResistanceInTheSlideThatDiffersFromKickToKickIsNoSpin() {
    BallPhysics resisting =
        FittedField.SOUND
            .physics()
            .withExtra(
                new ExtraLaw() {
                  @Override
                  public double rollingFactor(BallMoment m) {
                    return 1 + 0.3 * Math.sin(7.3 * (m.sessionTime() - m.sinceKick()));
                  }

                  @Override
                  public double resistedTurning(BallMoment m) {
                    return 1;
                  }
                });
    FittedField field =
        FittedField.of(
            FittedField.SOUND.withScenario(ScenarioKind.FLAT, 20).withPhysics(resisting));
    Judgement judged = judge(field, new KickSpin(0), new RollScatter(0)).get(0);
    assertThat(judged.scatter()).as("%s", judged).isGreaterThan(0.015);
    assertThat(judged.outcome()).as("%s", judged).isEqualTo(Outcome.BALL_ITSELF);
  }

  /** What is not known of the ball is the same in all kicks: spin that differs from kick to kick is the kicker's even if its mean is near zero. */
  @Test
  void aSpinThatScattersIsTheKickers() {
    FittedField field = FittedField.flats("kick_spin:fraction=0.01,scatter=0.03");
    Judgement judged = judge(field, new KickSpin(0)).get(0);
    assertThat(judged.outcome()).as("%s", judged).isEqualTo(Outcome.NAMED);
  }

  /** Chips that lose the more speed the faster they land seem to have spin that follows their speed. The flat kicks beside them have none, which hides that. */
  @Test
  void valuesOfOneKindOfKickAreExaminedByThemselves() {
    FittedField field =
        FittedField.of(
            FittedField.SOUND
                .withScenario(ScenarioKind.MIXED, 24)
                .withEffects("unnamed_impact_speed:slope=0.03"));
    Judgement spin = judge(field, new KickSpin(0, 0, true)).get(0);
    assertThat(spin.follows()).as("%s", spin).isPresent();
    assertThat(spin.isName()).isFalse();
  }
}
