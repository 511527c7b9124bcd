package fieldcal.movement;

import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Watches the robots of both teams, frame by frame. Give it every frame as it comes, and the referee's phase when that changes. {@link #statistics} can be read at any time. Movements are counted some two seconds after they happened.
 *
 * <p>Memory is bounded by the number of robots and cameras; frames allocate nothing. Never throws on bad frames. For one thread.
 */
public final class MovementObserver {
  /** Most robots that are followed: a team's sixteen, and a few misread numbers. */
  private static final int MOST_ROBOTS = 64;

  /** Another camera may take the place of one that has sent nothing for so long, s; chosen: a computer of vision restarts in less, and keeps its cameras' places. */
  private static final double GONE = 30;

  private final MovementStatistics statistics = new MovementStatistics();
  private final ManoeuvreFinder driving =
      new ManoeuvreFinder(PathKind.POSITION, m -> statistics.of(m.robot().team()).add(m));
  private final ManoeuvreFinder turning =
      new ManoeuvreFinder(
          PathKind.ORIENTATION, m -> statistics.of(m.robot().team()).add(Turn.of(m)));
  private final Map<RobotId, Watched> robots = new HashMap<>();
  private final Map<Integer, CameraState> cameras = new HashMap<>();
  private PlayPhase phase = PlayPhase.UNKNOWN;

  /** A robot and what is kept of it. */
  private static final class Watched {
    private final RobotTrack track;
    private final FrameSteps[] steps = new FrameSteps[Stretch.CAMERAS];
    private final StandingNoise[] standing = new StandingNoise[Stretch.CAMERAS];

    Watched(RobotTrack track) {
      this.track = track;
      for (int i = 0; i < Stretch.CAMERAS; i++) {
        steps[i] = new FrameSteps();
        standing[i] = new StandingNoise();
      }
    }

    void forget() {
      track.end();
      for (int i = 0; i < Stretch.CAMERAS; i++) {
        steps[i].forget();
        standing[i].forget();
      }
    }
  }

  /** A camera's frames. */
  private static final class CameraState {
    private final int index;
    private double lastTime = Double.NEGATIVE_INFINITY;
    private long frames;

    CameraState(int index) {
      this.index = index;
    }
  }

  /** Creates an observer that has seen nothing, without a referee. */
  public MovementObserver() {}

  /**
   * What the referee says from now on.
   *
   * @param next the phase
   * @throws NullPointerException when it is null
   */
  public void phase(PlayPhase next) {
    Objects.requireNonNull(next, "next");
    if (next != PlayPhase.UNKNOWN) {
      statistics.refereeSeen = true;
    }
    if (next != phase) {
      breakOff();
      phase = next;
    }
  }

  /**
   * Takes a frame.
   *
   * @param frame of any camera; of each camera in the order of capture, a repeated one is ignored. Of more than eight cameras at once the first eight count
   */
  public void accept(VisionFrame frame) {
    double time = frame.captureTime();
    if (!Double.isFinite(time)) {
      return;
    }
    CameraState camera = camera(frame.cameraId(), time);
    if (camera == null) {
      statistics.surplusFrames++;
      return;
    }
    if (time <= camera.lastTime && time > camera.lastTime - 1) {
      statistics.repeatedFrames++;
      return;
    }
    camera.lastTime = time;
    camera.frames++;
    statistics.detections += frame.robots().size();
    if (phase != PlayPhase.HALTED && !phase.counts()) {
      return;
    }
    for (int i = 0; i < frame.robots().size(); i++) {
      RobotDetection robot = frame.robots().get(i);
      Watched watched = watched(robot.id());
      if (watched == null) {
        statistics.refused++;
      } else if (phase == PlayPhase.HALTED) {
        watched.standing[camera.index].add(
            robot.x(), robot.y(), statistics.standing(), statistics.standingSquares());
      } else if (watched.track.accept(time, camera.index, robot)) {
        statistics.counted++;
        watched.steps[camera.index].add(
            camera.frames, time, robot.x(), robot.y(), statistics.of(robot.id().team()).league());
      } else {
        statistics.refused++;
      }
    }
  }

  /** A camera and its place; null when all places are taken. A damaged frame may name a camera that does not exist: it holds a place no longer than one that was switched off. */
  private CameraState camera(int id, double time) {
    CameraState known = cameras.get(id);
    if (known != null) {
      return known;
    }
    int index = cameras.size();
    if (index == Stretch.CAMERAS) {
      Optional<Integer> gone =
          cameras.entrySet().stream()
              .filter(e -> time - e.getValue().lastTime > GONE)
              .map(Map.Entry::getKey)
              .findFirst();
      if (gone.isEmpty()) {
        return null;
      }
      index = cameras.remove(gone.get()).index;
      breakOff();
    }
    CameraState entered = new CameraState(index);
    cameras.put(id, entered);
    return entered;
  }

  private Watched watched(RobotId id) {
    Watched known = robots.get(id);
    if (known == null && robots.size() < MOST_ROBOTS) {
      known = new Watched(new RobotTrack(id, driving, turning));
      robots.put(id, known);
    }
    return known;
  }

  private void breakOff() {
    robots.values().forEach(Watched::forget);
  }

  /** Ends all paths, since the recording is over or a clock jumped: what was seen so far is counted, and no movement connects it with later frames. */
  public void finish() {
    breakOff();
    cameras.values().forEach(camera -> camera.lastTime = Double.NEGATIVE_INFINITY);
  }

  /** Forgets all that was counted, as in a break in which robots may be changed. */
  public void clear() {
    breakOff();
    statistics.clear();
  }

  /**
   * What was counted so far.
   *
   * @return the live statistics, which go on counting; merge them into others to keep a copy
   */
  public MovementStatistics statistics() {
    return statistics;
  }

  /**
   * Noise of one coordinate of a moving robot's detections, from the residuals of the fits.
   *
   * @return standard deviation, m; 2.5 mm before anything was fitted
   */
  public double noise() {
    return driving.noise();
  }

  /**
   * Whether {@link #noise} was measured.
   *
   * @return false when it is only the usual value
   */
  public boolean noiseKnown() {
    return driving.noiseKnown();
  }

  /**
   * The limits of a team as far as they are known; takes as long as {@link LimitEstimator#estimate}.
   *
   * @param team which
   * @return estimates, each with its error or the reason why there is none
   */
  public TeamLimits limits(Team team) {
    return LimitEstimator.estimate(team, statistics.of(team));
  }
}
