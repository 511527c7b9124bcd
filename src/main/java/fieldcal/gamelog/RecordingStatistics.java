package fieldcal.gamelog;

import fieldcal.proto.Referee;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** Collects what shows how good a recording is, while it is read. Memory is constant; not thread-safe. */
public final class RecordingStatistics implements RecordingListener {
  /** A camera that is silent for longer has a gap, s: more than thirty frames of any camera in use. */
  public static final double GAP = 0.5;

  /** Most stages that are kept, so that memory stays bounded. A match has 14. */
  private static final int MAX_STAGES = 200;

  /** Most trackers that are kept, so that memory stays bounded. A match has about four. */
  private static final int MAX_TRACKERS = 32;

  private final Map<Integer, CameraObserver> cameras = new TreeMap<>();
  private final Map<Referee.Command, Long> commands = new EnumMap<>(Referee.Command.class);
  private final List<RefereeStatistics.StageStart> stages = new ArrayList<>();
  private final Map<String, TrackerObserver> trackers = new TreeMap<>();
  private long refereeMessages;
  private RefereeState lastReferee;

  /** Starts with nothing seen. */
  public RecordingStatistics() {}

  @Override
  public void onFrame(VisionFrame frame, double receivedTime) {
    cameras.computeIfAbsent(frame.cameraId(), CameraObserver::new).add(frame, receivedTime);
  }

  @Override
  public void onClockJump(int cameraId, double jump) {
    cameras.computeIfAbsent(cameraId, CameraObserver::new).clockJumped();
  }

  @Override
  public void onReferee(RefereeState state, double receivedTime) {
    refereeMessages++;
    if (lastReferee == null
        || state.commandCounter() != lastReferee.commandCounter()
        || state.command() != lastReferee.command()) {
      commands.merge(state.command(), 1L, Long::sum);
    }
    if ((lastReferee == null || state.stage() != lastReferee.stage())
        && stages.size() < MAX_STAGES) {
      stages.add(new RefereeStatistics.StageStart(receivedTime, state.stage()));
    }
    lastReferee = state;
  }

  @Override
  public boolean wantsTrackers() {
    return true;
  }

  @Override
  public void onTracker(TrackerFrame frame, double receivedTime) {
    String key = frame.source() + '\n' + frame.uuid();
    TrackerObserver known = trackers.get(key);
    if (known == null && trackers.size() < MAX_TRACKERS) {
      known = new TrackerObserver(frame.source(), frame.uuid());
      trackers.put(key, known);
    }
    if (known != null) {
      known.add(frame, receivedTime);
    }
  }

  /**
   * The trackers that sent frames.
   *
   * @return by their names
   */
  public List<TrackerStatistics> trackers() {
    return trackers.values().stream().map(TrackerObserver::statistics).toList();
  }

  /**
   * The cameras that sent frames.
   *
   * @return one entry each, by id
   */
  public List<CameraStatistics> cameras() {
    return cameras.values().stream().map(CameraObserver::statistics).toList();
  }

  /**
   * What the referee did.
   *
   * @return empty if it was silent
   */
  public Optional<RefereeStatistics> referee() {
    return lastReferee == null
        ? Optional.empty()
        : Optional.of(new RefereeStatistics(refereeMessages, commands, stages, lastReferee));
  }
}
