package fieldcal.app.cli;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.RecordingFolder;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.ReadableRecordings;
import fieldcal.app.recording.RecordingChoice;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The recordings that a command line names: files as they are, and of folders those that the console would calibrate.
 *
 * @param logs at least one
 * @param apart recordings of a folder that are kept apart
 * @param leftOut one line for each recording of a folder that is kept apart or cannot be read
 * @param notRead those that cannot be read, and copies of others
 * @param folders that were named
 */
record LogArguments(
    List<Path> logs,
    List<Path> apart,
    List<String> leftOut,
    List<DataProblem> notRead,
    List<Path> folders) {

  static LogArguments of(List<Path> named, LogOpener opener) throws IOException {
    List<Path> logs = new ArrayList<>();
    List<Path> apart = new ArrayList<>();
    List<String> leftOut = new ArrayList<>();
    List<DataProblem> notRead = new ArrayList<>();
    List<Path> folders = new ArrayList<>();
    for (Path path : named) {
      if (!Files.isDirectory(path)) {
        logs.add(path);
        continue;
      }
      folders.add(path);
      ReadableRecordings readable = ReadableRecordings.of(RecordingFolder.logs(path), opener);
      RecordingChoice choice = RecordingFolder.choice(readable, path);
      if (choice.entries().isEmpty()) {
        throw new InputException(path + ": there is no recording (*.log, *.log.gz) in this folder");
      }
      for (RecordingChoice.Entry entry : choice.entries()) {
        if (entry.used()) {
          logs.add(entry.facts().log());
        } else {
          apart.add(entry.facts().log());
          leftOut.add("left out: " + entry.facts().log() + ": " + entry.words());
        }
      }
      readable.broken().values().forEach(why -> leftOut.add("left out: " + why));
      notRead.addAll(readable.problems());
      notRead.addAll(choice.copies());
    }
    if (logs.isEmpty()) {
      throw new InputException(String.join("; ", leftOut) + "; nothing is left to calibrate");
    }
    return new LogArguments(
        List.copyOf(logs),
        List.copyOf(apart),
        List.copyOf(leftOut),
        List.copyOf(notRead),
        List.copyOf(folders));
  }

  /** What the robots were commanded: of the file that was named, or else in the used recordings of the folders. */
  List<CommandFile.Command> commands(Path named) throws IOException {
    if (named != null) {
      return CommandFile.read(named);
    }
    List<CommandFile.Command> all = new ArrayList<>();
    for (Path folder : folders) {
      all.addAll(RecordingFolder.commands(folder, apart));
    }
    return all;
  }

  /** Where the decisions about kicks are: with the results, or else in the folder of the recordings. */
  Path decisions(Path out) {
    return out == null && folders.size() == 1 ? folders.get(0) : out;
  }

  /** Which recordings were used, where a folder had others. */
  void tell(PrintWriter out) {
    if (!leftOut.isEmpty()) {
      int all = logs.size() + leftOut.size();
      out.println(logs.size() + " of " + all + " recordings used.");
      leftOut.forEach(line -> out.println("  " + line));
      out.println();
    }
    out.flush();
  }
}
