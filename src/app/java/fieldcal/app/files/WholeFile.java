package fieldcal.app.files;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * Writes files so that a crash or a full disk leaves either the old file or the new one. A symbolic link stays, and what it leads to is replaced; a device, a pipe or another thing that is no file is written to
 * as it is.
 */
public final class WholeFile {
  /** As many links in a row as Linux follows. */
  private static final int MOST_LINKS = 40;

  private WholeFile() {}

  /**
   * Writes bytes, replacing an older file in one step.
   *
   * @param bytes what to write
   * @param file where; its directory is made if needed
   * @throws IOException when it cannot be written; the old file is as it was
   */
  public static void write(byte[] bytes, Path file) throws IOException {
    streamBytes(file, to -> to.write(bytes));
  }

  /** Where a link leads to, also when nothing is there yet. */
  private static Path followed(Path link) throws IOException {
    Path at = link.toAbsolutePath();
    for (int i = 0; i < MOST_LINKS; i++) {
      if (Files.exists(at)) {
        return at.toRealPath();
      }
      if (!Files.isSymbolicLink(at)) {
        return at;
      }
      at = at.resolveSibling(Files.readSymbolicLink(at)).normalize();
    }
    throw new FileSystemException(
        link.toString(), null, "is a symbolic link that leads to itself; name a file");
  }

  private static void append(Path stream, Content content) throws IOException {
    try (OutputStream to = new BufferedOutputStream(NamedOutput.open(stream))) {
      content.writeTo(to);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(stream + ": " + e.getMessage(), e);
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

  /** What makes the content of a text file. */
  public interface TextContent {
    /**
     * Writes it.
     *
     * @param to the file
     * @throws IOException when it cannot be written or made
     */
    void writeTo(Writer to) throws IOException;
  }

  /** What makes the content of a file. */
  public interface Content {
    /**
     * Writes it.
     *
     * @param to the file
     * @throws IOException when it cannot be written or made
     */
    void writeTo(OutputStream to) throws IOException;
  }

  /**
   * Writes text in UTF-8 as it is made, replacing an older file in one step.
   *
   * @param file where; its directory is made if needed
   * @param content makes the text
   * @throws IOException when it cannot be written or made; the old file is as it was
   */
  public static void stream(Path file, TextContent content) throws IOException {
    streamBytes(
        file,
        bytes -> {
          Writer text = new OutputStreamWriter(bytes, StandardCharsets.UTF_8);
          content.writeTo(text);
          text.flush();
        });
  }

  /**
   * Writes bytes as they are made, replacing an older file in one step.
   *
   * @param file where; its directory is made if needed
   * @param content makes the bytes
   * @throws IOException when it cannot be written or made; the old file is as it was
   */
  public static void streamBytes(Path file, Content content) throws IOException {
    if (NamedOutput.isStream(file)) {
      append(file, content);
      return;
    }
    Path target = Files.isSymbolicLink(file) ? followed(file) : file.toAbsolutePath();
    Path directory = target.getParent();
    Files.createDirectories(directory);
    Unfinished.removeLeftBehind(directory);
    // Beside the file, so that the move is one step; not a temporary file, which only its owner
    // could read.
    Path unfinished = Unfinished.of(target);
    try {
      try (OutputStream to = new BufferedOutputStream(Files.newOutputStream(unfinished))) {
        content.writeTo(to);
      }
      Files.move(unfinished, target, StandardCopyOption.REPLACE_EXISTING);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      // A full disk says no more than that.
      FileSystemException named = new FileSystemException(file.toString(), null, e.getMessage());
      named.initCause(e);
      throw named;
    } finally {
      Unfinished.remove(unfinished);
    }
  }
}
