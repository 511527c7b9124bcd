package fieldcal.benchmark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * What other programs compute while ours do, from Linux's counters: what all cores were busy, without this process and the children that it waited for.
 *
 * @param busy time of all cores, ticks
 * @param own time of this process and of its ended children, ticks
 * @param nanos when that was
 */
record OwnCpu(long busy, long own, long nanos) {
  /** Ticks of a second, as every Linux counts. */
  private static final double TICKS = 100;

  private static final Path MACHINE = Path.of("/proc/stat");
  private static final Path PROCESS = Path.of("/proc/self/stat");

  /** Idle, and idle while something is read. */
  private static final int IDLE = 3;

  private static final int IO_WAIT = 4;

  /** Counters of a machine; what guests take is in the first two already. */
  private static final int COUNTERS = 8;

  /** User and system time of the process and of its children, counted behind its name. */
  private static final int FIRST_TIME = 11;

  private static final int TIMES = 4;

  static OwnCpu now() throws IOException {
    String[] all = Files.readString(MACHINE).lines().findFirst().orElseThrow().split("\\s+");
    long busy = 0;
    for (int i = 0; i < COUNTERS; i++) {
      busy += i == IDLE || i == IO_WAIT ? 0 : Long.parseLong(all[i + 1]);
    }
    String process = Files.readString(PROCESS);
    String[] mine = process.substring(process.lastIndexOf(')') + 2).split(" ");
    long own = Arrays.stream(mine, FIRST_TIME, FIRST_TIME + TIMES).mapToLong(Long::parseLong).sum();
    return new OwnCpu(busy, own, System.nanoTime());
  }

  /** How many cores others kept busy since then, on average; without what ours took beside that which is counted, s. */
  double othersSince(OwnCpu before, double uncounted) {
    double others = (busy - before.busy - (own - before.own)) / TICKS - uncounted;
    return Math.max(0, others / seconds(before));
  }

  double seconds(OwnCpu before) {
    return 1e-9 * (nanos - before.nanos);
  }
}
