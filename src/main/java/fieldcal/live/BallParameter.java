package fieldcal.live;

import fieldcal.kick.KickKind;
import fieldcal.vision.BallModels;
import java.util.Locale;
import java.util.Optional;

/** The parameters of the ball model that are watched. */
public enum BallParameter {
  /** Acceleration while the ball slides, m/s². */
  ACC_SLIDE(KickKind.FLAT, "accSlide", "m/s²", false),
  /** Acceleration while the ball rolls, m/s². */
  ACC_ROLL(KickKind.FLAT, "accRoll", "m/s²", false),
  /** Speed at the start of rolling as a fraction of the kick's. */
  K_SWITCH(KickKind.FLAT, "kSwitch", "", true),
  /** Horizontal velocity after the first impact of a chip as a fraction of that before. */
  DAMPING_XY_FIRST_HOP(KickKind.CHIP, "dampingXyFirstHop", "", true),
  /** The same at the later impacts. */
  DAMPING_XY_OTHER_HOPS(KickKind.CHIP, "dampingXyOtherHops", "", true),
  /** Vertical velocity after an impact as a fraction of that before. */
  DAMPING_Z(KickKind.CHIP, "dampingZ", "", false);

  private final KickKind kind;
  private final String modelName;
  private final String unit;
  private final boolean spinSensitive;

  BallParameter(KickKind kind, String modelName, String unit, boolean spinSensitive) {
    this.kind = kind;
    this.modelName = modelName;
    this.unit = unit;
    this.spinSensitive = spinSensitive;
  }

  /**
   * The model it belongs to.
   *
   * @return flat or chip
   */
  public KickKind kind() {
    return kind;
  }

  /**
   * The name in the model's record.
   *
   * @return for example {@code accRoll}
   */
  public String modelName() {
    return modelName;
  }

  /**
   * The name in files.
   *
   * @return for example {@code acc_roll}
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The unit.
   *
   * @return empty for a ratio
   */
  public String unit() {
    return unit;
  }

  /**
   * Whether spin that the ball had before it was kicked changes the value that a kick seems to show. A spinning ball slides longer or shorter, so that it rolls at another fraction of its speed, and leaves its
   * bounces faster or slower along the carpet; its accelerations while it slides or rolls, and its vertical speed after a bounce, are those of any other ball.
   *
   * <p>In matches four of five kicks come after dribbling or catching, so leaving them out would leave too few. So samples of such kicks count as well, unless their median differs from that of the others by more than 2.5 standard errors of the difference and by more than 5 % of the value. As long as there are too few of the others to compare with (fewer than five, or
   * than three where samples scatter so little that a difference of 5 % would show), they count, but begin a warning only where they are larger than published ({@link ParameterEstimate#maybeSpun}): a dribbler gives the ball backspin, which makes all of these parameters smaller.
   *
   * @return true for {@code kSwitch} and the horizontal dampings
   */
  public boolean spinSensitive() {
    return spinSensitive;
  }

  /**
   * Whether the parameter depends on the ball's speed on every carpet, although models have one value for all speeds: in ten matches of 2026 a ball rolled at −0.27 m/s² at 1 m/s and at −0.42 at 3 m/s. The samples of
   * slow and fast kicks then differ, and a change of the carpet shows much earlier when this dependence is taken out.
   *
   * @return true for {@code accRoll}
   */
  public boolean speedSensitive() {
    return this == ACC_ROLL;
  }

  /**
   * The value that a published model has.
   *
   * @param models the published models
   * @return empty when there is none of its kind
   */
  public Optional<Double> of(BallModels models) {
    return switch (this) {
      case ACC_SLIDE -> models.flat().map(m -> m.accSlide());
      case ACC_ROLL -> models.flat().map(m -> m.accRoll());
      case K_SWITCH -> models.flat().map(m -> m.kSwitch());
      case DAMPING_XY_FIRST_HOP -> models.chip().map(m -> m.dampingXyFirstHop());
      case DAMPING_XY_OTHER_HOPS -> models.chip().map(m -> m.dampingXyOtherHops());
      case DAMPING_Z -> models.chip().map(m -> m.dampingZ());
    };
  }

  /**
   * The parameter with a given name.
   *
   * @param id as {@link #id}
   * @return empty when there is none
   */
  public static Optional<BallParameter> ofId(String id) {
    for (BallParameter p : values()) {
      if (p.id().equals(id)) {
        return Optional.of(p);
      }
    }
    return Optional.empty();
  }
}
