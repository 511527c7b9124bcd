package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** What who reads a pipe sees of long work. */
class HeartbeatTest {
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private long nanos;

  private Heartbeat heartbeat() {
    return new Heartbeat(new PrintStream(out, true, StandardCharsets.UTF_8), () -> nanos);
  }

  @Test
  void aLineSaysForHowLongAndWhat() {
    try (Heartbeat heartbeat = heartbeat()) {
      heartbeat.at("reading flat.log, 45 of 300 MB");
      nanos = 20_400_000_000L;
      heartbeat.tell();
      heartbeat.at("the search for causes");
      nanos = 30_400_000_000L;
      heartbeat.tell();
    }
    assertThat(out.toString(StandardCharsets.UTF_8).lines())
        .containsExactly("  20 s  reading flat.log, 45 of 300 MB", "  30 s  the search for causes");
  }

  @Test
  void shortWorkSaysNothing() {
    try (Heartbeat heartbeat = heartbeat()) {
      heartbeat.at("fitting, 1 of 20 kicks");
    }
    assertThat(out.size()).isZero();
  }
}
