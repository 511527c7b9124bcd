package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Nobody finds a token by trying. */
class GuessesTest {
  @Test
  void afterTenWrongOnesNobodyMayTryForAMinute() {
    AtomicLong clock =
        new AtomicLong(Long.MAX_VALUE - 5); // a clock that overflows, as nanoTime may
    Guesses guesses = new Guesses(clock::get);
    for (int i = 0; i < 10; i++) {
      assertThat(guesses.mayTry()).isTrue();
      guesses.wrong();
      clock.addAndGet(1_000_000_000L);
    }
    assertThat(guesses.mayTry()).isFalse();
    clock.addAndGet(49_000_000_000L);
    assertThat(guesses.mayTry()).isFalse();
    clock.addAndGet(2_000_000_000L);
    assertThat(guesses.mayTry()).isTrue();
  }
}
