package fieldcal.app.sslsim;

import fieldcal.app.net.MatchNetwork;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.net.VisionWatch;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.WorldModel;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.gamelog.RefereeState;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.proto.Referee;
import fieldcal.proto.RobotCommand;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** A simulator on the network, or real robots behind a bridge: vision comes by multicast, commands go by the league's simulation protocol. */
public final class NetworkPlayField implements PlayField {
  /** Between two commands, s. */
  private static final double TICK = 0.01;

  /** A referee that was heard and is silent for longer cannot give a HALT any more, s: 20 messages. */
  private static final double REFEREE_SILENT = 2;

  /** A ball that was laid down is left alone for a while, s. */
  private static final double BETWEEN_TELEPORTS = 1;

  /** A clock that goes back by more was set again, s. */
  private static final double CLOCK_JUMP = 1;

  private final Epoch epoch;
  private final MatchNetwork network;
  private final RobotLink client;
  private final RecordingOrigin origin;
  private final WorldModel model = new WorldModel();
  private final VisionWatch watch = new VisionWatch();
  private List<String> lastNotes;
  private final long startNanos = System.nanoTime();
  private final double startTime;
  private PlayField.Receiver receiver;
  private double newestFrame = Double.NaN;
  private long newestArrived;
  private double now = Double.NEGATIVE_INFINITY;
  private double firstJump = Double.NaN;
  private double nextTick;
  private Permission permission = Permission.RUN;
  private double refereeHeard = Double.NaN;
  private double teleported = Double.NEGATIVE_INFINITY;
  private Optional<String> over = Optional.empty();
  private double lastJumps;
  private byte[] message;
  private Optional<VisionFrame> frameInMessage = Optional.empty();
  private Optional<FieldGeometry> geometryInMessage = Optional.empty();

  private final class Sink implements MatchNetwork.Sink {
    @Override
    public void visionMessage(byte[] bytes, long arrivedNanos) {
      message = bytes;
      frameInMessage = Optional.empty();
      geometryInMessage = Optional.empty();
    }

    @Override
    public void frame(VisionFrame frame) {
      double jumpsBefore = watch.jumps();
      boolean whole = watch.frame(frame.captureTime(), network.arrival());
      double sent = Double.isNaN(frame.sentTime()) ? frame.captureTime() : frame.sentTime();
      if (over.isEmpty() && sent < newestFrame - CLOCK_JUMP) {
        lastJumps = jumpsBefore;
        over =
            Optional.of(
                String.format(
                    Locale.ROOT,
                    "vision's clock went back by %.0f s: vision or the simulator was restarted;"
                        + " play again for the kicks that are missing",
                    newestFrame - sent));
      }
      if (over.isPresent()) {
        return;
      }
      if (!(sent <= newestFrame)) {
        newestFrame = sent;
        newestArrived = System.nanoTime();
      }
      model.accept(frame);
      if (!whole) {
        receiver.lost(wallClock());
      }
      frameInMessage = Optional.of(frame);
    }

    @Override
    public void geometry(FieldGeometry geometry) {
      geometryInMessage = Optional.of(geometry);
    }

    @Override
    public void refereeMessage(byte[] bytes) {
      receiver.referee(wallClock(), bytes);
    }

    @Override
    public void referee(RefereeState state) {
      refereeHeard = wallClock();
      permission =
          state.command() == Referee.Command.HALT
              ? Permission.HALT
              : state.command() == Referee.Command.STOP ? Permission.STOP : Permission.RUN;
    }
  }

  /**
   * Begins to listen and to talk.
   *
   * @param host of the simulator
   * @param ports where it listens
   * @param vision where its vision sends to
   * @param referee where a referee sends to, if there is one
   * @throws IOException when the host is unknown or a port cannot be opened; one line for the operator
   */
  public NetworkPlayField(
      String host, SimulatorPorts ports, NetworkPlace vision, Optional<NetworkPlace> referee)
      throws IOException {
    this(new SimulatorClient(host, ports), RecordingOrigin.SIMULATION, vision, referee);
  }

  private NetworkPlayField(
      RobotLink link, RecordingOrigin origin, NetworkPlace vision, Optional<NetworkPlace> referee)
      throws IOException {
    this.origin = origin;
    long unixNanos = System.currentTimeMillis() * 1_000_000L;
    epoch = Epoch.atSecondOf(unixNanos);
    startTime = epoch.secondsOfNanos(unixNanos);
    client = link;
    try {
      network = new MatchNetwork(vision, referee, epoch, new Sink());
    } catch (IOException e) {
      client.close();
      throw e;
    }
  }

  /**
   * The robots of a real team: its bridge takes the simulation protocol's robot commands, vision comes as at a tournament. Robots stand while the bridge does not answer.
   *
   * @param bridge host and port; the next port, too, when the robots are of both teams: then blue's commands go to the first
   * @param first one robot
   * @param second the other
   * @param vision where vision sends to
   * @param referee where a referee sends to, if there is one
   * @return the field
   * @throws IOException when the host is unknown or a port cannot be opened; one line for the operator
   * @throws IllegalArgumentException when the bridge is not HOST:PORT
   */
  public static NetworkPlayField ofRobots(
      String bridge,
      RobotId first,
      RobotId second,
      NetworkPlace vision,
      Optional<NetworkPlace> referee)
      throws IOException {
    int colon = bridge.lastIndexOf(':');
    int port;
    try {
      port = Integer.parseInt(bridge.substring(colon + 1));
    } catch (NumberFormatException e) {
      port = 0;
    }
    if (colon < 1 || port == 0) {
      throw new IllegalArgumentException(
          "the bridge must be HOST:PORT, for example 127.0.0.1:10400, but is '" + bridge + "'");
    }
    String host = bridge.substring(0, colon);
    RobotLink link = new BridgeClient(host, port, first, second, System::nanoTime);
    return new NetworkPlayField(link, RecordingOrigin.FIELD, vision, referee);
  }

