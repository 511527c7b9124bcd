package fieldcal.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.Parameter;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** What holds for every effect. Its test says which one, and how to predict with it. */
abstract class EffectContract {
  /** The design's table: ids and parameters; a region is spread over four. */
  private static final Map<String, List<String>> TABLE =
      Map.ofEntries(
          Map.entry("air_drag", List.of("cd")),
          Map.entry("magnus", List.of("cl")),
          Map.entry("kick_spin", List.of("fraction", "chips")),
          Map.entry("side_spin", List.of("fraction")),
          Map.entry("field_slope", List.of("percent", "direction")),
          Map.entry("carpet_nap", List.of("amplitude", "direction")),
          Map.entry("speed_dependent_roll", List.of("slope")),
          Map.entry(
              "worn_region", List.of("change", "region_x0", "region_x1", "region_y0", "region_y1")),
          Map.entry("camera_offset", List.of("x_mm", "y_mm", "camera")),
          Map.entry("camera_time_offset", List.of("ms", "camera")),
          Map.entry(
              "camera_pose_error",
              List.of("tilt_mrad", "axis", "height_mm", "shift_x_mm", "shift_y_mm", "camera")),
          Map.entry("camera_position_error", List.of("x_mm", "y_mm", "height_mm", "camera")),
          Map.entry("lens_distortion_error", List.of("delta", "camera")),
          Map.entry("ball_height_error", List.of("mm")),
          Map.entry("speed_dependent_restitution", List.of("slope")),
          Map.entry("bounce_spin_coupling", List.of("coefficient")),
          Map.entry("drift", List.of("percent_per_10min")),
          Map.entry("robot_kick_bias", List.of("percent", "yaw", "team", "robot")),
          Map.entry("clock_skew", List.of("ppm", "camera")),
          Map.entry("rolling_shutter", List.of("ms")),
          Map.entry("wind", List.of("speed", "direction")),
          Map.entry("slip_dependent_friction", List.of("slope")),
          Map.entry("camera_moved", List.of("x_mm", "y_mm", "at", "camera")),
          Map.entry("ball_changed", List.of("roll", "slide", "at")),
          Map.entry(
              "contact_impacts",
              List.of("reversed", "friction", "loss", "rolling", "lowest_hop_mm")),
          Map.entry("carpet_seam", List.of("loss", "turn", "normal", "distance")));

  /** Two flats and a chip, two cameras that are known in full and one of which nothing is. */
  private static final Arena ARENA =
      new Arena(
          -4,
          4,
          -3,
          3,
          new double[] {10, 30, 90},
          true,
          true,
          List.of(
              MeasurementEffectsTest.camera(0, -2),
              MeasurementEffectsTest.camera(1, 2),
              ObservedCamera.unknown(2, 3)),
          List.of(new RobotId(Team.YELLOW, 3), new RobotId(Team.BLUE, 7)));

  private static final Arena EMPTY =
      new Arena(0, 0, 0, 0, new double[] {10}, false, false, List.of(), List.of());

  /** The effect with all magnitudes away from zero and its place where the predictions feel it. */
  abstract Effect effect();

  /** Some predicted numbers, m. */
  abstract double[] predict(Effect effect);

  /** How the prediction must turn when the effect's world does; null when nothing turns. */
  Effect turned(double angle) {
    return null;
  }

  /** The prediction of {@link #predict} in a world turned by an angle, turned back. */
  double[] predictTurned(Effect effect, double angle) {
    throw new UnsupportedOperationException();
  }

  static List<String> ids() {
    return TABLE.keySet().stream().sorted().toList();
  }

  @Test
  void isInTheTableAndInTheCatalogue() {
    assertThat(TABLE).containsKey(effect().id());
    assertThat(effect().parameters().stream().map(Parameter::name))
        .isEqualTo(TABLE.get(effect().id()));
    Effect listed = EffectCatalogue.find(effect().id()).orElseThrow();
    assertThat(listed).hasSameClassAs(effect());
    assertThat(listed.isAbsent()).isTrue();
    assertThat(effect().isAbsent()).isFalse();
  }

  @Test
  void saysWhatItIs() {
    assertThat(effect().sentence()).endsWith(".").hasSizeBetween(20, 160);
    for (Parameter parameter : effect().parameters()) {
      assertThat(parameter.source()).isNotBlank();
      assertThat(parameter.isWithinBounds()).isTrue();
      assertThat(parameter.scale()).isLessThanOrEqualTo(parameter.max() - parameter.min());
    }
    for (String magnitude : effect().magnitudes()) {
      assertThat(effect().with(magnitude, 0).value(magnitude)).isZero();
    }
  }

