package fieldcal.app.report;

import com.fasterxml.jackson.annotation.JsonProperty;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.PublishWords;
import fieldcal.verdict.VerdictRule;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Everything the calibration report shows, as plain values; immutable.
 *
 * <p>Units are SI unless a name ends in {@code Mm} or says otherwise; positions are in the field frame (origin at the
 * centre, x to the goal, y left, z up, z = 0 for a ball at rest). A number that is not known is NaN, a text that does
 * not apply is empty; neither is an error. Texts may hold anything, also file names with markup: the writer escapes.
 *
 * @param provenance what the calibration was made from, and by what
 * @param models the models calibrated, flat before chip; a kind without kicks may be left out
 * @param cameras the cameras that took part
 * @param field the field to draw; empty when no geometry was seen
 * @param kicks all kicks found, in the order of time, also those that were dropped
 * @param verdict whether the model may be published
 * @param warnings what the operator should know before publishing, one sentence each, the most important first
 * @param problems damage and gaps in the input, counted
 */
public record CalibrationReport(
    Provenance provenance,
    List<Model> models,
    List<Camera> cameras,
    Optional<Field> field,
    List<Kick> kicks,
    PublishWords verdict,
    List<String> warnings,
    List<Problem> problems) {

  /**
   * Copies the lists.
   *
   * @throws NullPointerException if anything is null
   */
  public CalibrationReport {
    Objects.requireNonNull(provenance, "provenance");
    Objects.requireNonNull(field, "field");
    models = List.copyOf(models);
    cameras = List.copyOf(cameras);
    kicks = List.copyOf(kicks);
    Objects.requireNonNull(verdict, "verdict");
    warnings = List.copyOf(warnings);
    problems = List.copyOf(problems);
  }

  /**
   * The same without its kicks.
   *
   * @return the changed copy
   */
  public CalibrationReport withoutKicks() {
    return new CalibrationReport(
        provenance, models, cameras, field, List.of(), verdict, warnings, problems);
  }

  /** What a kick is, and which of the two models it belongs to. */
  public enum Kind {
    /** Along the ground. */
    FLAT,
    /** Through the air. */
    CHIP
  }

  /**
   * One calibrated model.
   *
   * @param kind flat or chip
   * @param parameters in the order they are shown
   * @param jointRmsMm residual of the joint fit over all kicks, per axis, mm; NaN without a joint fit
   * @param note one sentence under the table, for example where accRoll of the chips comes from; may be empty
   */
  public record Model(
      Kind kind, List<ModelParameter> parameters, @Rounded(6) double jointRmsMm, String note) {

    /** Copies the list. */
    public Model {
      Objects.requireNonNull(kind, "kind");
      parameters = List.copyOf(parameters);
      Objects.requireNonNull(note, "note");
    }
  }

  /**
   * One parameter of a model: the average over the selected kicks, beside it the joint fit and what is published.
   *
   * @param name the field's name, for example "accSlide"; the same as in {@link KickParameter}
   * @param unit for example "m/s²"; empty for a ratio
   * @param mean average over the selected kicks; NaN if no kick determines it
   * @param standardError of the mean; NaN if unknown
   * @param n number of kicks in the mean
   * @param sigma scatter from kick to kick beyond what the fits' own errors explain: a kick is judged by its distance
   *     from the mean in units of √(sigma² + its standard error²); NaN if unknown
   * @param joint value of the joint fit; NaN without one
   * @param jointStandardError its standard error; NaN if unknown
   * @param published value of the model in use; NaN if none is published
   * @param note for example "fixed: from the flat calibration"; may be empty
   */
  public record ModelParameter(
      String name,
      String unit,
      @Rounded(6) double mean,
      @Rounded(6) double standardError,
      int n,
      @Rounded(6) double sigma,
      @Rounded(6) double joint,
      @Rounded(6) double jointStandardError,
      @Rounded(6) double published,
      String note) {
    /** Checks that the texts are there. */
    public ModelParameter {
      Objects.requireNonNull(name, "name");
      Objects.requireNonNull(unit, "unit");
      Objects.requireNonNull(note, "note");
    }

    /**
     * What people call it.
     *
     * @return for example "sliding deceleration (acc_slide)"
     */
    @JsonProperty
    public String words() {
      return ParameterWords.of(name);
    }

    /**
     * How far the mean is from the published value.
     *
     * @return mean / published − 1, in percent, positive when the mean is the larger in magnitude; NaN if either is
     *     unknown or the published one is zero
     */
    @JsonProperty
    @Rounded(6)
    public double differencePercent() {
      return published == 0 ? Double.NaN : (mean / published - 1) * 100;
    }

    /**
     * Whether that matters: the difference is at least {@value VerdictRule#NOTABLE_PERCENT} % and more than chance.
     *
     * @return false also when there is nothing to compare with
     */
    @JsonProperty
    public boolean differs() {
      return VerdictRule.differs(mean, standardError, published);
    }
  }

  /**
   * One camera and how its view differs from that of the others.
   *
   * @param id number in the vision packets
   * @param noiseMm standard deviation of a detection of the resting ball, per axis, mm
   * @param rateHz frames per second
   * @param observations detections of kicked balls that went into the fits
   * @param offsetXMm how much too far in x the camera reports, relative to the mean of all cameras, mm; NaN if the
   *     recording does not determine it (a single camera)
   * @param offsetXErrorMm standard error, mm
   * @param offsetYMm the same in y, mm
   * @param offsetYErrorMm standard error, mm
   * @param x position above the field, m; NaN if unknown
   * @param y position above the field, m; NaN if unknown
   * @param note what is odd about it, for example that only its published position is used; may be empty
   */
  public record Camera(
      int id,
      @Rounded(6) double noiseMm,
      @Rounded(2) double rateHz,
      long observations,
      @Rounded(2) double offsetXMm,
      @Rounded(2) double offsetXErrorMm,
      @Rounded(2) double offsetYMm,
      @Rounded(2) double offsetYErrorMm,
      @Rounded(3) double x,
      @Rounded(3) double y,
      String note) {

    /** Checks that the text is there. */
    public Camera {
      Objects.requireNonNull(note, "note");
    }
  }

  /**
   * One kick and its fit.
   *
   * @param id running number, as in {@code calibration.json}
   * @param kind flat or chip
   * @param source the recording it is from
   * @param unix time of the kick, Unix time in s
   * @param team "yellow", "blue", or empty if unknown
   * @param robot number of the kicking robot; negative if unknown
   * @param end why the observations end, as in {@code calibration.json}: "stopped", "left_field", "touched_robot",
   *     "lost", "recording_ended"
   * @param observations number that the fit was given
   * @param rejected how many of them the fit put aside as outliers
   * @param rmsMm residual per axis of those it used, mm; NaN if there is no fit
   * @param x kick position, m
   * @param y kick position, m
   * @param vx velocity right after the kick, m/s
   * @param vy velocity right after the kick, m/s
   * @param vz velocity right after the kick, m/s; 0 for a flat kick
   * @param parameters the fitted parameters of the model; empty if there is no fit
   * @param selected whether the kick is part of the model
   * @param rejectedBecause why it is not, in words; empty when selected
   * @param seen the observations, one entry per camera; may be empty
   * @param fitted the fitted trajectory; {@link FittedPath#NONE} if there is no fit
   * @param events what happens on the fitted trajectory, in the order of time
   */
  public record Kick(
      int id,
      Kind kind,
      String source,
      @Rounded(4) double unix,
      String team,
      int robot,
      String end,
      int observations,
      int rejected,
      @Rounded(6) double rmsMm,
      @Rounded(4) double x,
      @Rounded(4) double y,
      @Rounded(4) double vx,
      @Rounded(4) double vy,
      @Rounded(4) double vz,
      List<KickParameter> parameters,
      boolean selected,
      String rejectedBecause,
      List<Observations> seen,
      FittedPath fitted,
      List<PathEvent> events) {

    /** Copies the lists. */
    public Kick {
      Objects.requireNonNull(kind, "kind");
      Objects.requireNonNull(source, "source");
      Objects.requireNonNull(team, "team");
      Objects.requireNonNull(end, "end");
      Objects.requireNonNull(rejectedBecause, "rejectedBecause");
      Objects.requireNonNull(fitted, "fitted");
      parameters = List.copyOf(parameters);
      seen = List.copyOf(seen);
      events = List.copyOf(events);
    }
  }

  /**
   * What one kick says about one parameter.
   *
   * @param name as in {@link ModelParameter}
   * @param value fitted value; NaN if undetermined
   * @param standardError from the fit's covariance; NaN if undetermined
   * @param undetermined why the kick does not determine it, in words; empty if it does
   * @param dropped why this value is not averaged though the kick may be used for other parameters; empty if it is
   */
  public record KickParameter(
      String name,
      @Rounded(5) double value,
      @Rounded(5) double standardError,
      String undetermined,
      String dropped) {

    /** Checks that the texts are there. */
    public KickParameter {
      Objects.requireNonNull(name, "name");
      Objects.requireNonNull(undetermined, "undetermined");
      Objects.requireNonNull(dropped, "dropped");
    }
  }
}
