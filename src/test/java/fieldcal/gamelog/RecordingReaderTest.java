package fieldcal.gamelog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.proto.Referee;
import fieldcal.vision.DecodingProblem;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import fieldcal.vision.VisionSamples;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RecordingReaderTest {
  @TempDir Path folder;

  private final VisionSamples samples = new VisionSamples(1);
  private final FieldGeometry geometry =
      samples.geometry().withCameras(List.of(samples.camera(0), samples.camera(1)));
  private final LogBuilder log = new LogBuilder();

  /** Writes down what it is told. */
  private static final class Notes implements RecordingListener {
    final List<VisionFrame> frames = new ArrayList<>();
    final List<FieldGeometry> geometries = new ArrayList<>();
    final List<RefereeState> referee = new ArrayList<>();
    final List<Double> jumps = new ArrayList<>();
    final List<String> sequence = new ArrayList<>();
    long bytesRead;
    long totalBytes;

    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      frames.add(frame);
      sequence.add("frame " + frame.frameNumber());
    }

    @Override
    public void onGeometry(FieldGeometry field) {
      geometries.add(field);
      sequence.add("geometry");
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      referee.add(state);
      sequence.add("referee");
    }

    @Override
    public void onClockJump(int cameraId, double jump) {
      jumps.add(jump);
      sequence.add("jump");
    }

    @Override
    public void onProgress(long read, long total) {
      assertThat(read).isGreaterThanOrEqualTo(bytesRead).isLessThanOrEqualTo(total);
      bytesRead = read;
      totalBytes = total;
    }
  }

  private final Notes notes = new Notes();

  private RecordingSummary read(byte[] bytes) throws IOException {
    try (RecordingReader reader =
        RecordingReader.open(
            LogBuilder.write(folder.resolve("recording.log"), bytes), LogBuilder.EPOCH)) {
      return reader.read(notes);
    }
  }

  private VisionFrame frame(int camera, int number, double time) {
    return samples.frame(camera, number, time);
  }

  @Test
  void framesComeInTheOrderOfTheirCapture() throws IOException {
    log.geometry(geometry, 1);
    List<VisionFrame> sent = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 500; i++) {
      VisionFrame frame = frame(i % 2, i, 1 + 0.007 * i);
      sent.add(frame);
    }
    List<VisionFrame> received = new ArrayList<>(sent);
    for (int i = 0; i + 5 < received.size(); i += 5) {
      int other = i + random.nextInt(5);
      VisionFrame swapped = received.get(i);
      received.set(i, received.get(other));
      received.set(other, swapped);
    }
    received.forEach(frame -> log.frame(frame, frame.captureTime() + 0.03));

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).isEqualTo(sent);
    assertThat(summary.frames()).isEqualTo(500);
    assertThat(summary.messages())
        .containsOnlyKeys(MessageType.SSL_VISION_2014)
        .containsValue(501L);
    assertThat(summary.duration()).isCloseTo(3.53, within(0.06));
    assertThat(summary.problems().count(LogProblem.DUPLICATE_FRAME)).isZero();
    assertThat(notes.bytesRead).isEqualTo(notes.totalBytes).isEqualTo(log.size());
  }

  @Test
  void withoutAToleranceTheOrderIsThatOfReception() throws IOException {
    log.geometry(geometry, 1);
    log.frame(frame(0, 1, 10), 10.02);
    log.frame(frame(1, 2, 9.99), 10.03);
    log.frame(frame(0, 3, 10.01), 10.04);
    try (RecordingReader reader =
        RecordingReader.open(log.write(folder.resolve("recording.log")), LogBuilder.EPOCH)) {
      reader.read(notes, 0);
    }
    assertThat(notes.sequence).containsExactly("geometry", "frame 1", "frame 2", "frame 3");
  }

  @Test
  void geometryComesOnceAndWhenItChanges() throws IOException {
    FieldGeometry other = geometry.withCameras(List.of(samples.camera(0), samples.camera(1)));
    for (int i = 0; i < 30; i++) {
      log.geometry(i < 20 ? geometry : other, 1 + 0.1 * i).frame(frame(0, i, 1 + 0.1 * i));
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.geometries).containsExactly(geometry, other);
    assertThat(notes.sequence.indexOf("geometry")).isZero();
    assertThat(notes.sequence.subList(1, 31).indexOf("geometry")).isEqualTo(20);
    assertThat(summary.geometry()).contains(other);
    assertThat(summary.problems().count(LogProblem.GEOMETRY_CHANGED)).isEqualTo(1);
    assertThat(summary.problems().first(LogProblem.GEOMETRY_CHANGED).get(0).detail())
        .isEqualTo("cameras");
  }

  @Test
  void framesWithoutGeometryAreGivenAndCounted() throws IOException {
    log.frame(frame(0, 1, 1))
        .frame(frame(1, 1, 1.01))
        .geometry(geometry, 1.02)
        .frame(frame(3, 1, 1.03));

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(3);
    assertThat(summary.problems().count(LogProblem.FRAME_BEFORE_GEOMETRY)).isEqualTo(2);
    assertThat(summary.problems().count(LogProblem.UNCALIBRATED_CAMERA)).isEqualTo(1);
    assertThat(summary.problems().first(LogProblem.UNCALIBRATED_CAMERA).get(0).detail())
        .isEqualTo("camera 3");
  }

  /** Some visions send one camera's calibration at a time. */
  @Test
  void framesBeforeTheirCamerasAreNotOfUnknownCameras() throws IOException {
    FieldGeometry first = geometry.withCameras(geometry.cameras().subList(0, 1));
    log.geometry(first, 1);
    for (int i = 0; i < 5; i++) {
      log.frame(frame(0, i, 1.1 + 0.01 * i))
          .frame(frame(1, i, 1.1 + 0.01 * i))
          .frame(frame(6, i, 1.1 + 0.01 * i));
    }
    log.geometry(geometry, 2).frame(frame(1, 5, 2.1)).frame(frame(7, 0, 2.1));

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(17);
    assertThat(summary.problems().count(LogProblem.FRAME_BEFORE_CAMERA)).isEqualTo(5);
    assertThat(summary.problems().first(LogProblem.FRAME_BEFORE_CAMERA).get(0).detail())
        .isEqualTo("camera 1");
    assertThat(summary.problems().count(LogProblem.UNCALIBRATED_CAMERA)).isEqualTo(6);
    assertThat(summary.problems().first(LogProblem.UNCALIBRATED_CAMERA).get(0).detail())
        .isEqualTo("cameras 6, 7");
  }

  @Test
  void duplicatesAreLeftOut() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 50; i++) {
      VisionFrame frame = frame(i % 2, i, 1 + 0.01 * i);
      log.frame(frame);
      if (i % 5 == 0) {
        log.frame(frame);
      }
    }

    assertThat(read(log.bytes()).problems().count(LogProblem.DUPLICATE_FRAME)).isEqualTo(10);
    assertThat(notes.frames).hasSize(50);
  }

  @Test
  void aJumpOfTheCameraClockLosesNoFrame() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 90; i++) {
      double time = 1 + 0.013 * i;
      double jump = i < 30 ? 0 : i < 60 ? -100 : 2500;
      log.frame(frame(0, i, time + jump), time + 0.01);
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(90).extracting(VisionFrame::frameNumber).isSorted();
    assertThat(notes.jumps).hasSize(2);
    assertThat(notes.jumps.get(0)).isCloseTo(-100, within(0.02));
    assertThat(notes.jumps.get(1)).isCloseTo(2600, within(0.02));
    assertThat(notes.sequence.indexOf("jump")).isEqualTo(31);
    assertThat(summary.problems().count(LogProblem.CLOCK_JUMP_BACK)).isEqualTo(1);
    assertThat(summary.problems().count(LogProblem.CLOCK_JUMP_FORWARD)).isEqualTo(1);
  }

  /** It reads what waited at once, and misses what did not fit. */
  @Test
  void aRecorderThatPausesIsNoJump() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 400; i++) {
      double time = 1 + 0.013 * i;
      boolean paused = time > 2 && time < 4;
      if (!paused || time < 3.1) {
        log.frame(frame(0, i, time), paused ? 4 : time + 0.01);
      }
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.jumps).isEmpty();
    assertThat(summary.problems().kinds()).isEmpty();
    assertThat(notes.frames).hasSize((int) summary.frames());
  }

  @Test
  void aJumpOfTheRecorderLosesNoFrame() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 90; i++) {
      double time = 1 + 0.013 * i;
      log.frame(frame(0, i, time), i < 40 ? time : time - 30);
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(90).extracting(VisionFrame::captureTime).isSorted();
    assertThat(summary.problems().first(LogProblem.CLOCK_JUMP_BACK).get(0).detail())
        .startsWith("the recorder's clock");
  }

  @Test
  void aGapInTheRecordingIsNoJump() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 60; i++) {
      log.frame(frame(0, i, i < 30 ? 1 + 0.01 * i : 500 + 0.01 * i));
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(60);
    assertThat(notes.jumps).isEmpty();
    assertThat(summary.problems().kinds()).isEmpty();
  }

  @Test
  void aSingleFrameWithADamagedTimeIsLeftOut() throws IOException {
    log.geometry(geometry, 1);
    for (int i = 0; i < 60; i++) {
      double time = 1 + 0.013 * i;
      log.frame(frame(0, i, i == 20 || i == 59 ? time + 70_000 : time), time + 0.01);
    }

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(58).extracting(VisionFrame::captureTime).isSorted();
    assertThat(notes.jumps).isEmpty();
    assertThat(summary.problems().count(LogProblem.STRAY_TIME)).isEqualTo(2);
  }

  @Test
  void refereeMessagesComeInPlace() throws IOException {
    log.geometry(geometry, 1).frame(frame(0, 1, 1.0));
    log.record(1.005, 3, referee(Referee.Command.STOP, Referee.Stage.NORMAL_FIRST_HALF));
    log.frame(frame(0, 2, 1.1));
    log.record(1.2, 3, referee(Referee.Command.FORCE_START, Referee.Stage.NORMAL_FIRST_HALF));
    log.record(1.3, 3, new byte[] {1, 2, 3});
    log.record(1.4, 5, new byte[] {1}).record(1.5, 42, new byte[] {1});

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.sequence)
        .containsExactly("geometry", "frame 1", "referee", "frame 2", "referee");
    assertThat(notes.referee).extracting(RefereeState::isPlaying).containsExactly(false, true);
    RefereeState first = notes.referee.get(0);
    assertThat(first.time()).isCloseTo(5, within(1e-9));
    assertThat(first.yellow()).isEqualTo(new RefereeState.TeamState("Y", 2, 0));
    assertThat(first.blueOnPositiveHalf()).contains(true);
    assertThat(summary.problems().count(LogProblem.MALFORMED_REFEREE)).isEqualTo(1);
    assertThat(summary.problems().count(LogProblem.UNKNOWN_MESSAGE_TYPE)).isEqualTo(1);
    assertThat(summary.messages())
        .containsEntry(MessageType.SSL_REFBOX_2013, 3L)
        .containsEntry(MessageType.SSL_VISION_TRACKER_2020, 1L)
        .containsEntry(MessageType.UNKNOWN, 1L);
  }

  /** Packets overtake each other on the network, and some controllers send the old state once more beside the new one. */
  @Test
  void anOlderRefereeMessageIsNoChange() throws IOException {
    log.record(1.00, 3, referee(Referee.Command.HALT, Referee.Stage.NORMAL_FIRST_HALF, 1.00, 0.5));
    log.record(2.01, 3, referee(Referee.Command.STOP, Referee.Stage.NORMAL_FIRST_HALF, 2.00, 2.0));
    log.record(2.02, 3, referee(Referee.Command.HALT, Referee.Stage.NORMAL_FIRST_HALF, 1.95, 0.5));
    log.record(2.02, 3, referee(Referee.Command.HALT, Referee.Stage.NORMAL_FIRST_HALF, 2.00, 0.5));
    log.record(3.00, 3, referee(Referee.Command.STOP, Referee.Stage.NORMAL_FIRST_HALF, 3.00, 2.0));
    // Its clock was set back by an hour.
    log.record(4, 3, referee(Referee.Command.HALT, Referee.Stage.NORMAL_FIRST_HALF, -3596, -3596));
    read(log.bytes());

    assertThat(notes.referee)
        .extracting(RefereeState::command)
        .containsExactly(
            Referee.Command.HALT, Referee.Command.STOP, Referee.Command.STOP, Referee.Command.HALT);
  }

  @Test
  void breaksAreNoPlay() throws IOException {
    log.record(1, 3, referee(Referee.Command.NORMAL_START, Referee.Stage.NORMAL_HALF_TIME));
    log.record(1, 3, referee(Referee.Command.TIMEOUT_BLUE, Referee.Stage.NORMAL_FIRST_HALF));
    read(log.bytes());

    assertThat(notes.referee).allMatch(RefereeState::isBreak).noneMatch(RefereeState::isPlaying);
  }

  @Test
  void aPacketThatIsNoMessageIsCountedWithItsPlace() throws IOException {
    log.geometry(geometry, 1);
    int at = log.size();
    log.record(1.1, 4, "no protobuf at all".getBytes()).frame(frame(0, 1, 1.2));

    RecordingSummary summary = read(log.bytes());

    assertThat(notes.frames).hasSize(1);
    assertThat(summary.problems().first(DecodingProblem.MALFORMED_PACKET).get(0).offset())
        .isEqualTo(at);
  }

  @Test
  void readsOnce() throws IOException {
    Path file = log.geometry(geometry, 0.5).write(folder.resolve("a.log"));
    try (RecordingReader reader = RecordingReader.open(file)) {
      assertThat(reader.epoch()).isEqualTo(LogBuilder.EPOCH);
      reader.read(notes);
      assertThatThrownBy(() -> reader.read(notes)).isInstanceOf(IllegalStateException.class);
    }
  }

  @Test
  void aLogWithoutMessagesHasNoTimes() throws IOException {
    RecordingSummary summary = read(log.bytes());

    assertThat(summary.frames()).isZero();
    assertThat(summary.duration()).isNaN();
    assertThat(summary.geometry()).isEmpty();
  }

  @Test
  void mutatedRecordingsNeverThrow() throws IOException {
    long seed = 7;
    SplittableRandom random = new SplittableRandom(seed);
    VisionEncoder encoder = new VisionEncoder(LogBuilder.EPOCH);
    log.geometry(geometry, 1);
    for (int i = 0; i < 60; i++) {
      log.record(1 + 0.01 * i, 4, encoder.encode(VisionPacket.of(frame(i % 2, i, 1 + 0.01 * i))));
      if (i % 10 == 0) {
        log.record(1 + 0.01 * i, 3, referee(Referee.Command.STOP, Referee.Stage.NORMAL_FIRST_HALF));
      }
    }
    byte[] good = log.bytes();
    for (int round = 0; round < 2000; round++) {
      byte[] bytes = good.clone();
      for (int hits = 1 + random.nextInt(20); hits > 0; hits--) {
        bytes[16 + random.nextInt(bytes.length - 16)] = (byte) random.nextInt();
      }
      bytes = Arrays.copyOf(bytes, bytes.length - (random.nextBoolean() ? random.nextInt(500) : 0));
      try (RecordingReader reader =
          RecordingReader.open(LogBuilder.write(folder.resolve("mutant.log"), bytes))) {
        RecordingSummary summary = reader.read(new RecordingListener() {});
        assertThat(summary.frames()).as("seed %d, round %d", seed, round).isBetween(20L, 60L);
      }
    }
  }

  private static byte[] referee(Referee.Command command, Referee.Stage stage) {
    return referee(command, stage, 5, 4);
  }

  /** Sent at a time of the recording's epoch, about a command of a time. */
  private static byte[] referee(
      Referee.Command command, Referee.Stage stage, double time, double commandTime) {
    Referee.TeamInfo.Builder team =
        Referee.TeamInfo.newBuilder()
            .setName("Y")
            .setScore(2)
            .setRedCards(0)
            .setYellowCards(0)
            .setTimeouts(4)
            .setTimeoutTime(0)
            .setGoalkeeper(0);
    return Referee.newBuilder()
        .setPacketTimestamp(micros(time))
        .setStage(stage)
        .setCommand(command)
        .setCommandCounter(1)
        .setCommandTimestamp(micros(commandTime))
        .setYellow(team)
        .setBlue(team)
        .setBlueTeamOnPositiveHalf(true)
        .build()
        .toByteArray();
  }

  private static long micros(double time) {
    return 1_763_712_345_000_000L + Math.round(1e6 * time);
  }

  @Test
  void aDamagedTimeOfTheLastMessageDoesNotMakeARecordingOfMinutesOneOfYears() throws IOException {
    LogBuilder log = new LogBuilder();
    for (int i = 0; i < 10; i++) {
      log.record(1 + i, MessageType.SSL_REFBOX_2013.code(), new byte[0]);
    }
    log.record(3e8, MessageType.SSL_REFBOX_2013.code(), new byte[0]);
    assertThat(read(log.bytes()).duration()).isCloseTo(9, within(1e-6));
  }
}
