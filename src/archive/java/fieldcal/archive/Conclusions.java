package fieldcal.archive;

import fieldcal.archive.table.Row;
import fieldcal.archive.table.Tables;
import fieldcal.archive.venue.Carpet;
import fieldcal.archive.venue.Change;
import fieldcal.archive.venue.MatchFacts;
import fieldcal.archive.venue.VenueFinder;
import fieldcal.archive.venue.VenueStudy;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * What follows from all logs together.
 *
 * @param summaries of all logs
 * @param venues with their carpets and changes
 * @param teams of all tournaments
 */
record Conclusions(List<MatchSummary> summaries, List<VenueStudy> venues, List<TeamStudy> teams) {

  /** Which teams played in which tournaments; matches without names are of no team. */
  static List<TeamMatches> teams(List<MatchSummary> summaries) {
    Map<String, Map<String, List<LogFile>>> found = new TreeMap<>();
    for (MatchSummary summary : summaries) {
      summary.teams().stream()
          .filter(Objects::nonNull)
          .distinct()
          .forEach(
              team ->
                  found
                      .computeIfAbsent(summary.log().tournament(), t -> new TreeMap<>())
                      .computeIfAbsent(team, t -> new ArrayList<>())
                      .add(summary.log()));
    }
    List<TeamMatches> teams = new ArrayList<>();
    found.forEach(
        (tournament, byTeam) ->
            byTeam.forEach((team, logs) -> teams.add(new TeamMatches(tournament, team, logs))));
    return teams;
  }

  static List<VenueStudy> venues(List<MatchSummary> summaries) {
    List<MatchFacts> matches =
        summaries.stream().map(MatchSummary::facts).filter(Objects::nonNull).toList();
    return VenueFinder.find(matches).stream().map(VenueStudy::of).toList();
  }

  /** Carpet of each match that has one, by its log. */
  Map<String, Carpet> carpets() {
    Map<String, Carpet> carpets = new HashMap<>();
    for (VenueStudy venue : venues) {
      for (Carpet carpet : venue.carpets()) {
        carpet.matches().forEach(match -> carpets.put(match.log(), carpet));
      }
    }
    return carpets;
  }

  List<Row> carpetRows() {
    List<Row> rows = new ArrayList<>();
    for (VenueStudy venue : venues) {
      for (Carpet carpet : venue.carpets()) {
        carpet
            .parameters()
            .forEach((parameter, pooled) -> rows.add(row(carpet, parameter, pooled)));
      }
    }
    return rows;
  }

  private static Row row(Carpet carpet, String parameter, Carpet.Pooled pooled) {
    List<MatchFacts> matches = carpet.matches();
    return Tables.CARPETS
        .row()
        .set("venue", carpet.venue())
        .set("carpet", carpet.name())
        .set("first", matches.get(0).start())
        .set("last", matches.get(matches.size() - 1).start())
        .set("parameter", parameter)
        .set("matches", pooled.n())
        .set("value", pooled.value())
        .set("standard_error", pooled.error())
        .set("scatter", pooled.scatter())
        .set("drift", pooled.drift())
        .set("drift_error", pooled.driftError())
        .set("published", pooled.published());
  }

  List<Row> changeRows() {
    List<Row> rows = new ArrayList<>();
    for (VenueStudy venue : venues) {
      for (Change change : venue.changes()) {
        rows.add(
            Tables.CHANGES
                .row()
                .set("venue", change.venue())
                .set("kind", change.kind().id())
                .set("camera", change.camera().isPresent() ? change.camera().getAsInt() : null)
                .set("after", change.last().end())
                .set("before", change.next().start())
                .set("last_match", change.last().log())
                .set("next_match", change.next().log())
                .set("what", change.what())
                .set("sigmas", change.sigmas()));
      }
    }
    return rows;
  }

  List<Row> teamRows() {
    return teams.stream().flatMap(team -> team.rows().stream()).toList();
  }
}
