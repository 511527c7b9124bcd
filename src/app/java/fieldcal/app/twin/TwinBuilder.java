package fieldcal.app.twin;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CommandedKick;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.limits.LimitsOutcome;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.wording.EffectName;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import fieldcal.diagnosis.Cause;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectFields;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.learned.LearnedTerm;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.MovementEffect;
import fieldcal.movement.TeamLimits;
import fieldcal.movement.TurnLimits;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.KickBehaviour.SpinTable;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.CameraSettings.Exposure;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.imaging.TabulatedError;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.Region;
import fieldcal.simulation.physics.TabulatedLaw;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.FieldGeometry;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Makes a twin of what a diagnosis, the frames and the movement of the robots tell. */
final class TwinBuilder {
  /** Spins that kickers give. */
  private static final List<String> SPINS = List.of("kick_spin", "side_spin");

  /** Another effect of the kicker. All of them become its settings. */
  private static final String BIAS = "robot_kick_bias";

  private final DiagnosisOutcome diagnosis;
  private final FieldRecording field;
  private final LimitsOutcome limits;
  private final List<String> notes = new ArrayList<>();

  TwinBuilder(DiagnosisOutcome diagnosis, FieldRecording field, LimitsOutcome limits) {
    this.diagnosis = diagnosis;
    this.field = field;
    this.limits = limits;
  }

  Twin build() throws InputException {
    CalibrationOutcome calibration = diagnosis.calibration();
    String logs = calibration.logs().stream().map(Path::toString).collect(Collectors.joining(", "));
    FieldGeometry geometry =
        calibration
            .data()
            .geometry()
            .orElseThrow(
                () -> new InputException(logs + ": no geometry; a twin needs to know its cameras"));
    Map<Integer, CameraCalibration> published = CameraStudy.published(field);
    requireCameras(logs, published);
    CameraStudy study = new CameraStudy(field);
    List<InstalledCamera> cameras = study.cameras(published);
    if (cameras.isEmpty()) {
      throw new InputException(logs + ": no camera sent enough frames to tell its rate");
    }
    ExtendedModel model = diagnosis.diagnosis().model();
    SimulationSettings base = SimulationSettings.DEFAULT;
    Exposure exposure = study.together() ? Exposure.TOGETHER : Exposure.FREE;
    CameraSettings vision = base.cameras().withCount(Math.min(8, cameras.size()));
    List<CommandedKick> commanded = CommandedKick.of(calibration, diagnosis.diagnosis().kicks());
    SimulationSettings settings =
        base.withField(fieldOf(geometry))
            .withPhysics(physics(model))
            .withKickBehaviour(new KickerStudy(commanded, notes).behaviour(scatters()))
            .withCameras(vision.withExposure(exposure))
            .withNuisance(Nuisance.NONE)
            .withPublishedModels(calibration.data().published())
            .withScenario(
                base.scenario().withLimits(limitsOf(limits.yellow()), limitsOf(limits.blue())))
            .withInstalled(cameras);
    settings = withEffects(settings, model);
    TwinWords.unexplained(diagnosis.diagnosis().unexplained()).ifPresent(notes::add);
    notes.addAll(study.notes());
    return new Twin(calibration.logs().stream().map(Path::toString).toList(), settings, notes);
  }

  /** One calibration of each camera, and a place of each. */
  private void requireCameras(String logs, Map<Integer, CameraCalibration> published)
      throws InputException {
    for (int id : field.calibration().data().streams().keySet()) {
      if (!published.containsKey(id)) {
        throw new InputException(
            logs
                + ": camera "
                + id
                + " has no calibration in the last geometry; make a twin of recordings with one"
                + " geometry");
      }
      try {
        fieldcal.camera.Camera.of(published.get(id));
      } catch (IllegalArgumentException e) {
        throw new InputException(
            logs + ", camera " + id + ": " + e.getMessage() + "; a twin needs to know where it is");
      }
    }
  }

  private static FieldSize fieldOf(FieldGeometry g) {
    return new FieldSize(g.length(), g.width(), g.boundaryWidth(), g.goalWidth(), g.goalDepth());
  }

  /** Whether the twin's kickers have it. */
  static boolean isSpin(Effect effect) {
    return SPINS.contains(effect.id());
  }

  private BallPhysics physics(ExtendedModel model) {
    FlatModel flat = model.flat().orElse(FlatModel.typical());
    ChipModel chip = model.chip().orElse(ChipModel.typical());
    double roll = flat.accRoll();
    if (model.flat().isEmpty()) {
      roll = chip.accRoll();
      notes.add("No flat kick was recorded: sliding and the switch to rolling have usual values.");
    }
    if (model.chip().isEmpty()) {
      notes.add("No chip was recorded: bounces have usual values.");
    }
    return BallPhysics.ideal(
        flat.accSlide(),
        roll,
        flat.kSwitch(),
        chip.dampingXyFirstHop(),
        chip.dampingXyOtherHops(),
        chip.dampingZ());
  }

  private Map<String, Spin> scatters() {
    Map<String, Spin> spins = new LinkedHashMap<>();
    for (Effect effect : diagnosis.diagnosis().model().effects()) {
      if (effect.differsFromKickToKick()) {
        double scatter =
            diagnosis.diagnosis().causes().stream()
                .filter(c -> c.effect().id().equals(effect.id()))
                .mapToDouble(Cause::scatter)
                .findFirst()
                .orElse(0);
        spins.put(effect.id(), new Spin(effect, scatter));
      }
    }
    return spins;
  }

