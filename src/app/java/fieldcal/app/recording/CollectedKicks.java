package fieldcal.app.recording;

import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraViews;
import fieldcal.kick.Kick;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The kicks of one recording or several, and what is needed to judge them.
 *
 * @param epoch of all times
 * @param kicks in order of the recordings, numbered from 1
 * @param sources recording of each kick, by the kick's number
 * @param cameras all cameras that sent frames
 * @param observers what measurement effects know of each of them, as published
 * @param streams frames and rate of each camera, by id
 * @param geometry the last geometry of the first recording that has one
 * @param published the models in it
 * @param problems everything that was skipped or odd, for the operator
 * @param sessionStart time of the earliest frame, s since the epoch; 0 without a frame
 * @param recordings where each of them comes from, in order
 * @param duration of all recordings together, s
 * @param together by the number of each camera, those that sent frames while it was calibrated as it is
 */
public record CollectedKicks(
    Epoch epoch,
    List<Kick> kicks,
    Map<Integer, String> sources,
    CameraViews cameras,
    List<ObservedCamera> observers,
    Map<Integer, CameraStream> streams,
    Optional<FieldGeometry> geometry,
    BallModels published,
    List<DataProblem> problems,
    double sessionStart,
    List<RecordingFacts> recordings,
    double duration,
    Map<Integer, Set<Integer>> together) {

  /** Copies the lists. {@inheritDoc} */
  public CollectedKicks {
    kicks = List.copyOf(kicks);
    sources = Map.copyOf(sources);
    observers = List.copyOf(observers);
    streams = Map.copyOf(streams);
    problems = List.copyOf(problems);
    recordings = List.copyOf(recordings);
    together = Map.copyOf(together);
  }

  /**
   * The same with more that the operator must know.
   *
   * @param more comes after the others
   * @return the changed copy
   */
  public CollectedKicks withProblems(List<DataProblem> more) {
    List<DataProblem> all = new ArrayList<>(problems);
    all.addAll(more);
    return new CollectedKicks(
        epoch,
        kicks,
        sources,
        cameras,
        observers,
        streams,
        geometry,
        published,
        all,
        sessionStart,
        recordings,
        duration,
        together);
  }
}
