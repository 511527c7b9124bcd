package fieldcal.calibration;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * Works on many kicks on all processors, each of which takes the next kick that has not been started. A parallel stream hands out blocks instead, on two processors a quarter of all kicks at a time:
 * a chip takes five times as long as a flat kick, and the processor that has the flat ones waits for the other.
 */
final class OneByOne {
  private OneByOne() {}

  /**
   * The results, in the order of the inputs.
   *
   * @param work called from several threads; must not return null
   */
  static <T, R> List<R> map(List<T> all, Function<T, R> work) {
    Object[] results = new Object[all.size()];
    AtomicInteger next = new AtomicInteger();
    IntStream.rangeClosed(0, ForkJoinPool.getCommonPoolParallelism())
        .parallel()
        .forEach(
            processor -> {
              for (int i = next.getAndIncrement(); i < results.length; i = next.getAndIncrement()) {
                results[i] = work.apply(all.get(i));
              }
            });
    @SuppressWarnings("unchecked") // only work fills them
    List<R> list = (List<R>) List.copyOf(Arrays.asList(results));
    return list;
  }
}
