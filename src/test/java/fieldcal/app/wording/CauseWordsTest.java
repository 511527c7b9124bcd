package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.decision.Dependence;
import fieldcal.diagnosis.decision.Dependence.Form;
import fieldcal.diagnosis.decision.Dependence.Level;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.learned.Variable;
import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraMoved;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.CameraPositionError;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.measurement.ClockSkew;
import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.measurement.RollingShutter;
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
import fieldcal.effect.motion.RollScatter;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SlipDependentFriction;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.effect.motion.Wind;
import fieldcal.effect.motion.WornRegion;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class CauseWordsTest {
  private static final Diagnosis DIAGNOSIS = SampleDiagnosis.explained(8);
  private static final CauseWords WORDS = new CauseWords(DIAGNOSIS, SampleDiagnosis.observers());

  static Stream<Effect> catalogue() {
    return EffectCatalogue.all().stream();
  }

  @ParameterizedTest
  @MethodSource("catalogue")
  void everyEffectHasItsOwnWords(Effect absent) {
    Effect effect = SampleDiagnosis.present(absent);
    CauseText text = WORDS.of(effect, Map.of());
    assertThat(text.what()).isNotEqualTo(effect.sentence()).endsWith(".");
    assertThat(text.name()).doesNotContain("_").doesNotContain("null");
    assertThat(text.advice()).endsWith(".").doesNotStartWith("Use the extended model");
    assertThat(text.sentences()).doesNotContain("NaN", "null", "%s", "–", "_", "<", "  ");
    assertThat(Character.isUpperCase(text.what().charAt(0))).isTrue();
    assertThat(text.strength()).matches("[^_]*\\d[^_]*");
  }

  /** The first line says that the prediction gains nothing; no cause then advises to predict with the extended model. */
  @ParameterizedTest
  @MethodSource("catalogue")
  void nobodyIsSentToAModelThatPredictsNoBetter(Effect absent) {
    Effect effect = SampleDiagnosis.present(absent);
    Diagnosis doubted =
        SampleDiagnosis.leaving(DIAGNOSIS, DIAGNOSIS.base(), DIAGNOSIS.unexplained());
    CauseText text = new CauseWords(doubted, SampleDiagnosis.observers()).of(effect, Map.of());
    assertThat(VerdictText.caveat(doubted)).isPresent();
    assertThat(text.advice()).doesNotContain("extended model").endsWith(".");
  }

  @Test
  void noTwoEffectsHaveTheSameName() {
    List<String> names =
        EffectCatalogue.all().stream().map(Effect::id).map(EffectName::of).toList();
    assertThat(names).doesNotHaveDuplicates().hasSize(EffectCatalogue.all().size());
    assertThat(names).as("they are joined by or").noneMatch(n -> n.contains(" or "));
    assertThat(EffectName.of(new KickSpin(-0.2))).isEqualTo("backspin from the kicker");
    assertThat(EffectName.of("ball_of_wool")).isEqualTo("ball of wool");
  }

  /** Each magnitude, with what must be said of it and of its opposite. */
  static Stream<Arguments> magnitudes() {
    return Stream.of(
        Arguments.of(new AirDrag(0.47), "drag coefficient 0.47", "−0.47); a real drag"),
        Arguments.of(new Magnus(0.6), "0.60, a ball with topspin is pressed", "topspin is lifted"),
        Arguments.of(new KickSpin(0.25), "topspin: 25 %", "backspin: 25 %"),
        Arguments.of(
            new KickSpin(0.05, -0.35, true),
            "The kickers give chips 30 % backspin and flat kicks 5.0 % topspin",
            "The kickers give chips 30 % topspin and flat kicks 5.0 % backspin"),
        Arguments.of(new SideSpin(0.15), "15 % of the spin", "curves to the left"),
        Arguments.of(new SideSpin(0.15), "curves to the right", "mm to the left after 2 s"),
        Arguments.of(
            new FieldSlope(0.3, 0), "3.0 mm per metre towards the +x goal", "towards the −x goal"),
        Arguments.of(
            new CarpetNap(0.06, Math.PI / 2),
            "roll to the left (+y), direction 90° are braked 6.0 % more",
            "roll to the right (−y), direction −90° are braked 6.0 % more"),
        Arguments.of(
            new SpeedDependentRoll(0.05),
            "more than a slow one: by 0.050 m/s² for every m/s (0.330 m/s² at 1 m/s, 0.430",
            "less than a slow one: by 0.050 m/s²"),
        Arguments.of(
            new WornRegion(0.25, 2, 4.5, -1, 1),
            "Between x = 2 and 4.5 m and y = −1 and 1 m, on the side of the +x goal, the carpet"
                + " brakes 25 % more",
            "brakes 25 % less"),
        Arguments.of(
            new SpeedDependentRestitution(0.1),
            "lose more height than soft ones: an impact at 3 m/s leaves 38 %",
            "lose less height"),
        Arguments.of(
            new BounceSpinCoupling(0.12),
            "spin of a rolling ball, 12 % of its horizontal speed",
            "takes less speed"),
        Arguments.of(
            new Drift(12), "braked 12 % more (from 0.280 to 0.314 m/s²)", "braked 12 % less"),
        Arguments.of(
            new RobotKickBias(5, 0.02, Team.BLUE, 3),
            "Robot blue 3 kicks 5.0 % faster and 1.1° farther to the left than commanded",
            "5.0 % slower and 1.1° farther to the right"),
        Arguments.of(
            new RobotKickBias(5, 0.02, Team.BLUE, 3),
            "it kicks at 5.25 m/s, and a pass over 4 m arrives 80 mm too far to the left",
            "at 4.75 m/s"),
        Arguments.of(
            new Wind(0.8, 0), "moves at 0.80 m/s towards the +x goal", "towards the −x goal"),
        Arguments.of(
            new SlipDependentFriction(0.05),
            "grows by 5.0 % for every m/s with which the ball slips over the carpet (2.85 m/s² at 1"
                + " m/s of slip, 3.30",
            "falls by 5.0 %"),
        Arguments.of(
            new CarpetSeam(0.1, 0.05, Math.PI / 2, -2),
            "A seam of the carpet at y = −2 m takes 10 % of the speed across it and turns the path"
                + " by 2.9° to the left.",
            "adds 10 % of the speed across it and turns the path by 2.9° to the right"),
        Arguments.of(
            new BallChanged(0.12, -0.06, 750),
            "From 12.5 minutes into the session on, another ball is in play, which brakes 12 %"
                + " more when it rolls and brakes 6.0 % less when it slides.",
            "brakes 12 % less when it rolls and brakes 6.0 % more"),
        Arguments.of(
            new ContactImpacts(-0.2, 0.3, 0, 0, 10),
            "does not quite stop the slip of the ball's lowest point: 20 % of it stays",
            "reverses the slip of the ball's lowest point: 20 % of it comes back"),
        Arguments.of(
            new CameraMoved(12, -7, 45, 1),
            "Camera 1 was knocked: from 45 s into the session on, it reports everything 12 mm too"
                + " far towards the +x goal and 7.0 mm too far to the right (−y).",
            "12 mm too far towards the −x goal and 7.0 mm too far to the left (+y)"),
        Arguments.of(
            new LensDistortionError(0.012, LensDistortionError.ALL_CAMERAS),
            "Every camera's lens distortion is published 0.012 too large",
            "0.012 too small"),
        Arguments.of(
            new CameraOffset(21.2, 3.1, 1),
            "Camera 1 reports everything 21 mm too far towards the +x goal and 3.1 mm too far to"
                + " the left (+y)",
            "21 mm too far towards the −x goal and 3.1 mm too far to the right (−y)"),
        Arguments.of(
            new CameraOffset(21.2, 3.1, 101),
            "Camera 101 (camera 1, calibrated again) reports everything 21 mm too far towards",
            "towards the −x goal"),
        Arguments.of(
            new CameraTimeOffset(4.1, 0),
            "Camera 0's time stamps are 4.1 ms late. A ball at 6 m/s appears 25 mm behind",
            "4.1 ms early. A ball at 6 m/s appears 25 mm ahead of"),
        Arguments.of(
            new CameraPoseError(2, 0, 60, 0, 0, 1),
            "Camera 1 hangs 60 mm lower, and looks 2.0 mrad (0.11°) farther to the right (−y),"
                + " direction −90°, than its calibration says.",
            "hangs 60 mm higher, and looks 2.0 mrad (0.11°) farther to the left (+y), direction"
                + " 90°, than its calibration says."),
        Arguments.of(
            new CameraPoseError(0, 0, 0, 20, 0.9, 1),
            "hangs 20 mm farther towards the −x goal than its calibration",
            "towards the +x goal"),
        Arguments.of(
            new CameraPositionError(90, 0, 0, 1),
            "The position that vision publishes for camera 1 is 90 mm too far towards the +x goal",
            "towards the −x goal"),
        Arguments.of(
            new CameraPositionError(0, 0, 60, EffectParameters.ALL_CAMERAS),
            "The position that vision publishes for every camera is 60 mm too high",
            "60 mm too low"),
        Arguments.of(
            new LensDistortionError(0.012, 1), "published 0.012 too large", "0.012 too small"),
        Arguments.of(
            new BallHeightError(8.5),
            "8.5 mm higher than it is. It reports balls too near to",
            "8.5 mm lower than it is. It reports balls too far from"),
        Arguments.of(
            new ClockSkew(120, 1),
            "120 ppm fast, 72 ms in ten minutes. After ten minutes, a ball at 6 m/s appears 432"
                + " mm behind",
            "120 ppm slow"),
        Arguments.of(
            new RollingShutter(10), "the last row 10 ms after the first", "first row 10 ms after"),
        Arguments.of(new RollingShutter(10), "60 mm ahead of", "60 mm behind"));
  }

  @ParameterizedTest
  @MethodSource("magnitudes")
  void sizeAndSignAreSaid(Effect effect, String words, String opposite) {
    assertThat(WORDS.of(effect, Map.of()).sentences()).contains(words).doesNotContain(opposite);
    assertThat(WORDS.of(opposite(effect), Map.of()).sentences()).contains(opposite);
  }

  @Test
  void chanceHasWordsAndAdvice() {
    for (Effect effect : EffectCatalogue.unnamed()) {
      LearnedFinding found =
          new LearnedFinding(
              effect,
              "ground",
              List.of("kick"),
              OptionalInt.empty(),
              List.of(),
              0.12,
              Optional.empty(),
              new Gain(1, 10, 0.5, 1.5));
      assertThat(WORDS.of(found).sentences())
          .containsPattern("differs by (12 %|0\\.12 m/s²) from kick to kick")
          .contains("No model predicts it: ");
      assertThat(EffectName.of(effect)).endsWith("from kick to kick");
    }
  }

  private static Stream<Arguments> dependences() {
    Level low = new Level(66, 0, -0.12);
    Level high = new Level(250, 0, 0.1);
    double none = Double.NaN;
    return Stream.of(
        Arguments.of(
            new Dependence(Variable.SESSION_TIME, Form.STEP, 1, 186, 0.17, low, high, 0.97, 1e-5),
            "From 3.1 minutes into the session on, the rolling deceleration (acc_roll) is 17 %"
                + " higher. Check whether another ball"),
        Arguments.of(
            new Dependence(Variable.SESSION_TIME, Form.LINE, 1, none, 1e-3, low, high, 0.75, 1e-5),
            "The rolling deceleration (acc_roll) drifts during the session: it is 12 % below its"
                + " mean at minute 1.1 and 10 % above it at minute 4.2. Beyond that it differs by"
                + " 6.0 % from kick to kick, and nothing that was recorded says why. Check what"
                + " changed"),
        Arguments.of(
            new Dependence(Variable.SESSION_TIME, Form.CURVE, 4, none, none, low, high, 0.97, 1e-5),
            "follows the time since the session began in a smooth curve: it is lowest at minute"
                + " 1.1, 12 % below its mean, and highest at minute 4.2, 10 % above it. Check"
                + " what"),
        Arguments.of(
            new Dependence(
                Variable.SPEED,
                Form.LINE,
                1,
                none,
                0.05,
                new Level(2, 0, -0.1),
                new Level(6, 0, 0.1),
                0.97,
                1e-5),
            "changes steadily with the speed: it is 10 % below its mean at 2.0 m/s and 10 % above"
                + " it at 6.0 m/s. Record kicks that differ in nothing but the speed"),
        Arguments.of(
            new Dependence(
                Variable.PLACE,
                Form.CURVE,
                5,
                none,
                none,
                new Level(-2, 1, -0.1),
                new Level(3, -1, 0.1),
                0.97,
                1e-5),
            "lowest at x = −2.0 m, y = 1.0 m, 10 % below its mean"),
        Arguments.of(
            new Dependence(
                Variable.HEADING,
                Form.CURVE,
                2,
                none,
                none,
                new Level(0, 0, -0.1),
                new Level(Math.PI / 2, 0, 0.1),
                0.97,
                1e-5),
            "lowest towards the +x goal, direction 0°, 10 % below its mean"));
  }

  @ParameterizedTest
  @MethodSource("dependences")
  void whatFollowsSomethingIsNotSaidToDifferByChance(Dependence follows, String words) {
    LearnedFinding found =
        new LearnedFinding(
            new RollScatter(0),
            "ground",
            List.of(follows.on().label()),
            OptionalInt.empty(),
            List.of(),
            0.12,
            Optional.of(follows),
            new Gain(1, 10, 0.5, 1.5));
    assertThat(WORDS.of(found).sentences()).contains(words).doesNotContain("No model predicts it");
    assertThat(WORDS.of(found).name()).startsWith("rolling that depends on the ");
  }

  @Test
  void theTableOfMagnitudesIsComplete() {
    assertThat(magnitudes().map(a -> ((Effect) a.get()[0]).id()).collect(Collectors.toSet()))
        .containsExactlyInAnyOrderElementsOf(
            EffectCatalogue.all().stream().map(Effect::id).toList());
  }

  @Test
  void anEffectWithoutWordsOfItsOwnSaysItsSentence() {
    Effect unknown = mock("ball_of_wool");
    CauseText text = WORDS.of(unknown, Map.of());
    assertThat(text.name()).isEqualTo("ball of wool");
    assertThat(text.sentences()).isEqualTo("The ball is of wool. Predict with the extended model.");
  }

  private static Effect mock(String id) {
    return new Effect() {
      @Override
      public String id() {
        return id;
      }

      @Override
      public String sentence() {
        return "The ball is of wool.";
      }

      @Override
      public List<Parameter> parameters() {
        return List.of(new Parameter("size", "", 1, 1, 0, 2, true, "test"));
      }

      @Override
      public Effect withParameters(double... values) {
        return this;
      }

      @Override
      public boolean isAbsent() {
        return false;
      }
    };
  }

  @Test
  void placesAreInTheName() {
    assertThat(EffectName.of(new LensDistortionError(0.01, LensDistortionError.ALL_CAMERAS)))
        .isEqualTo("wrong lens distortion of all cameras");
    assertThat(EffectName.of(new CarpetSeam(0.1, 0, 0, 1.5)))
        .isEqualTo("seam of the carpet at x = 1.5 m");
    assertThat(EffectName.of(new CarpetSeam(0.1, 0, Math.PI / 4, -1)))
        .isEqualTo("seam of the carpet 1 m from the centre in direction −135°");
  }

  @Test
  void whatTheModelDoesToAKickIsComputed() {
    assertThat(WORDS.of(new AirDrag(0.47), Map.of()).consequence())
        .matches("A pass at 6 m/s travels \\d+ mm less far in 1 s than it would without air\\.");
    assertThat(WORDS.of(new KickSpin(-0.25), Map.of()).consequence())
        .contains("mm less far in 2 s than it would without spin")
        .contains("begins to roll at 58 % of its initial speed instead of 66 %");
    assertThat(WORDS.of(new CarpetNap(0.08, 0), Map.of()).consequence())
        .matches("A pass at 4 m/s that way travels [1-9]\\d* mm less far in 2 s than one .*");
    // Seen from 5 m, a plane 8.5 mm too high moves a ball 3 m aside by 8.5·3/5 mm.
    assertThat(WORDS.of(new BallHeightError(8.5), Map.of()).consequence())
        .containsPattern("by [2-5]\\.\\d mm on average, and by up to [5-9]\\.\\d mm");
  }

  @Test
  void aJumpBetweenTwoCamerasIsTheirDifference() {
    assertThat(WORDS.of(new CameraOffset(21, 0, 1), Map.of()).sentences())
        .contains("into that of camera 0 seems to jump by 42 mm")
        .contains("kicks cannot show which of the two is right");
  }

  @Test
  void partsThatAreWithinTheirErrorsAreNotSaid() {
    CauseText offset = WORDS.of(new CameraOffset(21, 0.7, 1), Map.of("x_mm", 0.12, "y_mm", 0.5));
    assertThat(offset.what()).doesNotContain("+y").contains("21 mm too far towards the +x goal,");
    assertThat(offset.strength()).isEqualTo("x 21.00 ± 0.12 mm, y 0.7 ± 0.5 mm");
    CauseText bias =
        WORDS.of(new RobotKickBias(5, 0.001, Team.YELLOW, 0), Map.of("percent", 0.4, "yaw", 0.002));
    assertThat(bias.what()).isEqualTo("Robot yellow 0 kicks 5.0 % faster than commanded.");
    assertThat(bias.strength()).isEqualTo("5.0 ± 0.4 %, yaw 0.06 ± 0.11°");
  }

  @Test
  void scatterFromKickToKickIsSaid() {
    Cause spin =
        new Cause(
            new KickSpin(-0.2),
            Map.of("fraction", 0.03),
            0.08,
            12,
            new Gain(1, 10, 0.5, 1.5),
            List.of("air_drag", "camera_time_offset"));
    assertThat(WORDS.of(spin).strength())
        .isEqualTo("fraction −0.200 ± 0.030; differs from kick to kick by ± 0.080");
    assertThat(WORDS.of(spin).name()).isEqualTo("backspin from the kicker");
    Cause unsure =
        new Cause(
            new KickSpin(0.11),
            Map.of("fraction", 0.12),
            0.08,
            12,
            new Gain(1, 10, 0.5, 1.5),
            List.of());
    assertThat(WORDS.of(unsure).what()).contains("topspin in some kicks and backspin in others");
    assertThat(WORDS.of(unsure).name()).isEqualTo("topspin/backspin from the kicker");
    Effect chips = new KickSpin(0.02, -0.3, true);
    Map<String, Double> errors = Map.of("fraction", 0.04, "chips", 0.04);
    assertThat(WORDS.of(chips, errors).what())
        .contains("chips 28 % backspin and flat kicks no spin that is certain (2.0 ± 4.0 %)");
    assertThat(WORDS.of(new KickSpin(0.02, -0.05, true), errors).what())
        .isEqualTo(
            "The kickers give the ball topspin in some kicks and backspin in others: on average"
                + " −3.0 ± 4.0 % of the spin of a rolling ball in chips, 2.0 ± 4.0 % in flat"
                + " kicks.");
    assertThat(WORDS.of(chips, errors).strength())
        .isEqualTo("fraction 0.02 ± 0.04, chips −0.30 ± 0.04");
    assertThat(EffectName.of(chips)).isEqualTo("topspin/backspin from the kicker");
    assertThat(CauseWords.rivals(spin)).contains("as well: air drag or wrong time stamps.");
    assertThat(CauseWords.rivals(DIAGNOSIS.causes().get(1))).isEmpty();
  }

  @Test
  void ofTwoCamerasItIsSaidThatEitherMayBeWrong() {
    assertThat(rivals(new CameraOffset(21, 0, 1), "camera_offset of camera 0"))
        .isEqualTo("These kicks do not show whether camera 0 or camera 1 is shifted.");
    assertThat(
            rivals(
                new CameraTimeOffset(3, 10),
                "camera_time_offset of camera 2",
                "rolling_shutter",
                "camera_time_offset of camera 0"))
        .startsWith(
            "These kicks do not show whether camera 0, camera 2 or camera 10 has wrong time stamps."
                + " Another cause would explain these kicks about as well: rolling shutter.");
    assertThat(rivals(new BallHeightError(8), "camera_offset of camera 1"))
        .startsWith("Another cause would explain these kicks about as well: offset of camera 1.");
    assertThat(
            rivals(
                new LensDistortionError(0.01, LensDistortionError.ALL_CAMERAS),
                "lens_distortion_error of camera 1"))
        .startsWith(
            "Another cause would explain these kicks about as well: wrong lens distortion of camera"
                + " 1.");
    assertThat(EffectName.of("camera_offset of camera 1")).isEqualTo("offset of camera 1");
    assertThat(EffectName.of("camera_pose_error of camera 1")).isEqualTo("misplaced camera 1");
    assertThat(EffectName.of("clock_skew of camera 2"))
        .isEqualTo("clock of camera 2 at the wrong rate");
  }

  private static String rivals(Effect effect, String... rivals) {
    return CauseWords.rivals(
        new Cause(effect, Map.of(), 0, 12, new Gain(1, 10, 0.5, 1.5), List.of(rivals)));
  }

  @Test
  void whatACameraReportedBeforeItWasKnockedIsNoShift() {
    assertThat(WORDS.of(new CameraMoved(12, -7, 45, 1), Map.of()).what()).contains("from 45 s");
    CameraMoved later = new CameraMoved(12, -7, 100_000, 1);
    ReportedShifts shifts = new ReportedShifts(SampleDiagnosis.observers(), DIAGNOSIS.kicks(), 0);
    assertThat(shifts.of(new CameraMoved(12, -7, 45, 1))).isPresent();
    assertThat(shifts.of(later)).isEmpty();
    assertThat(
            new ReportedShifts(SampleDiagnosis.observers(), DIAGNOSIS.kicks(), -100_000).of(later))
        .isPresent();
  }

  @Test
  void withoutCamerasOrModelLessIsSaid() {
    Diagnosis d = SampleDiagnosis.adequate(1);
    CauseWords words = new CauseWords(d, List.of());
    assertThat(words.of(new CameraOffset(21, 0, 1), Map.of()).consequence()).isEmpty();
    assertThat(words.of(new LensDistortionError(0.01, 1), Map.of()).consequence()).isEmpty();
    assertThat(words.of(new BallHeightError(1), Map.of()).consequence())
        .isEqualTo("It reports balls too near to the point below each camera.");
  }

  private static Effect opposite(Effect effect) {
    Effect opposite = effect;
    for (String name : effect.magnitudes()) {
      opposite = opposite.with(name, -effect.value(name));
    }
    assertThat(effect.parameters().stream().map(Parameter::name).toList()).isNotEmpty();
    return opposite;
  }
}
