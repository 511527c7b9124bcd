package fieldcal.diagnosis;

import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.diagnosis.hidden.HiddenRun.Times;
import fieldcal.diagnosis.hidden.Judgement;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.diagnosis.hidden.StudiedCase;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What a summary needs of one studied case, as a line of text, so that studies can run in several processes and be summarized together.
 *
 * @param seed of the case
 * @param group clear, marginal, invisible (single effects), null, pair, mixture, unnamed
 * @param hidden what was hidden
 * @param outcome in one word; FAILED when there is none
 * @param said the names that were given
 * @param visible named effects that could be seen
 * @param found how many of them were named or tied
 * @param wrong how many names were wrong
 * @param shown whether a cause without a name could be seen
 * @param variable whether what that depends on was said first: yes, no, or - where nothing was said
 * @param rmsBefore residual of kicks held out of the simple model, in units of the noise
 * @param rmsAfter the same of the extended model
 * @param expected whether nothing is to complain of
 * @param scores error of each size in its standard errors
 * @param percents error of each size, %
 * @param times of the stages, s
 * @param text everything in one line
 */
record CaseRow(
    long seed,
    String group,
    String hidden,
    String outcome,
    String said,
    int visible,
    int found,
    int wrong,
    boolean shown,
    String variable,
    double rmsBefore,
    double rmsAfter,
    boolean expected,
    List<Double> scores,
    List<Double> percents,
    List<Double> times,
    String text) {
  private static final String SEPARATOR = "\t";
  private static final int FIELDS = 17;

  static CaseRow of(StudiedCase c) {
    List<Strength> strengths =
        c.judgement().stream()
            .flatMap(j -> j.found().stream())
            .flatMap(f -> f.strength().stream())
            .toList();
    Times t = c.times();
    return new CaseRow(
        c.hidden().seed(),
        group(c),
        c.hidden().label(),
        c.outcome().map(Enum::name).orElse("FAILED"),
        c.names(),
        c.judgement().map(j -> j.visible().size()).orElse(0),
        c.judgement()
            .map(j -> (int) j.visible().stream().filter(f -> f.how() != How.NOT).count())
            .orElse(0),
        c.judgement().map(j -> j.wrong().size()).orElse(0),
        c.shown(),
        c.judgement().flatMap(Judgement::rightVariable).map(r -> r ? "yes" : "no").orElse("-"),
        c.rmsBefore(),
        c.rmsAfter(),
        c.asItShouldBe(),
        strengths.stream().flatMap(s -> s.scores().stream()).toList(),
        strengths.stream().map(Strength::percent).filter(p -> !p.isNaN()).toList(),
        List.of(t.simulation(), t.calibration(), t.diagnosis()),
        c.toString().replaceAll("\\s+", " "));
  }

  private static String group(StudiedCase c) {
    Category category = c.hidden().category();
    return (category == Category.SINGLE ? c.level().name() : category.name())
        .toLowerCase(Locale.ROOT);
  }

  /** Of a line; the opposite of {@link #toString}. */
  static CaseRow parse(String line) {
    String[] f = line.split(SEPARATOR, -1);
    if (f.length != FIELDS) {
      throw new IllegalArgumentException(
          "a line of a study has " + FIELDS + " fields, but this one " + f.length + ": " + line);
    }
    return new CaseRow(
        Long.parseLong(f[0]),
        f[1],
        f[2],
        f[3],
        f[4],
        Integer.parseInt(f[5]),
        Integer.parseInt(f[6]),
        Integer.parseInt(f[7]),
        Boolean.parseBoolean(f[8]),
        f[9],
        Double.parseDouble(f[10]),
        Double.parseDouble(f[11]),
        Boolean.parseBoolean(f[12]),
        numbers(f[13]),
        numbers(f[14]),
        numbers(f[15]),
        f[16]);
  }

  private static List<Double> numbers(String text) {
    return text.isEmpty()
        ? List.of()
        : Arrays.stream(text.split(" ")).map(Double::valueOf).toList();
  }

  private static String text(List<Double> numbers) {
    return numbers.stream()
        .map(d -> String.format(Locale.ROOT, "%.5g", d))
        .collect(Collectors.joining(" "));
  }

  /** One line. */
  @Override
  public String toString() {
    return Stream.of(
            seed,
            group,
            hidden,
            outcome,
            said,
            visible,
            found,
            wrong,
            shown,
            variable,
            rmsBefore,
            rmsAfter,
            expected,
            text(scores),
            text(percents),
            text(times),
            text)
        .map(String::valueOf)
        .collect(Collectors.joining(SEPARATOR));
  }

  boolean failed() {
    return outcome.equals("FAILED");
  }

  boolean right() {
    return outcome.equals("RIGHT") || outcome.equals("TIE");
  }

  /** All that could be seen is named, and nothing else. */
  boolean complete() {
    return !failed() && wrong == 0 && found == visible;
  }

  /** Share of what the simple model leaves above the noise that the extended model takes away. */
  double excessReduced() {
    double before = Math.sqrt(rmsBefore * rmsBefore - 1);
    return 1 - Math.sqrt(Math.max(0, rmsAfter * rmsAfter - 1)) / before;
  }

  double time(int stage) {
    return times.get(stage);
  }

  static ToDoubleFunction<CaseRow> timeOf(int stage) {
    return row -> row.time(stage);
  }
}
