package fieldcal.app.report.diagnosis;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.report.Field;
import fieldcal.app.report.Problem;
import fieldcal.app.report.Provenance;
import fieldcal.app.report.diagnosis.DiagnosisReport.CandidateRow;
import fieldcal.app.report.diagnosis.DiagnosisReport.CauseRow;
import fieldcal.app.report.diagnosis.DiagnosisReport.EffectParameter;
import fieldcal.app.report.diagnosis.DiagnosisReport.LearnedRow;
import fieldcal.app.report.diagnosis.DiagnosisReport.ParameterRow;
import fieldcal.app.report.diagnosis.DiagnosisReport.QualityRow;
import fieldcal.app.report.diagnosis.DiagnosisReport.Remains;
import fieldcal.app.report.diagnosis.DiagnosisReport.VerdictWords;
import fieldcal.app.wording.CauseText;
import fieldcal.app.wording.CauseWords;
import fieldcal.app.wording.Certainty;
import fieldcal.app.wording.EffectName;
import fieldcal.app.wording.NextKicks;
import fieldcal.app.wording.ParameterWords;
import fieldcal.app.wording.VerdictText;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.Parameter;
import fieldcal.diagnosis.Candidate;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.LearnedFinding;
import fieldcal.diagnosis.Quality;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.diagnosis.Unexplained;
import fieldcal.diagnosis.Verdict;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.motion.WornRegion;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Turns a diagnosis into what the report shows. Immutable. */
public final class DiagnosisReportBuilder {
  /** What happens on the field also shows in the image; people think on the field, so the image must show it twice as clearly. */
  private static final Set<String> IMAGE =
      Set.of(StructureVariable.IMAGE_COLUMN.id(), StructureVariable.IMAGE_ROW.id());

  private static final double IMAGE_WEIGHT = 0.5;

  private final Diagnosis diagnosis;
  private final CollectedKicks data;
  private final List<String> sources;
  private final List<DataProblem> remarks;
  private final CauseWords words;

  /**
   * A builder for one diagnosis.
   *
   * @param diagnosis what to show
   * @param data the kicks it was made from: times, recordings, cameras, field, problems
   * @param sources the recordings, as the operator named them
   * @param remarks on the kicks, beside the problems in the data
   */
  public DiagnosisReportBuilder(
      Diagnosis diagnosis, CollectedKicks data, List<String> sources, List<DataProblem> remarks) {
    this.diagnosis = diagnosis;
    this.remarks = List.copyOf(remarks);
    this.data = data;
    this.sources = List.copyOf(sources);
    words = new CauseWords(diagnosis, data.observers());
  }

  /**
   * Builds the view model.
   *
   * @return what the report shows
   */
  public DiagnosisReport build() {
    VerdictText verdict = VerdictText.of(diagnosis);
    List<ProfilePicture> profiles =
        diagnosis.structureBefore().stream()
            .filter(p -> !p.bins().isEmpty())
            .map(p -> ProfilePicture.of(p, diagnosis.structureAfter()))
            .toList();
    KickPictures kicks = new KickPictures(data, diagnosis.kicks().size());
    return new DiagnosisReport(
        Provenance.of(sources, data, diagnosis.seed()),
        new VerdictWords(
            diagnosis.verdict().id(), verdict.headline(), verdict.verdict(), verdict.lines()),
        diagnosis.causes().stream().map(this::cause).toList(),
        diagnosis.learned().stream().map(this::learned).toList(),
        quality(diagnosis.base()),
        quality(diagnosis.extended()),
        candidates(),
        remains(profiles),
        profiles,
        shown(profiles),
        data.geometry().map(Field::of),
        ResidualMap.of(diagnosis.kicks()),
        cameras(),
        diagnosis.kicks().stream().map(kicks::of).toList(),
        parameters(),
        Stream.concat(remarks.stream(), DataProblem.folded(data.problems()).stream())
            .map(Problem::of)
            .toList());
  }

  private CauseRow cause(Cause cause) {
    CauseText text = words.of(cause);
    List<EffectParameter> parameters =
        cause.effect().parameters().stream()
            .map(
                p ->
                    new EffectParameter(
                        p.name(),
                        p.unit(),
                        p.value(),
                        cause.standardErrors().getOrDefault(p.name(), Double.NaN)))
            .toList();
    return new CauseRow(
        cause.effect().id(),
        text.name(),
        text.what(),
        text.consequence(),
        text.advice(),
        text.strength(),
        parameters,
        Certainty.of(cause.evidence()),
        cause.gain().mm(),
        cause.gain().percent(),
        cause.gain().lowMm(),
        cause.gain().highMm(),
        CauseWords.rivals(cause),
        NextKicks.introduced(
            NextKicks.toTellApart(cause.effect().id(), cause.indistinguishableFrom())));
  }