  @Override
  public RecordingOrigin origin() {
    return origin;
  }

  /** By positions of two fields nobody drives, nor where the referee that could give a HALT is gone. {@inheritDoc} */
  @Override
  public Optional<String> hold() {
    return client.hold().or(network::mixed).or(this::refereeSilent);
  }

  private Optional<String> refereeSilent() {
    // Who never heard a referee plays without one.
    if (!(wallClock() - refereeHeard > REFEREE_SILENT)) {
      return Optional.empty();
    }
    String since = permission == Permission.RUN ? "" : " since its " + permission.name();
    return Optional.of("no message from the referee" + since);
  }

  @Override
  public Optional<String> silent() {
    return client.silent();
  }

  /** Before the first frame, this machine's clock stands in for vision's. {@inheritDoc} */
  @Override
  public double clockJumps() {
    double first = Double.isNaN(firstJump) ? 0 : firstJump;
    // A jump that ends the play changes no time that it is told.
    return first + (over.isPresent() ? lastJumps : watch.jumps());
  }

  @Override
  public Optional<String> over() {
    return over;
  }

  private double wallClock() {
    return startTime + (System.nanoTime() - startNanos) * 1e-9;
  }

  /** What vision sent last, as it sent it. */
  private void passMessage() {
    if (message != null && over.isEmpty()) {
      VisionPacket packet = new VisionPacket(frameInMessage, geometryInMessage);
      receiver.vision(wallClock(), packet, message);
    }
    message = null;
  }

  @Override
  public Epoch epoch() {
    return epoch;
  }

  @Override
  public double next(Receiver to) throws IOException {
    receiver = to;
    nextTick = Math.max(nextTick + TICK, wallClock());
    try {
      do {
        double left = Math.max(0, nextTick - wallClock());
        network.receive((long) Math.ceil(1000 * left));
        passMessage();
      } while (wallClock() < nextTick);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted");
    }
    client.listen();
    now = estimate();
    return now;
  }

  /** Now, on vision's clock as soon as it is known: it may be far ahead of this machine's or behind it. */
  private double estimate() {
    if (Double.isNaN(newestFrame)) {
      return wallClock();
    }
    double estimate = newestFrame + (System.nanoTime() - newestArrived) * 1e-9;
    if (Double.isNaN(firstJump)) {
      firstJump = estimate - wallClock();
      return estimate;
    }
    return Math.max(now, estimate);
  }

  @Override
  public void order(List<RobotOrder> orders) throws IOException {
    PlayWorld world = model.at(now, Permission.RUN);
    for (Team team : Team.values()) {
      List<RobotCommand> commands = new ArrayList<>();
      for (RobotOrder order : orders) {
        if (order.robot().team() == team) {
          double orientation =
              world.robot(order.robot()).map(PlayWorld.Robot::orientation).orElse(0.0);
          commands.add(command(order, orientation));
        }
      }
      if (!commands.isEmpty()) {
        client.robots(team, commands);
      }
    }
  }

  private static RobotCommand command(RobotOrder order, double orientation) {
    double cos = Math.cos(orientation);
    double sin = Math.sin(orientation);
    RobotOrder.Velocity v = order.velocity();
    return SimulatorClient.command(
        order.robot().number(),
        v.vx() * cos + v.vy() * sin,
        v.vy() * cos - v.vx() * sin,
        v.angular(),
        order.kick().speed(),
        order.kick().elevation(),
        order.dribbler());
  }

  @Override
  public void layBall(BallRequest request) throws IOException {
    if (now - teleported > BETWEEN_TELEPORTS) {
      teleported = now;
      client.layBall(request.x(), request.y());
    }
  }

  /** What it said last, however long ago: a HALT is over when the referee says so. {@inheritDoc} */
  @Override
  public Permission permission() {
    return permission;
  }

  @Override
  public List<String> notes() {
    if (lastNotes != null) {
      return lastNotes;
    }
    List<String> notes = new ArrayList<>(network.notes());
    notes.addAll(watch.notes());
    if (Double.isNaN(newestFrame)) {
      notes.add("check that vision is running, and that it sends to " + network);
    }
    notes.addAll(client.notes());
    return notes;
  }

  @Override
  public List<String> complaints() {
    List<String> all = new ArrayList<>(client.complaints());
    all.addAll(network.complaints());
    all.addAll(watch.complaints());
    return all;
  }

  @Override
  public void close() throws IOException {
    // What comes after the play, a calibration for example, is no silence of vision's.
    lastNotes = lastNotes == null ? List.copyOf(notes()) : lastNotes;
    network.close();
    client.close();
  }
}
