package fieldcal.app.play;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.fit.FitSettings;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Map;

/** A session that its operator ends early, and what its first kicks tell. */
public final class EndedSession {
  private EndedSession() {}

  /**
   * Plays.
   *
   * @param world where
   * @param request what was asked for
   * @param later when after the recording's start, s
   * @param enough good kicks after which it is ended
   * @return how it went
   * @throws IOException when the log cannot be written
   */
  public static PlaySession.Outcome play(
      SimulationSettings world, SessionRequest request, double later, int enough)
      throws IOException {
    InteractiveField field =
        InteractiveField.later(world, request.first(), request.second(), List.of(), later);
    PlaySession[] session = new PlaySession[1];
    session[0] =
        new PlaySession(
            request,
            new EmbeddedPlayField(field, Double.POSITIVE_INFINITY),
            s -> {
              if (s.state().good() >= enough) {
                session[0].abort("enough is seen");
              }
            });
    return session[0].run();
  }

  /**
   * The diagnosis that the first kicks of what was recorded allow.
   *
   * @param recorded what was recorded, calibrated
   * @param kicks how many of its kicks
   * @return the problem
   */
  public static DiagnosisProblem firstKicks(CalibrationOutcome recorded, int kicks) {
    return new DiagnosisProblem(
        recorded.calibration().fitted().stream()
            .sorted(Comparator.comparingDouble(f -> f.kick().time()))
            .limit(kicks)
            .toList(),
        recorded.calibration().cameras(),
        recorded.data().observers(),
        recorded.data().sessionStart(),
        Map.of(),
        DiagnosisProblem.DEFAULT_MAX_CAUSES,
        FitSettings.defaults().seed());
  }
}
