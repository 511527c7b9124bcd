package fieldcal.app.net;

import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Notices when two fields come in at once. From two senders, the second one's frames are ignored, and both are named. Frames of one sender cannot be told apart; there, robots are in two places at once. Not
 * thread-safe.
 */
final class MixedFields {
  /** Ignored frames after which two senders are named: vision that is started anew is ignored for some frames, too. */
  private static final int TOLD = 100;

  /** No more senders than that are named. */
  private static final int MOST = 5;

  /** Two fields come at once, if the other one's last frame is no older, ns. */
  private static final long AT_ONCE = 500_000_000L;

  /** No robot goes farther from one frame to the next, m: that were 35 m/s. */
  private static final double JUMP = 0.5;

  /** Frames that lie farther apart show no jump, s. */
  private static final double NEXT = 0.05;

  /** So many frames of a camera are looked at, and so many jumps among them are no mistake of vision's. */
  private static final int LOOKED_AT = 60;

  private static final int JUMPS = 30;

  private final Map<InetSocketAddress, Integer> ignored = new HashMap<>();
  private final List<String> told = new ArrayList<>();
  private final Map<Integer, Camera> cameras = new HashMap<>();

  /** What one camera has shown. */
  private static final class Camera {
    private Map<RobotId, RobotDetection> robots = Map.of();
    private double captured = Double.NaN;
    private final boolean[] jumped = new boolean[LOOKED_AT];
    private int frames;
    private int jumps;
    private String sender = "";

    void frame(InetSocketAddress from, VisionFrame frame) {
      Map<RobotId, RobotDetection> now = unique(frame);
      boolean jump =
          Math.abs(frame.captureTime() - captured) < NEXT
              && now.values().stream().anyMatch(r -> jumps(robots.get(r.id()), r));
      int slot = frames++ % LOOKED_AT;
      jumps += (jump ? 1 : 0) - (jumped[slot] ? 1 : 0);
      jumped[slot] = jump;
      robots = now;
      captured = frame.captureTime();
      sender = text(from);
    }

    /** Robots of which the frame shows one only: two with the same pattern may stand on one field. */
    private static Map<RobotId, RobotDetection> unique(VisionFrame frame) {
      Map<RobotId, RobotDetection> robots = new HashMap<>();
      Set<RobotId> twice = new HashSet<>();
      for (RobotDetection robot : frame.robots()) {
        if (robots.put(robot.id(), robot) != null) {
          twice.add(robot.id());
        }
      }
      robots.keySet().removeAll(twice);
      return robots;
    }

    private static boolean jumps(RobotDetection before, RobotDetection now) {
      return before != null && Math.hypot(now.x() - before.x(), now.y() - before.y()) > JUMP;
    }
  }

  private static String text(InetSocketAddress address) {
    return address.getAddress().getHostAddress() + ":" + address.getPort();
  }

  /** A frame that is listened to. */
  void frame(InetSocketAddress from, VisionFrame frame) {
    cameras.computeIfAbsent(frame.cameraId(), id -> new Camera()).frame(from, frame);
  }

  /** A frame that is ignored because another sender has the same camera; with the age of that one's last frame, ns. */
  void ignored(InetSocketAddress from, int camera, InetSocketAddress owner, long age) {
    if (age > AT_ONCE || told.size() == MOST) {
      return;
    }
    if (ignored.merge(from, 1, Integer::sum) == TOLD) {
      told.add(
          String.format(
              "two senders of vision at once: camera %d comes from %s, and from %s, which is"
                  + " ignored; switch one off, or give one another address",
              camera, text(owner), text(from)));
    }
    if (ignored.size() > 4 * MOST) {
      ignored.clear();
    }
  }

  /** Pairs of senders that send at once; none ever changes or goes away. */
  List<String> told() {
    return List.copyOf(told);
  }

  /** Whether frames of two fields come from one sender now; a clause for the operator. */
  Optional<String> mixed() {
    return cameras.values().stream()
        .filter(camera -> camera.jumps >= JUMPS)
        .findFirst()
        .map(
            camera ->
                "vision mixes two fields: robots are in two places at once in the frames from "
                    + camera.sender);
  }
}