  private LearnedRow learned(LearnedFinding finding) {
    CauseText text = words.of(finding);
    return new LearnedRow(
        text.name(),
        text.what(),
        text.advice(),
        text.strength(),
        finding.kind().name().toLowerCase(Locale.ROOT),
        finding.isShownToHelp(),
        finding.gain().mm(),
        finding.gain().percent(),
        finding.gain().lowMm(),
        finding.gain().highMm(),
        finding.curves().stream().map(CurvePicture::of).toList());
  }

  private static QualityRow quality(Quality q) {
    return new QualityRow(
        q.rmsMm(),
        q.noiseMm(),
        q.holdoutRmsMm(),
        q.typicalErrorMm().keySet().stream().mapToDouble(h -> h).toArray(),
        q.typicalErrorMm().values().stream().mapToDouble(e -> e).toArray());
  }

  /** The causes, then by what each explains alone; of what the search tried in several ways, the best. */
  private List<CandidateRow> candidates() {
    return diagnosis.candidates().stream()
        .sorted(
            Comparator.comparing((Candidate c) -> !c.named()).thenComparing(c -> -c.scoreGain()))
        .collect(
            Collectors.toMap(
                DiagnosisReportBuilder::sort, c -> c, (best, other) -> best, LinkedHashMap::new))
        .values()
        .stream()
        .map(DiagnosisReportBuilder::candidate)
        .toList();
  }

  /** What is one possible cause for a reader: parts of a camera's pose or regions of the carpet are tried one by one. */
  private static String sort(Candidate c) {
    return c.effect() instanceof WornRegion ? c.effect().id() : EffectName.of(c.effect());
  }

  private static CandidateRow candidate(Candidate c) {
    return new CandidateRow(
        EffectName.of(c.effect()),
        EffectName.strength(c.effect(), Map.of()),
        c.scoreGain(),
        c.named());
  }

  private Remains remains(List<ProfilePicture> profiles) {
    Unexplained u = diagnosis.unexplained();
    List<String> dependsOn = u.dependsOn().stream().map(StructureVariable::id).toList();
    String strongest =
        dependsOn.stream()
            .filter(v -> profiles.stream().anyMatch(p -> p.variable().equals(v)))
            .findFirst()
            .orElseGet(() -> largest(profiles, p -> p.after().deviation()));
    return new Remains(
        u.significant(),
        u.systematicMm(),
        u.deviation(),
        u.significant() ? VerdictText.rest(u) : "",
        dependsOn,
        strongest);
  }

  /** The variable that shows best what was found, or what was not. */
  private String shown(List<ProfilePicture> profiles) {
    if (diagnosis.verdict() == Verdict.UNEXPLAINED_STRUCTURE) {
      Optional<String> strongest =
          diagnosis.unexplained().dependsOn().stream().map(StructureVariable::id).findFirst();
      if (strongest.isPresent()) {
        return strongest.get();
      }
    }
    boolean explained =
        diagnosis.verdict() == Verdict.EXPLAINED || diagnosis.verdict() == Verdict.PARTLY_EXPLAINED;
    return largest(
        profiles,
        p ->
            IMAGE.contains(p.variable())
                ? IMAGE_WEIGHT * clarity(p, explained)
                : clarity(p, explained));
  }

  private static double clarity(ProfilePicture p, boolean explained) {
    return explained ? p.before().deviation() - p.after().deviation() : p.before().deviation();
  }

  private static String largest(
      List<ProfilePicture> profiles, ToDoubleFunction<ProfilePicture> size) {
    return profiles.stream()
        .filter(p -> !Double.isNaN(size.applyAsDouble(p)))
        .max(Comparator.comparingDouble(size))
        .or(() -> profiles.stream().findFirst())
        .map(ProfilePicture::variable)
        .orElse("");
  }

  private List<Integer> cameras() {
    return diagnosis.kicks().stream()
        .flatMapToInt(k -> IntStream.of(k.kick().observations().cameras()))
        .distinct()
        .sorted()
        .boxed()
        .toList();
  }

  private List<ParameterRow> parameters() {
    List<ParameterRow> rows = new ArrayList<>();
    ExtendedModel before = diagnosis.simpleModel();
    ExtendedModel after = diagnosis.model();
    addRows(
        rows,
        "flat",
        before.flat().map(FlatModel::parameters),
        after.flat().map(FlatModel::parameters));
    addRows(
        rows,
        "chip",
        before.chip().map(ChipModel::parameters),
        after.chip().map(ChipModel::parameters));
    return rows;
  }

  private static void addRows(
      List<ParameterRow> rows,
      String kind,
      Optional<List<Parameter>> before,
      Optional<List<Parameter>> after) {
    List<Parameter> old = before.orElse(List.of());
    List<Parameter> all = after.orElse(List.of());
    for (int i = 0; i < all.size(); i++) {
      Parameter p = all.get(i);
      double was = i < old.size() ? old.get(i).value() : Double.NaN;
      rows.add(new ParameterRow(kind, ParameterWords.of(p.name()), p.unit(), was, p.value()));
    }
  }
}
