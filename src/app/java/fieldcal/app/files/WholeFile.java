package fieldcal.app.files;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Writes files so that a crash or a full disk leaves either the old file or the new one. */
public final class WholeFile {
  private WholeFile() {}

  /**
   * Writes bytes, replacing an older file in one step.
   *
   * @param bytes what to write
   * @param file where; its directory is made if needed
   * @throws IOException when it cannot be written; the old file is as it was
   */
  public static void write(byte[] bytes, Path file) throws IOException {
    Path directory = file.toAbsolutePath().getParent();
    Files.createDirectories(directory);
    // Beside the file, so that the move is one step; not a temporary file, which only its owner
    // could read.
    Path unfinished = directory.resolve(file.getFileName() + ".part");
    try {
      Files.write(unfinished, bytes);
      Files.move(unfinished, file, StandardCopyOption.REPLACE_EXISTING);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      // A full disk says no more than that.
      throw new IOException(file + ": " + e.getMessage(), e);
    } finally {
      deleteQuietly(unfinished);
    }
  }

  /**
   * Writes text in UTF-8, replacing an older file in one step.
   *
   * @param text what to write
   * @param file where; its directory is made if needed
   * @throws IOException when it cannot be written; the old file is as it was
   */
  public static void write(String text, Path file) throws IOException {
    write(text.getBytes(StandardCharsets.UTF_8), file);
  }

  /** What went wrong before is what the operator must hear of, not that there is nothing to clean up. */
  private static void deleteQuietly(Path unfinished) {
    try {
      Files.deleteIfExists(unfinished);
    } catch (IOException e) {
      // The next write replaces it.
    }
  }
}
