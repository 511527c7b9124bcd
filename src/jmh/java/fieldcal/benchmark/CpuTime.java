package fieldcal.benchmark;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/** Time that this process computed on all cores together: other work on the machine does not count. */
public final class CpuTime {
  private CpuTime() {}

  /**
   * So far.
   *
   * @return s
   */
  public static double seconds() {
    return 1e-9
        * ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
            .getProcessCpuTime();
  }
}
