package fieldcal.diagnosis.hidden;

import fieldcal.ball.ChipModel;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.scenario.CalibrationScenario;
import fieldcal.vision.BallModels;
import fieldcal.vision.RobotId;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Draws one {@link HiddenCase}. What does not depend on the effect is drawn from streams of its own, so that a change of the strengths leaves the fields as they are. */
final class CaseDraw {
  /** 1/(1+β) of a solid sphere: where the physics of spin and carpet act, the ball is a golf ball. */
  private static final double SOLID = 1 / 1.4;

  private final long seed;
  private final RandomStream kind;
  private final RandomStream place;
  private final RandomStream physics;

  CaseDraw(long seed) {
    this.seed = seed;
    kind = RandomStream.of(seed, "hidden: what");
    place = RandomStream.of(seed, "hidden: where");
    physics = RandomStream.of(seed, "hidden: ball");
  }

  HiddenCase draw() {
    Category category = category();
    List<SimulatedEffect> effects = EffectChoice.pick(category, kind);
    ScenarioKind scenario = EffectChoice.scenario(effects, kind);
    List<SimulatedEffect> all = EffectChoice.withCompanions(effects, scenario, kind);
    SimulationSettings bare = world(all, scenario);
    List<RobotId> kickers = kickers(bare);
    RandomStream strength = RandomStream.of(seed, "hidden: how much");
    List<EffectSetting> hidden = new ArrayList<>();
    for (SimulatedEffect effect : all) {
      hidden.add(new EffectDraw(strength, bare, kickers, all.size() > 1).setting(effect));
    }
    return hidden(category, bare, hidden, kickers);
  }

  /** The same field with something else hidden in it. */
  HiddenCase with(Category category, ScenarioKind scenario, List<EffectSetting> hidden) {
    SimulationSettings bare = world(hidden.stream().map(EffectSetting::effect).toList(), scenario);
    return hidden(category, bare, hidden, kickers(bare));
  }

  private HiddenCase hidden(
      Category category,
      SimulationSettings bare,
      List<EffectSetting> hidden,
      List<RobotId> kickers) {
    boolean biased = hidden.stream().anyMatch(e -> e.effect() == SimulatedEffect.ROBOT_KICK_BIAS);
    boolean commands = place.happens(0.6) || biased;
    return new HiddenCase(seed, category, bare.withEffects(hidden), hidden, commands, kickers);
  }

  private SimulationSettings world(List<SimulatedEffect> effects, ScenarioKind scenario) {
    boolean cameras = effects.stream().anyMatch(EffectChoice::needsSeveralCameras);
    FieldSize field = place.happens(0.5) ? FieldSize.DIVISION_A : FieldSize.DIVISION_B;
    CameraSettings rig = rig(cameras);
    return SimulationSettings.DEFAULT
        .withSeed(seed)
        .withField(field)
        .withCameras(rig)
        .withScenario(scenario(scenario))
        .withNuisance(place.happens(0.8) ? Nuisance.TYPICAL : Nuisance.NONE)
        .withPhysics(physics(effects))
        .withPublishedModels(published());
  }

  private static List<RobotId> kickers(SimulationSettings world) {
    return new CalibrationScenario(world)
        .robots().stream().map(r -> r.id()).filter(id -> id.number() < 12).toList();
  }

  private Category category() {
    double u = kind.uniform(0, 1);
    return u < 0.46
        ? Category.SINGLE
        : u < 0.62
            ? Category.NULL
            : u < 0.72 ? Category.PAIR : u < 0.87 ? Category.MIXTURE : Category.UNNAMED;
  }

  private CameraSettings rig(boolean several) {
    int[] counts = {1, 1, 2, 2, 2, 2, 3, 4, 4, 4, 4, 4, 4, 5, 6, 7, 8, 8};
    int count = counts[place.below(counts.length)];
    if (several && count == 1) {
      count = 2;
    }
    double height = place.uniform(4, 6.5);
    // A single camera sees the corners at a flat angle; a lens with much negative distortion would
    // fold there.
    double distortion = place.uniform(count == 1 ? -0.03 : -0.08, 0.2);
    double noise = 1e-3 * 0.7 * Math.pow(3 / 0.7, place.uniform(0, 1));
    double rate = place.uniform(60, 78);
    return new CameraSettings(
        count,
        height,
        distortion,
        noise,
        1.75 * noise,
        0.008,
        rate,
        rate + place.uniform(0.2, 5),
        0.0215,
        0,
        place.uniform(0.4, 0.8));
  }

  private ScenarioSettings scenario(ScenarioKind what) {
    int kicks = place.happens(0.8) ? 12 + place.below(17) : 8 + place.below(25);
    double slowest = place.uniform(1.6, 2.6);
    double fastest = place.uniform(5, 6.5);
    double chipMin = Math.max(3, slowest);
    ScenarioSettings usual = ScenarioSettings.of(what, kicks);
    return new ScenarioSettings(
        what,
        kicks,
        slowest,
        fastest,
        chipMin,
        fastest,
        place.uniform(0.6, 0.95),
        place.uniform(0.2, 0.9),
        usual.teamSize(),
        usual.minutes(),
        usual.yellow(),
        usual.blue(),
        usual.manner());
  }

  private BallPhysics physics(List<SimulatedEffect> effects) {
    boolean golfBall = effects.stream().anyMatch(EffectChoice::actsOnTheBall);
    boolean spun = effects.contains(SimulatedEffect.BOUNCE_SPIN_COUPLING);
    double accSlide = -physics.uniform(2.4, 3.8);
    double accRoll = -physics.uniform(0.18, 0.42);
    double kSwitch = physics.uniform(0.58, 0.75);
    // Spin of a bounce's own making must differ from hop to hop for the coupling to be seen: small
    // losses.
    double first = spun ? physics.uniform(0.85, 0.95) : physics.uniform(0.65, 0.85);
    double other = spun ? physics.uniform(0.85, 0.93) : physics.uniform(0.85, 0.97);
    double up = physics.uniform(0.45, 0.6);
    return BallPhysics.ideal(accSlide, accRoll, golfBall ? SOLID : kSwitch, first, other, up);
  }

  private BallModels published() {
    ChipModel chip = ChipModel.typical();
    String text =
        String.format(
            Locale.ROOT,
            "straight_two_phase { acc_slide: %.4f acc_roll: %.4f k_switch: %.4f }%nchip_fixed_loss"
                + " { damping_xy_first_hop: %.4f damping_xy_other_hops: %.4f damping_z: %.4f }",
            -place.uniform(2.4, 3.8),
            -place.uniform(0.2, 0.4),
            place.uniform(0.6, 0.72),
            place.uniform(0.65, 0.85),
            Math.min(0.98, chip.dampingXyOtherHops() * place.uniform(0.92, 1.05)),
            place.uniform(0.42, 0.6));
    return BallModels.fromFile(text.getBytes(StandardCharsets.UTF_8));
  }
}
