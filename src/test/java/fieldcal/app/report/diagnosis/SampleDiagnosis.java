package fieldcal.app.report.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.camera.Camera;
import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.motion.AirDrag;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Diagnoses by hand that look like real ones: two cameras that disagree by 42 mm and air drag, found; the same not found; nothing there. Seeded.
 */
public final class SampleDiagnosis {
  private static final Effect OFFSET = new CameraOffset(21.2, -0.4, 1);
  private static final Effect DRAG = new AirDrag(0.47);
  private static final FlatModel FLAT = new FlatModel(-3.0, -0.28, 0.66);
  private static final ChipModel CHIP = new ChipModel(0.7, 0.87, 0.45, -0.28);

  private SampleDiagnosis() {}

  /** Two cameras at 5 m, of which only the positions are known. */
  public static List<ObservedCamera> observers() {
    double none = Double.NaN;
    List<ObservedCamera> observers = new ArrayList<>();
    for (int id = 0; id < 2; id++) {
      Camera camera = Camera.ofPosition(id, id == 0 ? -3 : 3, 0, 5);
      observers.add(new ObservedCamera(id, 2, Optional.of(camera), none, none, none, none, 0));
    }
    return observers;
  }

  /** A model with these effects. */
  public static ExtendedModel model(List<Effect> effects) {
    return new ExtendedModel(Optional.of(FLAT), Optional.of(CHIP), effects, 0);
  }

  /** A model that predicts all kicks about equally well. */
  public static Quality quality(
      double rmsMm, double noiseMm, double holdoutRmsMm, Map<Double, Double> predictedMm) {
    return new Quality(rmsMm, noiseMm, holdoutRmsMm, predictedMm, predictedMm);
  }

