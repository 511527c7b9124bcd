package fieldcal.archive;

import fieldcal.app.files.WholeFile;
import fieldcal.archive.atlas.AtlasPage;
import fieldcal.archive.atlas.AtlasView;
import fieldcal.archive.venue.CameraFacts;
import fieldcal.archive.venue.Carpet;
import fieldcal.archive.venue.Change;
import fieldcal.archive.venue.MatchFacts;
import fieldcal.archive.venue.Measured;
import fieldcal.archive.venue.VenueStudy;
import fieldcal.movement.Grid;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;

/** From the conclusions to the page. */
final class Atlas {
  /** Kicks that the page lists; all are in the table. */
  private static final int LISTED = 100;

  private static final double MICRO = 1e-6;

  private Atlas() {}

  static void write(Conclusions conclusions, ArchiveFolder folder) throws IOException {
    WholeFile.write(
        AtlasPage.html(view(conclusions)), Path.of(folder.root()).resolve("archive.html"));
  }

  private static AtlasView view(Conclusions conclusions) {
    List<MatchSummary> summaries = conclusions.summaries();
    Map<String, Carpet> carpets = conclusions.carpets();
    double play = 0;
    long kicks = 0;
    List<AtlasView.Broken> broken = new ArrayList<>();
    for (MatchSummary summary : summaries) {
      kicks += summary.kicks();
      if (summary.facts() == null) {
        broken.add(
            new AtlasView.Broken(
                summary.log().tournament(), summary.log().name(), summary.fatal()));
      } else {
        play += MICRO * (summary.facts().end() - summary.facts().start()) / 60;
      }
    }
    String version = Atlas.class.getPackage().getImplementationVersion();
    return new AtlasView(
        "fieldcal " + (version == null ? "(development)" : version),
        summaries.size(),
        play,
        kicks,
        FindingWords.of(conclusions),
        conclusions.venues().stream().map(venue -> venue(venue, carpets)).toList(),
        conclusions.teams().stream().map(Atlas::team).toList(),
        MatchSummary.BIN,
        speeds(summaries),
        fast(summaries),
        trackers(summaries),
        broken,
        problems(summaries));
  }

  private static AtlasView.Venue venue(VenueStudy study, Map<String, Carpet> carpets) {
    List<MatchFacts> matches = study.venue().matches();
    return new AtlasView.Venue(
        study.venue().name(),
        matches.stream().map(MatchFacts::tournament).distinct().toList(),
        matches.get(0).fieldLength(),
        matches.get(0).fieldWidth(),
        matches.stream().map(match -> match(match, carpets.get(match.log()))).toList(),
        study.carpets().stream().map(Atlas::carpet).toList(),
        study.changes().stream().map(Atlas::change).toList(),
        cameras(matches));
  }

  private static AtlasView.Match match(MatchFacts match, Carpet carpet) {
    List<AtlasView.Value> model = new ArrayList<>();
    List<AtlasView.Value> published = new ArrayList<>();
    for (String parameter : VenueStudy.PARAMETERS) {
      Measured measured = match.model().get(parameter);
      if (measured != null) {
        model.add(new AtlasView.Value(parameter, measured.value(), measured.error()));
      }
      Double its = match.published().get(parameter);
      if (its != null) {
        published.add(new AtlasView.Value(parameter, its, Double.NaN));
      }
    }
    return new AtlasView.Match(
        match.file(),
        MICRO * match.start(),
        carpet == null ? null : carpet.name(),
        model,
        published);
  }

  private static AtlasView.Carpet carpet(Carpet carpet) {
    List<AtlasView.Parameter> parameters = new ArrayList<>();
    carpet
        .parameters()
        .forEach(
            (name, p) ->
                parameters.add(
                    new AtlasView.Parameter(
                        name,
                        p.value(),
                        p.error(),
                        p.scatter(),
                        p.n(),
                        p.drift(),
                        p.driftError(),
                        p.published())));
    List<MatchFacts> matches = carpet.matches();
    return new AtlasView.Carpet(
        carpet.name(),
        MICRO * matches.get(0).start(),
        MICRO * matches.get(matches.size() - 1).start(),
        matches.size(),
        parameters);
  }

  private static AtlasView.Change change(Change change) {
    return new AtlasView.Change(
        MICRO * change.last().end(),
        MICRO * change.next().start(),
        change.kind().id(),
        FindingWords.words(change));
  }

  private static List<AtlasView.Camera> cameras(List<MatchFacts> matches) {
    Map<Integer, List<CameraFacts>> byId = new TreeMap<>();
    for (MatchFacts match : matches) {
      match.cameras().forEach(c -> byId.computeIfAbsent(c.id(), id -> new ArrayList<>()).add(c));
    }
    List<AtlasView.Camera> cameras = new ArrayList<>();
    byId.forEach(
        (id, all) ->
            cameras.add(
                new AtlasView.Camera(
                    id,
                    all.size(),
                    median(all, CameraFacts::rate),
                    median(all, CameraFacts::noise),
                    median(all, CameraFacts::jitter),
                    median(all, CameraFacts::loss),
                    all.stream().mapToLong(CameraFacts::gaps).sum(),
                    median(all, c -> Math.hypot(c.offsetX().value(), c.offsetY().value())),
                    median(all, CameraFacts::distortion))));
    return cameras;
  }

