package fieldcal.app.report.diagnosis;

import fieldcal.app.report.Field;
import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.report.Rounded;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Everything the diagnosis report shows, as plain values; immutable. Residuals are seen minus predicted, in mm. A number that is not known is NaN, a text
 * that does not apply is empty. Texts may hold anything: the writer escapes.
 *
 * @param provenance what the diagnosis was made from, and by what
 * @param verdict what it comes to, in words
 * @param causes in the order in which they explain most
 * @param learned what helps the prediction and has no name
 * @param before the simple model
 * @param after the model with all that was found
 * @param candidates all that were tried, best first
 * @param remains what is left
 * @param profiles how residuals depend on each variable
 * @param shown id of the variable that shows best what was found
 * @param field the field to draw; empty when no geometry was seen
 * @param map mean residuals over the field
 * @param cameras ids of all cameras that saw kicks
 * @param kicks in order of time
 * @param parameters of the simple and of the extended model
 * @param problems damage and gaps in the input, counted
 */
public record DiagnosisReport(
    Provenance provenance,
    VerdictWords verdict,
    List<CauseRow> causes,
    List<LearnedRow> learned,
    QualityRow before,
    QualityRow after,
    List<CandidateRow> candidates,
    Remains remains,
    List<ProfilePicture> profiles,
    String shown,
    Optional<Field> field,
    ResidualMap map,
    List<Integer> cameras,
    List<KickPicture> kicks,
    List<ParameterRow> parameters,
    List<Problem> problems) {

  /**
   * Copies the lists.
   *
   * @throws NullPointerException if anything is null
   */
  public DiagnosisReport {
    Objects.requireNonNull(provenance, "provenance");
    Objects.requireNonNull(verdict, "verdict");
    Objects.requireNonNull(field, "field");
    causes = List.copyOf(causes);
    learned = List.copyOf(learned);
    candidates = List.copyOf(candidates);
    profiles = List.copyOf(profiles);
    cameras = List.copyOf(cameras);
    kicks = List.copyOf(kicks);
    parameters = List.copyOf(parameters);
    problems = List.copyOf(problems);
  }

  /**
   * The verdict.
   *
   * @param id as in {@code diagnosis.json}
   * @param headline what it means for the team, one sentence
   * @param verdict what it comes to, with the causes by name
   * @param lines more of it
   */
  public record VerdictWords(String id, String headline, String verdict, List<String> lines) {

    /** Copies the list. */
    public VerdictWords {
      lines = List.copyOf(lines);
    }
  }

  /**
   * One cause.
   *
   * @param id of the effect
   * @param name a few words
   * @param what what is wrong
   * @param consequence what it does to the game; may be empty
   * @param advice what to do
   * @param strength numbers with errors
   * @param parameters its parameters, in the order of files
   * @param certainty how sure it is, in words
   * @param gainMm what kicks that were held out gain, root mean square, mm
   * @param gainPercent the same in per cent
   * @param gainLowMm lower bound, 2.5 %
   * @param gainHighMm upper bound, 97.5 %
   * @param rivals what it cannot be told from, a sentence; may be empty
   * @param kicksToRecord which kicks would tell; may be empty
   */
  public record CauseRow(
      String id,
      String name,
      String what,
      String consequence,
      String advice,
      String strength,
      List<EffectParameter> parameters,
      String certainty,
      @Rounded(3) double gainMm,
      @Rounded(2) double gainPercent,
      @Rounded(3) double gainLowMm,
      @Rounded(3) double gainHighMm,
      String rivals,
      String kicksToRecord) {

    /** Copies the list. */
    public CauseRow {
      parameters = List.copyOf(parameters);
    }
  }

  /**
   * One number of a cause.
   *
   * @param name as in files
   * @param unit may be empty
   * @param value the number
   * @param error standard error; NaN when it is not estimated
   */
  public record EffectParameter(
      String name, String unit, @Rounded(6) double value, @Rounded(6) double error) {}

  /**
   * How well a model does.
   *
   * @param rmsMm residual per axis in the fit, mm
   * @param noiseMm what the cameras make of it, mm
   * @param holdoutRmsMm residual per axis of kicks that were held out, mm
   * @param horizons how far ahead is predicted, s
   * @param typicalErrorMm error of these predictions of a usual kick, mm; of the same length
   */
  public record QualityRow(
      @Rounded(3) double rmsMm,
      @Rounded(3) double noiseMm,
      @Rounded(3) double holdoutRmsMm,
      double[] horizons,
      @Rounded(2) double[] typicalErrorMm) {

    /** Copies the arrays. */
    public QualityRow {
      horizons = horizons.clone();
      typicalErrorMm = typicalErrorMm.clone();
    }
  }

  /**
   * One possible cause that was tried.
   *
   * @param name a few words, with camera, robot or place
   * @param strength the numbers that would fit best
   * @param scoreGain by how much chi-square would fall, were it the only cause
   * @param named whether it is one of the causes
   */
  public record CandidateRow(
      String name, String strength, @Rounded(1) double scoreGain, boolean named) {}

  /**
   * Something that helps the prediction and has no name.
   *
   * @param name a few words
   * @param what what it does, a sentence with numbers
   * @param advice what to do; may be empty
   * @param formula the best simple formula of a curve, the numbers of all else
   * @param kind "curve", "law" (takes the place of the simple model's) "scatter" (differs from kick to kick by chance) or "unproven" (an effect that is not proven to be a cause); only curves have pictures
   * @param helps whether it may be told as something that helps
   * @param gainMm what kicks that were held out gain, root mean square, mm
   * @param gainPercent the same in per cent
   * @param gainLowMm lower bound, 2.5 %
   * @param gainHighMm upper bound, 97.5 %
   * @param curves pictures, one of each component
   */
  public record LearnedRow(
      String name,
      String what,
      String advice,
      String formula,
      String kind,
      boolean helps,
      @Rounded(3) double gainMm,
      @Rounded(2) double gainPercent,
      @Rounded(3) double gainLowMm,
      @Rounded(3) double gainHighMm,
      List<CurvePicture> curves) {

    /** Copies the list. */
    public LearnedRow {
      curves = List.copyOf(curves);
    }
  }

  /**
   * What is left when all causes are in the model.
   *
   * @param significant whether it is more than noise
   * @param systematicMm its size, mm
   * @param deviation its size in standard deviations of noise
   * @param words in a sentence; empty when it is noise
   * @param dependsOn ids of variables, strongest first
   * @param shown id of the variable to draw; empty when there is none
   */
  public record Remains(
      boolean significant,
      @Rounded(3) double systematicMm,
      @Rounded(2) double deviation,
      String words,
      List<String> dependsOn,
      String shown) {

    /** Copies the list. */
    public Remains {
      dependsOn = List.copyOf(dependsOn);
    }
  }

  /**
   * One parameter of the simple model, before and after the causes are in it.
   *
   * @param kind flat or chip
   * @param name the field's name
   * @param unit may be empty
   * @param before of the simple model alone; NaN when it has none
   * @param after with the causes
   */
  public record ParameterRow(
      String kind, String name, String unit, @Rounded(5) double before, @Rounded(5) double after) {}
}
