package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.diagnosis.Verdict;
import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.diagnosis.hidden.Judgement.Found;
import fieldcal.diagnosis.hidden.Judgement.How;
import fieldcal.diagnosis.hidden.Judgement.Outcome;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.truth.Truth;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Compares diagnosis and truth. */
public final class Judge {
  private Judge() {}

  /**
   * Judges.
   *
   * @param hidden the case
   * @param visibility of each hidden effect alone, in their order
   * @param truth what really happened
   * @param diagnosis what was said
   * @return the judgement
   */
  public static Judgement judge(
      HiddenCase hidden, List<Visibility> visibility, Truth truth, Diagnosis diagnosis) {
    List<Cause> left = new ArrayList<>(diagnosis.causes());
    List<Found> found = new ArrayList<>();
    if (hidden.category() != Category.UNKNOWN) {
      for (int i = 0; i < hidden.hidden().size(); i++) {
        found.add(named(hidden.hidden().get(i), visibility.get(i), truth, left));
      }
      // Names first: a tie must not take the cause that is another effect's own.
      found.replaceAll(f -> f.how() == How.NAMED ? f : tied(f, left));
    }
    return new Judgement(
        outcome(hidden, visibility, found, left, diagnosis.verdict()),
        found,
        left,
        diagnosis.verdict());
  }

  private static Found named(
      EffectSetting hidden, Visibility visibility, Truth truth, List<Cause> left) {
    for (Cause cause : left) {
      Likeness likeness = new Likeness(hidden, visibility, truth, cause);
      if (likeness.same()) {
        left.remove(cause);
        Optional<Strength> strength = Optional.of(likeness.strength());
        return new Found(hidden, visibility, How.NAMED, Optional.of(cause), strength);
      }
    }
    return new Found(hidden, visibility, How.NOT, Optional.empty(), Optional.empty());
  }

  private static Found tied(Found before, List<Cause> left) {
    for (Cause cause : left) {
      if (cause.indistinguishableFrom().contains(before.hidden().effect().id())) {
        left.remove(cause);
        return new Found(
            before.hidden(), before.visibility(), How.TIED, Optional.of(cause), Optional.empty());
      }
    }
    return before;
  }

  private static Outcome outcome(
      HiddenCase hidden,
      List<Visibility> visibility,
      List<Found> found,
      List<Cause> wrong,
      Verdict verdict) {
    if (!wrong.isEmpty()) {
      return Outcome.WRONG;
    }
    boolean unexplained = verdict == Verdict.UNEXPLAINED_STRUCTURE;
    return switch (hidden.category()) {
      case NULL -> unexplained ? Outcome.UNEXPLAINED : Outcome.RIGHT;
      case UNKNOWN ->
          unexplained || visibility.get(0).level() == Visibility.Class.INVISIBLE
              ? Outcome.RIGHT
              : Outcome.MISSED;
      case SINGLE, PAIR -> {
        if (found.stream().anyMatch(f -> f.how() == How.NOT)) {
          yield unexplained ? Outcome.UNEXPLAINED : Outcome.MISSED;
        }
        yield found.stream().allMatch(f -> f.how() == How.NAMED) ? Outcome.RIGHT : Outcome.TIE;
      }
    };
  }
}
