package fieldcal.app.sslsim;

import com.google.protobuf.InvalidProtocolBufferException;
import fieldcal.proto.RobotCommand;
import fieldcal.proto.RobotControl;
import fieldcal.proto.RobotControlResponse;
import fieldcal.proto.SimulatorError;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * Talks to the bridge of a team whose robots are real: the simulation protocol's robot commands over UDP. A bridge that does not answer keeps all robots standing: whether they hear is not known.
 *
 * <p>Commands say the number of a robot, not its team. When both robots are of one team they go to the bridge's port; otherwise those of the blue one go there, those of the yellow one to the next.
 */
final class BridgeClient implements RobotLink {
  /** A bridge that has not answered for so long is silent, s: 30 commands. */
  static final double SILENT = 0.3;

  private static final int LARGEST = 65_536;
  private static final int MOST_COMPLAINTS = 20;

  private final Map<Team, DatagramChannel> channels = new EnumMap<>(Team.class);
  private final Map<Team, Long> answered = new EnumMap<>(Team.class);
  private final Map<String, Integer> complaints = new LinkedHashMap<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(LARGEST);
  private final LongSupplier nanoTime;
  private final String name;
  private int silences;
  private boolean silent = true;
  private boolean everAnswered;

  /** A bridge for two robots; with a clock in ns. */
  BridgeClient(String host, int port, RobotId first, RobotId second, LongSupplier nanoTime)
      throws IOException {
    this.nanoTime = nanoTime;
    boolean both = first.team() != second.team();
    if (port < 1 || port > (both ? 65_534 : 65_535)) {
      throw new IllegalArgumentException(
          "the bridge's port must lie in [1, 65535], but is " + port);
    }
    name = host + ":" + port;
    InetAddress address;
    try {
      address = InetAddress.getByName(host);
    } catch (UnknownHostException e) {
      throw new IOException("'" + host + "' is not a known host", e);
    }
    for (Team team : both ? Team.values() : new Team[] {first.team()}) {
      DatagramChannel channel = DatagramChannel.open();
      channel.configureBlocking(false);
      channel.connect(new InetSocketAddress(address, port + (both && team != Team.BLUE ? 1 : 0)));
      channels.put(team, channel);
    }
  }

  @Override
  public void robots(Team team, List<RobotCommand> commands) throws IOException {
    RobotControl message = RobotControl.newBuilder().addAllRobotCommands(commands).build();
    try {
      channels.get(team).write(ByteBuffer.wrap(message.toByteArray()));
    } catch (PortUnreachableException e) {
      // Nobody listens there yet: then nobody answers either.
      return;
    }
  }

  /** Somebody at the field does: the play says where. */
  @Override
  public void layBall(double x, double y) {
    // There is no hand on this side.
  }

  @Override
  public void listen() throws IOException {
    for (Map.Entry<Team, DatagramChannel> entry : channels.entrySet()) {
      byte[] answer = receive(entry.getValue());
      while (answer != null) {
        answered.put(entry.getKey(), nanoTime.getAsLong());
        note(answer);
        answer = receive(entry.getValue());
      }
    }
    boolean now = !heard();
    silences += now && !silent ? 1 : 0;
    silent = now;
    everAnswered |= !now;
  }

  private boolean heard() {
    long now = nanoTime.getAsLong();
    return channels.keySet().stream()
        .allMatch(t -> answered.containsKey(t) && now - answered.get(t) < SILENT * 1e9);
  }

  private byte[] receive(DatagramChannel channel) throws IOException {
    buffer.clear();
    try {
      return channel.read(buffer) > 0 ? Arrays.copyOf(buffer.array(), buffer.position()) : null;
    } catch (PortUnreachableException e) {
      return null;
    }
  }

  private void note(byte[] answer) {
    List<SimulatorError> errors;
    try {
      errors = RobotControlResponse.parseFrom(answer).getErrorsList();
    } catch (InvalidProtocolBufferException e) {
      errors = List.of(SimulatorError.newBuilder().setMessage("an answer cannot be read").build());
    }
    for (SimulatorError error : errors) {
      String text = Complaint.shortened(error.getMessage());
      if (complaints.containsKey(text) || complaints.size() < MOST_COMPLAINTS) {
        complaints.merge(text, 1, Integer::sum);
      }
    }
  }

  @Override
  public Optional<String> hold() {
    // Also between two calls of listen.
    return silent || !heard()
        ? Optional.of("the bridge at " + name + " does not answer")
        : Optional.empty();
  }

  @Override
  public List<String> notes() {
    List<String> notes = new ArrayList<>();
    if (!everAnswered) {
      notes.add("the bridge at " + name + " never answered");
    } else if (silences > 0) {
      notes.add("the bridge fell silent " + (silences == 1 ? "once" : silences + " times"));
    }
    complaints.forEach(
        (text, n) -> notes.add("bridge: " + text + (n > 1 ? ", " + n + " times" : "")));
    return notes;
  }

  @Override
  public List<String> complaints() {
    return complaints.keySet().stream().map(text -> "bridge: " + text).toList();
  }

  @Override
  public void close() throws IOException {
    for (DatagramChannel channel : channels.values()) {
      channel.close();
    }
  }
}
