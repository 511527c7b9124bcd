package fieldcal.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.play.PlayWorld.Ball;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** How an AI of the TIGERs' kind hosts the play: world frames in mm and ns come in, one command per robot goes out. */
class HostAdapterTest {

  /** What such an AI has: a frame of tracked objects, mm and ns. */
  record WorldFrame(
      long timestamp,
      long lastVision,
      double[] ball,
      long ballSeen,
      Map<RobotId, double[]> bots,
      String command) {}

  /** What its robots are sent: velocity in the robot's own frame, m/s; kicker and dribbler. */
  record BotCommand(
      double forward, double left, double angular, double kick, boolean chip, int rpm) {}

  /** The adapter: all that a host has to write. */
  static final class CalibrationRole {
    private final CalibrationPlay play;

    CalibrationRole(CalibrationPlay play) {
      this.play = play;
    }

    /** Called with every world frame; answers what each of the two robots is to be sent. */
    Map<RobotId, BotCommand> update(WorldFrame frame) {
      PlayAnswer answer = play.tick(world(frame));
      Map<RobotId, BotCommand> commands = new TreeMap<>();
      for (RobotOrder order : answer.orders()) {
        double[] bot = frame.bots().get(order.robot());
        commands.put(order.robot(), command(order, bot == null ? 0 : bot[2]));
      }
      return commands;
    }

    static PlayWorld world(WorldFrame frame) {
      double now = 1e-9 * frame.timestamp();
      List<Robot> robots = new ArrayList<>();
      frame
          .bots()
          .forEach(
              (id, b) ->
                  robots.add(
                      new Robot(
                          id, b[0] / 1000, b[1] / 1000, b[2], b[3] / 1000, b[4] / 1000, now)));
      double[] b = frame.ball();
      Optional<Ball> ball =
          Optional.of(
              new Ball(
                  b[0] / 1000, b[1] / 1000, b[2] / 1000, b[3] / 1000, 1e-9 * frame.ballSeen()));
      return new PlayWorld(
          now, 1e-9 * frame.lastVision(), ball, robots, permission(frame.command()));
    }

    static Permission permission(String command) {
      return switch (command) {
        case "HALT" -> Permission.HALT;
        case "STOP" -> Permission.STOP;
        default -> Permission.RUN;
      };
    }

    static BotCommand command(RobotOrder order, double orientation) {
      double cos = Math.cos(orientation);
      double sin = Math.sin(orientation);
      RobotOrder.Velocity v = order.velocity();
      return new BotCommand(
          v.vx() * cos + v.vy() * sin,
          v.vy() * cos - v.vx() * sin,
          v.angular(),
          order.kick().speed(),
          order.kick().chip(),
          order.dribbler() ? 8000 : 0);
    }
  }

  private static WorldFrame frame(FakeField field) {
    Map<RobotId, double[]> bots = new TreeMap<>();
    field.robots.forEach(
        (id, b) ->
            bots.put(
                id,
                new double[] {1000 * b.x, 1000 * b.y, b.orientation, 1000 * b.vx, 1000 * b.vy}));
    long now = Math.round(field.time * 1e9);
    field.ballSeen = field.ballVisible ? field.time : field.ballSeen;
    long ballSeen = Math.round(field.ballSeen * 1e9);
    double[] ball = {
      1000 * field.ballX, 1000 * field.ballY, 1000 * field.ballVx, 1000 * field.ballVy
    };
    return new WorldFrame(now, now, ball, ballSeen, bots, field.permission.name());
  }

  @Test
  void anAiHostsThePlay() {
    FieldGeometry geometry = FakeField.GEOMETRY;
    RobotId first = new RobotId(Team.YELLOW, 3);
    RobotId second = new RobotId(Team.BLUE, 7);
    List<PlayedKick> toFit = new ArrayList<>();

    PlayPlan plan = PlayPlan.flat(first, second, geometry, PlayLine.Half.WHOLE, 12);
    KickChooser chooser = new SpreadKicks(12, 2.0, 6.5, 0, 1); // 2 to 6.5 m/s, flat, seed 1
    CalibrationPlay play = new CalibrationPlay(plan, chooser, toFit::add);
    CalibrationRole role = new CalibrationRole(play);

    FakeField field = new FakeField();
    while (!play.over() && field.time < 400) {
      Map<RobotId, BotCommand> commands = role.update(frame(field)); // with every world frame
      commands.forEach((id, c) -> send(field, id, c));
      field.step();
      while (!toFit.isEmpty()) {
        PlayedKick kick = toFit.remove(0);
        play.judge(kick.number(), true); // as soon as its fit is there: whether it counts
      }
    }

    assertThat(play.state().phase()).isEqualTo(PlayPhase.FINISHED);
    assertThat(play.state().good()).isEqualTo(12);
    assertThat(field.hardestContact).isLessThan(0.1);
  }

  @Test
  void whatTheAiKnowsOfRefereeAndBallReachesThePlay() {
    FakeField field = new FakeField();
    PlayPlan plan =
        PlayPlan.flat(
            FakeField.YELLOW, FakeField.BLUE, FakeField.GEOMETRY, PlayLine.Half.WHOLE, 12);
    CalibrationPlay play = new CalibrationPlay(plan, new SpreadKicks(12, 2.0, 6.5, 0, 1), k -> {});
    CalibrationRole role = new CalibrationRole(play);
    role.update(frame(field));

    field.permission = Permission.STOP;
    field.time += FakeField.TICK;
    assertThat(role.update(frame(field)).values())
        .hasSize(2)
        .allMatch(c -> c.forward() == 0 && c.left() == 0 && c.angular() == 0)
        .allMatch(c -> c.kick() == 0 && c.rpm() == 0);
    assertThat(play.state().waiting()).contains("referee: STOP");

    field.permission = Permission.RUN;
    field.ballVisible = false;
    for (int i = 0; i < 200; i++) {
      role.update(frame(field)).forEach((id, c) -> send(field, id, c));
      field.step();
    }
    assertThat(play.state().waiting()).contains("the ball is not seen");
  }

  /** The radio, and the robot's own turn from its frame into the field's. */
  private static void send(FakeField field, RobotId id, BotCommand c) {
    double orientation = field.robots.get(id).orientation;
    double vx = c.forward() * Math.cos(orientation) - c.left() * Math.sin(orientation);
    double vy = c.forward() * Math.sin(orientation) + c.left() * Math.cos(orientation);
    field.robots.get(id).order =
        new RobotOrder(
            id,
            new RobotOrder.Velocity(vx, vy, c.angular()),
            Optional.empty(),
            new RobotOrder.Kick(c.kick(), c.chip() ? 0.8 : 0),
            c.rpm() > 0);
  }
}
