package fieldcal.benchmark;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;

/** What the browser of a block computes. Its processes leave their parents behind and are ended by nobody who counts them. Not thread-safe. */
final class BrowserCpu {
  private static final String NAME = "chrom";

  private final ProcessHandle block;
  private final Map<Long, Duration> used = new HashMap<>();

  BrowserCpu(ProcessHandle block) {
    this.block = block;
  }

  /** Now and then, as long as the block runs. */
  void look() {
    block
        .descendants()
        .filter(process -> process.info().command().orElse("").contains(NAME))
        .forEach(
            process ->
                process.info().totalCpuDuration().ifPresent(now -> used.put(process.pid(), now)));
  }

  double seconds() {
    return used.values().stream().mapToDouble(d -> 1e-9 * d.toNanos()).sum();
  }
}