  /** Offset and drag found in so many kicks. */
  public static Diagnosis explained(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 7, List.of(OFFSET, DRAG), true);
    return new Diagnosis(
        Verdict.EXPLAINED,
        quality(14.2, 1.5, 14.6, Map.of(0.5, 21.3, 1.0, 38.2, 2.0, 64.9)),
        quality(1.52, 1.5, 1.56, Map.of(0.5, 5.1, 1.0, 12.4, 2.0, 29.0)),
        List.of(
            new Cause(
                OFFSET,
                Map.of("x_mm", 0.12, "y_mm", 0.11),
                0,
                18234,
                new Gain(12.1, 82.9, 11.6, 12.7),
                List.of("camera_offset of camera 0", "ball_height_error")),
            new Cause(
                DRAG, Map.of("cd", 0.021), 0, 231.4, new Gain(0.94, 37.6, 0.71, 1.2), List.of())),
        List.of(),
        candidates(true),
        new Unexplained(false, 0.1, 0.8, List.of()),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of(OFFSET, DRAG)),
        List.of(),
        List.of(),
        Map.of(),
        42);
  }

  /** Drag found, and beside it another law of the bounce, a curve over the speed, reports that depend on the place in the image, and something left. */
  public static Diagnosis partly(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 10, List.of(DRAG), true);
    List<LearnedFinding> learned = SampleLearned.findings();
    List<Effect> effects = new ArrayList<>(List.of(DRAG));
    learned.stream().map(LearnedFinding::effect).filter(Effect::hasOwnMean).forEach(effects::add);
    return new Diagnosis(
        Verdict.PARTLY_EXPLAINED,
        quality(24.2, 1.5, 25.1, Map.of(0.5, 121.3, 1.0, 502.0, 2.0, 864.9)),
        quality(4.1, 1.5, 4.5, Map.of(0.5, 31.0, 1.0, 88.0, 2.0, 131.0)),
        List.of(
            new Cause(DRAG, Map.of("cd", 0.021), 0, 11.4, new Gain(9.4, 37.6, 7.1, 12), List.of())),
        learned,
        candidates(false),
        new Unexplained(
            true, 2.9, 41, List.of(StructureVariable.HEIGHT, StructureVariable.IMAGE_ROW)),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(effects),
        List.of(),
        List.of(),
        Map.of(),
        42);
  }

  /** The same with other causes, another base, and what failed. */
  public static Diagnosis with(
      Diagnosis d, List<Cause> causes, Quality base, List<String> problems) {
    return new Diagnosis(
        d.verdict(),
        base,
        d.extended(),
        causes,
        d.learned(),
        d.candidates(),
        d.unexplained(),
        d.structureBefore(),
        d.structureAfter(),
        d.kicks(),
        d.simpleModel(),
        d.model(),
        d.trace(),
        problems,
        Map.of(),
        d.seed());
  }

  /** The same with another quality of the extended model, and other residuals without a cause. */
  public static Diagnosis leaving(Diagnosis d, Quality extended, Unexplained left) {
    return with(d, extended, d.learned(), left, d.kicks());
  }

  /** The same with other things that have no name. */
  public static Diagnosis learning(Diagnosis d, List<LearnedFinding> learned) {
    return with(d, d.extended(), learned, d.unexplained(), d.kicks());
  }

  /** The same with other kicks. */
  public static Diagnosis of(Diagnosis d, List<KickResiduals> kicks) {
    return with(d, d.extended(), d.learned(), d.unexplained(), kicks);
  }

  private static Diagnosis with(
      Diagnosis d,
      Quality extended,
      List<LearnedFinding> learned,
      Unexplained left,
      List<KickResiduals> kicks) {
    return new Diagnosis(
        d.verdict(),
        d.base(),
        extended,
        d.causes(),
        learned,
        d.candidates(),
        left,
        d.structureBefore(),
        d.structureAfter(),
        kicks,
        d.simpleModel(),
        d.model(),
        d.trace(),
        d.problems(),
        d.ballErrors(),
        d.seed());
  }

  /** Nothing wrong. */
  public static Diagnosis adequate(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 8, List.of(), true);
    Quality quality = quality(1.51, 1.5, 1.55, Map.of(0.5, 5.2, 1.0, 12.7, 2.0, 29.5));
    return new Diagnosis(
        Verdict.MODEL_ADEQUATE,
        quality,
        quality,
        List.of(),
        List.of(),
        candidates(false),
        new Unexplained(false, 0.05, 0.3, List.of()),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of()),
        List.of(),
        List.of(),
        Map.of(),
        42);
  }

  /** Something that no effect explains. */
  public static Diagnosis unexplained(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 9, List.of(DRAG), false);
    Quality quality = quality(3.4, 1.5, 3.6, Map.of(0.5, 7.2, 1.0, 18.7, 2.0, 40.5));
    return new Diagnosis(
        Verdict.UNEXPLAINED_STRUCTURE,
        quality,
        quality,
        List.of(),
        List.of(),
        candidates(false),
        new Unexplained(
            true, 2.9, 41, List.of(StructureVariable.TIME_SINCE_KICK, StructureVariable.SPEED)),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of()),
        List.of(),
        List.of(),
        Map.of(),
        42);
  }

  /** An effect with something of its first magnitude: a scale, or what the search starts a law with. */
  public static Effect present(Effect effect) {
    if (!effect.starts().isEmpty()) {
      return effect.starts().get(0);
    }
    String name = effect.magnitudes().get(0);
    double scale =
        effect.parameters().stream()
            .filter(p -> p.name().equals(name))
            .mapToDouble(Parameter::scale)
            .findFirst()
            .orElseThrow();
    return effect.withNone().with(name, scale);
  }

  private static List<Candidate> candidates(boolean found) {
    List<Candidate> all = new ArrayList<>();
    if (found) {
      all.add(candidate(OFFSET, 38000, true));
      all.add(candidate(new CameraOffset(-21.2, 0.4, 0), 37990, false));
      all.add(candidate(DRAG, 1520, true));
    }
    for (Effect effect : EffectCatalogue.all()) {
      if (all.stream().noneMatch(c -> c.effect().id().equals(effect.id()))) {
        all.add(candidate(present(effect), 400.0 / all.size(), false));
      }
    }
    return all;
  }

  private static Candidate candidate(Effect effect, double scoreGain, boolean named) {
    return new Candidate(effect, scoreGain, named);
  }
}