  private static double median(List<CameraFacts> cameras, ToDoubleFunction<CameraFacts> of) {
    return StatUtils.percentile(
        cameras.stream().mapToDouble(of).filter(Double::isFinite).toArray(), 50);
  }

  private static AtlasView.Team team(TeamStudy study) {
    return new AtlasView.Team(
        study.matches().tournament(),
        study.matches().team(),
        study.matches().logs().size(),
        study.manoeuvres(),
        study.quantities().stream()
            .map(
                q ->
                    new AtlasView.Quantity(
                        q.name(),
                        q.robot() == null ? -1 : q.robot(),
                        q.direction() == null ? Double.NaN : q.direction(),
                        q.value(),
                        q.error(),
                        q.samples(),
                        q.reached(),
                        q.note()))
            .toList(),
        picture(study.ownFrame()),
        picture(study.againstSpeed()),
        picture(study.standing()),
        study.standingNoise());
  }

  private static AtlasView.Picture picture(Grid.Occupied cells) {
    return new AtlasView.Picture(
        cells.widthX(), cells.widthY(), cells.x(), cells.y(), cells.count());
  }

  private static List<AtlasView.Speeds> speeds(List<MatchSummary> summaries) {
    Map<String, long[]> all = new TreeMap<>();
    for (MatchSummary summary : summaries) {
      summary
          .speeds()
          .forEach(
              (team, bins) -> {
                long[] sum = all.computeIfAbsent(team, key -> new long[MatchSummary.BINS]);
                for (int i = 0; i < sum.length; i++) {
                  sum[i] += bins[i];
                }
              });
    }
    List<AtlasView.Speeds> speeds = new ArrayList<>();
    all.forEach(
        (team, bins) -> speeds.add(new AtlasView.Speeds(team, bins, Arrays.stream(bins).sum())));
    return speeds;
  }

  private static List<AtlasView.Fast> fast(List<MatchSummary> summaries) {
    return summaries.stream()
        .flatMap(summary -> summary.fast().stream())
        .sorted(
            Comparator.comparingDouble(FastKick::odds)
                .thenComparingDouble(FastKick::speed)
                .reversed()
                .thenComparingLong(FastKick::time)
                .thenComparing(FastKick::file))
        .limit(LISTED)
        .map(
            k ->
                new AtlasView.Fast(
                    k.tournament(),
                    k.file(),
                    MICRO * k.time(),
                    k.team(),
                    k.robot(),
                    k.kind(),
                    k.speed(),
                    k.error(),
                    k.odds(),
                    k.rolling(),
                    k.maySpin()))
        .toList();
  }

  /** Each tracker of each tournament. */
  private static List<AtlasView.Tracker> trackers(List<MatchSummary> summaries) {
    Map<String, Map<String, List<TrackerFacts>>> found = new TreeMap<>();
    for (MatchSummary summary : summaries) {
      for (TrackerFacts tracker : summary.trackers()) {
        found
            .computeIfAbsent(summary.log().tournament(), t -> new TreeMap<>())
            .computeIfAbsent(tracker.source(), t -> new ArrayList<>())
            .add(tracker);
      }
    }
    List<AtlasView.Tracker> trackers = new ArrayList<>();
    found.forEach(
        (tournament, bySource) ->
            bySource
                .values()
                .forEach(all -> trackers.add(tracker(tournament, TrackerFacts.pooled(all)))));
    return trackers;
  }

  private static AtlasView.Tracker tracker(String tournament, TrackerFacts t) {
    return new AtlasView.Tracker(
        tournament,
        t.source(),
        t.matches(),
        t.delay(),
        t.position(),
        t.velocity(),
        t.kicks(),
        t.matched(),
        t.missed(),
        t.invented(),
        t.speedBias(),
        t.speedScatter(),
        t.stops(),
        t.stopPosition(),
        t.stopTime());
  }

  private static List<AtlasView.Problem> problems(List<MatchSummary> summaries) {
    Map<String, Long> logs = new TreeMap<>();
    summaries.stream()
        .filter(summary -> summary.facts() != null)
        .forEach(summary -> summary.problems().keySet().forEach(w -> logs.merge(w, 1L, Long::sum)));
    return logs.entrySet().stream()
        .map(e -> new AtlasView.Problem(e.getKey(), e.getValue()))
        .sorted(
            Comparator.comparingLong(AtlasView.Problem::logs)
                .reversed()
                .thenComparing(AtlasView.Problem::what))
        .toList();
  }
}
