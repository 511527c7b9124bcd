package fieldcal.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** {@code ./fieldcal} as the operator has it: a process of its own. */
public final class FieldcalProcess {
  /** How often its memory is looked at, ms. */
  private static final int LOOK = 10;

  private FieldcalProcess() {}

  /**
   * What it took.
   *
   * @param seconds from its start to its end
   * @param megabytes the most it had in memory; 0 where the system does not tell as Linux does
   */
  public record Used(double seconds, double megabytes) {}

  /**
   * Runs a command to its end.
   *
   * @param project where {@code fieldcal} lies
   * @param arguments of it
   * @return what it took
   * @throws IOException when it cannot be run or does not end well
   * @throws InterruptedException when the waiting is interrupted
   */
  public static Used run(Path project, List<String> arguments)
      throws IOException, InterruptedException {
    List<String> words = new ArrayList<>(List.of(project.resolve("fieldcal").toString()));
    words.addAll(arguments);
    long before = System.nanoTime();
    Process process =
        new ProcessBuilder(words)
            .directory(project.toFile())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    double resident = 0;
    while (!process.waitFor(LOOK, TimeUnit.MILLISECONDS)) {
      resident = Math.max(resident, residentMegabytes(process.pid()));
    }
    double seconds = (System.nanoTime() - before) * 1e-9;
    if (process.exitValue() != 0) {
      throw new IOException(String.join(" ", words) + " ended with status " + process.exitValue());
    }
    return new Used(seconds, resident);
  }

  /** The most it had so far; 0 after its end. */
  private static double residentMegabytes(long pid) {
    try (Stream<String> lines = Files.lines(Path.of("/proc/" + pid + "/status"))) {
      return lines
          .filter(l -> l.startsWith("VmHWM:"))
          .mapToDouble(l -> Double.parseDouble(l.replaceAll("\\D+", "")) / 1024)
          .findFirst()
          .orElse(0);
    } catch (IOException | UncheckedIOException gone) {
      return 0;
    }
  }
}