  private SimulationSettings withEffects(SimulationSettings settings, ExtendedModel model) {
    List<EffectSetting> effects = new ArrayList<>();
    BallPhysics physics = settings.physics();
    List<SpinTable> spins = new ArrayList<>();
    Map<Integer, CameraErrors> errors = new LinkedHashMap<>();
    double[] reach = {settings.field().length() / 2, settings.field().width() / 2};
    for (Effect effect : model.effects()) {
      if (isOfMissingCamera(effect, settings.installed())) {
        notes.add("The twin has no " + EffectName.of(effect) + ": it has no such camera.");
      } else if (effect instanceof LearnedTerm term) {
        switch (term.actsOn()) {
          case "kick" -> spins.add(LearnedTables.spin(term));
          case "measurement" -> {
            int camera = term.camera().orElseThrow();
            double[] view = reach(settings, camera, reach);
            Optional<TabulatedError> error = LearnedTables.error(term, view);
            error.ifPresent(
                e -> errors.merge(camera, CameraErrors.NONE.withTable(e), CameraErrors::plus));
            if (error.isEmpty()) {
              notes.add(
                  "The simulator cannot have "
                      + EffectName.of(effect)
                      + ": its cameras' time stamps do not depend on the speed of the ball.");
            }
          }
          default -> {
            for (TabulatedLaw law : LearnedTables.laws(term, reach)) {
              physics = physics.withExtra(law);
            }
          }
        }
      } else if (!isSpin(effect) && !effect.id().equals(BIAS) && !effect.isAbsent()) {
        add(effect, effects);
      }
    }
    List<InstalledCamera> cameras =
        settings.installed().stream()
            .map(c -> c.withErrors(errors.getOrDefault(c.id(), CameraErrors.NONE)))
            .map(c -> c.withLatency(Math.max(0, c.latency() + stampsLate(c.id(), effects))))
            .toList();
    return settings
        .withPhysics(physics)
        .withKickBehaviour(settings.kickBehaviour().withSpinTables(spins))
        .withInstalled(cameras)
        .withEffects(effects);
  }

  /** Whether it is an error of a camera that the twin has not. */
  private static boolean isOfMissingCamera(Effect effect, List<InstalledCamera> cameras) {
    return EffectFields.of(effect).get("camera") instanceof Number id
        && cameras.stream().noneMatch(c -> c.id() == id.intValue());
  }

  /** The measured delay counts from the time stamp; by so much that comes after the exposure, s. */
  private static double stampsLate(int camera, List<EffectSetting> effects) {
    return effects.stream()
        .filter(e -> e.effect() == SimulatedEffect.CAMERA_TIME_OFFSET && e.concernsCamera(camera))
        .mapToDouble(e -> 1e-3 * e.number("ms"))
        .sum();
  }

  private static double[] reach(SimulationSettings settings, int camera, double[] whole) {
    InstalledCamera c =
        settings.installed().stream().filter(i -> i.id() == camera).findFirst().orElseThrow();
    Region view = c.view();
    if (view.equals(Region.NONE)) {
      return whole;
    }
    double x = c.vision().derivedWorldX();
    double y = c.vision().derivedWorldY();
    return Double.isNaN(x)
        ? new double[] {2 * whole[0], 2 * whole[1]}
        : new double[] {
          Math.max(view.x1() - x, x - view.x0()), Math.max(view.y1() - y, y - view.y0())
        };
  }

  /** The simulator has the same causes under the same names; one whose strength it does not allow is left out and named. */
  private void add(Effect effect, List<EffectSetting> effects) {
    Map<String, String> values = new LinkedHashMap<>();
    EffectFields.of(effect).forEach((name, value) -> values.put(name, String.valueOf(value)));
    try {
      effects.add(new EffectSetting(SimulatedEffect.of(effect.id()), values));
    } catch (IllegalArgumentException e) {
      notes.add("The simulator cannot have " + EffectName.of(effect) + ": " + e.getMessage() + ".");
    }
  }

  private RobotLimits limitsOf(TeamLimits team) {
    RobotLimits usual = RobotLimits.DEFAULT;
    String name = team.team().label();
    TurnLimits turn = team.turning();
    RobotLimits result =
        new RobotLimits(
            of("velocity of " + name, " m/s", team.velocity(), usual.velocity()),
            of("acceleration of " + name, " m/s²", team.acceleration(), usual.acceleration()),
            of("braking of " + name, " m/s²", team.braking(), usual.braking()),
            of("rate of turning of " + name, " rad/s", turn.velocity(), usual.angularVelocity()),
            of(
                "angular acceleration of " + name,
                " rad/s²",
                turn.acceleration(),
                usual.angularAcceleration()),
            0,
            0);
    for (LimitDeviation d : team.deviations()) {
      double coefficient = Math.max(0, Math.min(0.95, d.coefficient()));
      result =
          d.effect() == MovementEffect.TORQUE_LIMITED
              ? result.withTorqueLoss(coefficient)
              : result.withDirectionality(coefficient);
    }
    return result;
  }

  private double of(String what, String unit, LimitEstimate estimate, double usual) {
    if (estimate.known() && estimate.reached() && estimate.value() > 0) {
      return estimate.value();
    }
    notes.add(
        "The recordings do not show the largest "
            + what
            + ": "
            + usual
            + unit
            + " is assumed, a usual value.");
    return estimate.known() ? Math.max(usual, estimate.value()) : usual;
  }
}
