package fieldcal.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class OneByOneTest {
  @Test
  void eachIsDoneOnceAndTheResultsAreInTheirOrder() {
    List<Integer> all = IntStream.range(0, 1000).boxed().toList();
    AtomicInteger done = new AtomicInteger();
    List<Integer> squares =
        OneByOne.map(
            all,
            i -> {
              done.incrementAndGet();
              return i * i;
            });
    assertThat(squares).isEqualTo(all.stream().map(i -> i * i).toList());
    assertThat(done).hasValue(all.size());
  }

  @Test
  void nothingGivesNothing() {
    assertThat(OneByOne.map(List.of(), i -> i)).isEmpty();
  }

  @Test
  void whatIsThrownIsThrown() {
    assertThatThrownBy(
            () ->
                OneByOne.map(
                    List.of(1, 2, 3),
                    i -> {
                      throw new IllegalStateException("no " + i);
                    }))
        .isInstanceOf(IllegalStateException.class);
  }
}
