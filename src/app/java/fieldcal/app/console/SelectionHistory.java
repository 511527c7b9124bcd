package fieldcal.app.console;

import fieldcal.calibration.HandSelection;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** The decisions about kicks, and those that can be taken back or done again. Not thread-safe. */
final class SelectionHistory {
  /** More steps back nobody remembers. */
  private static final int MOST_STEPS = 500;

  private final Deque<Step> undo = new ArrayDeque<>();
  private final Deque<Step> redo = new ArrayDeque<>();
  private HandSelection now = HandSelection.none();

  /** What was done, and the decisions before it (in {@code undo}) or after it (in {@code redo}). */
  private record Step(String label, HandSelection selection) {}

  HandSelection now() {
    return now;
  }

  /** Decisions of an earlier run; nothing to undo. */
  void restart(HandSelection selection) {
    undo.clear();
    redo.clear();
    now = selection;
  }

  void change(String label, HandSelection next) {
    undo.push(new Step(label, now));
    if (undo.size() > MOST_STEPS) {
      undo.removeLast();
    }
    redo.clear();
    now = next;
  }

  Optional<String> undoLabel() {
    return Optional.ofNullable(undo.peek()).map(Step::label);
  }

  Optional<String> redoLabel() {
    return Optional.ofNullable(redo.peek()).map(Step::label);
  }

  void undo() {
    step(undo, redo, "nothing to undo");
  }

  void redo() {
    step(redo, undo, "nothing to redo");
  }

  private void step(Deque<Step> from, Deque<Step> to, String nothing) {
    Step step = from.poll();
    if (step == null) {
      throw ApiException.conflict(nothing);
    }
    to.push(new Step(step.label, now));
    now = step.selection;
  }
}
