package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulatedEffect;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * One case with its judgement; small, since a study keeps hundreds.
 *
 * @param hidden the case
 * @param visibility of each hidden effect alone
 * @param judgement what the diagnosis is worth; empty when it did not come to an end
 * @param said what the diagnosis said
 * @param rmsBefore residual of kicks held out of the simple model, in units of the noise
 * @param rmsAfter the same of the extended model
 * @param times of the stages
 * @param failure what was thrown
 */
public record StudiedCase(
    HiddenCase hidden,
    List<Visibility> visibility,
    Optional<Judgement> judgement,
    String said,
    double rmsBefore,
    double rmsAfter,
    HiddenRun.Times times,
    Optional<Throwable> failure) {

  /** A bias of a kicker that is that many standard errors large counts as visible as a residual of one σ. */
  private static final double BIAS_UNIT = 6;

  /** Copies the list. {@inheritDoc} */
  public StudiedCase {
    visibility = List.copyOf(visibility);
  }

  /**
   * Measures how well each effect of a case can be seen.
   *
   * @param hidden the case
   * @return in the order of the effects
   */
  public static List<Visibility> visibility(HiddenCase hidden) {
    List<Visibility> all = new ArrayList<>();
    for (EffectSetting effect : hidden.hidden()) {
      if (effect.effect() == SimulatedEffect.ROBOT_KICK_BIAS) {
        all.add(biasVisibility(hidden, effect));
        continue;
      }
      Optional<EffectSetting> needed =
          EffectChoice.companion(effect.effect())
              .flatMap(c -> hidden.hidden().stream().filter(e -> e.effect() == c).findFirst());
      all.add(
          needed.isEmpty()
              ? Visibility.of(hidden, List.of(effect))
              : Visibility.of(hidden, List.of(needed.get(), effect))
                  .beyond(Visibility.of(hidden, List.of(needed.get()))));
    }
    return all;
  }

  /** A bias moves no ball off its path; it is seen in the mean over the robot's kicks, which scatter. */
  private static Visibility biasVisibility(HiddenCase hidden, EffectSetting bias) {
    int kicks = hidden.settings().scenario().kicks() / hidden.kickers().size();
    double speed = 0.01 * bias.number("percent") / hidden.settings().kickBehaviour().speedScatter();
    double yaw = bias.number("yaw") / hidden.settings().kickBehaviour().directionScatter();
    double errors = Math.hypot(speed, yaw) * Math.sqrt(kicks);
    return new Visibility(errors / BIAS_UNIT, errors / BIAS_UNIT, kicks);
  }

  /**
   * Runs a case.
   *
   * @param hidden the case
   * @param visibility of each of its effects
   * @return what came of it
   */
  public static StudiedCase of(HiddenCase hidden, List<Visibility> visibility) {
    try {
      HiddenRun run = HiddenRun.of(hidden, step -> {});
      Answer a = run.answer();
      double noise = a.base().noiseMm();
      return new StudiedCase(
          hidden,
          visibility,
          Optional.of(Judge.judge(hidden, visibility, run.truth(), a)),
          Judgement.said(a),
          a.base().holdoutRmsMm() / noise,
          a.extended().holdoutRmsMm() / noise,
          run.times(),
          Optional.empty());
    } catch (RuntimeException failure) {
      double none = Double.NaN;
      return new StudiedCase(
          hidden,
          visibility,
          Optional.empty(),
          failure.toString(),
          none,
          none,
          new HiddenRun.Times(none, none, none),
          Optional.of(failure));
    }
  }

  /**
   * Whether a cause without a name is hidden that could be seen.
   *
   * @return false when there is none or it is invisible
   */
  public boolean shown() {
    for (int i = 0; i < visibility.size(); i++) {
      if (!hidden.hidden().get(i).effect().catalogued()
          && visibility.get(i).level() != Visibility.Class.INVISIBLE) {
        return true;
      }
    }
    return false;
  }

  /**
   * How visible the least visible of its effects is.
   *
   * @return the class; invisible without effects
   */
  public Visibility.Class level() {
    return visibility.stream()
        .map(Visibility::level)
        .max(Enum::compareTo)
        .orElse(Visibility.Class.INVISIBLE);
  }

  /**
   * What came out.
   *
   * @return the outcome; empty when the diagnosis did not come to an end
   */
  public Optional<Judgement.Outcome> outcome() {
    return judgement.map(Judgement::outcome);
  }

  /**
   * Whether it is what may be asked for: silence is right where there is nothing to see.
   *
   * @return false for failures, for wrong names, and for clear or marginal effects that were missed
   */
  public boolean asItShouldBe() {
    if (judgement.isEmpty()) {
      return false;
    }
    return switch (judgement.get().outcome()) {
      case RIGHT, TIE -> true;
      case WRONG -> false;
      case MISSED, UNEXPLAINED ->
          !hidden.hidden().isEmpty()
              && judgement.get().complete()
              && !(shown() && judgement.get().outcome() == Judgement.Outcome.MISSED);
    };
  }

  /**
   * The names that were given.
   *
   * @return ids joined by +, in alphabetical order; "adequate" or "unexplained" without any
   */
  public String names() {
    if (judgement.isEmpty()) {
      return "failed";
    }
    List<Named> causes = new ArrayList<>(judgement.get().wrong());
    judgement.get().found().forEach(f -> f.cause().ifPresent(causes::add));
    if (causes.isEmpty()) {
      return judgement.get().verdict().replaceAll("model_|_structure", "");
    }
    return causes.stream().map(c -> c.effect().id()).sorted().collect(Collectors.joining("+"));
  }

  /** One line: seed, outcome, what was hidden, what was said. */
  @Override
  public String toString() {
    String seen =
        visibility.stream()
            .map(v -> String.format(Locale.ROOT, "%.2f", v.gain()))
            .collect(Collectors.joining(" and "));
    String strengths =
        judgement.stream()
            .flatMap(j -> j.found().stream())
            .flatMap(f -> f.strength().stream())
            .map(s -> String.format(Locale.ROOT, "%.1f se, %.0f %%", s.sigmas(), s.percent()))
            .collect(Collectors.joining("; "));
    return String.format(
        Locale.ROOT,
        "%d %s %s%s -> %s [%s; held out %.2f -> %.2f noise; %.1f + %.1f + %.1f s]",
        hidden.seed(),
        outcome().map(Enum::name).orElse("FAILED"),
        hidden.hidden().isEmpty()
            ? ""
            : level().name().toLowerCase(Locale.ROOT) + " [gain " + seen + " σ] ",
        hidden,
        said,
        strengths,
        rmsBefore,
        rmsAfter,
        times.simulation(),
        times.calibration(),
        times.diagnosis());
  }
}
