package fieldcal.app.sslsim;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.vision.Team;
import fieldcal.vision.VisionEncoder;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.function.BooleanSupplier;

/** Serves a simulated field: vision by multicast, robot control for both teams and simulator control by the league's protocol, in real time. For one thread. */
public final class SimulatorServer implements Closeable {
  private static final int LARGEST = 65_536;

  /** A field that falls behind by more, because the machine was busy, does not catch up, s. */
  private static final double MOST_BEHIND = 0.25;

  private final InteractiveField field;
  private final SimulatorProtocol protocol;
  private final VisionSender vision;
  private final VisionEncoder encoder;
  private final Impairment impairment;
  private final Random luck;
  private final List<Door> doors;
  private final ByteBuffer buffer = ByteBuffer.allocate(LARGEST);
  private final PriorityQueue<Delayed> delayed =
      new PriorityQueue<>(Comparator.comparingLong(Delayed::due).thenComparingLong(Delayed::order));
  private long order;
  private long lostReplies;

  /** A port, and whose messages come there. */
  private record Door(DatagramChannel channel, Team team) {}

  /** Something that happens later, because the network is slow. */
  private record Delayed(long due, long order, Action action) {}

  /** What happens then. */
  private interface Action {
    void run() throws IOException;
  }

  /**
   * Opens the ports.
   *
   * @param field to be served
   * @param ports where to listen
   * @param target where vision goes to, a multicast group or one address
   * @param impairment of the network
   * @param seed of what is lost
   * @throws IOException when a port cannot be opened; one line for the operator
   */
  public SimulatorServer(
      InteractiveField field,
      SimulatorPorts ports,
      InetSocketAddress target,
      Impairment impairment,
      long seed)
      throws IOException {
    this.field = field;
    this.impairment = impairment;
    luck = new Random(seed);
    protocol = new SimulatorProtocol(field);
    encoder = new VisionEncoder(field.epoch());
    vision = new VisionSender(target);
    doors =
        List.of(
            new Door(open(ports.control()), null),
            new Door(open(ports.blue()), Team.BLUE),
            new Door(open(ports.yellow()), Team.YELLOW));
  }

  private DatagramChannel open(int port) throws IOException {
    DatagramChannel channel = DatagramChannel.open();
    try {
      channel.configureBlocking(false);
      channel.bind(new InetSocketAddress(port));
      return channel;
    } catch (IOException e) {
      channel.close();
      vision.close();
      throw new IOException(
          "port " + port + " cannot be opened (" + e.getMessage() + "); is a simulator running?",
          e);
    }
  }

  /**
   * Serves until told to stop.
   *
   * @param stop asked some hundred times a second
   * @throws IOException when the network fails
   */
  public void serve(BooleanSupplier stop) throws IOException {
    long last = System.nanoTime();
    double owed = 0;
    while (!stop.getAsBoolean()) {
      long now = System.nanoTime();
      owed = Math.min(MOST_BEHIND, owed + protocol.speed() * (now - last) * 1e-9);
      last = now;
      listen();
      while (owed >= SimulatedWorld.TICK) {
        protocol.beforeStep();
        field.step(this::show);
        owed -= SimulatedWorld.TICK;
        deliver();
      }
      deliver();
      rest();
    }
  }

  private void rest() throws IOException {
    try {
      Thread.sleep(1);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private void listen() throws IOException {
    for (Door door : doors) {
      buffer.clear();
      SocketAddress from = door.channel().receive(buffer);
      while (from != null) {
        byte[] message = Arrays.copyOf(buffer.array(), buffer.position());
        SocketAddress sender = from;
        later(() -> answer(door, sender, message));
        buffer.clear();
        from = door.channel().receive(buffer);
      }
    }
  }

  private void answer(Door door, SocketAddress sender, byte[] message) throws IOException {
    byte[] reply;
    try {
      reply =
          door.team() == null ? protocol.control(message) : protocol.robots(door.team(), message);
    } catch (InvalidProtocolBufferException e) {
      reply = SimulatorProtocol.unreadable(door.team() == null);
    }
    byte[] bytes = reply;
    later(() -> reply(door.channel(), bytes, sender));
  }

  /** Who asked may be gone, or the network; that is no reason to end. */
  void reply(DatagramChannel channel, byte[] bytes, SocketAddress sender) {
    try {
      channel.send(ByteBuffer.wrap(bytes), sender);
    } catch (IOException e) {
      lostReplies++;
    }
  }

  /**
   * Packets of vision and replies that could not be sent.
   *
   * @return 0 as long as the network works
   */
  public long lost() {
    return vision.lost() + lostReplies;
  }

  private void show(SimulatedPacket packet) {
    byte[] bytes = encoder.encode(packet.packet());
    later(() -> vision.send(bytes));
  }

  private void later(Action action) {
    if (luck.nextDouble() >= impairment.loss()) {
      long due = System.nanoTime() + Math.round(impairment.delay() * 1e9);
      delayed.add(new Delayed(due, order++, action));
    }
  }

  private void deliver() throws IOException {
    while (!delayed.isEmpty() && delayed.peek().due() <= System.nanoTime()) {
      delayed.poll().action().run();
    }
  }

  @Override
  public void close() throws IOException {
    vision.close();
    for (Door door : doors) {
      door.channel().close();
    }
  }
}
