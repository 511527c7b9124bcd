package fieldcal.archive.benchmark;

import fieldcal.archive.table.ParquetFile;
import fieldcal.archive.table.Row;
import fieldcal.archive.table.Table;
import fieldcal.archive.table.Tables;
import fieldcal.archive.venue.VenueStudy;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Draws an archive, runs {@code fieldcal archive} on it in processes of its own, and prints what came out beside what is true. */
public final class ArchiveBenchmark {
  private static final String NO_OPTIONS = "";

  private final DrawnArchive drawn;
  private final Path folder;
  private final Path logs;
  private int missed;

  private ArchiveBenchmark(DrawnArchive drawn, Path folder) {
    this.drawn = drawn;
    this.folder = folder;
    this.logs = drawn.folder();
  }

  /**
   * Runs the benchmark.
   *
   * @param args {@code --matches N} (default 24), {@code --minutes M} (3), {@code --seed S} (1), {@code --dir DIR} (a temporary one)
   * @throws Exception when something cannot be run
   */
  public static void main(String[] args) throws Exception {
    Map<String, String> options = new TreeMap<>();
    for (int i = 0; i + 1 < args.length; i += 2) {
      options.put(args[i], args[i + 1]);
    }
    int matches = Integer.parseInt(options.getOrDefault("--matches", "24"));
    double minutes = Double.parseDouble(options.getOrDefault("--minutes", "3"));
    long seed = Long.parseLong(options.getOrDefault("--seed", "1"));
    Path folder =
        options.containsKey("--dir")
            ? Path.of(options.get("--dir")).toAbsolutePath()
            : Files.createTempDirectory("fieldcal-archive");
    DrawnArchive drawn = DrawnArchive.plan(folder.resolve("logs"), matches, seed);
    long begin = System.nanoTime();
    if (!Files.exists(drawn.folder())) {
      drawn.write(minutes);
    }
    say(
        "drawn: %d matches of %.1f minutes, %d broken logs, seed %d, in %.0f s; in %s",
        matches, minutes, drawn.broken().size(), seed, (System.nanoTime() - begin) * 1e-9, folder);
    int status = new ArchiveBenchmark(drawn, folder).run();
    if (!options.containsKey("--dir")) {
      delete(folder);
    }
    System.exit(status);
  }

  private static void say(String format, Object... values) {
    System.out.println(String.format(Locale.ROOT, format, values));
  }

  private void judge(boolean good, String format, Object... values) {
    missed += good ? 0 : 1;
    say((good ? "  ok      " : "  MISSED  ") + format, values);
  }

  private int run() throws Exception {
    int cores = Runtime.getRuntime().availableProcessors();
    int all = drawn.matches().size() + drawn.broken().size();
    Path whole = clean("whole");
    Run run = Run.start(logs, whole, "local[" + cores + ",4]", false, NO_OPTIONS);
    double seconds = run.await();
    Path alone = clean("alone");
    Run single = Run.onOneCore(logs, alone);
    double secondsAlone = single.await();
    double play = rows(whole, Tables.MATCHES).stream().mapToDouble(r -> r.number("duration")).sum();
    say("speed");
    say(
        "  %d cores: %.1f s, %.1f minutes of play per second, %.0f MB at most, %.1f s of CPU",
        cores, seconds, play / 60 / seconds, run.peakMegabytes(), run.cpuSeconds());
    say(
        "  1 core: %.1f s, %.1f minutes of play per second, %.0f MB at most, %.1f s of CPU; %.0f"
            + " times real time for each s of CPU",
        secondsAlone,
        play / 60 / secondsAlone,
        single.peakMegabytes(),
        single.cpuSeconds(),
        play / single.cpuSeconds());
    say(
        "  throughput of %d cores: %.2f of %d × one process on one core (goal 0.9; only an idle"
            + " machine shows it)",
        cores, secondsAlone / seconds / cores, cores);
    say("tables");
    judge(
        Run.content(whole).equals(Run.content(alone)),
        "the same with 1 and %d threads: %d files",
        cores,
        Run.content(whole).size());
    judge(
        rows(whole, Tables.PROBLEMS).stream().filter(r -> (Boolean) r.get("fatal")).count()
            == drawn.broken().size(),
        "%d broken logs are one row each",
        drawn.broken().size());
    compareTruth(whole);
    say("killed with -9, and resumed");
    Path killed = clean("killed");
    for (int part = 1; part <= 2; part++) {
      Run victim = Run.start(logs, killed, "local[" + cores + ",4]", part > 1, NO_OPTIONS);
      victim.killAt(part * all / 3);
      say("  killed with %d of %d logs done", victim.done(), all);
    }
    Run.start(logs, killed, "local[" + cores + ",4]", true, NO_OPTIONS).await();
    judge(Run.content(whole).equals(Run.content(killed)), "tables are identical");
    cluster(whole, all);
    say(missed == 0 ? "all reached" : "%d missed", missed);
    return missed == 0 ? 0 : 1;
  }

