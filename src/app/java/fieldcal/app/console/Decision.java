package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.HandSelection;
import fieldcal.kick.Kick;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.BiFunction;
import java.util.stream.Collectors;

/**
 * What an operator decides about kicks, as the page sends it.
 *
 * @param action what to do
 * @param kicks numbers of the kicks, for actions on kicks
 * @param reason why, for dropping
 * @param seen version of the state that the operator looked at; empty when it does not matter
 */
record Decision(Action action, List<Integer> kicks, String reason, OptionalLong seen) {
  private static final int LONGEST_REASON = 200;
  private static final int MOST_KICKS = 100_000;

  /** What can be decided. */
  enum Action {
    /** These kicks are not used. */
    DROP(true),
    /** These kicks are used, whatever the rules say. */
    KEEP(true),
    /** The rules decide about these kicks. */
    AUTO(true),
    /** One more round of the 2σ rule. */
    TWO_SIGMA(false),
    /** No round of the 2σ rule. */
    NO_TWO_SIGMA(false),
    /** As many rounds of the 2σ rule as it takes. */
    ALL_TWO_SIGMA(false),
    /** The last decision is taken back. */
    UNDO(false),
    /** What was taken back is done again. */
    REDO(false);

    private final boolean onKicks;

    Action(boolean onKicks) {
      this.onKicks = onKicks;
    }
  }

  /**
   * Reads a decision.
   *
   * @throws ApiException when it is none, with the field
   */
  static Decision of(JsonNode body) {
    Action action = Requests.oneOf(body, "action", Action.values());
    List<Integer> kicks = new ArrayList<>();
    if (action.onKicks) {
      JsonNode list = body.path("kicks");
      if (!list.isArray() || list.isEmpty() || list.size() > MOST_KICKS) {
        throw ApiException.badRequest("kicks must be a list of one number or more");
      }
      for (JsonNode kick : list) {
        if (!kick.isInt()) {
          throw ApiException.badRequest("kicks must be numbers, not " + kick);
        }
        kicks.add(kick.asInt());
      }
    }
    String reason = Requests.text(body, "reason", LONGEST_REASON).strip();
    OptionalLong seen = Requests.number(body, "seen");
    return new Decision(
        action, List.copyOf(kicks), reason.isEmpty() ? "no reason given" : reason, seen);
  }

  /** Carries it out on a history of decisions. */
  void apply(CalibrationOutcome outcome, SelectionHistory history) {
    HandSelection now = history.now();
    switch (action) {
      case DROP -> history.change(label("dropping"), onEach(outcome, now, this::dropped));
      case KEEP -> history.change(label("keeping"), onEach(outcome, now, HandSelection::keep));
      case AUTO ->
          history.change(label("restoring"), onEach(outcome, now, HandSelection::leaveToRules));
      case TWO_SIGMA -> twoSigma(outcome, history);
      case NO_TWO_SIGMA ->
          history.change("leaving 2σ out", now.withTwoSigmaRounds(OptionalInt.of(0)));
      case ALL_TWO_SIGMA ->
          history.change(
              "2σ until no value is beyond it", now.withTwoSigmaRounds(OptionalInt.empty()));
      case UNDO -> history.undo();
      case REDO -> history.redo();
    }
  }

  private HandSelection dropped(HandSelection selection, String key) {
    return selection.drop(key, reason);
  }

  private static void twoSigma(CalibrationOutcome outcome, SelectionHistory history) {
    HandSelection now = history.now();
    if (KickDesk.wouldLeave(outcome) == 0) {
      throw ApiException.conflict("No value is beyond 2σ any more.");
    }
    int round = now.twoSigmaRounds().orElseThrow() + 1;
    history.change("round " + round + " of 2σ", now.withTwoSigmaRounds(OptionalInt.of(round)));
  }

  private HandSelection onEach(
      CalibrationOutcome outcome,
      HandSelection selection,
      BiFunction<HandSelection, String, HandSelection> one) {
    HandSelection changed = selection;
    for (int id : kicks) {
      Kick kick =
          outcome.calibration().kicks().stream()
              .map(CalibratedKick::fit)
              .map(f -> f.kick())
              .filter(k -> k.id() == id)
              .findFirst()
              .orElseThrow(() -> ApiException.notFound("there is no kick " + id));
      changed = one.apply(changed, outcome.key(kick));
    }
    return changed;
  }

  private String label(String verb) {
    return kicks.size() > 4
        ? verb + " " + kicks.size() + " kicks"
        : verb
            + (kicks.size() == 1 ? " kick " : " kicks ")
            + kicks.stream().map(Object::toString).collect(Collectors.joining(", "));
  }
}
