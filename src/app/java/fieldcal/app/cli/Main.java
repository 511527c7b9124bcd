package fieldcal.app.cli;

import fieldcal.app.files.FileFailure;
import fieldcal.app.wording.Harmless;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileSystemException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/** The command line of fieldcal. */
@Command(
    name = "fieldcal",
    description = "Calibrates the motion models of an SSL team on the field it plays on.",
    mixinStandardHelpOptions = true,
    version = "fieldcal 0.1.0")
public final class Main {
  private static final int BAD_INPUT = 1;

  /** In the order of the help. */
  private static final List<Class<?>> COMMANDS =
      List.of(
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
          ArchiveCommand.class);

  /** What is answered without looking into any command. */
  private static final Set<String> ABOUT_ALL = Set.of("-h", "--help", "-V", "--version");

  /** The commands themselves hold the options. */
  public Main() {}

  /**
   * Runs a command.
   *
   * @param args command and options
   */
  public static void main(String[] args) {
    // Numbers are written alike everywhere: by the machine's language some would have other digits,
    // or a comma.
    Locale.setDefault(Locale.ROOT);
    int status = commandLineFor(args).execute(args);
    Optional<String> failure = StandardOutput.failure();
    if (failure.isPresent() && status == 0) {
      System.err.println("fieldcal: " + failure.get());
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
    CommandLine all = new CommandLine(new Main());
    COMMANDS.forEach(all::addSubcommand);
    return prepared(all);
  }

  /**
   * The commands that are needed for one line of arguments: looking at the options of all of them takes longer than all else that
   * {@code --help} does.
   *
   * @param args command and options
   * @return as {@link #commandLine()}, as far as these arguments can tell
   */
  static CommandLine commandLineFor(String... args) {
    String first = args.length == 0 ? "" : args[0];
    CommandLine few = new CommandLine(new Main());
    if (args.length == 1 && ABOUT_ALL.contains(first)) {
      COMMANDS.stream().map(Main::described).forEach(few::addSubcommand);
      return prepared(few);
    }
    Optional<Class<?>> named = COMMANDS.stream().filter(c -> name(c).equals(first)).findFirst();
    if (named.isEmpty()) {
      return commandLine();
    }
    few.addSubcommand(named.get());
    return prepared(few);
  }

  private static String name(Class<?> command) {
    return command.getAnnotation(Command.class).name();
  }

  /** Name and description of a command, which is all that the list of commands shows. */
  private static CommandLine described(Class<?> command) {
    CommandSpec spec = CommandSpec.create().name(name(command));
    spec.usageMessage().description(command.getAnnotation(Command.class).description());
    return new CommandLine(spec);
  }

  private static CommandLine prepared(CommandLine commands) {
    return commands
        .setOut(new HarmlessWriter(new PrintWriter(System.out, true)))
        .setErr(new HarmlessWriter(new PrintWriter(System.err, true)))
        .setExecutionExceptionHandler(Main::explain)
        .setParameterExceptionHandler(Main::misused);
  }

  /** The error alone: the whole usage below it would scroll it off the screen. */
  private static int misused(ParameterException exception, String[] args) {
    CommandLine command = exception.getCommandLine();
    PrintWriter err = command.getErr();
    err.println("fieldcal: " + words(exception));
    if (exception instanceof UnmatchedArgumentException unmatched) {
      UsageWords.guess(unmatched.getSuggestions()).ifPresent(err::println);
    }
    err.println("Try '" + command.getCommandSpec().qualifiedName() + " --help' for the options.");
    err.flush();
    return command.getCommandSpec().exitCodeOnInvalidInput();
  }

  /** The parser's own words, where these are not about its insides. */
  private static String words(ParameterException exception) {
    boolean ofNoCommand = exception.getCommandLine().getParent() == null;
    if (ofNoCommand
        && exception instanceof UnmatchedArgumentException unmatched
        && !unmatched.isUnknownOption()) {
      return "there is no command '" + unmatched.getUnmatched().get(0) + "'";
    }
    return UsageWords.of(exception.getMessage());
  }

  private static int explain(Exception exception, CommandLine command, ParseResult parsed) {
    PrintWriter err = command.getErr();
    if (exception instanceof FileSystemException failure) {
      err.println("fieldcal: " + Harmless.line(FileFailure.words(failure)));
    } else if (exception instanceof IOException) {
      err.println("fieldcal: " + Harmless.line(String.valueOf(exception.getMessage())));
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
