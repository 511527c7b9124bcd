package fieldcal.app.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.proto.Referee;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SourcesTest {
  private static final Epoch EPOCH = new Epoch(1_763_000_000_000_000_000L);
  private static final long SECOND = 1_000_000_000L;
  private static final InetSocketAddress FIELD_A = new InetSocketAddress("10.0.0.1", 4001);
  private static final InetSocketAddress FIELD_B = new InetSocketAddress("10.0.0.2", 4001);

  private final List<VisionFrame> frames = new ArrayList<>();
  private final List<FieldGeometry> geometries = new ArrayList<>();
  private final VisionSource vision =
      new VisionSource(
          EPOCH,
          new VisionSource.Sink() {
            @Override
            public void frame(VisionFrame frame) {
              frames.add(frame);
            }

            @Override
            public void geometry(FieldGeometry geometry) {
              geometries.add(geometry);
            }
          });

  private static byte[] frame(int camera, double time) {
    VisionFrame frame =
        new VisionFrame(camera, 1, time, time + 0.01, Double.NaN, List.of(), List.of());
    return new VisionEncoder(EPOCH).encode(VisionPacket.of(frame));
  }

  private static byte[] geometry(double length) {
    FieldGeometry field = FieldGeometry.of(length, 6, 1, 0.2, 0.3, List.of());
    return new VisionEncoder(EPOCH).encode(VisionPacket.of(field));
  }

  private void send(InetSocketAddress from, byte[] data, double now) {
    vision.accept(new Packet(data, from, (long) (now * SECOND)));
  }

  @Test
  void anotherFieldOnTheSameGroupIsNotMixedIn() {
    for (int i = 0; i < 50; i++) {
      send(FIELD_A, frame(0, i), 0.02 * i);
      send(FIELD_B, frame(0, 1000 + i), 0.02 * i);
    }
    send(FIELD_A, geometry(12), 1);
    send(FIELD_B, geometry(9), 1);
    assertThat(frames).hasSize(50).allSatisfy(f -> assertThat(f.captureTime()).isLessThan(100));
    assertThat(geometries).singleElement().satisfies(g -> assertThat(g.length()).isEqualTo(12));
    assertThat(vision.counts())
        .satisfiesExactly(
            a -> {
              assertThat(a.cameras()).containsExactly(0);
              assertThat(a.ignored()).isZero();
            },
            b -> {
              assertThat(b.packets()).isEqualTo(51);
              assertThat(b.ignored()).isEqualTo(51);
              assertThat(b.cameras()).isEmpty();
            });
  }

  private static byte[] robot(int camera, double time, double x) {
    RobotDetection robot =
        new RobotDetection(new RobotId(Team.YELLOW, 3), x, 0.5, 0, 1, Double.NaN);
    VisionFrame frame =
        new VisionFrame(camera, 1, time, time + 0.01, Double.NaN, List.of(), List.of(robot));
    return new VisionEncoder(EPOCH).encode(VisionPacket.of(frame));
  }

  @Test
  void twoSendersOfOneCameraAreNamed() {
    for (int i = 0; i < 150; i++) {
      double now = i / 70.0;
      send(FIELD_A, robot(0, now, 1), now);
      send(FIELD_B, robot(0, now, -2), now + 0.001);
    }
    assertThat(vision.mixed().told())
        .containsExactly(
            "two senders of vision at once: camera 0 comes from 10.0.0.1:4001, and from"
                + " 10.0.0.2:4001, which is ignored; switch one off, or give one another address");
    assertThat(vision.mixed().mixed()).isEmpty();
  }

  @Test
  void visionThatIsStartedAnewIsNoSecondOne() {
    for (int i = 0; i < 700; i++) {
      double now = i / 70.0;
      send(i < 70 ? FIELD_A : FIELD_B, robot(0, now, 1), now);
    }
    assertThat(vision.mixed().told()).isEmpty();
  }

  /** A relay sends the frames of both from its own address. */
  @Test
  void twoFieldsFromOneSenderAreNoticedWhileTheyLast() {
    for (int i = 0; i < 100; i++) {
      double now = i / 70.0;
      send(FIELD_A, robot(0, now, 1 + 0.02 * i), now);
    }
    assertThat(vision.mixed().mixed()).isEmpty();
    for (int i = 100; i < 150; i++) {
      double now = i / 70.0;
      send(FIELD_A, robot(0, now, 3), now);
      send(FIELD_A, robot(0, now, -2), now + 0.001);
    }
    assertThat(vision.mixed().mixed())
        .contains(
            "vision mixes two fields: robots are in two places at once in the frames from"
                + " 10.0.0.1:4001");
    for (int i = 150; i < 250; i++) {
      double now = i / 70.0;
      send(FIELD_A, robot(0, now, 3), now);
    }
    assertThat(vision.mixed().mixed()).isEmpty();
  }

  @Test
  void computersThatEachSendTheirCamerasWorkTogether() {
    for (int i = 0; i < 10; i++) {
      send(FIELD_A, frame(0, i), i);
      send(FIELD_B, frame(1, i), i);
    }
    assertThat(frames).hasSize(20);
    assertThat(vision.counts())
        .extracting(SourceCounts::cameras)
        .containsExactly(List.of(0), List.of(1));
  }

  @Test
  void whenTheFirstFallsSilentTheNextTakesItsPlace() {
    send(FIELD_A, frame(0, 1), 1);
    send(FIELD_B, frame(0, 2), 2);
    send(FIELD_B, frame(0, 3.5), 3.5);
    send(FIELD_A, frame(0, 3.6), 3.6);
    assertThat(frames).extracting(VisionFrame::captureTime).containsExactly(1.0, 3.5);
  }

  @Test
  void wrongPacketsAreCounted() {
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      byte[] noise = new byte[random.nextInt(200)];
      random.nextBytes(noise);
      send(FIELD_A, noise, i);
    }
    send(FIELD_A, referee().toByteArray(), 300);
    assertThat(frames).isEmpty();
    assertThat(vision.counts().get(0).wrong()).isGreaterThan(195);
  }

  @Test
  void manySendersDoNotFillTheMemory() {
    for (int i = 0; i < 1000; i++) {
      send(new InetSocketAddress("10.1.0.1", 1 + i), frame(i % 4, i), i);
    }
    assertThat(vision.counts()).hasSize(16);
  }

  @Test
  void visionThatIsStartedAnewOverAndOverIsHeardEachTime() {
    for (int start = 0; start < 40; start++) {
      for (int i = 0; i < 3; i++) {
        send(new InetSocketAddress("10.0.0.1", 40_000 + start), frame(0, i), 3 * start + 0.1 * i);
      }
    }
    assertThat(frames).hasSize(120);
    assertThat(vision.tooMany()).isZero();
    assertThat(vision.counts()).last().satisfies(s -> assertThat(s.silentFor()).isZero());
    assertThat(vision.counts().get(0).silentFor()).isEqualTo(45.2 - 0.2, within(1e-6));
  }

  @Test
  void moreSendersAtOnceThanCanBeAreCounted() {
    for (int i = 0; i < 30; i++) {
      send(new InetSocketAddress("10.0.0.1", 40_000 + i), frame(i, i), 0.01 * i);
    }
    assertThat(frames).hasSize(16);
    assertThat(vision.tooMany()).isEqualTo(14);
  }

  @Test
  void sendersOfJunkMakeRoomForVisionAtOnce() {
    for (int i = 0; i < 40; i++) {
      send(new InetSocketAddress("10.66.0.1", 1 + i), new byte[] {7, 7, 7}, 0.001 * i);
    }
    send(FIELD_A, frame(0, 1), 0.05);
    for (int i = 0; i < 40; i++) {
      send(new InetSocketAddress("10.66.0.2", 1 + i), new byte[] {7, 7, 7}, 0.06 + 0.001 * i);
    }
    send(FIELD_A, frame(0, 1.1), 0.15);
    assertThat(frames).hasSize(2);
    assertThat(vision.counts()).hasSize(16).anySatisfy(s -> assertThat(s.packets()).isEqualTo(2));
    assertThat(vision.tooMany()).isEqualTo(80 - 15);
  }

  @Test
  void sendersOfJunkMakeRoomForTheReferee() {
    RefereeSource source = new RefereeSource(EPOCH);
    for (int i = 0; i < 40; i++) {
      InetSocketAddress junk = new InetSocketAddress("10.66.0.1", 1 + i);
      source.accept(new Packet(new byte[] {7, 7, 7}, junk, i));
    }
    assertThat(source.accept(new Packet(referee().toByteArray(), FIELD_A, 50))).isPresent();
  }

  @Test
  void ofTwoRefereesTheFirstIsListenedTo() {
    RefereeSource source = new RefereeSource(EPOCH);
    byte[] message = referee().toByteArray();
    assertThat(source.accept(new Packet(message, FIELD_A, 0))).isPresent();
    assertThat(source.accept(new Packet(message, FIELD_B, SECOND))).isEmpty();
    assertThat(source.accept(new Packet(new byte[] {7, 7, 7}, FIELD_A, SECOND))).isEmpty();
    assertThat(source.counts()).extracting(SourceCounts::ignored).containsExactly(0L, 1L);
    assertThat(source.counts()).extracting(SourceCounts::wrong).containsExactly(1L, 0L);
    assertThat(source.accept(new Packet(message, FIELD_B, 4 * SECOND))).isPresent();
  }

  private static Referee referee() {
    Referee.TeamInfo team =
        Referee.TeamInfo.newBuilder()
            .setName("A")
            .setScore(0)
            .setRedCards(0)
            .setYellowCards(0)
            .setTimeouts(0)
            .setTimeoutTime(0)
            .setGoalkeeper(0)
            .build();
    return Referee.newBuilder()
        .setPacketTimestamp(1)
        .setStage(Referee.Stage.NORMAL_FIRST_HALF)
        .setCommand(Referee.Command.NORMAL_START)
        .setCommandCounter(1)
        .setCommandTimestamp(1)
        .setYellow(team)
        .setBlue(team)
        .build();
  }
}
