package fieldcal.simulation.truth;

import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallEvent;
import fieldcal.simulation.physics.BallHistory;
import fieldcal.simulation.physics.BallTrace;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.KickTruth.KickCommand;
import fieldcal.simulation.truth.KickTruth.Vector3;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/** Writes down the kicks while the world runs. Not thread-safe. */
public final class KickLog implements BallTrace {
  /** Two touches of one robot within this time are one push, s. */
  private static final double PUSH = 0.15;

  private final BallHistory history;
  private final List<KickTruth> finished = new ArrayList<>();
  private final double[] sample = new double[3];

  private final List<BallHold> holds = new ArrayList<>();

  private int commanded;
  private KickTruth open;
  private RobotId holder;
  private double holdStart;
  private List<BallEvent> events = new ArrayList<>();
  private List<Vector3> path = new ArrayList<>();

  /**
   * An empty log.
   *
   * @param history is asked for positions between steps
   */
  public KickLog(BallHistory history) {
    this.history = history;
  }

  /**
   * A kick begins; one that is still open ends as redirected.
   *
   * @param kind what set the ball in motion
   * @param purpose what the robot wanted
   * @param time session time, s
   * @param ball right after the kick
   * @param robot who
   * @param command its command
   */
  public void begin(
      KickKind kind,
      String purpose,
      double time,
      BallBody ball,
      SimulatedRobot robot,
      KickCommand command) {
    if (open != null) {
      end(time, EndReason.REDIRECTED, Optional.of(robot.id()));
    }
    commanded += kind == KickKind.DEFLECTION ? 0 : 1;
    events = new ArrayList<>();
    path = new ArrayList<>();
    Vector3 position = new Vector3(ball.x(), ball.y(), ball.z());
    open =
        new KickTruth(
            finished.size(),
            kind,
            purpose,
            time,
            0,
            EndReason.RECORDING_ENDED,
            position,
            new Vector3(ball.vx(), ball.vy(), ball.vz()),
            new Vector3(ball.spinX(), ball.spinY(), ball.spinZ()),
            robot.id(),
            new Vector3(robot.x(), robot.y(), robot.orientation()),
            command,
            List.of(),
            KickTruth.PATH_STEP,
            List.of(),
            Optional.empty());
    path.add(position);
  }

  /**
   * The ball bounces off a robot: what was under way ends, a deflection begins. A robot that pushes the ball along touches it many times in a row; only the last of these counts.
   *
   * @param time session time, s
   * @param ball right after the contact
   * @param robot who
   */
  public void deflect(double time, BallBody ball, SimulatedRobot robot) {
    boolean pushed =
        open != null
            && open.kind() == KickKind.DEFLECTION
            && open.robot().equals(robot.id())
            && time - open.time() < PUSH;
    if (pushed) {
      open = null;
    } else {
      end(time, EndReason.TOUCHED_ROBOT, Optional.of(robot.id()));
    }
    KickCommand command = new KickCommand(ball.groundSpeed(), Math.atan2(ball.vy(), ball.vx()), 0);
    begin(KickKind.DEFLECTION, "deflection", time, ball, robot, command);
  }

  /**
   * The open kick is over; without one, nothing happens.
   *
   * @param time session time, s
   * @param reason why
   * @param robot the robot that ended it, if one did
   */
  public void end(double time, EndReason reason, Optional<RobotId> robot) {
    if (open == null) {
      return;
    }
    KickTruth o = open;
    open = null;
    finished.add(
        new KickTruth(
            o.index(),
            o.kind(),
            o.purpose(),
            o.time(),
            time - o.time(),
            reason,
            o.position(),
            o.velocity(),
            o.spin(),
            o.robot(),
            o.robotPose(),
            o.command(),
            events,
            o.pathStep(),
            path,
            robot));
  }

  /**
   * A robot has the ball at its dribbler.
   *
   * @param time session time, s
   * @param robot who
   */
  public void beginHold(double time, RobotId robot) {
    endHold(time);
    holder = robot;
    holdStart = time;
  }

  /**
   * Nobody has the ball at the dribbler any more.
   *
   * @param time session time, s
   */
  public void endHold(double time) {
    if (holder != null) {
      holds.add(new BallHold(holder, holdStart, time));
      holder = null;
    }
  }

  /**
   * When robots had the ball at their dribblers.
   *
   * @return by time
   */
  public List<BallHold> holds() {
    return Collections.unmodifiableList(holds);
  }

  /**
   * Whether a kick is under way.
   *
   * @return true between begin and end
   */
  public boolean running() {
    return open != null;
  }

  /**
   * How many kicks robots were commanded to make.
   *
   * @return without deflections, with the one that is under way
   */
  public int commanded() {
    return commanded;
  }

  /**
   * The kicks that are over.
   *
   * @return by time
   */
  public List<KickTruth> finished() {
    return Collections.unmodifiableList(finished);
  }

  @Override
  public void node(double time, BallBody ball) {
    if (open == null) {
      return;
    }
    double next = open.time() + path.size() * KickTruth.PATH_STEP;
    while (next <= time) {
      history.positionAt(next, sample);
      path.add(new Vector3(sample[0], sample[1], sample[2]));
      next = open.time() + path.size() * KickTruth.PATH_STEP;
    }
  }

  @Override
  public void event(BallEvent event) {
    if (open == null) {
      return;
    }
    events.add(event);
    if (event.kind() == BallEvent.Kind.STOP) {
      end(event.time(), EndReason.STOPPED, Optional.empty());
    }
  }
}
