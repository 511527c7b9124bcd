package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.diagnosis.hidden.Judgement.Found;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Outcome;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.truth.Truth;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Compares diagnosis and truth. A name is wrong when it is not hidden, describes no part of what is ({@link Likeness#alike}), and is not said to be indistinguishable from it. */
public final class Judge {
  private final HiddenCase hidden;
  private final List<Visibility> visibility;
  private final Truth truth;
  private final Answer answer;

  private Judge(HiddenCase hidden, List<Visibility> visibility, Truth truth, Answer answer) {
    this.hidden = hidden;
    this.visibility = visibility;
    this.truth = truth;
    this.answer = answer;
  }

  /**
   * Judges.
   *
   * @param hidden the case
   * @param visibility of each hidden effect alone, in their order
   * @param truth what really happened
   * @param answer what was said
   * @return the judgement
   */
  public static Judgement judge(
      HiddenCase hidden, List<Visibility> visibility, Truth truth, Answer answer) {
    return new Judge(hidden, visibility, truth, answer).judge();
  }

  private Judgement judge() {
    List<Named> left = new ArrayList<>(answer.causes());
    List<Found> found = new ArrayList<>();
    for (int i = 0; i < hidden.hidden().size(); i++) {
      if (hidden.hidden().get(i).effect().catalogued()) {
        found.add(named(hidden.hidden().get(i), visibility.get(i), left));
      }
    }
    // Names first: a tie must not take the cause that is another effect's own.
    found.replaceAll(f -> f.how() == How.NAMED ? f : tied(f, left));
    List<Named> excused = left.stream().filter(this::excused).toList();
    left.removeAll(excused);
    return new Judgement(
        outcome(found, left), found, left, excused, answer.verdict(), rightVariable());
  }

  private Likeness likeness(EffectSetting effect, Visibility seen, Named cause) {
    return new Likeness(effect, seen, truth, cause);
  }

  private Found named(EffectSetting effect, Visibility seen, List<Named> left) {
    for (Named cause : left) {
      Likeness likeness = likeness(effect, seen, cause);
      if (likeness.same()) {
        left.remove(cause);
        Optional<Strength> strength = Optional.of(likeness.strength());
        return new Found(effect, seen, How.NAMED, Optional.of(cause), strength);
      }
    }
    return new Found(effect, seen, How.NOT, Optional.empty(), Optional.empty());
  }

  private Found tied(Found before, List<Named> left) {
    for (Named cause : left) {
      if (likeness(before.hidden(), before.visibility(), cause).tied()) {
        left.remove(cause);
        return new Found(
            before.hidden(), before.visibility(), How.TIED, Optional.of(cause), Optional.empty());
      }
    }
    return before;
  }

  private boolean excused(Named cause) {
    for (int i = 0; i < hidden.hidden().size(); i++) {
      Likeness likeness = likeness(hidden.hidden().get(i), visibility.get(i), cause);
      if (likeness.alike() || likeness.tied()) {
        return true;
      }
    }
    return false;
  }

  private Optional<Boolean> rightVariable() {
    return hidden.hidden().stream()
        .map(EffectSetting::effect)
        .filter(e -> !e.catalogued())
        .findFirst()
        .flatMap(e -> RightVariable.first(e, answer));
  }

  /** Whether it is said that there is something without a name. */
  private boolean admitted() {
    return !answer.learned().isEmpty()
        || !answer.verdict().equals(Answer.ADEQUATE) && !answer.verdict().equals(Answer.EXPLAINED);
  }

  private boolean unnamedIsVisible() {
    for (int i = 0; i < visibility.size(); i++) {
      if (!hidden.hidden().get(i).effect().catalogued()
          && visibility.get(i).level() != Visibility.Class.INVISIBLE) {
        return true;
      }
    }
    return false;
  }

  private Outcome outcome(List<Found> found, List<Named> wrong) {
    if (!wrong.isEmpty()) {
      return Outcome.WRONG;
    }
    if (hidden.hidden().isEmpty()) {
      return admitted() ? Outcome.UNEXPLAINED : Outcome.RIGHT;
    }
    if (found.stream().anyMatch(f -> f.how() == How.NOT)) {
      return admitted() ? Outcome.UNEXPLAINED : Outcome.MISSED;
    }
    if (unnamedIsVisible() && !admitted()) {
      return Outcome.MISSED;
    }
    return found.stream().allMatch(f -> f.how() == How.NAMED) ? Outcome.RIGHT : Outcome.TIE;
  }
}
