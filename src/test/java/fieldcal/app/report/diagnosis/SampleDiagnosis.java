package fieldcal.app.report.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Gain;
import fieldcal.diagnosis.KickResiduals;
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

  /** Offset and drag found in so many kicks. */
  public static Diagnosis explained(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 7, List.of(OFFSET, DRAG), true);
    return new Diagnosis(
        Verdict.EXPLAINED,
        new Quality(14.2, 1.5, 14.6, Map.of(0.5, 21.3, 1.0, 38.2, 2.0, 64.9)),
        new Quality(1.52, 1.5, 1.56, Map.of(0.5, 5.1, 1.0, 12.4, 2.0, 29.0)),
        List.of(
            new Cause(
                OFFSET,
                Map.of("x_mm", 0.12, "y_mm", 0.11),
                0,
                18234,
                new Gain(12.1, 82.9, 11.6, 12.7),
                List.of("ball_height_error"),
                "flat kicks along y through the middle of each camera's view"),
            new Cause(
                DRAG,
                Map.of("cd", 0.021),
                0,
                231.4,
                new Gain(0.94, 37.6, 0.71, 1.2),
                List.of(),
                "")),
        candidates(true),
        new Unexplained(false, 0.1, 0.8, List.of()),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of(OFFSET, DRAG)),
        42);
  }

  /** Nothing wrong. */
  public static Diagnosis adequate(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 8, List.of(), true);
    Quality quality = new Quality(1.51, 1.5, 1.55, Map.of(0.5, 5.2, 1.0, 12.7, 2.0, 29.5));
    return new Diagnosis(
        Verdict.MODEL_ADEQUATE,
        quality,
        quality,
        List.of(),
        candidates(false),
        new Unexplained(false, 0.05, 0.3, List.of()),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of()),
        42);
  }

  /** Something that no effect explains. */
  public static Diagnosis unexplained(int kicks) {
    List<KickResiduals> residuals = SampleKicks.of(kicks, 9, List.of(DRAG), false);
    Quality quality = new Quality(3.4, 1.5, 3.6, Map.of(0.5, 7.2, 1.0, 18.7, 2.0, 40.5));
    return new Diagnosis(
        Verdict.UNEXPLAINED_STRUCTURE,
        quality,
        quality,
        List.of(),
        candidates(false),
        new Unexplained(
            true, 2.9, 41, List.of(StructureVariable.TIME_SINCE_KICK, StructureVariable.SPEED)),
        SampleProfiles.of(residuals, false),
        SampleProfiles.of(residuals, true),
        residuals,
        model(List.of()),
        model(List.of()),
        42);
  }

  private static List<Candidate> candidates(boolean found) {
    List<Candidate> all = new ArrayList<>();
    if (found) {
      all.add(new Candidate(OFFSET, 38000, 18234, Double.NaN, true));
      all.add(new Candidate(new CameraOffset(-21.2, 0.4, 0), 38000, 18230, -4, false));
      all.add(new Candidate(DRAG, 1520, 412, Double.NaN, true));
    }
    for (Effect effect : EffectCatalogue.all()) {
      if (all.stream().noneMatch(c -> c.effect().id().equals(effect.id()))) {
        boolean tried = all.size() % 3 > 0;
        Effect small = effect.probes().get(0);
        all.add(new Candidate(small, 2, tried ? 9.0 - all.size() : Double.NaN, -5, false));
      }
    }
    return all;
  }
}
