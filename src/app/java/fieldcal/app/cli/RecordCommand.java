package fieldcal.app.cli;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.record.NetworkRecorder;
import fieldcal.app.record.RecordStatus;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Clock;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code fieldcal record}: a game log from the network. */
@Command(
    name = "record",
    mixinStandardHelpOptions = true,
    sortOptions = false,
    description =
        "Records vision, and the referee if wanted, from the network as an SSL game log."
            + " Ctrl-C ends the recording; the file is complete then.",
    footer = {"", "Example: fieldcal record --out flat-kicks.log.gz"})
final class RecordCommand implements Callable<Integer> {
  /** The group that the league's rules name for vision. */
  private static final String LEAGUE_VISION = "224.5.23.2:10006";

  /** Who looks at a file or a pipe sees that it goes on, s. */
  private static final double BETWEEN_LINES = 5;

  /** Ctrl-C waits so long for the end of the file, ms. */
  private static final long PATIENCE = 5000;

  @Spec private CommandSpec spec;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "FILE",
      description = "the game log to write, .log or .log.gz (compressed)")
  private Path out;

  @Option(
      names = "--multicast",
      paramLabel = "ADDR:PORT",
      defaultValue = LEAGUE_VISION,
      description =
          "where vision sends to (default: the league's multicast group, ${DEFAULT-VALUE});"
              + " 255.255.255.255:10006 receives vision that is broadcast")
  private String multicast;

  @Option(
      names = "--referee",
      paramLabel = "ADDR:PORT",
      description =
          "multicast address of the referee, to record it too; the league's is 224.5.23.1:10003")
  private String referee;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "ends after so many seconds; without it, Ctrl-C ends it")
  private Double seconds;

  @Option(
      names = "--interface",
      paramLabel = "NAME",
      description = "name or address of the network interface to receive on; default: all of them")
  private String networkInterface;

  @Option(names = "--overwrite", description = "replaces a file that is there already")
  private boolean overwrite;

  private double lastLine;

  @Override
  public Integer call() throws IOException {
    double limit = seconds == null ? Double.POSITIVE_INFINITY : seconds;
    if (!(limit > 0)) {
      throw new ParameterException(
          spec.commandLine(), "--seconds must be a positive number, but is " + seconds);
    }
    if (!NetworkRecorder.isLogName(out)) {
      throw new ParameterException(
          spec.commandLine(), "--out must end with .log or .log.gz, but is '" + out + "'");
    }
    NetworkPlace vision = place(multicast);
    Optional<NetworkPlace> whistle = Optional.ofNullable(referee).map(this::place);
    PrintWriter text = spec.commandLine().getOut();
    try (NetworkRecorder recorder =
        new NetworkRecorder(out, overwrite, vision, whistle, Clock.systemUTC())) {
      Thread atExit = new Thread(() -> finish(recorder), "fieldcal-record-exit");
      Runtime.getRuntime().addShutdownHook(atExit);
      text.printf("recording %s%s to %s%n", vision, also(whistle), out);
      text.flush();
      RecordStatus last;
      try (TerminalProgress progress = TerminalProgress.ofWords(Heartbeat.none())) {
        last = recorder.run(limit, s -> show(s, vision, progress, text));
      } finally {
        forget(atExit);
      }
      text.printf(
          Locale.ROOT,
          "recorded %s: %.1f s, %d frames of %s%s%n",
          out,
          last.seconds(),
          last.frames(),
          last.cameraNames(),
          last.geometry() ? "" : "; no geometry was heard, so chips cannot be fitted");
      last.notes().stream().skip(1).forEach(note -> text.println("  " + note.strip()));
      text.flush();
    }
    return 0;
  }

  private static String also(Optional<NetworkPlace> whistle) {
    return whistle.map(w -> " and the referee of " + w).orElse("");
  }

  private NetworkPlace place(String text) {
    try {
      NetworkPlace place = NetworkPlace.parse(text, networkInterface);
      if (place.address().getPort() == 0) {
        throw new IllegalArgumentException(
            "nobody sends to port 0; the league's vision uses 10006, its referee 10003");
      }
      return place;
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }

  private void show(
      RecordStatus status, NetworkPlace vision, TerminalProgress progress, PrintWriter text) {
    String line = status.line(vision.toString());
    progress.say(line);
    if (!TerminalProgress.isTerminal(TerminalProgress.ERROR_STREAM)
        && status.seconds() - lastLine >= BETWEEN_LINES) {
      lastLine = status.seconds();
      text.println(line);
      text.flush();
    }
  }

  /** Ctrl-C stops the recording, and the machine waits for the end of its file. */
  private static void finish(NetworkRecorder recorder) {
    recorder.stop();
    try {
      recorder.awaitEnd(PATIENCE);
      // The command has something to say yet.
      Thread.sleep(100);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void forget(Thread atExit) {
    try {
      Runtime.getRuntime().removeShutdownHook(atExit);
    } catch (IllegalStateException e) {
      // The machine is going down already, which is why the recording ended.
    }
  }
}
