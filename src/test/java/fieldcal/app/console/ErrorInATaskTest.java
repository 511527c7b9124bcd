package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A task that runs out of memory or stack is shown as failed, and the console goes on. */
class ErrorInATaskTest {
  private static final long LONGEST_S = 60;

  @TempDir Path session;

  private static void await(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LONGEST_S);
    while (!condition.getAsBoolean()) {
      assertThat(System.nanoTime()).as("waited for %d s", LONGEST_S).isLessThan(end);
      Thread.sleep(5);
    }
  }

  @Test
  void theNextTaskRunsAfterAnErrorInOneAndInItsProgress() throws Exception {
    AtomicBoolean listenerFails = new AtomicBoolean();
    Work work =
        new Work(
            () -> {
              if (listenerFails.get()) {
                throw new StackOverflowError();
              }
            });
    work.start();
    try {
      work.again(
          "fails",
          progress -> {
            throw new StackOverflowError();
          });
      listenerFails.set(true);
      work.again("is told of badly", progress -> {});
      CountDownLatch ran = new CountDownLatch(1);
      work.again("runs", progress -> ran.countDown());
      assertThat(ran.await(LONGEST_S, TimeUnit.SECONDS)).isTrue();
    } finally {
      work.close();
    }
  }

  @Test
  void aCalibrationThatRunsOutOfMemorySaysSoAndCanBeRepeated() throws Exception {
    SampleSession.copy(SampleSession.small(), session);
    AtomicBoolean memoryIsFull = new AtomicBoolean(true);
    Work[] work = new Work[1];
    work[0] =
        new Work(
            () -> {
              boolean fits = work[0].status().map(Work.Status::text).orElse("").equals("fitting");
              if (fits && memoryIsFull.get()) {
                throw new OutOfMemoryError("Java heap space");
              }
            });
    KickDesk kicks =
        new KickDesk(
            SessionDirectory.open(session), ConsoleSettings.local(session, 0), work[0], () -> {});
    work[0].start();
    try {
      kicks.read();
      await(() -> kicks.view().failure().isPresent());
      assertThat(kicks.view().failure().orElseThrow()).contains("not enough memory");
      memoryIsFull.set(false);
      await(() -> work[0].status().isEmpty());
      kicks.read();
      await(() -> kicks.view().outcome().isPresent());
      assertThat(kicks.view().failure()).isEmpty();
    } finally {
      work[0].close();
      kicks.close();
    }
  }

  @Test
  void aMatchThatEndsWithAnErrorSaysSoAndAnotherCanBegin() throws Exception {
    LiveSession match = new LiveSession("match", () -> {});
    match.start(
        () -> {
          throw new OutOfMemoryError("Java heap space");
        });
    await(() -> !match.running());
    assertThat(match.failure()).hasValueSatisfying(why -> assertThat(why).contains("memory"));
    match.start(
        () -> {
          throw new IOException("nobody sends");
        });
    await(() -> !match.running());
    assertThat(match.failure()).isEqualTo(Optional.of("nobody sends"));
  }
}
