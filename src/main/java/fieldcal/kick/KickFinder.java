package fieldcal.kick;

import fieldcal.camera.Camera;
import fieldcal.vision.BallDetection;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
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
  /** A camera that sends nothing for that long has a gap; if all do, the recording has, s. */
  private static final double RECORDING_GAP = 0.25;

  /** Two cameras see the same kick within that time and distance, s and m. */
  private static final double SAME_TIME = 0.12;

  private static final double SAME_PLACE = 0.35;

  /** Kicks that ended before another camera told of them; more do not happen within {@link #SAME_TIME}. */
  private static final int REMEMBERED = 4;

  /** A ball that is not faster than before bounced off a robot; a kick adds speed, m/s. */
  private static final double LEAST_GAIN = 0.2;

  /** Robots also kick from the strip around the lines; beyond it, balls bounce off what is there, m. */
  private static final double MARGIN = 0.3;

  /** No robot kicks the same ball again so soon; a chip's projection may jump while it leaves its kicker, s. */
  private static final double SAME_ROBOT_AGAIN = 0.3;

  /** A frame and a half before a jump, since its time is good to some milliseconds only, s. */
  private static final double JUST_BEFORE = 0.02;

  /** A kicked ball is that much farther from its robot some 0.1 s later, m. */
  private static final double LEAST_SEPARATION = 0.04;

  /** A ball that bounces off a robot is hidden by it for up to that long; after more the robot held it, and has kicked it, s. */
  private static final double HIDDEN = 0.2;

  /** A ball that a robot stops reappears within that distance of where it was seen last, m. */
  static final double SAME_BALL = 0.5;

  /** A kicker hides the ball for up to that long, s: 0.5 m at 2 m/s. */
  private static final double HIDDEN_START = 0.3;

  /** A ball that another camera saw so far from there just before was not there, m. */
  private static final double ELSEWHERE = 0.2;

  /** It had the ball within that time before, s. */
  private static final double HELD = 1.5;

  /** After a longer gap nothing is known of where the ball went, s. */
  private static final double LONG_GAP = 0.6;

  private final KickFinderSettings settings;
  private final Consumer<Kick> sink;
  private final Map<Integer, CameraTracks> cameras = new HashMap<>();
  private final Map<Integer, Camera> views = new HashMap<>();
  private final RobotPoses robots = new RobotPoses();
  private final DribbleWatch dribbles = new DribbleWatch();
  private final PlayingArea area = new PlayingArea();
  private final List<ActiveKick> active = new ArrayList<>();
  private final Deque<ActiveKick> ended = new ArrayDeque<>();
  private final TrackMatcher matcher = new TrackMatcher(views);
  private final KickFinderCounts counts = new KickFinderCounts();
  private final double[] robotVelocity = new double[2];
  private final double[] hiddenStart = new double[3];
  private double now = Double.NEGATIVE_INFINITY;
  private int found;
  private double lastEnd = Double.NEGATIVE_INFINITY;
  private double lastEndX;
  private double lastEndY;
  private double gapEnd = Double.NEGATIVE_INFINITY;

  /**
   * Starts with nothing seen.
   *
   * @param settings thresholds
   * @param sink receives each kick once its ball has stopped, left, been touched or been lost; numbered from 1 in that order
   */
  public KickFinder(KickFinderSettings settings, Consumer<Kick> sink) {
    this.settings = Objects.requireNonNull(settings, "settings");
    this.sink = Objects.requireNonNull(sink, "sink");
  }

  /**
   * Learns the field's lines and where the cameras hang.
   *
   * @param geometry as published; may come again and may change
   * @param cameraModels the cameras by id
   */
  public void geometry(FieldGeometry geometry, Map<Integer, Camera> cameraModels) {
    area.update(geometry);
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
   * Takes the next frame.
   *
   * @param frame of any camera
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
    for (BallTrack track : tracks.associate(t)) {
      follow(track);
    }
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
    ended.clear();
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
    RobotId robot =
        robots.kicker(
            jump.time(),
            jump.x(),
            jump.y(),
            jump.vx(),
            jump.vy(),
            settings.robotReach(),
            robotVelocity);
    if (robot != null || startedAlone(jump)) {
      considerKick(jump, track, owner, robot);
    } else if (owner == null) {
      considerHidden(jump, track);
    }
  }

  /** Whether this is a kick's ball that comes into view, or another camera told of this kick already; then its track shows the same ball. */
  private boolean isKnown(JumpDetector.Jump jump, BallTrack track, ActiveKick owner) {
    if (jump.born() && owner != null) {
      return true;
    }
    ActiveKick same = sameKick(jump, track);
    if (same != null && owner == null) {
      same.join(track);
    }
    return same != null || justEnded(jump, track);
  }

  /** Nobody is near the ball that moves all of a sudden: it may have been hidden by its kicker at first. */
  private void considerHidden(JumpDetector.Jump jump, BallTrack track) {
    RobotId robot =
        robots.kickerBefore(
            jump.time(), jump.x(), jump.y(), jump.vx(), jump.vy(), HIDDEN_START, hiddenStart);
    if (robot == null) {
      return;
    }
    JumpDetector.Jump start = jump.earlier(hiddenStart[0]);
    robotVelocity[0] = hiddenStart[1];
    robotVelocity[1] = hiddenStart[2];
    if (dribbles.hadBall(robot, start.time(), HELD)
        && !underWay(track, start)
        && !isKnown(start, track, null)) {
      considerKick(start, track, null, robot);
    }
  }

  /** Whether another camera saw this ball elsewhere before it can have been kicked here, so that it only comes into view. */
  private boolean underWay(BallTrack track, JumpDetector.Jump start) {
    for (CameraTracks camera : cameras.values()) {
      for (BallTrack other : camera.tracks()) {
        if (other != track
            && wasElsewhere(other, start)
            && (other.lastTime() < track.time(track.size() - 1)
                ? matcher.continues(other, track)
                : other.camera() != track.camera() && matcher.meets(other, track))) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean wasElsewhere(BallTrack other, JumpDetector.Jump start) {
    for (int age = 0; age < other.size(); age++) {
      if (other.time(age) < start.time() - JUST_BEFORE) {
        double away = Math.hypot(other.x(age) - start.x(), other.y(age) - start.y());
        return other.size() >= 3 && away > ELSEWHERE;
      }
    }
    return false;
  }

  private void considerKick(
      JumpDetector.Jump jump, BallTrack track, ActiveKick owner, RobotId robot) {
    if (area.outside(jump.x(), jump.y()) > MARGIN) {
      return;
    }
    if (owner != null && isPartOf(owner, jump, track, robot)) {
      return;
    }
    if (robot != null && carried(robot, jump, track)) {
      counts.carried++;
      return;
    }
    if (owner != null) {
      end(owner, KickEnd.TOUCHED_ROBOT, jump.time() - 0.005);
    }
    if (isDeflection(jump, robot)) {
      counts.deflections++;
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

  /** Without a robot in reach only a ball that lay still can have been kicked, by one that no camera sees. */
  private boolean startedAlone(JumpDetector.Jump jump) {
    return jump.fromRest()
        && robots.nearest(jump.time(), jump.x(), jump.y(), settings.robotReach()) == null
        && jump.speed() > 1.5 * settings.minSpeed()
        && area.outside(jump.x(), jump.y()) <= 0;
  }

  /** A ball that stays at the robot is dribbled or pushed, however fast both are. */
  private boolean carried(RobotId robot, JumpDetector.Jump jump, BallTrack track) {
    double t = track.lastTime();
    double before = robots.distanceTo(robot, jump.time(), jump.x(), jump.y());
    return robots.distanceTo(robot, t, track.x(0), track.y(0)) - before < LEAST_SEPARATION;
  }

  /**
   * A ball that bounces off a robot has lost energy, a kicked one has won some: as the robot sees it, which may itself have run into the ball.
   */
  private boolean isDeflection(JumpDetector.Jump jump, RobotId robot) {
    if (robot == null) {
      return !jump.fromRest() && jump.speed() < speedBefore(jump) + LEAST_GAIN;
    }
    if (jump.born()) {
      return jump.speed() < speedBefore(jump) + LEAST_GAIN;
    }
    double rx = robotVelocity[0];
    double ry = robotVelocity[1];
    double before = Math.hypot(jump.vxBefore() - rx, jump.vyBefore() - ry);
    return Math.hypot(jump.vx() - rx, jump.vy() - ry) < before + LEAST_GAIN;
  }

  /**
   * Speed before the jump. A track that begins with a moving ball does not know it: but a kick whose ball was about to come by here
   * does; then this is that ball, seen again after the robot that stopped it had hidden it.
   */
  private double speedBefore(JumpDetector.Jump jump) {
    if (!jump.born()) {
      return jump.speedBefore();
    }
    double fastest = 0;
    for (ActiveKick kick : active) {
      fastest = Math.max(fastest, kick.speedNear(jump.time(), jump.x(), jump.y()));
    }
    boolean justEnded =
        jump.time() - lastEnd < HIDDEN
            && Math.hypot(jump.x() - lastEndX, jump.y() - lastEndY) < SAME_BALL;
    return justEnded ? Double.POSITIVE_INFINITY : fastest;
  }

  /** The kick of which another camera told already. */
  private ActiveKick sameKick(JumpDetector.Jump jump, BallTrack track) {
    for (ActiveKick kick : active) {
      if (kick.source() != track && same(kick.jump(), jump)) {
        return kick;
      }
    }
    return null;
  }

  private static boolean same(JumpDetector.Jump known, JumpDetector.Jump jump) {
    return Math.abs(known.time() - jump.time()) < SAME_TIME
        && Math.hypot(known.x() - jump.x(), known.y() - jump.y()) < SAME_PLACE;
  }

  /** Whether another camera told of this kick, and its ball was stopped already. */
  private boolean justEnded(JumpDetector.Jump jump, BallTrack track) {
    for (ActiveKick kick : ended) {
      if (kick.source() != track && same(kick.jump(), jump)) {
        return true;
      }
    }
    return false;
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
    ended.addFirst(kick);
    if (ended.size() > REMEMBERED) {
      ended.removeLast();
    }
    lastEnd = kick.lastTime();
    lastEndX = kick.newest().x(0);
    lastEndY = kick.newest().y(0);
    if (reason == KickEnd.TOUCHED_ROBOT) {
      RobotId catcher = robots.nearest(lastEnd, lastEndX, lastEndY, settings.robotReach());
      if (catcher != null) {
        dribbles.caught(catcher, lastEnd);
      }
    }
    Kick finished = kick.finish(reason, time);
    if (finished == null) {
      counts.tooShort++;
    } else {
      sink.accept(finished.withId(++found));
    }
  }
}