  @Test
  void takesItsParametersBack() {
    double[] values = effect().parameters().stream().mapToDouble(Parameter::value).toArray();
    assertThat(effect().withParameters(values)).isEqualTo(effect());
    assertThatThrownBy(() -> effect().withParameters(new double[values.length + 1]))
        .isInstanceOf(IllegalArgumentException.class);
    values[0] = Double.NaN;
    assertThatThrownBy(() -> effect().withParameters(values))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void zeroIsAbsentToTheLastBit() {
    Effect none = effect().withNone();
    assertThat(none.isAbsent()).isTrue();
    assertThat(predict(none)).isEqualTo(predict(null));
    assertThat(predict(effect())).isNotEqualTo(predict(null));
  }

  @Test
  void everyMagnitudeShows() {
    Effect effect = effect();
    List<Effect> small = new ArrayList<>(effect.starts());
    if (small.isEmpty()) {
      for (Parameter p : effect.parameters()) {
        if (effect.magnitudes().contains(p.name())) {
          small.add(effect.withNone().with(p.name(), p.scale()));
        }
      }
    }
    assertThat(small).isNotEmpty();
    for (Effect one : small) {
      assertThat(one.isAbsent()).isFalse();
      assertThat(largest(predict(one), predict(null))).as(one.toString()).isGreaterThan(1e-6);
    }
  }

  @Test
  void changesSmoothlyWithItsMagnitudes() {
    Effect effect = effect();
    for (Parameter parameter : effect.parameters()) {
      if (parameter.estimated()) {
        smooth(effect, parameter);
        if (effect.starts().isEmpty()) {
          smooth(effect.withNone(), effect.withNone().parameters().get(index(effect, parameter)));
        }
      }
    }
  }

  @Test
  void candidatesAreAbsentAndWithinTheirBounds() {
    Effect effect = effect();
    assertThat(effect.canShowIn(ARENA)).isTrue();
    List<Effect> candidates = effect.candidates(ARENA);
    assertThat(candidates).isNotEmpty().doesNotHaveDuplicates().hasSizeLessThanOrEqualTo(40);
    for (Effect candidate : candidates) {
      assertThat(candidate).hasSameClassAs(effect);
      assertThat(candidate.isAbsent()).isTrue();
      assertThat(candidate.parameters()).allMatch(Parameter::isWithinBounds);
      if (candidate instanceof MeasurementEffect m) {
        assertThat(ARENA.cameras()).anyMatch(c -> m.isApplicable(c) && m.concerns(c));
      }
    }
    if (effect.canShowIn(EMPTY)) {
      assertThat(effect.candidates(EMPTY)).isNotEmpty();
    }
  }

  @Test
  void placesAreNotEstimatedAndChoicesAreMagnitudes() {
    Effect effect = effect();
    List<String> fixed =
        effect.parameters().stream().filter(p -> !p.estimated()).map(Parameter::name).toList();
    assertThat(fixed).containsAll(effect.places());
    assertThat(effect.choices()).isNotEmpty().doesNotHaveDuplicates();
    for (List<String> choice : effect.choices()) {
      assertThat(effect.magnitudes()).containsAll(choice);
    }
    for (Effect start : effect.starts()) {
      assertThat(start.isAbsent()).isFalse();
      assertThat(start.parameters()).allMatch(Parameter::isWithinBounds);
    }
    for (Effect companion : effect.companions()) {
      assertThat(companion.isAbsent()).isFalse();
      assertThat(companion.id()).isNotEqualTo(effect.id());
    }
  }

  private static int index(Effect effect, Parameter parameter) {
    return effect.parameters().indexOf(parameter);
  }

  private void smooth(Effect effect, Parameter parameter) {
    double[] coarse = slope(effect, parameter, 1e-2 * parameter.scale());
    double[] fine = slope(effect, parameter, 1e-3 * parameter.scale());
    double size = 0;
    for (double value : coarse) {
      size = Math.max(size, Math.abs(value));
    }
    for (int i = 0; i < fine.length; i++) {
      assertThat(fine[i]).as(parameter.name()).isEqualTo(coarse[i], within(2e-3 * size + 1e-5));
    }
  }

  /** Central difference per scale, m. */
  private double[] slope(Effect effect, Parameter parameter, double step) {
    double[] up = predict(effect.with(parameter.name(), parameter.value() + step));
    double[] down = predict(effect.with(parameter.name(), parameter.value() - step));
    double[] slope = new double[up.length];
    for (int i = 0; i < slope.length; i++) {
      slope[i] = (up[i] - down[i]) / (2 * step) * parameter.scale();
    }
    return slope;
  }

  @Test
  void turnsWithItsWorld() {
    for (double angle : new double[] {0.7, -2}) {
      Effect turned = turned(angle);
      if (turned != null) {
        assertThat(largest(predictTurned(turned, angle), predict(effect()))).isLessThan(1e-7);
      }
    }
  }

  static double largest(double[] a, double[] b) {
    assertThat(a).hasSameSizeAs(b);
    double largest = 0;
    for (int i = 0; i < a.length; i++) {
      largest = Math.max(largest, Math.abs(a[i] - b[i]));
    }
    return largest;
  }
}
