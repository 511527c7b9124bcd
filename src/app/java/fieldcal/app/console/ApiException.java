package fieldcal.app.console;

/** A request that cannot be answered, with the status and one sentence for the operator. */
final class ApiException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int status;

  ApiException(int status, String message) {
    super(message);
    this.status = status;
  }

  static ApiException badRequest(String message) {
    return new ApiException(400, message);
  }

  /** What was asked is right, but not now. */
  static ApiException conflict(String message) {
    return new ApiException(409, message);
  }

  static ApiException notFound(String message) {
    return new ApiException(404, message);
  }

  int status() {
    return status;
  }
}
