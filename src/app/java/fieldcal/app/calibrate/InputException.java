package fieldcal.app.calibrate;

import java.io.IOException;

/** An input file that cannot be used. The message is one line: file, place, what is wrong, what to do. */
public final class InputException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * With a message for the operator.
   *
   * @param message one line
   */
  public InputException(String message) {
    super(message);
  }
}
