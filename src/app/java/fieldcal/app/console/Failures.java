package fieldcal.app.console;

import fieldcal.app.files.FileFailure;
import java.io.IOException;
import java.nio.file.FileSystemException;

/** Errors in words for the operator. */
final class Failures {
  private Failures() {}

  static String words(Exception e) {
    if (e instanceof FileSystemException file) {
      return FileFailure.words(file);
    }
    if (e instanceof IOException && e.getMessage() != null) {
      return e.getMessage();
    }
    return "this is a defect, please report it: " + e;
  }
}
