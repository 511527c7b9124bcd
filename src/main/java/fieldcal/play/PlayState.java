package fieldcal.play;

import java.util.List;
import java.util.Optional;

/**
 * How far the play is; immutable.
 *
 * @param phase what it is busy with
 * @param waiting why nothing moves at the moment, or why it stopped; empty when all is well
 * @param waitingFor the robot or the place that this is about
 * @param good kicks that count
 * @param made kicks that were made, those that do not count included
 * @param unjudged kicks that were made and are being fitted
 * @param wanted how many good kicks are wanted
 * @param next the kick that is being prepared or watched
 * @param kicker index of the robot that kicks next, 0 or 1; -1 when undecided
 * @param remarks what the operator should hear of at once, such as a robot whose kicker has no effect; in order, none ever changes or goes away
 */
public record PlayState(
    PlayPhase phase,
    Optional<String> waiting,
    WaitingFor waitingFor,
    int good,
    int made,
    int unjudged,
    int wanted,
    Optional<PlannedKick> next,
    int kicker,
    List<String> remarks) {

  /** Copies the list. {@inheritDoc} */
  public PlayState {
    remarks = List.copyOf(remarks);
  }
}
