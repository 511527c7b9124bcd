package fieldcal.archive.match;

import fieldcal.app.limits.PlayPhases;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.recording.LogOpener;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingStatistics;
import fieldcal.gamelog.RefereeState;
import fieldcal.gamelog.TrackerFrame;
import fieldcal.movement.MovementObserver;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ForkJoinPool;

/** Reads one game log once, for everything that the tables need of it. */
public final class MatchReader {

  private MatchReader() {}

  /**
   * Reads a log.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @param opener opens it
   * @return what it holds
   * @throws IOException when it cannot be read at all; the message names file and place
   */
  public static MatchData read(Path log, LogOpener opener) throws IOException {
    Watch watch = new Watch();
    KickCollector.Progress unseen = (file, bytesRead, totalBytes) -> {};
    CollectedKicks data = new KickCollector(unseen, opener, watch).collect(List.of(log));
    watch.movement.finish();
    return new MatchData(
        log,
        Files.size(log),
        watch.frames,
        data,
        calibrate(data),
        watch.statistics.cameras(),
        watch.statistics.referee(),
        watch.teams,
        watch.movement,
        watch.trackers);
  }

  /** One thread for each log: the other cores have logs of their own. */
  private static Calibration calibrate(CollectedKicks data) {
    CalibrationProblem problem =
        new CalibrationProblem(
            data.kicks(),
            data.epoch(),
            data.cameras(),
            data.published().flat().orElse(FlatModel.typical()),
            data.published().chip().orElse(ChipModel.typical()),
            Optional.empty(),
            HandSelection.none());
    ForkJoinPool own = new ForkJoinPool(1);
    try {
      return own.submit(() -> new Calibrator(FitSettings.defaults()).calibrate(problem, kick -> {}))
          .get();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    } finally {
      own.shutdownNow();
    }
  }

  /** Reads along with the kick finder. */
  private static final class Watch implements RecordingListener {
    private final RecordingStatistics statistics = new RecordingStatistics();
    private final MovementObserver movement = new MovementObserver();
    private final TrackerWatch trackers = new TrackerWatch();
    private final Map<Team, String> teams = new EnumMap<>(Team.class);
    private long frames;

    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      frames++;
      statistics.onFrame(frame, receivedTime);
      movement.accept(frame);
    }

    @Override
    public boolean wantsTrackers() {
      return true;
    }

    @Override
    public void onTracker(TrackerFrame frame, double receivedTime) {
      trackers.accept(frame);
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      statistics.onReferee(state, receivedTime);
      movement.phase(PlayPhases.of(state));
      name(Team.YELLOW, state.yellow());
      name(Team.BLUE, state.blue());
    }

    private void name(Team team, RefereeState.TeamState state) {
      if (!state.name().isBlank()) {
        teams.put(team, state.name());
      }
    }

    @Override
    public void onClockJump(int cameraId, double jump) {
      statistics.onClockJump(cameraId, jump);
      movement.finish();
    }
  }
}
