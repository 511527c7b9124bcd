package fieldcal.app.play;

import fieldcal.calibration.Average;
import fieldcal.play.PlayState;
import fieldcal.play.PlayWorld;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A session at one moment; immutable.
 *
 * @param time since the session began, s
 * @param state phase, reason of waiting, counts
 * @param paused whether the operator paused it
 * @param world ball, robots, permission
 * @param geometry of the field; empty before vision has sent it
 * @param robots the two that play
 * @param ballWanted where somebody should place the ball, {x, y} in m; empty when nobody has to
 * @param kicks all that were made, in order
 * @param model what they say so far: average of each parameter by its name; those that no kick determines are missing
 * @param undecided which causes the kicks so far do not tell apart; found out only by adaptive sessions that record
 */
public record SessionSnapshot(
    double time,
    PlayState state,
    boolean paused,
    PlayWorld world,
    Optional<FieldGeometry> geometry,
    List<RobotId> robots,
    List<Double> ballWanted,
    List<KickResult> kicks,
    Map<String, Average> model,
    Undecided undecided) {

  /** Copies the collections. {@inheritDoc} */
  public SessionSnapshot {
    robots = List.copyOf(robots);
    ballWanted = List.copyOf(ballWanted);
    kicks = List.copyOf(kicks);
    model = Map.copyOf(model);
  }

  /**
   * Causes that a diagnosis could not tell from others.
   *
   * @param causes in words, one entry for each two of them
   * @param sought those of them that the next kick is chosen to tell apart; a kick of this play tells no others apart
   * @param advice what would tell them apart, in words
   */
  public record Undecided(List<String> causes, List<String> sought, List<String> advice) {

    /** Copies the lists. {@inheritDoc} */
    public Undecided {
      causes = List.copyOf(causes);
      sought = List.copyOf(sought);
      advice = List.copyOf(advice);
    }

    /**
     * Whether more kicks of this play may tell.
     *
     * @return false also when nothing is undecided
     */
    public boolean mayBeTold() {
      return !sought.isEmpty();
    }
  }
}
