package fieldcal.archive;

import fieldcal.app.archive.ArchiveEngine;
import fieldcal.app.archive.ArchiveProgress;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.recording.LogOpener;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.apache.spark.SparkConf;
import org.apache.spark.SparkException;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.scheduler.SparkListener;
import org.apache.spark.scheduler.SparkListenerTaskEnd;
import org.apache.spark.util.DoubleAccumulator;

/** Spark, as the archive uses it: lists in, lists out, one element for each task. */
final class Engine implements AutoCloseable {
  /** A task that dies is tried again; in one process Spark would give up at once. As many times as on a cluster. */
  private static final String ALL_CORES = "local[*,4]";

  /** The newest Java that Spark 4.0 runs on is 21; 22 and 23 still have what it needs, 24 has not. */
  private static final int NEWEST_JAVA = 23;

  /** What the driver remembers of tasks that are over: it must not grow with the number of logs. */
  private static final String REMEMBERED = "100";

  private final JavaSparkContext context;

  private Engine(JavaSparkContext context) {
    this.context = context;
  }

  /** Starts Spark, or joins the cluster. */
  static Engine start(Optional<String> master) throws IOException {
    int java = Runtime.version().feature();
    if (java > NEWEST_JAVA) {
      throw new InputException(
          "archive: Apache Spark 4.0 does not run on Java "
              + java
              + "; set JAVA_HOME to a Java 17 or 21");
    }
    SparkConf conf =
        new SparkConf().setAppName("fieldcal archive").set("spark.ui.enabled", "false");
    master.ifPresent(conf::setMaster);
    conf.setIfMissing("spark.master", ALL_CORES);
    for (String kept : List.of("Jobs", "Stages", "Tasks")) {
      conf.set("spark.ui.retained" + kept, REMEMBERED);
    }
    if (conf.get("spark.master").startsWith("local")) {
      conf.set("spark.driver.host", "127.0.0.1").set("spark.driver.bindAddress", "127.0.0.1");
    } else {
      // The cluster has Spark; of what we bring, ours comes first.
      conf.setIfMissing("spark.jars", ownJars());
      conf.setIfMissing("spark.executor.userClassPathFirst", "true");
    }
    try {
      return new Engine(new JavaSparkContext(conf));
    } catch (Exception e) {
      // Scala declares nothing: also checked ones.
      throw new InputException(
          "archive: Spark does not start on '" + conf.get("spark.master") + "': " + firstLine(e));
    }
  }

  /** What is on the class path beside the folder {@code jars}, which holds Spark. */
  private static String ownJars() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
        .filter(jar -> jar.endsWith(".jar"))
        .filter(jar -> !Path.of(jar).toAbsolutePath().getParent().endsWith("jars"))
        .collect(Collectors.joining(","));
  }

  /** Finds out which log each file is; the order stays. */
  List<LogFile> identify(List<LogFile> files) throws IOException {
    return collect(() -> context.parallelize(files, files.size()).map(LogTask::identify).collect());
  }

  /** Reads logs, the largest first, so that none is left for the end; gives them back, without fingerprint those that changed meanwhile. */
  List<LogFile> read(
      List<LogFile> logs, ArchiveFolder folder, LogOpener opener, ArchiveEngine.Progress progress)
      throws IOException {
    List<LogFile> order =
        logs.stream()
            .sorted(Comparator.comparingLong(LogFile::bytes).reversed().thenComparing(LogFile::log))
            .toList();
    DoubleAccumulator play = context.sc().doubleAccumulator("play");
    Watch watch = new Watch(order, play, progress);
    context.sc().addSparkListener(watch);
    try {
      List<LogFile> read =
          collect(
              () ->
                  context
                      .parallelize(order, order.size())
                      .map(
                          log -> {
                            LogTask.Done done = LogTask.run(log, folder, opener, attempt(log));
                            play.add(done.play());
                            return done.log();
                          })
                      .collect());
      watch.allDone();
      return read;
    } finally {
      context.sc().removeSparkListener(watch);
    }
  }

  /** Reads the tables again, for what follows from all of them: a summary of each log, and each team in each tournament. */
  Conclusions conclude(List<LogFile> logs, ArchiveFolder folder) throws IOException {
    List<MatchSummary> summaries =
        collect(
            () ->
                context
                    .parallelize(logs, logs.size())
                    .map(log -> MatchSummary.of(log, folder))
                    .collect());
    List<TeamMatches> teams = Conclusions.teams(summaries);
    List<TeamStudy> studies =
        teams.isEmpty()
            ? List.of()
            : collect(
                () ->
                    context
                        .parallelize(teams, teams.size())
                        .map(team -> TeamStudy.of(team, folder))
                        .collect());
    return new Conclusions(summaries, Conclusions.venues(summaries), studies);
  }

  private static String attempt(LogFile log) {
    return log.log() + "-" + TaskContext.get().taskAttemptId();
  }

  /** Something that Spark does. */
  private interface Job<T> {
    List<T> run();
  }

  private static <T> List<T> collect(Job<T> job) throws IOException {
    try {
      return job.run();
    } catch (RuntimeException e) {
      throw e;
    } catch (Exception e) {
      // Scala declares nothing, so the compiler does not know what comes.
      if (e instanceof SparkException) {
        throw new IOException("archive: Spark gave up: " + firstLine(e), e);
      }
      throw new IllegalStateException(e);
    }
  }

  private static String firstLine(Exception e) {
    return String.valueOf(e.getMessage()).lines().findFirst().orElse("");
  }

  @Override
  public void close() {
    context.close();
  }

  /** Follows the tasks. */
  private static final class Watch extends SparkListener {
    private final List<LogFile> order;
    private final DoubleAccumulator play;
    private final ArchiveEngine.Progress progress;
    private final long bytes;
    private int done;
    private long bytesDone;

    Watch(List<LogFile> order, DoubleAccumulator play, ArchiveEngine.Progress progress) {
      this.order = order;
      this.play = play;
      this.progress = progress;
      bytes = order.stream().mapToLong(LogFile::bytes).sum();
    }

    @Override
    public synchronized void onTaskEnd(SparkListenerTaskEnd end) {
      if (end.taskInfo().successful() && done < order.size()) {
        done++;
        bytesDone += order.get(end.taskInfo().index()).bytes();
        tell();
      }
    }

    /** Spark tells the ends of tasks from a thread of its own, of the last ones possibly too late. */
    synchronized void allDone() {
      if (done < order.size()) {
        done = order.size();
        bytesDone = bytes;
        tell();
      }
    }

    private void tell() {
      progress.at(new ArchiveProgress(order.size(), done, bytes, bytesDone, play.value()));
    }
  }
}
