package fieldcal.app.limits;

import fieldcal.app.recording.DataProblem;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.gamelog.LogProblem;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeState;
import fieldcal.movement.MovementObserver;
import fieldcal.vision.ProblemKind;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongConsumer;

/**
 * One recording, read and counted.
 *
 * @param facts which
 * @param observer what it saw
 * @param summary what was read
 * @param names of the teams, as the referee says; without one, or when it is empty, none
 * @param problems what was wrong
 */
record RecordedMovement(
    RecordingFacts facts,
    MovementObserver observer,
    RecordingSummary summary,
    Map<Team, String> names,
    List<DataProblem> problems) {

  /** Reads a recording to its end; {@code bytesRead} is called with how far it is. */
  static RecordedMovement read(Path log, LogOpener opener, LongConsumer bytesRead)
      throws IOException {
    RecordingFacts facts = RecordingFacts.of(log, opener);
    MovementObserver observer = new MovementObserver();
    try (RecordingReader reader = opener.recording(log)) {
      Map<Team, String> names = new EnumMap<>(Team.class);
      RecordingSummary summary = reader.read(new Feed(observer, names, bytesRead));
      observer.finish();
      return new RecordedMovement(
          facts, observer, summary, names, problems(log, summary, observer));
    }
  }

  private static List<DataProblem> problems(
      Path log, RecordingSummary summary, MovementObserver observer) {
    List<DataProblem> list = new ArrayList<>();
    ProblemAccount account = summary.problems();
    for (ProblemKind kind : account.kinds()) {
      // Cameras that are calibrated again change nothing here: each piece has a constant of its own
      // for each camera.
      if (kind != LogProblem.GEOMETRY_CHANGED) {
        list.add(DataProblem.of(log, account, kind));
      }
    }
    if (summary.frames() == 0) {
      list.add(
          new DataProblem(
              log.toString(),
              "no vision frame in the recording",
              1,
              "record SSL-Vision's multicast, message type 4"));
    } else if (!observer.statistics().refereeSeen()) {
      list.add(
          new DataProblem(
              log.toString(),
              "no referee message in the recording",
              1,
              "everything was counted, including breaks, which may distort the limits"));
    } else if (observer.statistics().counted() == 0) {
      list.add(
          new DataProblem(
              log.toString(),
              "the ball was never in play while robots were seen",
              1,
              "there is nothing to measure: only play counts, by the referee's stage and command"));
    }
    if (observer.statistics().refused() > 0) {
      list.add(
          new DataProblem(
              log.toString(),
              "detections that cannot be of the robot they name",
              observer.statistics().refused(),
              "exchanged identities or jumps; they were left out"));
    }
    if (observer.statistics().surplusFrames() > 0) {
      list.add(
          new DataProblem(
              log.toString(),
              "frames of more than eight cameras at once",
              observer.statistics().surplusFrames(),
              "the first eight count; a damaged frame may name a camera that does not exist"));
    }
    return list;
  }

  /** Gives an observer what a recording holds. */
  private record Feed(MovementObserver observer, Map<Team, String> names, LongConsumer bytesRead)
      implements RecordingListener {
    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      observer.accept(frame);
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      observer.phase(PlayPhases.of(state));
      name(Team.YELLOW, state.yellow());
      name(Team.BLUE, state.blue());
    }

    private void name(Team team, RefereeState.TeamState state) {
      if (!state.name().isBlank()) {
        names.put(team, state.name());
      }
    }

    @Override
    public void onClockJump(int cameraId, double jump) {
      observer.finish();
    }

    @Override
    public void onProgress(long read, long totalBytes) {
      bytesRead.accept(read);
    }
  }
}
