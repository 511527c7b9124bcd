package fieldcal.app.cli;

import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.app.console.Console;
import fieldcal.app.console.ConsoleSettings;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Clock;
import java.util.HexFormat;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code fieldcal console}: the page an operator works with, until it is interrupted. */
@Command(
    name = "console",
    mixinStandardHelpOptions = true,
    description =
        "Serves a page in the browser on which you look at kicks, drop and restore them, and"
            + " diagnose and publish the ball model. Ctrl-C ends it.")
final class ConsoleCommand implements Callable<Integer> {
  private static final int TOKEN_BYTES = 12;

  @Spec private CommandSpec spec;

  @Mixin private LogOptions logOptions;

  @Parameters(
      arity = "0..1",
      paramLabel = "DIR",
      defaultValue = ".",
      description =
          "the session: its recordings (*.log, *.log.gz) are calibrated together, decisions and"
              + " results are kept there (default: the current directory)")
  private Path directory;

  @Option(
      names = "--port",
      paramLabel = "P",
      defaultValue = "8520",
      description = "port to listen on, 0 for any (default: ${DEFAULT-VALUE})")
  private int port;

  @Option(
      names = "--address",
      paramLabel = "A",
      defaultValue = ConsoleSettings.LOOPBACK,
      description =
          "address to listen on; with any other than the default, other machines can reach the"
              + " console and need a token (default: ${DEFAULT-VALUE})")
  private String address;

  @Option(
      names = "--token",
      paramLabel = "T",
      description =
          "token that other machines need, at least "
              + ConsoleSettings.SHORTEST_TOKEN
              + " letters and digits; without it, one is generated when it is needed")
  private String token;

  @Option(
      names = "--token-file",
      paramLabel = "FILE",
      description =
          "a file with that token in its first line: unlike --token, other users of this machine"
              + " do not see it among the running programs")
  private Path tokenFile;

  @Option(
      names = "--initial",
      paramLabel = "FILE",
      description =
          "published model to start from and to compare with: SSL_GeometryModels (binary or text)"
              + " or a calibration.json; default: the model that the recordings publish")
  private Path initial;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "seed of the random search (default: ${DEFAULT-VALUE})",
      defaultValue = "20260101")
  private long seed;

  @Override
  public Integer call() throws IOException, InterruptedException {
    ConsoleSettings settings = settings();
    try (Console console = Console.start(settings, Clock.systemUTC())) {
      PrintWriter out = spec.commandLine().getOut();
      out.println("Console of " + directory + ": " + console.url());
      out.println("Open this address in a browser; Ctrl-C ends the console.");
      out.flush();
      CountDownLatch ended = new CountDownLatch(1);
      Runtime.getRuntime().addShutdownHook(new Thread(console::close));
      ended.await();
    }
    return 0;
  }

  private ConsoleSettings settings() throws IOException {
    Optional<BallModels> start =
        initial == null ? Optional.empty() : Optional.of(InitialModels.read(initial));
    if (token != null && tokenFile != null) {
      throw new ParameterException(spec.commandLine(), "give --token or --token-file, not both");
    }
    Optional<String> known =
        tokenFile == null ? Optional.ofNullable(token) : Optional.of(firstLine(tokenFile));
    if (known.isEmpty() && !ConsoleSettings.isLoopback(address)) {
      byte[] random = new byte[TOKEN_BYTES];
      new SecureRandom().nextBytes(random);
      known = Optional.of(HexFormat.of().formatHex(random));
    }
    try {
      return new ConsoleSettings(directory, address, port, known, start, seed, logOptions.opener());
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage());
    }
  }

  private static String firstLine(Path file) throws IOException {
    String text = new String(JsonFiles.bytes(file), StandardCharsets.UTF_8);
    return text.lines().findFirst().orElse("").strip();
  }
}
