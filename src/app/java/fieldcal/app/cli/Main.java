package fieldcal.app.cli;

import picocli.CommandLine;
import picocli.CommandLine.Command;

/** The command line of fieldcal. */
@Command(
    name = "fieldcal",
    mixinStandardHelpOptions = true,
    subcommands = {CalibrateCommand.class, SimulateCommand.class})
public final class Main implements Runnable {

  /**
   * Runs a command.
   *
   * @param args command and options
   */
  public static void main(String[] args) {
    System.exit(new CommandLine(new Main()).execute(args));
  }

  @Override
  public void run() {
    CommandLine.usage(this, System.out);
  }
}
