package fieldcal.diagnosis.hidden;

import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * A simulated world with something to find in it, or nothing. The seed says it all.
 *
 * @param seed from which everything was drawn
 * @param category what kind of riddle it is
 * @param settings of the simulation, hidden effects included
 * @param hidden what is to be found
 * @param commands whether the diagnosis is told what the robots were told
 * @param kickers the two robots that kick
 */
public record HiddenCase(
    long seed,
    Category category,
    SimulationSettings settings,
    List<EffectSetting> hidden,
    boolean commands,
    List<RobotId> kickers) {

  /** Kinds of riddles. */
  public enum Category {
    /** One effect of the catalogue. */
    SINGLE,
    /** Nothing. */
    NULL,
    /** Two effects of the catalogue. */
    PAIR,
    /** Three or four effects of the catalogue. */
    MIXTURE,
    /** A cause that has no name, alone or beside one that has. */
    UNNAMED
  }

  /** Copies the lists. {@inheritDoc} */
  public HiddenCase {
    hidden = List.copyOf(hidden);
    kickers = List.copyOf(kickers);
  }

  /**
   * The case of a seed.
   *
   * @param seed any number
   * @return always the same for the same seed
   */
  public static HiddenCase draw(long seed) {
    return new CaseDraw(seed).draw();
  }

  /**
   * The field, the cameras and the ball of a seed with something given hidden in them; what the seed itself would hide does not matter.
   *
   * @param seed any number
   * @param scenario which kicks
   * @param effects what to hide, as on the command line; one at most
   * @return always the same for the same arguments
   */
  public static HiddenCase of(long seed, ScenarioKind scenario, String... effects) {
    return of(
        seed,
        effects.length == 0 ? Category.NULL : Category.SINGLE,
        scenario,
        Arrays.stream(effects).map(EffectSetting::parse).toList());
  }

  /** The same of any kind of riddle. */
  static HiddenCase of(
      long seed, Category category, ScenarioKind scenario, List<EffectSetting> hidden) {
    return new CaseDraw(seed).with(category, scenario, hidden);
  }

  /**
   * The effects that have a name.
   *
   * @return in the order of {@link #hidden}
   */
  public List<EffectSetting> named() {
    return hidden.stream().filter(e -> e.effect().catalogued()).toList();
  }

  /**
   * Whether it hides a cause without a name.
   *
   * @return true when one is among what is hidden
   */
  public boolean hidesUnnamed() {
    return hidden.stream().anyMatch(e -> !e.effect().catalogued());
  }

  /**
   * Whether an effect is hidden.
   *
   * @param id of the effect
   * @return true when it is one of them
   */
  public boolean hides(String id) {
    return hidden.stream().anyMatch(e -> e.effect().id().equals(id));
  }

  /**
   * The same world with other effects.
   *
   * @param effects instead of the hidden ones
   * @return the changed settings
   */
  public SimulationSettings settingsWith(List<EffectSetting> effects) {
    return settings.withEffects(effects);
  }

  /**
   * The ids of what is hidden.
   *
   * @return joined by +; "null" when nothing is
   */
  public String label() {
    return hidden.isEmpty()
        ? "null"
        : hidden.stream()
            .map(EffectSetting::effect)
            .map(SimulatedEffect::id)
            .collect(Collectors.joining("+"));
  }

  /** One line that says what is hidden where. */
  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s %s %d kicks, %.0f x %.0f m, %d cameras at %.1f m, distortion %.3f, noise %.2f mm%s%s:"
            + " %s",
        category.name().toLowerCase(Locale.ROOT),
        settings.scenario().kind().label(),
        settings.scenario().kicks(),
        settings.field().length(),
        settings.field().width(),
        settings.cameras().count(),
        settings.cameras().height(),
        settings.cameras().distortion(),
        1000 * settings.cameras().ballNoise(),
        settings.nuisance().falseBallRate() == 0 ? ", clean" : "",
        commands ? ", commands" : "",
        hidden.isEmpty()
            ? "nothing"
            : hidden.stream().map(EffectSetting::toString).collect(Collectors.joining(" + ")));
  }
}
