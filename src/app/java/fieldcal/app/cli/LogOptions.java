package fieldcal.app.cli;

import fieldcal.app.recording.LogOpener;
import fieldcal.gamelog.GameLogReader;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/** What all commands that read recordings are told about them. */
final class LogOptions {
  @Spec(Target.MIXEE)
  private CommandSpec spec;

  private LogOpener opener = LogOpener.USUAL;

  @Option(
      names = "--unpack-limit",
      paramLabel = "RATIO",
      defaultValue = "" + GameLogReader.LARGEST_RATIO,
      description =
          "a packed recording may unpack to at most RATIO times its size (default:"
              + " ${DEFAULT-VALUE}); Infinity: no limit")
  private void limit(double ratio) {
    try {
      opener = new LogOpener(ratio);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--unpack-limit " + e.getMessage(), e);
    }
  }

  LogOpener opener() {
    return opener;
  }
}
