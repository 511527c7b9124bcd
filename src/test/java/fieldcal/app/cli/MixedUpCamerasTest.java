package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.DataProblem;
import fieldcal.app.recording.KickCollector;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.verdict.VisionFault;
import fieldcal.vision.BallDetection;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Cameras whose numbers are swapped, and cameras that are calibrated the wrong way round, are named. */
class MixedUpCamerasTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");

  @TempDir private static Path folder;

  private static Path sound;

  @BeforeAll
  static void simulate() {
    sound = folder.resolve("sound.log");
    int exit =
        Main.commandLine()
            .setOut(new PrintWriter(Writer.nullWriter()))
            .execute("simulate", "--scenario=mixed", "--kicks=8", "--out=" + sound);
    assertThat(exit).isZero();
  }

  @Test
  void aSoundRecordingHasNone() throws IOException {
    assertThat(mixedUp(sound)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"erforce-flat", "grsim-flat", "world-null-chip", "ode-chip"})
  void recordingsOfOtherSimulatorsHaveNone(String name) throws IOException {
    assertThat(mixedUp(DATA.resolve(name + ".log.gz"))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"0,1", "1,3"})
  void swappedNumbersAreNamed(int one, int other) throws IOException {
    Path log =
        changed(
            f ->
                new VisionFrame(
                    f.cameraId() == one ? other : f.cameraId() == other ? one : f.cameraId(),
                    f.frameNumber(),
                    f.captureTime(),
                    f.sentTime(),
                    f.cameraClockTime(),
                    f.balls(),
                    f.robots()));
    assertThat(mixedUp(log))
        .singleElement()
        .asString()
        .contains(log + ", cameras " + one + " and " + other + ": ")
        .contains("numbers are swapped");
  }

  /** About the centre of the field, as with corners of the wrong half, and about a place of its own. */
  @ParameterizedTest
  @CsvSource({"0,0,0", "2,0,0", "3,6,4.5"})
  void aCameraThatIsTheWrongWayRoundIsNamed(int camera, double sumX, double sumY)
      throws IOException {
    Path log = changed(f -> f.cameraId() == camera ? rotated(f, sumX, sumY) : f);
    assertThat(mixedUp(log))
        .singleElement()
        .asString()
        .contains(log + ", camera " + camera + ": it is rotated by 180°");
  }

  @Test
  void ofTwoCamerasBothAreNamed() throws IOException {
    Path two = folder.resolve("two.log");
    EditedLog.copy(
        sound,
        two,
        p -> p.frame().filter(f -> f.cameraId() > 1).isPresent() ? VisionPacket.EMPTY : p);
    Path log = changed(two, f -> f.cameraId() == 1 ? rotated(f, 0, 0) : f);
    assertThat(mixedUp(log))
        .singleElement()
        .asString()
        .contains("cameras 0 and 1: one of them is rotated by 180°");
  }

  @Test
  void theVerdictIsToldOfThem() throws IOException {
    Path log = changed(f -> f.cameraId() == 2 ? rotated(f, 0, 0) : f);
    assertThat(faults(log)).containsExactly(new VisionFault.MixedUp(List.of(2), false));
    assertThat(faults(sound)).isEmpty();
  }

  /** grSim's frames came a thirtieth slower than their time stamps say; but no camera of it has a pose, so its time is a simulator's. */
  @Test
  void theClockOfASimulatorWithoutPosesIsNotJudged() throws IOException {
    assertThat(faults(DATA.resolve("grsim-flat.log.gz")))
        .singleElement()
        .isInstanceOfSatisfying(
            VisionFault.ClockRate.class, clock -> assertThat(clock.simulator()).isTrue());
  }

  /** Cameras with poses, as real ones have. */
  @Test
  void theVerdictIsToldOfAClockThatRunsAtAnotherRate() throws IOException {
    assertThat(faults(changed(f -> slowed(f, 1.035))))
        .singleElement()
        .isInstanceOfSatisfying(
            VisionFault.ClockRate.class,
            clock -> {
              assertThat(clock.cameras()).containsExactly(0, 1, 2, 3);
              assertThat(clock.rate()).isBetween(1.03, 1.04);
            });
  }

  @Test
  void coordinatesOnAGridAreNamed() throws IOException {
    Path log = changed(f -> f.cameraId() == 1 ? onGrid(f, 0.01) : f);
    assertThat(onGrid(sound)).isEmpty();
    assertThat(onGrid(log))
        .singleElement()
        .asString()
        .contains(", camera 1: the coordinates of its balls are multiples of 10.0 mm");
  }

  /** Its seconds last longer on the recorder's clock. */
  private static VisionFrame slowed(VisionFrame f, double rate) {
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime() / rate,
        f.sentTime() / rate,
        f.cameraClockTime(),
        f.balls(),
        f.robots());
  }

  private static List<String> onGrid(Path log) throws IOException {
    CollectedKicks data = new KickCollector((file, read, total) -> {}).collect(List.of(log));
    return all(data).filter(p -> p.contains("multiples")).toList();
  }

  private static VisionFrame onGrid(VisionFrame f, double step) {
    List<BallDetection> balls =
        f.balls().stream()
            .map(
                b ->
                    new BallDetection(
                        Math.rint(b.x() / step) * step,
                        Math.rint(b.y() / step) * step,
                        b.z(),
                        b.confidence(),
                        b.area(),
                        b.pixelX(),
                        b.pixelY()))
            .toList();
    return EditedLog.withBalls(VisionPacket.of(f), balls).frame().orElseThrow();
  }

  private static List<VisionFault> faults(Path log) throws IOException {
    CollectedKicks data = new KickCollector((file, read, total) -> {}).collect(List.of(log));
    return RecordingFacts.surroundings(data.recordings()).faults();
  }

  private static Path changed(Function<VisionFrame, VisionFrame> change) throws IOException {
    return changed(sound, change);
  }

  private static Path changed(Path from, Function<VisionFrame, VisionFrame> change)
      throws IOException {
    return EditedLog.copy(
        from,
        folder.resolve("changed.log"),
        p -> p.frame().map(f -> VisionPacket.of(change.apply(f))).orElse(p));
  }

  private static VisionFrame rotated(VisionFrame f, double sumX, double sumY) {
    List<BallDetection> balls =
        f.balls().stream()
            .map(
                b ->
                    new BallDetection(
                        sumX - b.x(),
                        sumY - b.y(),
                        b.z(),
                        b.confidence(),
                        b.area(),
                        b.pixelX(),
                        b.pixelY()))
            .toList();
    List<RobotDetection> robots =
        f.robots().stream()
            .map(
                r ->
                    new RobotDetection(
                        r.id(),
                        sumX - r.x(),
                        sumY - r.y(),
                        r.orientation() + Math.PI,
                        r.confidence(),
                        r.height()))
            .toList();
    return new VisionFrame(
        f.cameraId(),
        f.frameNumber(),
        f.captureTime(),
        f.sentTime(),
        f.cameraClockTime(),
        balls,
        robots);
  }

  private static Stream<String> all(CollectedKicks data) {
    return data.problems().stream().map(DataProblem::toString);
  }

  private static List<String> mixedUp(Path log) throws IOException {
    CollectedKicks data = new KickCollector((file, read, total) -> {}).collect(List.of(log));
    return all(data).filter(p -> p.contains("swapped") || p.contains("rotated")).toList();
  }
}
