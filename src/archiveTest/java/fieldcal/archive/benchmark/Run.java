package fieldcal.archive.benchmark;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** One run of {@code fieldcal archive} in a process of its own, as a user starts it. */
final class Run {
  private static final long LOOK_EVERY_MS = 100;

  private final Process process;
  private final Path archive;
  private final long begin = System.nanoTime();
  private long peakKilobytes;
  private double cpuSeconds;

  private Run(Process process, Path archive) {
    this.process = process;
    this.archive = archive;
  }

  /** Keeps a process, with all its threads, on the first core. */
  private static final Path ONE_CORE = Path.of("/usr/bin/taskset");

  /** Starts a run on one core, where the system can hold it there. */
  static Run onOneCore(Path logs, Path archive) throws IOException {
    List<String> prefix =
        Files.isExecutable(ONE_CORE) ? List.of(ONE_CORE.toString(), "-c", "0") : List.of();
    return start(prefix, logs, archive, "local[1,4]", false, "");
  }

  /** Starts a run; {@code javaOptions} go to its machine. */
  static Run start(Path logs, Path archive, String master, boolean resume, String javaOptions)
      throws IOException {
    return start(List.of(), logs, archive, master, resume, javaOptions);
  }

  private static Run start(
      List<String> prefix,
      Path logs,
      Path archive,
      String master,
      boolean resume,
      String javaOptions)
      throws IOException {
    Path install = Path.of(System.getProperty("fieldcal.projectDir"), "build/install");
    List<String> command = new ArrayList<>(prefix);
    command.addAll(
        List.of(
            install.resolve("fieldcal/bin/fieldcal").toString(),
            "archive",
            logs.toString(),
            "--out",
            archive.toString(),
            "--master",
            master));
    if (resume) {
      command.add("--resume");
    }
    Files.createDirectories(archive.getParent());
    File output = archive.resolveSibling(archive.getFileName() + ".txt").toFile();
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.redirectOutput(output);
    builder.environment().put("FIELDCAL_ARCHIVE", install.resolve("archive").toString());
    builder.environment().put("FIELDCAL_JAVA_OPTS", javaOptions);
    builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    return new Run(builder.start(), archive);
  }

  /** How many logs it has recorded. */
  int done() throws IOException {
    Path state = archive.resolve("state");
    if (!Files.isDirectory(state)) {
      return 0;
    }
    try (Stream<Path> files = Files.list(state)) {
      return (int) files.filter(file -> file.toString().endsWith(".done")).count();
    }
  }

  private void look() {
    try {
      for (String line : Files.readAllLines(Path.of("/proc/" + process.pid() + "/status"))) {
        if (line.startsWith("VmHWM:")) {
          peakKilobytes = Long.parseLong(line.replaceAll("\\D", ""));
        }
      }
    } catch (IOException ended) {
      // No Linux, or the process has just ended: what was seen before counts.
    }
    process.info().totalCpuDuration().ifPresent(d -> cpuSeconds = d.toMillis() / 1000.0);
  }

  /** Kills it as the system would, as soon as that many logs are recorded. */
  void killAt(int logs) throws IOException, InterruptedException {
    while (process.isAlive() && done() < logs) {
      Thread.sleep(LOOK_EVERY_MS);
    }
    process.destroyForcibly();
    process.waitFor();
  }

  /** Waits for its end; seconds that it took. */
  double await() throws IOException, InterruptedException {
    while (!process.waitFor(LOOK_EVERY_MS, TimeUnit.MILLISECONDS)) {
      look();
    }
    double seconds = (System.nanoTime() - begin) * 1e-9;
    if (process.exitValue() != 0) {
      throw new IOException(
          Files.readString(archive.resolveSibling(archive.getFileName() + ".txt")));
    }
    return seconds;
  }

  double peakMegabytes() {
    return peakKilobytes / 1024.0;
  }

  double cpuSeconds() {
    return cpuSeconds;
  }

  /** Everything in an archive but its lock and Spark's messages. */
  static Map<String, String> content(Path archive) throws IOException {
    Map<String, String> content = new TreeMap<>();
    try (Stream<Path> files = Files.walk(archive)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        content.put(
            archive.relativize(file).toString(), fieldcal.archive.match.Fingerprint.of(file));
      }
    }
    content.keySet().removeAll(List.of("lock", "spark-messages.txt"));
    return Collections.unmodifiableMap(content);
  }
}
