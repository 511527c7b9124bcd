package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;

/** What who reads a pipe sees of long work. */
class HeartbeatTest {
  private final StringWriter out = new StringWriter();
  private long nanos;

  private Heartbeat heartbeat() {
    return new Heartbeat(new PrintWriter(out), () -> nanos);
  }

  @Test
  void aLineSaysForHowLongAndWhat() {
    try (Heartbeat heartbeat = heartbeat()) {
      heartbeat.at("reading flat.log, 45 of 300 MB");
      nanos = 30_400_000_000L;
      heartbeat.tell();
      heartbeat.at("the search for causes");
      nanos = 60_400_000_000L;
      heartbeat.tell();
    }
    assertThat(out.toString().lines())
        .containsExactly("  30 s  reading flat.log, 45 of 300 MB", "  60 s  the search for causes");
  }

  @Test
  void shortWorkSaysNothing() {
    try (Heartbeat heartbeat = heartbeat()) {
      heartbeat.at("fitting, 1 of 20 kicks");
    }
    assertThat(out.toString()).isEmpty();
  }

  /** The result may be printed already, and its first line is the verdict. */
  @Test
  void nothingIsSaidOnceTheWorkHasEnded() {
    Heartbeat ended = heartbeat();
    ended.at("fitting, 20 of 20 kicks");
    ended.close();
    ended.tell();
    assertThat(out.toString()).isEmpty();
  }

  /** The output has the result alone: its first line is the verdict, and it may be JSON. */
  @Test
  void theOutputOfACommandHasNoProgress() {
    StringWriter err = new StringWriter();
    CommandLine program = Main.commandLine();
    program.setOut(new PrintWriter(out));
    program.setErr(new PrintWriter(err));
    try (Heartbeat heartbeat = Heartbeat.of(program.getCommandSpec())) {
      heartbeat.at("fitting, 1 of 20 kicks");
      heartbeat.tell();
    }
    assertThat(out.toString()).isEmpty();
    assertThat(err.toString()).endsWith("fitting, 1 of 20 kicks" + System.lineSeparator());
  }

  /** Bars are redrawn on a terminal only. */
  @Test
  void aPipeGetsPlainLines() {
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    PrintStream before = System.err;
    System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
    try (Heartbeat heartbeat = heartbeat();
        TerminalProgress bar = TerminalProgress.ofBytes("reading", heartbeat);
        TerminalProgress words = TerminalProgress.ofWords(heartbeat)) {
      bar.note(", 2 of 3 recordings");
      bar.at(45_000_000, 300_000_000);
      heartbeat.tell();
      words.say("the search for causes");
      heartbeat.tell();
    } finally {
      System.setErr(before);
    }
    assertThat(out.toString().lines())
        .containsExactly(
            "   0 s  reading, 45 of 300 MB, 2 of 3 recordings", "   0 s  the search for causes");
    assertThat(errors.size()).isZero();
  }
}
