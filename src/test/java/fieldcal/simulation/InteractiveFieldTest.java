package fieldcal.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotCommand.Velocity;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class InteractiveFieldTest {
  private static final RobotId FIRST = new RobotId(Team.YELLOW, 0);
  private static final RobotId SECOND = new RobotId(Team.BLUE, 1);

  private static InteractiveField field(FieldTrouble... troubles) {
    return InteractiveField.of(
        SimulationSettings.DEFAULT.withSeed(4), FIRST, SECOND, List.of(troubles));
  }

  private static List<SimulatedPacket> run(InteractiveField field, double seconds) {
    List<SimulatedPacket> packets = new ArrayList<>();
    double end = field.world().time() + seconds;
    while (field.world().time() < end) {
      field.step(packets::add);
    }
    return packets;
  }

  private static boolean sees(List<SimulatedPacket> packets, RobotId robot) {
    return packets.stream()
        .flatMap(p -> p.packet().frame().stream())
        .flatMap(f -> f.robots().stream())
        .anyMatch(r -> r.id().equals(robot));
  }

  @Test
  void packetsArriveInOrderAndInTime() {
    InteractiveField field = field();
    double[] last = {0};
    for (int i = 0; i < 400; i++) {
      field.step(
          p -> {
            assertThat(p.receivedTime()).isGreaterThanOrEqualTo(last[0]);
            assertThat(field.world().time() - p.receivedTime())
                .isBetween(-1e-9, SimulatedWorld.TICK + 1e-9);
            last[0] = p.receivedTime();
          });
    }
    assertThat(last[0]).isCloseTo(2, within(0.05));
  }

  @Test
  void sameSeedAndCommandsGiveTheSamePackets() {
    List<List<SimulatedPacket>> runs = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      InteractiveField field = field();
      field.command(FIRST, RobotCommand.driveTo(1, 1, 0.5, 2));
      runs.add(run(field, 1.5));
    }
    assertThat(runs.get(0)).isEqualTo(runs.get(1)).isNotEmpty();
  }

  @Test
  void aRobotThatIsTakenOffIsNotSeenAndComesBack() {
    InteractiveField field = field(new FieldTrouble(FieldTrouble.Kind.ROBOT_GONE, 1, 2, 1));
    assertThat(sees(run(field, 0.9), SECOND)).isTrue();
    run(field, 0.2);
    assertThat(sees(run(field, 1.5), SECOND)).isFalse();
    run(field, 0.6);
    assertThat(sees(run(field, 0.5), SECOND)).isTrue();
  }

  /** As in a play whose other robot had crept to where the robot was taken off: it was kept off the field for ever. */
  @Test
  void aRobotIsPutDownBesideAnotherThatStandsInItsPlace() {
    InteractiveField field = field(new FieldTrouble(FieldTrouble.Kind.ROBOT_GONE, 1, 2, 1));
    field.placeRobot(SECOND, 4.4, 2.9, 1);
    run(field, 1.5);
    field.placeRobot(FIRST, 4.38, 2.85, 0);
    run(field, 1.6);
    SimulatedRobot back = robot(field, SECOND);
    double apart = Math.hypot(back.x() - 4.38, back.y() - 2.85);
    assertThat(apart).as("distance of the robots").isBetween(0.28, 0.32);
    assertThat(back.orientation()).isEqualTo(1);
  }

  private static SimulatedRobot robot(InteractiveField field, RobotId id) {
    return field.world().robots().stream().filter(r -> r.id().equals(id)).findFirst().orElseThrow();
  }

  @Test
  void noFrameArrivesWhileVisionIsOut() {
    InteractiveField field = field(new FieldTrouble(FieldTrouble.Kind.NO_VISION, 0.5, 1, 0));
    run(field, 0.5);
    assertThat(run(field, 0.9)).isEmpty();
    run(field, 0.2);
    assertThat(run(field, 0.5)).isNotEmpty();
  }

  @Test
  void kickersThatDoNotFireOnlyPush() {
    for (boolean fires : new boolean[] {true, false}) {
      InteractiveField field =
          fires ? field() : field(new FieldTrouble(FieldTrouble.Kind.MISSED_KICK, 0, 10, 0));
      double x = field.world().ball().x();
      double y = field.world().ball().y();
      field.command(FIRST, RobotCommand.driveTo(x + 0.2, y, 0, 0.4).kicking(new Kick(4, 0)));
      field.world().robots().stream()
          .filter(r -> r.id().equals(FIRST))
          .forEach(r -> r.place(x - 0.2, y, 0));
      double fastest = 0;
      for (int i = 0; i < 400; i++) {
        field.step(p -> {});
        fastest = Math.max(fastest, field.world().ball().groundSpeed());
      }
      assertThat(fastest > 3).isEqualTo(fires);
    }
  }

  /** A field whose first robot has the ball and drives forward with 0.3 m/s. */
  private static InteractiveField held(Set<RobotCharacter> like) {
    InteractiveField field = field().robotsLike(like);
    double x = field.world().ball().x();
    double y = field.world().ball().y();
    field.placeRobot(FIRST, x - 0.15, y, 0);
    field.command(FIRST, new RobotCommand(new Velocity(0.3, 0, 0), Kick.NONE, true));
    run(field, 0.4);
    assertThat(field.world().holder()).isPresent();
    return field;
  }

  /** Whether a robot that drives off with the ball still has it a second later. */
  private static boolean keeps(Set<RobotCharacter> like, double vx) {
    InteractiveField field = held(like);
    field.command(FIRST, new RobotCommand(new Velocity(vx, 0, 0), Kick.NONE, true));
    run(field, 1);
    return field.world().holder().isPresent();
  }

  @Test
  void aSlippingDribblerLosesTheBallThatIsPulledHard() {
    Set<RobotCharacter> slips = Set.of(RobotCharacter.SLIPPING_DRIBBLER);
    assertThat(keeps(Set.of(), -1.2)).isTrue();
    assertThat(keeps(slips, -1.2)).isFalse();
    assertThat(keeps(slips, 1)).isTrue();
  }

  @Test
  void aBallRollsOffAFrontPlateWithoutADribbler() {
    assertThat(letGo(Set.of())).isLessThan(0.38);
    assertThat(letGo(Set.of(RobotCharacter.SLIPPING_DRIBBLER)))
        .isCloseTo(0.3 + RobotCharacter.ROLLS_OFF, within(0.03));
  }

  /** How fast the ball is when a robot that drives with 0.3 m/s has switched its dribbler off, m/s. */
  private static double letGo(Set<RobotCharacter> like) {
    InteractiveField field = held(like);
    field.command(FIRST, new RobotCommand(new Velocity(0.3, 0, 0), Kick.NONE, false));
    for (int i = 0; i < 100 && field.world().holder().isPresent(); i++) {
      field.step(p -> {});
    }
    assertThat(field.world().holder()).isEmpty();
    return field.world().ball().groundSpeed();
  }

  @Test
  void aLateKickerFiresLaterAndAddsTheRobotsSpeed() {
    double[] fired = new double[2];
    double[] fastest = new double[2];
    for (int late = 0; late < 2; late++) {
      InteractiveField field =
          field().robotsLike(late == 1 ? Set.of(RobotCharacter.LATE_KICKER) : Set.of());
      double x = field.world().ball().x();
      double y = field.world().ball().y();
      field.placeRobot(FIRST, x - 0.15, y, 0);
      field.command(FIRST, new RobotCommand(new Velocity(0.3, 0, 0), new Kick(4, 0), false));
      for (int i = 0; i < 200; i++) {
        field.step(p -> {});
        if (fired[late] == 0 && field.world().ball().groundSpeed() > 3) {
          fired[late] = field.world().time();
          fastest[late] = field.world().ball().groundSpeed();
        }
      }
    }
    assertThat(fired[1] - fired[0]).isBetween(0.04, 0.07);
    assertThat(fastest[1] - fastest[0]).isCloseTo(0.3, within(0.05));
  }

  @Test
  void anUnevenKickerGivesSomeKicksAFifthLess() {
    InteractiveField field = field().robotsLike(Set.of(RobotCharacter.UNEVEN_KICKER));
    int full = 0;
    int weak = 0;
    for (int kick = 0; kick < 40; kick++) {
      field.world().placeBall(0, 0);
      field.placeRobot(FIRST, -0.15, 0, 0);
      field.command(FIRST, new RobotCommand(new Velocity(0.3, 0, 0), new Kick(4, 0), false));
      double fastest = 0;
      for (int i = 0; i < 120; i++) {
        field.step(p -> {});
        fastest = Math.max(fastest, field.world().ball().groundSpeed());
      }
      full += Math.abs(fastest - 4) < 0.3 ? 1 : 0;
      weak += Math.abs(fastest - 3.2) < 0.3 ? 1 : 0;
      field.command(FIRST, RobotCommand.HALT);
      run(field, 0.5);
    }
    assertThat(full + weak).isEqualTo(40);
    // Half of them: three standard deviations of 40 draws are 9.5.
    assertThat(weak).isBetween(11, 29);
  }

  @Test
  void aDriftingRobotDrivesBesideItsWay() {
    InteractiveField field = field().robotsLike(Set.of(RobotCharacter.DRIFTING));
    field.placeRobot(FIRST, -2, -2, 0);
    field.command(FIRST, new RobotCommand(new Velocity(1, 0, 0), Kick.NONE, false));
    run(field, 2);
    assertThat(robot(field).y() + 2).isBetween(0.08, 0.16);
  }

  @Test
  void aSluggishRobotStopsLate() {
    double[] way = new double[2];
    for (int sluggish = 0; sluggish < 2; sluggish++) {
      InteractiveField field = field();
      if (sluggish == 1) {
        field.robotsLike(Set.of(RobotCharacter.SLUGGISH));
      }
      field.placeRobot(FIRST, -2, -2, 0);
      field.command(FIRST, new RobotCommand(new Velocity(1, 0, 0), Kick.NONE, false));
      run(field, 2);
      double from = robot(field).x();
      field.command(FIRST, RobotCommand.HALT);
      run(field, 2);
      way[sluggish] = robot(field).x() - from;
    }
    // At 3.5 m/s² after 20 ms; at 1.5 m/s² and with 0.1 s of lag after 70 ms.
    assertThat(way[0]).isCloseTo(0.16, within(0.02));
    assertThat(way[1]).isCloseTo(0.42, within(0.04));
  }

  private static SimulatedRobot robot(InteractiveField field) {
    return field.world().robots().stream()
        .filter(r -> r.id().equals(FIRST))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void charactersHaveNames() {
    assertThat(RobotCharacter.parse("late-kicker,drifting"))
        .containsExactlyInAnyOrder(RobotCharacter.LATE_KICKER, RobotCharacter.DRIFTING);
    assertThat(VisionCharacter.parse("simultaneous")).containsExactly(VisionCharacter.SIMULTANEOUS);
    assertThatThrownBy(() -> RobotCharacter.parse("lazy"))
        .hasMessageContaining("lazy")
        .hasMessageContaining("slipping-dribbler");
    assertThatThrownBy(() -> VisionCharacter.parse("blind")).hasMessageContaining("disagreeing");
  }

  @Test
  void troublesAreDrawnFromTheSeed() {
    assertThat(FieldTrouble.random(7, 5, 60)).isEqualTo(FieldTrouble.random(7, 5, 60)).hasSize(5);
    assertThat(FieldTrouble.random(8, 5, 60)).isNotEqualTo(FieldTrouble.random(7, 5, 60));
    assertThatThrownBy(() -> new FieldTrouble(FieldTrouble.Kind.HALT, Double.NaN, 1, 0))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(
            () -> InteractiveField.of(SimulationSettings.DEFAULT, FIRST, FIRST, List.of()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("twice");
  }
}
