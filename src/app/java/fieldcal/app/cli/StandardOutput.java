package fieldcal.app.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** What became of the standard output, of which Java only says that something could not be written. */
final class StandardOutput {
  /** Where Linux says what the standard output is: unlike an error message, in no language. */
  private static final Path LINK = Path.of("/proc/self/fd/1");

  private static final String PIPE = "pipe";

  private StandardOutput() {}

  /**
   * Why the standard output could not be written.
   *
   * @return one line; empty when all was written, or when the reader of a pipe has closed it, as {@code head} does once it has enough
   */
  static Optional<String> failure() {
    if (!System.out.checkError()) {
      return Optional.empty();
    }
    String reason = reason();
    return reason.toLowerCase(Locale.ROOT).contains(PIPE) || isPipe()
        ? Optional.empty()
        : Optional.of("standard output: cannot be written" + reason);
  }

  /** The system says why when it is tried once more. */
  private static String reason() {
    // Closing it would close the standard output; it is not ours.
    @SuppressWarnings("resource")
    FileOutputStream out = new FileOutputStream(FileDescriptor.out);
    try {
      out.write('\n');
      return "";
    } catch (IOException e) {
      return " (" + e.getMessage() + ")";
    }
  }

  private static boolean isPipe() {
    try {
      return Files.readSymbolicLink(LINK).toString().startsWith(PIPE + ":");
    } catch (IOException | UnsupportedOperationException e) {
      return false;
    }
  }
}
