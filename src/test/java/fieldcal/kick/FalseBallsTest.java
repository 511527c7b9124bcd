package fieldcal.kick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.camera.Camera;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.live.SimulatedMatch;
import fieldcal.vision.BallDetection;
import fieldcal.vision.ChangedFrame;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** White spots everywhere: every kick is still found, none is invented, and what is remembered is bounded. */
class FalseBallsTest {
  private static final Path LOG =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."), "test-data", "world-null-flat.log.gz");

  /** Two looks at one kick agree to a frame or two, s. */
  private static final double SAME = 0.03;

  /** A third of the recording is enough, s from its begin. */
  private static final double END = 45;

  private static List<Kick> kicks(int falseBalls) throws IOException {
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    Random random = new Random(11);
    try (RecordingReader reader = RecordingReader.open(LOG)) {
      reader.read(
          new RecordingListener() {
            @Override
            public void onGeometry(FieldGeometry geometry) {
              know(finder, geometry);
            }

            @Override
            public void onFrame(VisionFrame frame, double receivedTime) {
              if (frame.captureTime() < END) {
                finder.accept(with(falseBalls, frame, random));
              }
            }
          });
    }
    finder.finish();
    return kicks;
  }

  /** The false balls lie anywhere in the quarter of the field that the camera sees. */
  private static VisionFrame with(int falseBalls, VisionFrame frame, Random random) {
    double toX = frame.cameraId() % 2 == 0 ? -6 : 6;
    double toY = frame.cameraId() < 2 ? -4.5 : 4.5;
    List<BallDetection> balls = new ArrayList<>(frame.balls());
    for (int i = 0; i < falseBalls; i++) {
      balls.add(spot(toX * random.nextDouble(), toY * random.nextDouble()));
    }
    return ChangedFrame.withBalls(frame, balls);
  }

  private static BallDetection spot(double x, double y) {
    return new BallDetection(x, y, Double.NaN, 0.5, 50, Double.NaN, Double.NaN);
  }

  @Test
  void amongTenInEachFrameEveryKickIsFoundAndNoneInvented() throws IOException {
    List<Kick> clean = kicks(0);
    List<Kick> among = kicks(10);
    assertThat(clean).hasSize(8);
    assertThat(among).hasSameSizeAs(clean);
    for (Kick kick : clean) {
      assertThat(among)
          .as("kick at %.3f s", kick.time())
          .anyMatch(k -> Math.abs(k.time() - kick.time()) < SAME);
    }
  }

  /** In a match robots hide the ball again and again, and whatever is seen meanwhile looks like it. */
  @Test
  void inAMatchNoKickIsLostAndNoFalseBallGetsIntoOne() {
    SimulatedMatch match = SimulatedMatch.play(11, 3, -0.28);
    List<Kick> clean = kicks(match, 0);
    List<Kick> among = kicks(match, 10);
    assertThat(clean).hasSizeGreaterThan(40);
    assertThat(among.stream().map(Kick::end))
        .containsExactlyElementsOf(clean.stream().map(Kick::end).toList());
    for (int i = 0; i < clean.size(); i++) {
      Kick kick = clean.get(i);
      String name = String.format(Locale.ROOT, "kick at %.3f s", kick.time());
      assertThat(among.get(i).time()).as(name).isCloseTo(kick.time(), within(SAME));
      assertThat(among.get(i).observations().size())
          .as("detections of the " + name)
          .isCloseTo(kick.observations().size(), within(2));
    }
  }

  private static List<Kick> kicks(SimulatedMatch match, int falseBalls) {
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    Random random = new Random(11);
    know(finder, match.recording().geometry());
    match.recording().frames().forEach(f -> finder.accept(with(falseBalls, f, random)));
    finder.finish();
    return kicks;
  }

  private static void know(KickFinder finder, FieldGeometry geometry) {
    Map<Integer, Camera> cameras = new HashMap<>();
    geometry.cameras().forEach(c -> cameras.put(c.id(), Camera.of(c)));
    finder.geometry(geometry, cameras);
  }

  /** Without noise both velocities are exactly the same. */
  @Test
  void aRestingBallThatWasHiddenIsTheSameBall() {
    CameraTracks tracks = new CameraTracks(0);
    Random random = new Random(5);
    for (int i = 0; i < 60; i++) {
      if (i < 20 || i > 45) {
        tracks.offer(spot(1, -2));
      }
      tracks.offer(spot(-6 * random.nextDouble(), -4.5 * random.nextDouble()));
      tracks.associate(i / 75.0, track -> {});
    }
    assertThat(tracks.tracks())
        .singleElement()
        .satisfies(ball -> assertThat(ball.total()).isEqualTo(34));
  }

  @Test
  void aHundredInEachFrameLeaveBoundedTracksAndTheBallAmongThem() {
    CameraTracks tracks = new CameraTracks(0);
    Random random = new Random(3);
    for (int i = 0; i < 300; i++) {
      double t = i / 75.0;
      for (int k = 0; k < 100; k++) {
        tracks.offer(spot(-6 * random.nextDouble(), -4.5 * random.nextDouble()));
      }
      tracks.offer(spot(-1 - t, -2));
      tracks.associate(t, track -> {});
      assertThat(tracks.tracks()).hasSizeLessThanOrEqualTo(200);
    }
    assertThat(tracks.tracks())
        .anySatisfy(
            track -> {
              assertThat(track.total()).isGreaterThan(250);
              assertThat(track.x(0)).isBetween(-5.1, -4.9);
            });
  }
}
