package fieldcal.app.recording;

import fieldcal.fit.CameraViews;
import fieldcal.kick.Kick;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The kicks of one recording or several, and what is needed to judge them.
 *
 * @param epoch of all times
 * @param kicks in order of the recordings, numbered from 1
 * @param sources recording of each kick, by the kick's number
 * @param cameras all cameras that sent frames
 * @param streams frames and rate of each camera, by id
 * @param geometry the last geometry of the first recording that has one
 * @param published the models in it
 * @param problems everything that was skipped or odd, for the operator
 * @param duration of all recordings together, s
 */
public record CollectedKicks(
    Epoch epoch,
    List<Kick> kicks,
    Map<Integer, String> sources,
    CameraViews cameras,
    Map<Integer, CameraStream> streams,
    Optional<FieldGeometry> geometry,
    BallModels published,
    List<DataProblem> problems,
    double duration) {

  /** Copies the lists. {@inheritDoc} */
  public CollectedKicks {
    kicks = List.copyOf(kicks);
    sources = Map.copyOf(sources);
    streams = Map.copyOf(streams);
    problems = List.copyOf(problems);
  }
}
