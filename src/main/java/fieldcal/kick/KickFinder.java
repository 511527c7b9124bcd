package fieldcal.kick;

import fieldcal.camera.Camera;
import fieldcal.vision.BallDetection;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Finds kicks in a stream of frames, frame by frame, with bounded memory.
 *
 * <p>A kick is a jump of the ball's velocity that a robot nearby, or the ball's rest before, explains, and after which the ball
 * moves away from that robot. Bounces of a chip, false detections and balls that are pushed or carried are none. Not thread-safe;
 * frames of one camera must come in order, those of different cameras roughly so.
 */
public final class KickFinder {
  /** When no camera sends anything for longer, the recording has a gap, s. */
  private static final double RECORDING_GAP = 0.25;

  /** Robots also kick from the strip around the lines; beyond it, balls bounce off what is there, m. */
  private static final double MARGIN = 0.3;

  /** No robot kicks the same ball again so soon; a chip's projection may jump while it leaves its kicker, s. */
  private static final double SAME_ROBOT_AGAIN = 0.3;

  /** A robot that catches a ball may hide it over the last part of its path, m. */
  private static final double CATCHING = 0.35;

  /** After a longer gap it is not known where the ball went, s. */
  private static final double LONG_GAP = 0.6;

  private final KickFinderSettings settings;
  private final Consumer<Kick> sink;
  private final Map<Integer, CameraTracks> cameras = new HashMap<>();
  private final Map<Integer, Camera> views = new HashMap<>();
  private final RobotPoses robots = new RobotPoses();
  private final DribbleWatch dribbles = new DribbleWatch();
  private final PlayingArea area = new PlayingArea();
  private final List<ActiveKick> active = new ArrayList<>();
  private final RecentEvents recent = new RecentEvents();
  private final TrackMatcher matcher = new TrackMatcher(views);
  private final KickFinderCounts counts = new KickFinderCounts();
  private final KickerSearch kickers;
  private final double[] scratch = new double[2];
  private double now = Double.NEGATIVE_INFINITY;
  private int found;
  private double gapEnd = Double.NEGATIVE_INFINITY;

