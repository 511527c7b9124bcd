package fieldcal.app.console;

import fieldcal.app.files.FileFailure;
import java.io.IOException;
import java.nio.file.FileSystemException;

/** Errors in words for the operator. */
final class Failures {
  private Failures() {}

  static String words(Throwable e) {
    if (e instanceof FileSystemException file) {
      return FileFailure.words(file);
    }
    if (e instanceof IOException && e.getMessage() != null) {
      return e.getMessage();
    }
    if (e instanceof OutOfMemoryError) {
      return "there is not enough memory for this: fewer recordings at once need less, or start the"
          + " console with FIELDCAL_JAVA_OPTS=-Xmx2g";
    }
    return "this is a defect, please report it: " + e;
  }
}
