package fieldcal.app.files;

import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;

/** What a file system refuses, in words for the operator: Java says much of it by the exception's type alone. */
public final class FileFailure {
  private FileFailure() {}

  /**
   * Names the file and the reason.
   *
   * @param e what was thrown
   * @return one line
   */
  public static String words(FileSystemException e) {
    return e.getFile() + ": " + reason(e);
  }

  private static String reason(FileSystemException e) {
    if (e.getReason() != null) {
      return e.getReason();
    }
    if (e instanceof NoSuchFileException) {
      return "no such file or directory";
    }
    if (e instanceof AccessDeniedException) {
      return "may not be read or written";
    }
    if (e instanceof FileAlreadyExistsException) {
      return "exists already and is of another type";
    }
    if (e instanceof NotDirectoryException) {
      return "is not a directory";
    }
    return e.getClass().getSimpleName().replace("Exception", "");
  }
}
