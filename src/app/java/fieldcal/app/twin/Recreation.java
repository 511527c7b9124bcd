package fieldcal.app.twin;

import fieldcal.app.files.WholeFile;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.statistics.RecordedFrames;
import fieldcal.ball.BallState;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.kick.Kick;
import fieldcal.kick.KickEnd;
import fieldcal.simulation.Replay;
import fieldcal.simulation.ReplayedKick;
import fieldcal.simulation.RobotTrack;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.Epoch;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleConsumer;

/** Records the kicks of a recording again, on its twin. */
final class Recreation {
  /** A ball that left the field, or was lost, is seen so long after the end of the kick, s. */
  private static final double SEEN_AFTER = 0.3;

  /** Places of robots are averaged over that time, s: five frames, in which a robot of 3 m/s goes 0.2 m. */
  private static final double BIN = 0.07;

  /** Height of a robot's pattern where it is not reported, m: between the league's limit and usual ones. */
  private static final double USUAL_HEIGHT = 0.14;

  private final FieldRecording field;
  private final SpinOfKick spins;
  private final Map<Integer, FittedPath> fitted;
  private final Epoch epoch;
  private final double start;

  /** With the paths of the extended model, which the twin obeys. */
  Recreation(FieldRecording field, Diagnosis diagnosis) {
    this.field = field;
    spins = new SpinOfKick(diagnosis.model());
    fitted =
        FittedPath.all(
            field.calibration().calibration().trusted().stream().map(FittedPath::of).toList(),
            diagnosis.kicks());
    Epoch recorded = field.calibration().data().epoch();
    // Session times of causes count from the first frame.
    start = field.calibration().data().sessionStart();
    epoch = new Epoch(recorded.unixNanosOf(start));
  }

  /** Writes one recording again, which must have a frame. */
  void write(RecordedFrames one, SimulationSettings settings, Path log, DoubleConsumer progress)
      throws IOException {
    List<Replay.Span> spans =
        one.spans().stream().map(s -> new Replay.Span(s[0] - start, s[1] - start)).toList();
    Replay replay = new Replay(settings, kicks(one), robots(one), spans);
    VisionEncoder encoder = new VisionEncoder(epoch);
    WholeFile.streamBytes(
        log,
        bytes -> {
          try (GameLogWriter writer = GameLogWriter.to(bytes, log)) {
            writer.write(
                epoch.unixNanosOf(spans.get(0).from()),
                MessageType.BLANK,
                RecordingOrigin.simulationMark());
            replay.run(packet -> write(writer, encoder, packet), progress);
          } catch (UncheckedIOException e) {
            throw e.getCause();
          }
        });
  }

  private void write(GameLogWriter writer, VisionEncoder encoder, SimulatedPacket packet) {
    try {
      writer.write(
          epoch.unixNanosOf(packet.receivedTime()),
          MessageType.SSL_VISION_2014,
          encoder.encode(packet.packet()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<ReplayedKick> kicks(RecordedFrames one) {
    List<ReplayedKick> kicks = new ArrayList<>();
    double before = Double.NEGATIVE_INFINITY;
    for (Kick kick : field.kicks(one)) {
      // A ball that is kicked from where it stopped comes there by itself.
      double free = before;
      before = kick.endTime();
      FittedPath fit = fitted.get(kick.id());
      if (fit == null) {
        continue;
      }
      double time = fit.path().kickTime();
      BallState state = fit.path().stateAt(time);
      double end = Math.max(time, kick.endTime());
      boolean held = kick.end() == KickEnd.TOUCHED_ROBOT || kick.end() == KickEnd.STOPPED;
      double rests =
          kick.fromRest()
              ? Math.min(
                  time, Math.max(free, one.restingSince(time, kick.x(), kick.y()).orElse(time)))
              : time;
      kicks.add(
          new ReplayedKick(
              rests - start,
              time - start,
              state.x(),
              state.y(),
              state.vx(),
              state.vy(),
              Math.max(0, state.vz()),
              end - start,
              kick.end() == KickEnd.TOUCHED_ROBOT,
              held ? Double.MAX_VALUE : end + SEEN_AFTER - start,
              spins.of(fit)));
    }
    return kicks;
  }

  /** All robots, averaged over cameras and short times. */
  private List<RobotTrack> robots(RecordedFrames one) {
    Map<RobotId, TreeMap<Long, double[]>> bins = new TreeMap<>();
    Map<RobotId, Double> heights = new TreeMap<>();
    for (List<VisionFrame> frames : one.frames().values()) {
      for (VisionFrame frame : frames) {
        double t = frame.captureTime() - start;
        for (RobotDetection robot : frame.robots()) {
          double[] sum =
              bins.computeIfAbsent(robot.id(), id -> new TreeMap<>())
                  .computeIfAbsent((long) Math.floor(t / BIN), b -> new double[6]);
          sum[0]++;
          sum[1] += t;
          sum[2] += robot.x();
          sum[3] += robot.y();
          sum[4] += Math.cos(robot.orientation());
          sum[5] += Math.sin(robot.orientation());
          if (Double.isFinite(robot.height())) {
            heights.put(robot.id(), robot.height());
          }
        }
      }
    }
    List<RobotTrack> tracks = new ArrayList<>();
    bins.forEach((id, sums) -> tracks.add(track(id, heights.getOrDefault(id, USUAL_HEIGHT), sums)));
    return tracks;
  }

  private static RobotTrack track(RobotId id, double height, TreeMap<Long, double[]> sums) {
    double[] times = new double[sums.size()];
    double[] poses = new double[3 * sums.size()];
    int i = 0;
    for (double[] sum : sums.values()) {
      times[i] = sum[1] / sum[0];
      poses[3 * i] = sum[2] / sum[0];
      poses[3 * i + 1] = sum[3] / sum[0];
      poses[3 * i + 2] = Math.atan2(sum[5], sum[4]);
      i++;
    }
    return new RobotTrack(id, height, times, poses);
  }
}
