package fieldcal.benchmark;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What Git says of the sources that are measured: everything but documents. */
final class MeasuredCommit {
  private static final List<String> SOURCES = List.of("--", ".", ":!docs", ":!*.md");

  private MeasuredCommit() {}

  /** The newest commit that changed something that is measured, in short. */
  static String of(Path project) throws IOException, InterruptedException {
    return git(project, List.of("log", "-1", "--abbrev=8", "--format=%h")).strip();
  }

  /** Files that are measured and not as in that commit, one a line; blank when there is none. */
  static String changes(Path project) throws IOException, InterruptedException {
    return git(project, List.of("status", "--porcelain"));
  }

  private static String git(Path project, List<String> words)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("git"));
    command.addAll(words);
    command.addAll(SOURCES);
    Process git =
        new ProcessBuilder(command)
            .directory(project.toFile())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    String answer = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (git.waitFor() != 0) {
      throw new IOException(String.join(" ", command) + " ended with " + git.exitValue());
    }
    return answer;
  }
}
