package fieldcal.simulation;

import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.vision.BallModels;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * What is to be simulated. Start from {@link #DEFAULT} and change it with the with-methods.
 *
 * @param scenario what the robots do
 * @param seed of all random numbers
 * @param field the field
 * @param physics laws of the ball without effects
 * @param kickBehaviour how kicks differ from commands without effects
 * @param cameras how cameras hang
 * @param nuisance what goes wrong in every recording
 * @param publishedModels the ball models in the geometry messages
 * @param effects what is wrong with this field
 * @param installed the cameras one by one, by id; empty = drawn as {@code cameras} and {@code nuisance} say. Of {@code cameras} then only the plane that vision assumes and the exposure count, of {@code
 *     nuisance} nothing
 */
public record SimulationSettings(
    ScenarioSettings scenario,
    long seed,
    FieldSize field,
    BallPhysics physics,
    KickBehaviour kickBehaviour,
    CameraSettings cameras,
    Nuisance nuisance,
    BallModels publishedModels,
    List<EffectSetting> effects,
    List<InstalledCamera> installed) {

  /** Models that are a little off, as on every field before it is calibrated. */
  public static final BallModels USUAL_MODELS =
      BallModels.fromFile(
          """
          straight_two_phase { acc_slide: -3.0 acc_roll: -0.26 k_switch: 0.64 }
          chip_fixed_loss { damping_xy_first_hop: 0.8 damping_xy_other_hops: 0.85 damping_z: 0.47 }
          """
              .getBytes(StandardCharsets.UTF_8));

  /** Twelve flat kicks on a Division A field with four cameras, ideal physics, seed 1. */
  public static final SimulationSettings DEFAULT =
      new SimulationSettings(
          ScenarioSettings.of(ScenarioKind.FLAT, 12),
          1,
          FieldSize.DIVISION_A,
          BallPhysics.IDEAL,
          KickBehaviour.DEFAULT,
          CameraSettings.DEFAULT,
          Nuisance.TYPICAL,
          USUAL_MODELS,
          List.of(),
          List.of());

  /**
   * Copies the list and checks that effects name cameras that exist. {@inheritDoc}
   *
   * @throws NullPointerException when a component is null
   * @throws IllegalArgumentException when an effect names a camera that does not exist
   */
  public SimulationSettings {
    Objects.requireNonNull(scenario, "scenario");
    Objects.requireNonNull(field, "field");
    Objects.requireNonNull(physics, "physics");
    Objects.requireNonNull(kickBehaviour, "kickBehaviour");
    Objects.requireNonNull(nuisance, "nuisance");
    Objects.requireNonNull(publishedModels, "publishedModels");
    effects = List.copyOf(effects);
    installed = List.copyOf(installed);
    if (installed.isEmpty()) {
      requireCounted(effects, cameras.count());
    } else {
      requireInstalled(effects, installed);
    }
  }

  private static void requireCounted(List<EffectSetting> effects, int count) {
    for (EffectSetting effect : effects) {
      String camera = effect.values().getOrDefault("camera", "0");
      if (!camera.equals("all") && Double.parseDouble(camera) >= count) {
        throw new IllegalArgumentException(
            effect + ": there are only " + count + " cameras, counted from 0");
      }
    }
  }

  private static void requireInstalled(
      List<EffectSetting> effects, List<InstalledCamera> installed) {
    List<Integer> ids = installed.stream().map(InstalledCamera::id).sorted().toList();
    if (ids.stream().distinct().count() < ids.size()) {
      throw new IllegalArgumentException("two cameras have one id: " + ids);
    }
    for (EffectSetting effect : effects) {
      String camera = effect.values().get("camera");
      if (camera != null
          && !camera.equals("all")
          && !ids.contains((int) Double.parseDouble(camera))) {
        throw new IllegalArgumentException(effect + ": the cameras are " + ids);
      }
    }
  }

  /**
   * Another scenario.
   *
   * @param newScenario what the robots do
   * @return the changed settings
   */
  public SimulationSettings withScenario(ScenarioSettings newScenario) {
    return new SimulationSettings(
        newScenario,
        seed,
        field,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Another scenario with a number of kicks.
   *
   * @param kind what the robots do
   * @param kicks how many kicks
   * @return the changed settings
   */
  public SimulationSettings withScenario(ScenarioKind kind, int kicks) {
    return withScenario(ScenarioSettings.of(kind, kicks));
  }

  /**
   * Another seed.
   *
   * @param newSeed of all random numbers
   * @return the changed settings
   */
  public SimulationSettings withSeed(long newSeed) {
    return new SimulationSettings(
        scenario,
        newSeed,
        field,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Another field.
   *
   * @param newField its size
   * @return the changed settings
   */
  public SimulationSettings withField(FieldSize newField) {
    return new SimulationSettings(
        scenario,
        seed,
        newField,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Other laws of the ball.
   *
   * @param newPhysics the laws
   * @return the changed settings
   */
  public SimulationSettings withPhysics(BallPhysics newPhysics) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        newPhysics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Other kickers.
   *
   * @param behaviour how kicks differ from commands
   * @return the changed settings
   */
  public SimulationSettings withKickBehaviour(KickBehaviour behaviour) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        behaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Other cameras.
   *
   * @param newCameras how they hang
   * @return the changed settings
   */
  public SimulationSettings withCameras(CameraSettings newCameras) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        kickBehaviour,
        newCameras,
        nuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Other trouble.
   *
   * @param newNuisance what goes wrong
   * @return the changed settings
   */
  public SimulationSettings withNuisance(Nuisance newNuisance) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        kickBehaviour,
        cameras,
        newNuisance,
        publishedModels,
        effects,
        installed);
  }

  /**
   * Other published models.
   *
   * @param models in the geometry messages
   * @return the changed settings
   */
  public SimulationSettings withPublishedModels(BallModels models) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        models,
        effects,
        installed);
  }

  /**
   * Other effects.
   *
   * @param newEffects instead of the present ones
   * @return the changed settings
   */
  public SimulationSettings withEffects(List<EffectSetting> newEffects) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        newEffects,
        installed);
  }

  /**
   * Cameras that hang already.
   *
   * @param newInstalled the cameras; empty = drawn
   * @return the changed settings
   */
  public SimulationSettings withInstalled(List<InstalledCamera> newInstalled) {
    return new SimulationSettings(
        scenario,
        seed,
        field,
        physics,
        kickBehaviour,
        cameras,
        nuisance,
        publishedModels,
        effects,
        newInstalled);
  }

  /**
   * The cameras' ids.
   *
   * @return ascending where drawn, else in the order of {@code installed}
   */
  public List<Integer> cameraIds() {
    return installed.isEmpty()
        ? IntStream.range(0, cameras.count()).boxed().toList()
        : installed.stream().map(InstalledCamera::id).toList();
  }

  /**
   * Other effects, as on the command line.
   *
   * @param newEffects each {@code id:name=value,name=value}
   * @return the changed settings
   * @throws IllegalArgumentException when one cannot be read
   */
  public SimulationSettings withEffects(String... newEffects) {
    return withEffects(List.of(newEffects).stream().map(EffectSetting::parse).toList());
  }
}
