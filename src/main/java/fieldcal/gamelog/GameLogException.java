package fieldcal.gamelog;

import java.io.IOException;
import java.nio.file.Path;

/** A game log that cannot be read at all. The message is one line: file, place, what is wrong, what to do. */
public final class GameLogException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * Composes the line about a file of which nothing was read.
   *
   * @param file the file
   * @param what what is wrong and what to do about it
   */
  public GameLogException(Path file, String what) {
    super(file + ": " + what);
  }

  /**
   * Composes the line about a file of which nothing was read.
   *
   * @param file the file
   * @param what what is wrong and what to do about it
   * @param cause what the system said
   */
  public GameLogException(Path file, String what, IOException cause) {
    super(file + ": " + what, cause);
  }

  /**
   * Composes the line.
   *
   * @param file the file
   * @param offset where in the file, bytes
   * @param what what is wrong and what to do about it
   */
  public GameLogException(Path file, long offset, String what) {
    super(file + " (byte " + offset + "): " + what);
  }

  /**
   * Composes the line.
   *
   * @param file the file
   * @param offset where in the file, bytes
   * @param what what is wrong and what to do about it
   * @param cause what the system said
   */
  public GameLogException(Path file, long offset, String what, IOException cause) {
    super(file + " (byte " + offset + "): " + what, cause);
  }
}
