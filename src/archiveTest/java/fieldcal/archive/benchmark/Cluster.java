package fieldcal.archive.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Spark's standalone cluster on this machine: a master and workers of one core each, started and ended by whoever made it. */
final class Cluster implements AutoCloseable {
  private static final int PORT = 17077;
  private static final double STARTS_WITHIN = 30;

  private final Path folder;
  private final List<Process> processes = new ArrayList<>();

  private Cluster(Path folder) {
    this.folder = folder;
  }

  static Cluster start(Path folder, int workers) throws IOException, InterruptedException {
    Files.createDirectories(folder);
    Cluster cluster = new Cluster(folder);
    cluster.start(
        "master",
        "org.apache.spark.deploy.master.Master",
        "--host",
        "127.0.0.1",
        "--port",
        "" + PORT,
        "--webui-port",
        "0");
    cluster.awaitLine("master", "Starting Spark master");
    for (int i = 0; i < workers; i++) {
      cluster.start(
          "worker-" + i,
          "org.apache.spark.deploy.worker.Worker",
          "--host",
          "127.0.0.1",
          "--webui-port",
          "0",
          "-c",
          "1",
          "-m",
          "2g",
          "--work-dir",
          folder.resolve("work-" + i).toString(),
          cluster.url());
      cluster.awaitLine("worker-" + i, "Successfully registered");
    }
    return cluster;
  }

  String url() {
    return "spark://127.0.0.1:" + PORT;
  }

  private void start(String name, String type, String... arguments) throws IOException {
    Path home = Path.of(System.getProperty("fieldcal.projectDir"), "build/install/archive");
    List<String> command = new ArrayList<>(List.of("java"));
    command.addAll(Arrays.asList(Files.readString(home.resolve("java-options")).split(" ")));
    command.addAll(List.of("-cp", home.resolve("jars") + "/*", type));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.redirectOutput(folder.resolve(name + ".txt").toFile());
    builder.environment().put("SPARK_HOME", home.toString());
    builder.environment().put("SPARK_SCALA_VERSION", "2.13");
    builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    processes.add(builder.start());
  }

  private void awaitLine(String name, String line) throws IOException, InterruptedException {
    long until = System.nanoTime() + (long) (STARTS_WITHIN * 1e9);
    while (!Files.readString(folder.resolve(name + ".txt")).contains(line)) {
      if (System.nanoTime() > until) {
        throw new IOException(
            name + " does not start: " + Files.readString(folder.resolve(name + ".txt")));
      }
      Thread.sleep(100);
    }
  }

  /** Kills a worker and what it runs, as a machine that loses its power. */
  void killWorker(int worker) {
    end(processes.get(1 + worker));
  }

  private static void end(Process process) {
    List<ProcessHandle> children = process.descendants().toList();
    process.destroyForcibly();
    children.forEach(ProcessHandle::destroyForcibly);
    process.onExit().orTimeout(10, TimeUnit.SECONDS).join();
  }

  @Override
  public void close() {
    for (int i = processes.size() - 1; i >= 0; i--) {
      end(processes.get(i));
    }
  }
}