  /**
   * Starts with nothing seen; until {@link #geometry} is called it takes the field to be unbounded.
   *
   * @param settings thresholds of kick finding
   * @param sink receives each kick once its ball has stopped, has left the field, was touched or was lost; kicks are numbered from 1 in that order
   */
  public KickFinder(KickFinderSettings settings, Consumer<Kick> sink) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.sink = Objects.requireNonNull(sink, "sink");
    kickers = new KickerSearch(settings, robots, dribbles, area);
  }

  /**
   * Learns the field's lines and where the cameras hang.
   *
   * @param geometry as published; may come again and may change
   * @param cameraModels the cameras by id; those that are missing are used without their position
   */
  public void geometry(FieldGeometry geometry, Map<Integer, Camera> cameraModels) {
    area.update(geometry);
    // A camera whose new calibration cannot be used no longer hangs where it did.
    views.clear();
    views.putAll(cameraModels);
  }

  /**
   * What was skipped so far, and why.
   *
   * @return running counts, live
   */
  public KickFinderCounts counts() {
    return counts;
  }

  /**
   * Takes the next frame. The sink is called from here. A frame that is up to a second older than the last one of its camera is skipped and counted; after a longer step back the clock is taken to have
   * restarted, and what is being followed ends. Never throws on bad detections.
   *
   * @param frame of any camera; times in s since the recording's epoch, places in m in the field frame
   */
  public void accept(VisionFrame frame) {
    double t = frame.captureTime();
    CameraTracks tracks = cameras.computeIfAbsent(frame.cameraId(), CameraTracks::new);
    if (!tracks.inOrder(t)) {
      if (tracks.lastTime() - t < 1.0) {
        counts.staleFrames++;
        return;
      }
      counts.clockJumps++;
      restart();
      tracks = cameras.computeIfAbsent(frame.cameraId(), CameraTracks::new);
    }
    if (t - now > RECORDING_GAP && now > Double.NEGATIVE_INFINITY) {
      gap(t);
    }
    now = Math.max(now, t);
    robots.update(frame);
    dribbles.update(frame);
    for (BallDetection ball : frame.balls()) {
      tracks.offer(ball);
    }
    tracks.associate(t, this::follow);
    endLost();
  }

  /** All cameras were silent. Through a short gap the ball rolls on, and is found again where it was heading. */
  private void gap(double t) {
    counts.recordingGaps++;
    gapEnd = t;
    if (t - now > LONG_GAP) {
      endAll(KickEnd.RECORDING_ENDED);
      cameras.values().forEach(CameraTracks::clear);
      robots.clear();
      dribbles.clear();
    }
  }

  /** Ends what is still being followed: the recording is over. The finder may be used for another recording afterwards. */
  public void finish() {
    restart();
  }

  private void restart() {
    endAll(KickEnd.RECORDING_ENDED);
    recent.clear();
    cameras.clear();
    robots.clear();
    dribbles.clear();
    now = Double.NEGATIVE_INFINITY;
  }

  private void follow(BallTrack track) {
    ActiveKick owner = ownerOf(track);
    if (owner == null) {
      owner = adopt(track);
    } else {
      KickEnd end = owner.update(track, robots, area);
      if (end != null) {
        end(owner, end, track.lastTime());
      }
    }
    JumpDetector.Jump jump = track.jumps().update(track, settings);
    if (jump != null) {
      consider(jump, track, active.contains(owner) ? owner : null);
    }
  }

  private ActiveKick ownerOf(BallTrack track) {
    for (ActiveKick kick : active) {
      if (kick.has(track)) {
        return kick;
      }
    }
    return null;
  }

  /** A track that belongs to no kick yet may be the ball of one, entering this camera's view. */
  private ActiveKick adopt(BallTrack track) {
    if (track.size() < 3) {
      return null;
    }
    for (ActiveKick kick : active) {
      if (track.lastTime() > kick.time()
          && !kick.isOther(track)
          && !kick.sees(track.camera(), track.lastTime())
          && matcher.same(kick, track)) {
        kick.join(track);
        return kick;
      }
    }
    return null;
  }

  private void consider(JumpDetector.Jump jump, BallTrack track, ActiveKick owner) {
    if (isKnown(jump, track, owner)) {
      return;
    }
    RobotId robot = kickers.kicker(jump);
    if (robot != null || kickers.startedAlone(jump)) {
      considerKick(jump, track, owner, robot);
    } else if (owner == null || jump.born()) {
      considerHidden(jump, track, owner);
    } else if (kickers.touched(jump) && !isPartOf(owner, jump, track, null)) {
      end(owner, KickEnd.TOUCHED_ROBOT, jump.time() - 0.005);
    }
  }

  /** Whether a known kick's ball comes into view here, or another camera has already shown this kick; then the track shows the same ball. */
  private boolean isKnown(JumpDetector.Jump jump, BallTrack track, ActiveKick owner) {
    if (jump.born() && owner != null && owner.goesOn(track, jump)) {
      return true;
    }
    ActiveKick same = recent.sameKick(active, jump, track);
    if (same != null && owner == null) {
      same.join(track);
    }
    return same != null || recent.isOver(jump, track);
  }

  /** Looks for the kicker of a ball that suddenly moves with no robot near it: its kicker may have hidden it at first. */
  private void considerHidden(JumpDetector.Jump jump, BallTrack track, ActiveKick owner) {
    RobotId robot = kickers.hiddenKicker(jump);
    if (robot == null) {
      return;
    }
    JumpDetector.Jump start = jump.earlier(kickers.hidden());
    if (!matcher.underWay(cameras.values(), track, start) && !isKnown(start, track, null)) {
      considerKick(start, track, owner, robot);
    }
  }

  private void considerKick(
      JumpDetector.Jump jump, BallTrack track, ActiveKick owner, RobotId robot) {
    if (area.outside(jump.x(), jump.y()) > MARGIN) {
      return;
    }
    if (owner != null && isPartOf(owner, jump, track, robot)) {
      return;
    }
    if (robot != null && kickers.carried(robot, jump, track)) {
      counts.carried++;
      return;
    }
    if (owner != null) {
      end(owner, KickEnd.TOUCHED_ROBOT, jump.time() - 0.005);
    }
    if (kickers.isDeflection(jump, robot, recent.speedBefore(jump, active))) {
      counts.deflections++;
      recent.deflected(jump);
      return;
    }
    start(jump, track, robot);
  }

  private void start(JumpDetector.Jump jump, BallTrack track, RobotId robot) {
    boolean dribbled = robot != null && dribbles.dribbled(robot, jump.time(), jump.fromRest());
    ActiveKick kick = new ActiveKick(jump, robot, dribbled, settings);
    kick.startedBy(track, robots);
    active.add(kick);
    for (CameraTracks camera : cameras.values()) {
      for (BallTrack other : camera.tracks()) {
        if (other != track
            && ownerOf(other) == null
            && other.size() >= 3
            && matcher.same(kick, other)) {
          kick.join(other);
        }
      }
    }
  }

  /** Whether the jump belongs to the kick that is followed already: a bounce near a robot, or its projection leaving the kicker. */
  private static boolean isPartOf(
      ActiveKick owner, JumpDetector.Jump jump, BallTrack track, RobotId robot) {
    boolean justKicked = owner.kickedBy(robot) && jump.time() - owner.time() < SAME_ROBOT_AGAIN;
    return justKicked || owner.wasInTheAir(track, jump.time());
  }

  private void endLost() {
    for (int i = active.size() - 1; i >= 0; i--) {
      ActiveKick kick = active.get(i);
      if (now - kick.lastTime() > settings.lostAfter()) {
        boolean inGap =
            kick.lastTime() < gapEnd && kick.lastTime() > gapEnd - LONG_GAP - RECORDING_GAP;
        KickEnd reason = inGap ? KickEnd.RECORDING_ENDED : KickEnd.LOST;
        end(kick, kick.vanished(area, robots, reason), kick.lastTime());
      }
    }
  }

  private void endAll(KickEnd reason) {
    active.sort(Comparator.comparingDouble(ActiveKick::time));
    while (!active.isEmpty()) {
      ActiveKick kick = active.get(0);
      end(kick, kick.vanished(area, robots, reason), kick.lastTime());
    }
  }

  private void end(ActiveKick kick, KickEnd reason, double time) {
    active.remove(kick);
    recent.ended(kick);
    if (reason == KickEnd.TOUCHED_ROBOT) {
      caught(kick);
    }
    Kick finished = kick.finish(reason, time);
    if (finished == null) {
      counts.tooShort++;
    } else {
      sink.accept(finished.withId(++found));
    }
  }

  /** Remembers which robot has the ball now. */
  private void caught(ActiveKick kick) {
    double t = kick.touchTime();
    BallTrack track = kick.newest();
    int age = 0;
    while (age + 1 < track.size() && track.time(age) > t) {
      age++;
    }
    RobotId catcher = robots.nearest(t, track.x(age), track.y(age), CATCHING, scratch);
    if (catcher != null) {
      dribbles.caught(catcher, t);
    }
  }
}
