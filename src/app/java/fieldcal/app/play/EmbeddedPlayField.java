package fieldcal.app.play;

import fieldcal.gamelog.RecordingOrigin;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotCommand.Velocity;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionEncoder;
import java.io.InterruptedIOException;
import java.util.List;

/** The simulated field in this process, with somebody beside it who lays the ball down when asked. */
public final class EmbeddedPlayField implements PlayField {
  /** A person needs that long to see what is wanted, walk, and place the ball, s. */
  private static final double REACTION = 2;

  private static final double CARRYING = 1;
  private static final int STEPS_PER_TICK = 2;

  private final InteractiveField field;
  private final VisionEncoder encoder;
  private final double pace;
  private final long startNanos = System.nanoTime();
  private double asked = Double.NaN;
  private double lastRequest = Double.NaN;

  /**
   * A field at a pace.
   *
   * @param field the simulation
   * @param pace field time over real time; infinite = as fast as it can
   */
  public EmbeddedPlayField(InteractiveField field, double pace) {
    this.field = field;
    this.pace = pace;
    encoder = new VisionEncoder(field.epoch());
  }

  /**
   * The simulation behind it.
   *
   * @return the field
   */
  public InteractiveField field() {
    return field;
  }

  @Override
  public Epoch epoch() {
    return field.epoch();
  }

  @Override
  public double next(Receiver receiver) throws InterruptedIOException {
    for (int i = 0; i < STEPS_PER_TICK; i++) {
      field.step(packet -> pass(packet, receiver));
    }
    double now = field.world().time();
    if (Double.isFinite(pace)) {
      keepPace(now);
    }
    return now;
  }

  private void pass(SimulatedPacket packet, Receiver receiver) {
    receiver.vision(packet.receivedTime(), packet.packet(), encoder.encode(packet.packet()));
  }

  private void keepPace(double now) throws InterruptedIOException {
    double ahead = now / pace - (System.nanoTime() - startNanos) * 1e-9;
    if (ahead > 0) {
      try {
        Thread.sleep((long) (1000 * ahead));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new InterruptedIOException("interrupted");
      }
    }
  }

  @Override
  public void order(List<RobotOrder> orders) {
    for (RobotOrder order : orders) {
      RobotCommand command =
          new RobotCommand(
              new Velocity(
                  order.velocity().vx(), order.velocity().vy(), order.velocity().angular()),
              new Kick(order.kick().speed(), order.kick().elevation()),
              order.dribbler());
      field.command(order.robot(), command);
    }
  }

  @Override
  public void layBall(BallRequest request) {
    SimulatedWorld world = field.world();
    double now = world.time();
    boolean fresh = !(now - lastRequest < 0.2);
    lastRequest = now;
    if (fresh) {
      asked = now;
    } else if (now - asked > REACTION && !world.ballCarried()) {
      field.handBall(request.x(), request.y(), CARRYING);
      asked = now + CARRYING;
    }
  }

  @Override
  public Permission permission() {
    return field.halted() ? Permission.HALT : Permission.RUN;
  }

  @Override
  public RecordingOrigin origin() {
    return RecordingOrigin.SIMULATION;
  }

  @Override
  public boolean goesOnByItself() {
    return false;
  }

  @Override
  public void close() {
    // Nothing to be closed.
  }
}
