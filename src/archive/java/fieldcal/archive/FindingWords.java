package fieldcal.archive;

import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.archive.venue.Carpet;
import fieldcal.archive.venue.Change;
import fieldcal.archive.venue.MatchFacts;
import fieldcal.archive.venue.VenueStudy;
import java.math.BigDecimal;
import java.math.MathContext;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** The conclusions for people, one line each. */
final class FindingWords {
  private static final DateTimeFormatter MINUTES =
      DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT).withZone(ZoneOffset.UTC);

  private FindingWords() {}

  static List<String> of(Conclusions conclusions) {
    List<String> lines = new ArrayList<>();
    for (VenueStudy venue : conclusions.venues()) {
      List<MatchFacts> matches = venue.venue().matches();
      lines.add(
          String.format(
              Locale.ROOT,
              "%s: %s of %s, %s to %s UTC",
              venue.venue().name(),
              count(matches.size()),
              matches.stream()
                  .map(MatchFacts::tournament)
                  .distinct()
                  .collect(Collectors.joining(", ")),
              time(matches.get(0).start()),
              time(matches.get(matches.size() - 1).end())));
      for (Carpet carpet : venue.carpets()) {
        lines.add("  " + carpet.name() + ": " + model(carpet));
      }
      venue.changes().forEach(change -> lines.add("  " + words(change)));
    }
    return lines;
  }

  private static String count(int matches) {
    return matches == 1 ? "1 match" : matches + " matches";
  }

  private static String model(Carpet carpet) {
    String parameters =
        carpet.parameters().entrySet().stream()
            .filter(e -> e.getKey().startsWith("acc_"))
            .map(
                e ->
                    String.format(
                        Locale.ROOT,
                        "%s %s ± %s m/s²",
                        ParameterWords.ofFileName(e.getKey()),
                        Amount.minus(String.format(Locale.ROOT, "%.4g", e.getValue().value())),
                        plain(e.getValue().error())))
            .collect(Collectors.joining(", "));
    return count(carpet.matches().size()) + (parameters.isEmpty() ? "" : ", " + parameters);
  }

  /** Two digits, never as a power of ten. */
  private static String plain(double error) {
    return Double.isFinite(error)
        ? new BigDecimal(error).round(new MathContext(2)).toPlainString()
        : "unknown";
  }

  /** A change with its time. */
  static String words(Change change) {
    String kind =
        switch (change.kind()) {
          case CARPET_OR_BALL -> "another carpet or ball: ";
          case BALL -> "another ball: ";
          default -> "";
        };
    return "between "
        + time(change.last().end())
        + " and "
        + time(change.next().start())
        + " UTC: "
        + kind
        + change.what();
  }

  static String time(long micros) {
    return MINUTES.format(Instant.ofEpochSecond(Math.floorDiv(micros, 1_000_000L)));
  }
}
