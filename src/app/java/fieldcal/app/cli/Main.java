package fieldcal.app.cli;

import fieldcal.app.files.FileFailure;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileSystemException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of fieldcal. */
@Command(
    name = "fieldcal",
    description = "Calibrates the motion models of an SSL team on the field it plays on.",
    mixinStandardHelpOptions = true,
    version = "fieldcal 0.1.0",
    subcommands = {
      InfoCommand.class,
      CalibrateCommand.class,
      ConsoleCommand.class,
      DiagnoseCommand.class,
      ExportCommand.class,
      LimitsCommand.class,
      MonitorCommand.class,
      SimulateCommand.class,
      PlayCommand.class,
      RecordCommand.class,
      TwinCommand.class,
      CompareCommand.class,
      ArchiveCommand.class
    })
public final class Main {
  private static final int BAD_INPUT = 1;

  /** The commands themselves hold the options. */
  public Main() {}

  /**
   * Runs a command.
   *
   * @param args command and options
   */
  public static void main(String[] args) {
    int status = commandLine().execute(args);
    if (System.out.checkError() && status == 0) {
      // A full disk behind the output, or nobody who reads it any more.
      System.err.println("fieldcal: standard output: cannot be written");
      status = BAD_INPUT;
    }
    System.exit(status);
  }

  /**
   * The commands, ready to run: bad usage gives 2, bad input one line on the error stream and 1.
   *
   * @return a new command line, whose output may be redirected
   */
  public static CommandLine commandLine() {
    return new CommandLine(new Main())
        .setOut(new HarmlessWriter(new PrintWriter(System.out, true)))
        .setErr(new HarmlessWriter(new PrintWriter(System.err, true)))
        .setExecutionExceptionHandler(Main::explain)
        .setParameterExceptionHandler(Main::misused);
  }

  /** The error alone: the whole usage below it would scroll it off the screen. */
  private static int misused(ParameterException exception, String[] args) {
    CommandLine command = exception.getCommandLine();
    PrintWriter err = command.getErr();
    err.println("fieldcal: " + exception.getMessage());
    UnmatchedArgumentException.printSuggestions(exception, err);
    err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help' for the options.");
    err.flush();
    return command.getCommandSpec().exitCodeOnInvalidInput();
  }

  private static int explain(Exception exception, CommandLine command, ParseResult parsed) {
    PrintWriter err = command.getErr();
    if (exception instanceof FileSystemException failure) {
      err.println("fieldcal: " + FileFailure.words(failure));
    } else if (exception instanceof IOException) {
      err.println("fieldcal: " + exception.getMessage());
    } else {
      err.println("fieldcal: this is a defect, please report it: " + exception);
      StackTraceElement[] trace = exception.getStackTrace();
      if (trace.length > 0) {
        err.println("fieldcal: at " + trace[0]);
      }
    }
    err.flush();
    return BAD_INPUT;
  }
}