  private void cluster(Path whole, int all) throws Exception {
    say(
        "standalone cluster with two workers on loopback, one killed at a third; driver with 512"
            + " MB");
    Path clustered = clean("clustered");
    try (Cluster cluster = Cluster.start(clean("cluster"), 2)) {
      Run run = Run.start(logs, clustered, cluster.url(), false, "-Xmx512m");
      while (run.done() < all / 3) {
        Thread.sleep(100);
      }
      cluster.killWorker(0);
      say("  worker killed with %d of %d logs done", run.done(), all);
      double seconds = run.await();
      say("  %.1f s, driver %.0f MB at most", seconds, run.peakMegabytes());
    }
    judge(
        Run.content(whole).equals(Run.content(clustered)),
        "the job ends, and tables are identical");
  }

  private void compareTruth(Path archive) throws IOException {
    Map<String, Row> matches = new TreeMap<>();
    rows(archive, Tables.MATCHES).forEach(row -> matches.put(row.text("file"), row));
    say("venues");
    long venues = matches.values().stream().map(row -> row.text("venue")).distinct().count();
    judge(venues == 3, "3 drawn, %d found", venues);
    judge(
        drawn.matches().stream()
            .allMatch(m -> matches.get(m.file()).text("venue").equals("V0" + (m.venue() + 1))),
        "every match is at its venue");
    say("changes");
    List<Row> changes = rows(archive, Tables.CHANGES);
    for (int venue = 0; venue < 3; venue++) {
      DrawnArchive.Match drawnChange = drawn.change(venue).orElseThrow();
      String kind = drawnChange.knocked() ? "camera_moved" : "carpet_or_ball";
      String log = matches.get(drawnChange.file()).text("log");
      judge(
          changes.stream()
              .anyMatch(c -> c.text("next_match").equals(log) && c.text("kind").equals(kind)),
          "%s before %s",
          kind,
          drawnChange.file());
    }
    judge(changes.size() == 3, "3 drawn, %d found", changes.size());
    changes.forEach(
        c -> say("          %s: %s, %s", c.text("venue"), c.text("kind"), c.text("what")));
    comparePooled(archive, matches);
    compareTeams(archive);
  }

  private void comparePooled(Path archive, Map<String, Row> matches) throws IOException {
    say("pooled parameters");
    int within = 0;
    int count = 0;
    for (Row row : rows(archive, Tables.CARPETS)) {
      double[] truth =
          drawn.matches().stream()
              .filter(m -> row.text("carpet").equals(matches.get(m.file()).text("carpet")))
              .findFirst()
              .orElseThrow()
              .ball();
      double true_ = truth[VenueStudy.PARAMETERS.indexOf(row.text("parameter"))];
      double sigmas = (row.number("value") - true_) / row.number("standard_error");
      boolean good = Math.abs(sigmas) <= 3;
      within += good ? 1 : 0;
      count++;
      say(
          "  %s %s %.5f ± %.5f, true %.5f: %+.1f standard errors%s",
          row.text("carpet"),
          row.text("parameter"),
          row.number("value"),
          row.number("standard_error"),
          true_,
          sigmas,
          good ? "" : " (!)");
    }
    judge(within == count, "%d of %d within 3 standard errors", within, count);
  }

  private void compareTeams(Path archive) throws IOException {
    say("limits of the teams, in all tournaments");
    List<String> names = List.of("velocity_max", "acceleration_max", "braking_max");
    double[] worst = new double[3];
    int[] counts = new int[3];
    for (Row row : rows(archive, Tables.TEAMS)) {
      int quantity = names.indexOf(row.text("quantity"));
      if (quantity >= 0 && Boolean.TRUE.equals(row.get("reached"))) {
        double truth = DrawnArchive.LIMITS[DrawnArchive.TEAMS.indexOf(row.text("team"))][quantity];
        worst[quantity] = Math.max(worst[quantity], Math.abs(row.number("value") / truth - 1));
        counts[quantity]++;
      }
    }
    for (int i = 0; i < 3; i++) {
      judge(
          worst[i] < 0.05,
          "%s: %d estimates, the worst %.1f %% off",
          names.get(i),
          counts[i],
          100 * worst[i]);
    }
  }

  private static List<Row> rows(Path archive, Table table) throws IOException {
    List<Row> rows = new ArrayList<>();
    try (Stream<Path> files = Files.walk(archive.resolve(table.name()))) {
      for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
        rows.addAll(ParquetFile.read(table, file));
      }
    }
    return rows;
  }

  private Path clean(String name) throws IOException {
    Path place = folder.resolve(name);
    if (Files.exists(place)) {
      delete(place);
    }
    return place;
  }

  private static void delete(Path folder) throws IOException {
    Path[] all;
    try (Stream<Path> files = Files.walk(folder)) {
      all = files.sorted(Comparator.reverseOrder()).toArray(Path[]::new);
    }
    for (Path one : Arrays.asList(all)) {
      Files.delete(one);
    }
  }
}
