package fieldcal.app.wording;

import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * One cause in an operator's words. Plain text; names in it may hold anything.
 *
 * @param name a few words in lower case, for example "offset of camera 1"
 * @param what what is wrong, one sentence with numbers
 * @param consequence what it does to the game, one sentence; empty when that is not known
 * @param advice what to do about it, one sentence or two; empty where nothing can be done
 * @param strength the fitted numbers with standard errors
 */
public record CauseText(
    String name, String what, String consequence, String advice, String strength) {

  /** Checks that nothing is missing. {@inheritDoc} */
  public CauseText {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(what, "what");
    Objects.requireNonNull(consequence, "consequence");
    Objects.requireNonNull(advice, "advice");
    Objects.requireNonNull(strength, "strength");
  }

  /**
   * What is wrong, what it does, what to do.
   *
   * @return the sentences in one line
   */
  public String sentences() {
    return Stream.of(what, consequence, advice)
        .filter(s -> !s.isEmpty())
        .collect(Collectors.joining(" "));
  }
}
