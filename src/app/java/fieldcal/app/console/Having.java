package fieldcal.app.console;

import io.javalin.http.Context;
import java.util.Optional;

/**
 * What a page has already, so that it is told only what changed.
 *
 * @param run of the console that told it
 * @param calibration the version of the calibration
 */
record Having(long run, long calibration) {
  static final Having NOTHING = new Having(-1, -1);

  /** As the page says in the address; nothing when it says something else. */
  static Having of(Context request) {
    return new Having(number(request, "run"), number(request, "calibration"));
  }

  private static long number(Context request, String name) {
    return Optional.ofNullable(request.queryParam(name))
        .filter(text -> text.matches("\\d{1,18}"))
        .map(Long::parseLong)
        .orElse(-1L);
  }
}
