package fieldcal.app.sslsim;

import fieldcal.app.net.Happenings;
import fieldcal.proto.RobotCommand;
import fieldcal.proto.RobotControl;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
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

  private final Map<Team, CommandChannel> channels = new EnumMap<>(Team.class);
  private final Map<Team, Long> answered = new EnumMap<>(Team.class);
  private final Complaints complaints = new Complaints("bridge");
  private final LongSupplier nanoTime;
  private final String name;
  private final Happenings silences;
  private final long begin;
  private boolean silent = true;
  private boolean everAnswered;
  private boolean asked;

  /** A bridge for two robots; with a clock in ns. */
  BridgeClient(String host, int port, RobotId first, RobotId second, LongSupplier nanoTime)
      throws IOException {
    this.nanoTime = nanoTime;
    begin = nanoTime.getAsLong();
    boolean both = first.team() != second.team();
    if (port < 1 || port > (both ? 65_534 : 65_535)) {
      throw new IllegalArgumentException(
          "the bridge's port must lie in [1, 65535], but is " + port);
    }
    name = host + ":" + port;
    silences =
        new Happenings(
            "the bridge at " + name + " keeps falling silent; from now on this is only counted");
    InetAddress address = CommandChannel.resolved(host);
    for (Team team : both ? Team.values() : new Team[] {first.team()}) {
      int offset = both && team != Team.BLUE ? 1 : 0;
      channels.put(team, new CommandChannel(address, port + offset));
    }
  }

  @Override
  public void robots(Team team, List<RobotCommand> commands) throws IOException {
    RobotControl message = RobotControl.newBuilder().addAllRobotCommands(commands).build();
    asked = true;
    // Where nobody listens yet nobody answers either.
    channels.get(team).send(message.toByteArray());
  }

  /** Somebody at the field does: the play says where. */
  @Override
  public void layBall(double x, double y) {
    // There is no hand on this side.
  }

  @Override
  public void listen() throws IOException {
    for (Map.Entry<Team, CommandChannel> entry : channels.entrySet()) {
      entry
          .getValue()
          .answers(
              answer -> {
                answered.put(entry.getKey(), nanoTime.getAsLong());
                complaints.add(SimulatorClient.errors(answer, false));
              });
    }
    boolean now = !heard();
    if (now && !silent) {
      silences.add(
          String.format(
              Locale.ROOT,
              "the bridge at %s fell silent, %.0f s after the play began; both robots are told to"
                  + " stand",
              name,
              (nanoTime.getAsLong() - begin) * 1e-9));
    }
    silent = now;
    everAnswered |= !now;
  }

  private boolean heard() {
    long now = nanoTime.getAsLong();
    return channels.keySet().stream()
        .allMatch(t -> answered.containsKey(t) && now - answered.get(t) < SILENT * 1e9);
  }

  @Override
  public Optional<String> hold() {
    // Also between two calls of listen.
    return silent || !heard()
        ? Optional.of("the bridge at " + name + " does not answer")
        : Optional.empty();
  }

  /** Who keeps the robots standing is the reason already. */
  @Override
  public Optional<String> silent() {
    return Optional.empty();
  }

  @Override
  public List<String> notes() {
    List<String> notes = new ArrayList<>();
    int times = silences.count();
    if (asked && !everAnswered) {
      notes.add("the bridge at " + name + " never answered");
    } else if (times > 0) {
      notes.add("the bridge fell silent " + (times == 1 ? "once" : times + " times"));
    }
    notes.addAll(complaints.counted());
    return notes;
  }

  @Override
  public List<String> complaints() {
    List<String> all = new ArrayList<>(silences.told());
    all.addAll(complaints.all());
    return all;
  }

  @Override
  public void close() throws IOException {
    for (CommandChannel channel : channels.values()) {
      channel.close();
    }
  }
}
