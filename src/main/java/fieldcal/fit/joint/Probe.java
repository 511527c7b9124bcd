package fieldcal.fit.joint;

import java.util.Objects;

/**
 * A derivative by something that kicks share, as the difference of two states.
 *
 * @param from a state; null for the one at which derivatives are taken: then the difference is one-sided
 * @param to a state a small step away from it
 * @param width length of the step, negative when it leads backwards
 * @param <S> what the global parameters amount to
 */
public record Probe<S>(S from, S to, double width) {
  /**
   * Checks what is there. {@inheritDoc}
   *
   * @throws NullPointerException when {@code to} is missing
   */
  public Probe {
    Objects.requireNonNull(to, "to");
  }
}
