package fieldcal.gamelog;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import fieldcal.vision.VisionSamples;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * How fast a log of a gigabyte is read, on one core: records only, with all frames decoded, and as a recording in capture order.
 *
 * <p>Writes the log into the temporary folder and deletes it. CPU time of the reading thread is what
 * counts, so that a busy machine does not show; the heap in use afterwards shows whether memory grows with the log.
 */
public final class ReadingBenchmark {
  private static final int CAMERAS = 4;
  private static final double FRAME_INTERVAL = 1 / 73.0;
  private static final long MB = 1_000_000;
  private static final Goal RATE = Goal.atLeast(500, "%.0f MB/s");

  /** A twentieth of the log: memory does not grow with it. */
  private static final Goal HEAP = Goal.atMost(50, "%.0f MB");

  private ReadingBenchmark() {}

  /** One way of reading. */
  private interface Reading {
    long read(Path file) throws IOException;
  }

  /**
   * Prints the table.
   *
   * @param settings size of the log
   * @param out where to
   * @param findings the numbers with a goal, of the second round
   * @throws IOException if the log cannot be written
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws IOException {
    Path file = Files.createTempFile("reading-benchmark", ".log");
    try {
      write(file, settings.megabytes() * MB);
      out.printf(
          Locale.ROOT,
          "log of %.2f GB, %d cameras; MB of log per second of one core%n",
          Files.size(file) / 1e9,
          CAMERAS);
      out.printf(
          "%-30s %12s %12s %10s %10s %12s %9s  %s%n",
          "", "CPU time", "wall time", "goal", "messages", "heap after", "goal", Goal.VERDICT);
      for (int round = 1; round <= 2; round++) {
        // The first round is slower, until Java has compiled what is used most.
        Findings told = round == 1 ? new Findings() : findings;
        measure("records only", file, ReadingBenchmark::records, out, told);
        measure("every frame decoded", file, ReadingBenchmark::decoded, out, told);
        measure("recording in capture order", file, ReadingBenchmark::recording, out, told);
      }
    } finally {
      Files.delete(file);
    }
  }

  private static void write(Path file, long size) throws IOException {
    Epoch epoch = LogBuilder.EPOCH;
    VisionEncoder encoder = new VisionEncoder(epoch);
    VisionSamples samples = new VisionSamples(1);
    FieldGeometry geometry =
        samples
            .geometry()
            .withCameras(
                List.of(
                    samples.camera(0), samples.camera(1), samples.camera(2), samples.camera(3)));
    List<VisionFrame> templates = new ArrayList<>();
    for (int i = 0; i < 1000; i++) {
      templates.add(samples.frame());
    }
    byte[] field = encoder.encode(VisionPacket.of(geometry));
    long written = 0;
    try (GameLogWriter log = GameLogWriter.create(file)) {
      for (int i = 0; written < size; i++) {
        double time = 1 + i * FRAME_INTERVAL / CAMERAS;
        if (i % 1000 == 0) {
          log.write(epoch.unixNanosOf(time), MessageType.SSL_VISION_2014, field);
        }
        VisionFrame template = templates.get(i % templates.size());
        VisionFrame frame =
            new VisionFrame(
                i % CAMERAS,
                i / CAMERAS,
                time,
                time + 0.005,
                Double.NaN,
                template.balls(),
                template.robots());
        byte[] packet = encoder.encode(VisionPacket.of(frame));
        log.write(epoch.unixNanosOf(time + 0.006), MessageType.SSL_VISION_2014, packet);
        written += packet.length + RecordHeader.LENGTH;
      }
    }
  }

  private static void measure(
      String what, Path file, Reading reading, PrintStream out, Findings findings)
      throws IOException {
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long cpu = threads.getCurrentThreadCpuTime();
    long wall = System.nanoTime();
    long count = reading.read(file);
    double cpuSeconds = (threads.getCurrentThreadCpuTime() - cpu) * 1e-9;
    double wallSeconds = (System.nanoTime() - wall) * 1e-9;
    System.gc();
    double heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1e6;
    double rate = Files.size(file) / 1e6 / cpuSeconds;
    out.printf(
        Locale.ROOT,
        "%-30s %7.0f MB/s %7.0f MB/s %10s %10d %9.1f MB %9s  %s%n",
        what,
        rate,
        Files.size(file) / 1e6 / wallSeconds,
        RATE,
        count,
        heap,
        HEAP,
        Goal.verdict(RATE.met(rate) && HEAP.met(heap)));
    findings.value("reading, " + what + ", per core", "%.0f MB/s", rate, RATE);
    findings.value("reading, " + what + ": heap afterwards", "%.0f MB", heap, HEAP);
  }

  private static long records(Path file) throws IOException {
    long count = 0;
    try (GameLogReader log = GameLogReader.open(file)) {
      while (log.next()) {
        count++;
      }
    }
    return count;
  }

  private static long decoded(Path file) throws IOException {
    VisionDecoder decoder = new VisionDecoder(LogBuilder.EPOCH);
    long count = 0;
    try (GameLogReader log = GameLogReader.open(file)) {
      while (log.next()) {
        VisionPacket packet =
            decoder.decode(log.buffer(), log.payloadOffset(), log.payloadLength());
        count += packet.frame().isPresent() ? 1 : 0;
      }
    }
    return count;
  }

  private static long recording(Path file) throws IOException {
    try (RecordingReader recording = RecordingReader.open(file)) {
      return recording.read(new RecordingListener() {}).frames();
    }
  }
}
