package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import fieldcal.play.PlayWorld;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.VisionCharacter;
import fieldcal.simulation.robot.RobotCommand;
import fieldcal.vision.BallDetection;
import fieldcal.vision.Epoch;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionFrame;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What the play is told of robots and ball, where cameras overlap above all. */
class WorldModelTest {
  private static final RobotId FIRST = new RobotId(Team.YELLOW, 0);
  private static final RobotId SECOND = new RobotId(Team.YELLOW, 1);
  private static final Path TEST_DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  private static VisionFrame frame(int camera, double time, double x, double y) {
    RobotDetection robot = new RobotDetection(FIRST, x, y, 0.3f, 1, 0.145);
    return new VisionFrame(camera, 0, time, time, Double.NaN, List.of(), List.of(robot));
  }

  private static VisionFrame ball(int camera, double time, double x, double y) {
    BallDetection ball = new BallDetection(x, y, Double.NaN, 1, 0, Double.NaN, Double.NaN);
    return new VisionFrame(camera, 0, time, time, Double.NaN, List.of(ball), List.of());
  }

  private static Robot first(WorldModel model, double now) {
    return model.at(now, Permission.RUN).robot(FIRST).orElseThrow();
  }

  @Test
  void recordedRobotsStandUnderCamerasThatDisagree() throws Exception {
    List<VisionFrame> frames = new ArrayList<>();
    VisionDecoder decoder = new VisionDecoder(Epoch.atSecondOf(1_795_343_409_000_000_000L));
    try (GameLogReader log = GameLogReader.open(TEST_DATA.resolve("erforce-standing.log.gz"))) {
      while (log.next()) {
        assertThat(log.type()).isEqualTo(MessageType.SSL_VISION_2014);
        decoder
            .decode(log.buffer(), log.payloadOffset(), log.payloadLength())
            .frame()
            .ifPresent(frames::add);
      }
    }
    assertThat(frames).hasSizeGreaterThan(1000);
    WorldModel model = new WorldModel();
    double begin = frames.get(0).captureTime();
    for (VisionFrame frame : frames) {
      model.accept(frame);
      PlayWorld world = model.at(frame.captureTime(), Permission.RUN);
      if (frame.captureTime() - begin > 2) {
        // What "it stands" means to the play: 0.08 m/s; the joined filter read 0.4 m/s.
        assertThat(world.robots()).allSatisfy(r -> assertThat(r.speed()).isLessThan(0.06));
        assertThat(world.robot(FIRST).orElseThrow().x()).isCloseTo(-0.02, within(0.006));
        assertThat(world.robot(SECOND).orElseThrow().x()).isCloseTo(-0.02, within(0.006));
      }
    }
  }

  /** Nobody brakes before the edge who is thought to stand where it was seen last. */
  @Test
  void aRobotThatIsNotSeenDrivesOnUntilThePlayStopsIt() {
    WorldModel model = new WorldModel();
    double t = 0;
    for (int i = 0; i < 200; i++) {
      t = 0.015 * i;
      model.accept(frame(0, t, t, 1));
      model.at(t, Permission.RUN);
    }
    assertThat(first(model, t + 0.2).x()).isCloseTo(t + 0.2, within(0.005));
    assertThat(first(model, t + 0.2).vx()).isCloseTo(1, within(0.02));
    assertThat(first(model, t + 0.3).vx()).isZero();
  }

  @Test
  void camerasThatAgreeOnTheTimeButNotOnThePlaceDoNotMakeARobotMove() {
    WorldModel model = new WorldModel();
    for (int i = 0; i < 300; i++) {
      double t = 0.015 * i;
      model.accept(frame(0, t, 1, -2));
      model.accept(frame(1, t, 1.04, -2));
      assertThat(i < 3 || first(model, t).speed() < 1e-9).isTrue();
    }
    assertThat(first(model, 4.5).x()).isCloseTo(1.02, within(1e-6));
    // Out of the sight of one: it does not jump.
    for (int i = 300; i < 320; i++) {
      model.accept(frame(0, 0.015 * i, 1, -2));
      assertThat(first(model, 0.015 * i).x()).isCloseTo(1.02, within(0.001));
    }
  }

  @Test
  void aRobotThatDrivesIntoTheViewOfAnotherCameraKeepsItsVelocity() {
    WorldModel model = new WorldModel();
    for (int i = 0; i < 150; i++) {
      double t = 0.014 * i;
      if (t < 1.2) {
        model.accept(frame(0, t, t, 0));
      }
      if (t > 1) {
        model.accept(frame(1, t + 0.005, t + 0.005 + 0.02, 0));
      }
      if (t > 0.8) {
        Robot robot = first(model, t + 0.005);
        assertThat(robot.vx()).isCloseTo(1, within(0.02));
        assertThat(robot.x()).isCloseTo(t + 0.005 + 0.01, within(0.015));
      }
    }
  }

