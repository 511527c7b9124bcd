package fieldcal.app.twin;

import fieldcal.ball.BallTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A kick and the path that was fitted to it.
 *
 * @param kick the observations
 * @param kind flat or chip
 * @param path of the ball
 */
record FittedPath(Kick kick, KickKind kind, BallTrajectory path) {
  /** As the simple model fits the kick alone. */
  static FittedPath of(KickFit fit) {
    return new FittedPath(fit.kick(), fit.kind(), fit.trajectory());
  }

  /**
   * The paths of the extended model; for kicks that the diagnosis left out, since no model explains them, those that were fitted to each alone: the robots made them all the same.
   *
   * @param alone by the simple model, of all kicks that are believed
   * @param diagnosed kicks of the diagnosis
   * @return by the number of the kick
   */
  static Map<Integer, FittedPath> all(List<FittedPath> alone, List<KickResiduals> diagnosed) {
    Map<Integer, FittedPath> paths = new TreeMap<>();
    alone.forEach(p -> paths.put(p.kick().id(), p));
    diagnosed.forEach(k -> paths.put(k.kick().id(), new FittedPath(k.kick(), k.kind(), k.after())));
    return paths;
  }
}