  @Test
  void onePatternTakenForAnotherDoesNotMoveARobot() {
    WorldModel model = new WorldModel();
    for (int i = 0; i < 100; i++) {
      double t = 0.014 * i;
      model.accept(frame(0, t, 1, 1));
      if (i > 50 && i < 60) {
        model.accept(frame(1, t + 0.003, -3, 1));
      }
      if (i > 10) {
        assertThat(first(model, t + 0.003).x()).isCloseTo(1, within(1e-6));
      }
    }
  }

  @Test
  void simulatedCamerasThatStampTheSameTimesAndDisagree() {
    SimulationSettings settings =
        VisionCharacter.apply(
            Set.of(VisionCharacter.SIMULTANEOUS, VisionCharacter.DISAGREEING),
            SimulationSettings.DEFAULT.withSeed(2));
    InteractiveField field = InteractiveField.of(settings, FIRST, SECOND, List.of());
    field.placeRobot(FIRST, 0, 0, 0);
    field.command(FIRST, RobotCommand.HALT);
    WorldModel model = new WorldModel();
    List<VisionFrame> seen = new ArrayList<>();
    double fastest = 0;
    for (int i = 0; i < 800; i++) {
      field.step(
          p ->
              p.packet()
                  .frame()
                  .ifPresent(
                      f -> {
                        model.accept(f);
                        seen.add(f);
                      }));
      double now = field.world().time();
      if (now > 2) {
        fastest = Math.max(fastest, first(model, now).speed());
      }
    }
    assertThat(seen.stream().map(VisionFrame::captureTime).distinct().count())
        .isLessThan(seen.size() / 3);
    assertThat(fastest).isLessThan(0.07);
  }

  /** Without them, one pattern in fifty makes a robot that stands turn by 27° and puts eight that are not there in the way. */
  @Test
  void patternsThatAreMisreadMakeNoRobotsAndTurnNone() {
    SimulationSettings settings =
        VisionCharacter.apply(
            Set.of(VisionCharacter.MISREADING), SimulationSettings.DEFAULT.withSeed(3));
    InteractiveField field = InteractiveField.of(settings, FIRST, SECOND, List.of());
    WorldModel model = new WorldModel();
    Set<RobotId> detected = new HashSet<>();
    for (int i = 0; i < 4000; i++) {
      field.step(
          p ->
              p.packet()
                  .frame()
                  .ifPresent(
                      f -> {
                        model.accept(f);
                        f.robots().forEach(r -> detected.add(r.id()));
                      }));
      double now = field.world().time();
      if (now > 0.5) {
        PlayWorld world = model.at(now, Permission.RUN);
        assertThat(world.robots()).hasSize(4);
        assertThat(first(model, now).orientation()).isCloseTo(0, within(0.05));
      }
    }
    assertThat(detected).hasSizeGreaterThan(12);
  }

  /** Two computers of vision, of which one stalls or has a clock that is behind. */
  @Test
  void aBallThatOneCameraShowsLateIsWhereTheOtherSeesIt() {
    WorldModel model = new WorldModel();
    for (int i = 0; i < 4; i++) {
      model.accept(ball(0, 0.014 * i, 1, 1));
      model.accept(ball(1, 0.014 * i, 1, 1));
    }
    for (int i = 4; i < 30; i++) {
      model.accept(ball(0, 0.014 * i, 1, 1));
    }
    model.accept(ball(1, 0.1, 1.1, 1));
    PlayWorld.Ball ball = model.at(0.42, Permission.RUN).ball().orElseThrow();
    assertThat(ball.x()).isCloseTo(1, within(1e-6));
    assertThat(ball.seen()).isCloseTo(0.014 * 29, within(1e-9));
  }

  @Test
  void aRobotThatWasPutElsewhereIsThereWhenItWasSeenFourTimes() {
    WorldModel model = new WorldModel();
    for (int i = 0; i < 100; i++) {
      double t = 0.014 * i;
      boolean moved = i >= 50;
      model.accept(frame(0, t, moved ? -2 : 1, 1));
      if (i > 10) {
        // Four that do not fit, four that are sure.
        assertThat(first(model, t).x()).isCloseTo(i < 57 ? 1 : -2, within(1e-6));
      }
    }
  }
}
