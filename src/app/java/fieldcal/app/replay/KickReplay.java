package fieldcal.app.replay;

import com.google.protobuf.Duration;
import com.google.protobuf.DynamicMessage;
import com.google.protobuf.InvalidProtocolBufferException;
import com.google.protobuf.Timestamp;
import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.files.WholeFile;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.calibration.CalibratedKick;
import fieldcal.fit.CameraView;
import fieldcal.fit.KickFit;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.proto.SSL_WrapperPacket;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * The kicks of a calibration as an MCAP recording: vision's own frames around each kick, the kick, its fitted path, the residual of every detection, and a drawing for Foxglove's 3D panel. All on the cameras' clock.
 */
public final class KickReplay {
  /** What is shown before a kick, s: the resting ball. */
  private static final double BEFORE = 0.5;

  /** And after its end, s. */
  private static final double AFTER = 0.3;

  /** Points of a path, one per 10 ms: as dense as frames are. */
  private static final double STEP = 0.01;

  /** m; the ball's diameter, Laws of the Game 2.1 (a golf ball). */
  private static final double BALL = 0.043;

  private static final double NANOS = 1e9;

  private final CalibrationOutcome outcome;
  private final LogOpener opener;
  private final Epoch epoch;

  /** One message that belongs to a kick. */
  private record Timed(long nanos, String topic, byte[] data) {}

  /** When a kick is shown, Unix time in ns. */
  private record Window(long from, long to) {}

  /**
   * The replay of a calibration.
   *
   * @param outcome the calibration
   * @param opener opens its game logs
   */
  public KickReplay(CalibrationOutcome outcome, LogOpener opener) {
    this.outcome = outcome;
    this.opener = opener;
    epoch = outcome.data().epoch();
  }

  /**
   * Writes the recording. The game logs are read again, frame by frame.
   *
   * @param file where; an earlier one is replaced
   * @throws IOException when it cannot be written, or a game log cannot be read any more
   */
  public void write(Path file) throws IOException {
    WholeFile.streamBytes(file, this::write);
  }

  private void write(OutputStream out) throws IOException {
    try (McapWriter mcap = new McapWriter(out)) {
      Topics topics = new Topics(mcap);
      for (RecordingFacts used : outcome.data().recordings()) {
        Path log = used.log();
        List<CalibratedKick> kicks =
            outcome.calibration().kicks().stream()
                .filter(k -> log.toString().equals(outcome.data().sources().get(id(k))))
                .sorted(Comparator.comparingDouble(k -> k.fit().kick().time()))
                .toList();
        replay(log, kicks, topics);
      }
    }
  }

  private static int id(CalibratedKick kick) {
    return kick.fit().kick().id();
  }

  /** The channels. */
  private static final class Topics {
    private final McapWriter mcap;
    private final McapWriter.Channel vision;
    private final McapWriter.Channel kick;
    private final McapWriter.Channel path;
    private final McapWriter.Channel residual;
    private final McapWriter.Channel scene;

    Topics(McapWriter mcap) throws IOException {
      this.mcap = mcap;
      vision = mcap.channel("/vision", SSL_WrapperPacket.getDescriptor());
      kick = mcap.channel("/kick", ReplaySchemas.KICK);
      path = mcap.channel("/path", ReplaySchemas.PATH_POINT);
      residual = mcap.channel("/residual", ReplaySchemas.RESIDUAL);
      scene = mcap.channel("/scene", ReplaySchemas.SCENE);
    }

    void write(Timed message) throws IOException {
      McapWriter.Channel channel =
          switch (message.topic()) {
            case "/kick" -> kick;
            case "/path" -> path;
            case "/residual" -> residual;
            case "/scene" -> scene;
            default -> vision;
          };
      mcap.message(channel, message.nanos(), message.data());
    }
  }

  /** Frames and fits of one recording, in the order of time. */
  private void replay(Path log, List<CalibratedKick> kicks, Topics topics) throws IOException {
    List<Window> windows = kicks.stream().map(k -> window(k.fit())).toList();
    int next = 0;
    List<Timed> pending = new ArrayList<>();
    int done = 0;
    byte[] geometry = null;
    try (GameLogReader reader = opener.messages(log)) {
      while (reader.next()) {
        if (reader.type() != MessageType.SSL_VISION_2014) {
          continue;
        }
        byte[] payload = reader.message().payload();
        SSL_WrapperPacket packet = parse(payload);
        if (packet == null) {
          continue;
        }
        if (packet.hasGeometry()) {
          geometry = payload;
        }
        if (!packet.hasDetection()) {
          continue;
        }
        long nanos = (long) (packet.getDetection().getTCapture() * NANOS);
        // From one kick on, its messages wait for their turn among the frames.
        while (next < windows.size() && nanos >= windows.get(next).from()) {
          pending.addAll(messages(kicks.get(next)));
          if (geometry != null) {
            pending.add(new Timed(windows.get(next).from(), "/vision", geometry));
          }
          pending.subList(done, pending.size()).sort(Comparator.comparingLong(Timed::nanos));
          next++;
        }
        while (done < pending.size() && pending.get(done).nanos() <= nanos) {
          topics.write(pending.get(done++));
        }
        if (done == pending.size()) {
          pending.clear();
          done = 0;
        }
        if (inside(windows, next, nanos)) {
          topics.write(new Timed(nanos, "/vision", payload));
        }
      }
    }
    for (; next < windows.size(); next++) {
      pending.addAll(messages(kicks.get(next)));
    }
    pending.subList(done, pending.size()).sort(Comparator.comparingLong(Timed::nanos));
    for (; done < pending.size(); done++) {
      topics.write(pending.get(done));
    }
  }

  private static SSL_WrapperPacket parse(byte[] payload) {
    try {
      return SSL_WrapperPacket.parseFrom(payload);
    } catch (InvalidProtocolBufferException e) {
      // calibrate has counted and named what cannot be read.
      return null;
    }
  }

  /** Whether a frame belongs to one of the kicks that have begun. */
  private static boolean inside(List<Window> windows, int begun, long nanos) {
    for (int i = 0; i < begun; i++) {
      if (nanos >= windows.get(i).from() && nanos <= windows.get(i).to()) {
        return true;
      }
    }
    return false;
  }

  private Window window(KickFit fit) {
    double first = Math.min(fit.kick().observations().time(0), KickTables.start(fit) - BEFORE);
    return new Window(nanos(first), nanos(fit.kick().endTime() + AFTER));
  }

  /** MCAP's times are not negative; simulators begin at 0. */
  private long nanos(double seconds) {
    return Math.max(0, epoch.unixNanosOf(seconds));
  }

  private List<Timed> messages(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    List<Timed> all = new ArrayList<>();
    double start = KickTables.start(fit);
    all.add(new Timed(nanos(start), "/kick", kick(calibrated).toByteArray()));
    if (fit.failure().isPresent()) {
      return all;
    }
    double end = Math.min(fit.kick().endTime(), fit.trajectory().restTime() + AFTER);
    List<DynamicMessage> line = new ArrayList<>();
    for (int i = 0; start + i * STEP <= end; i++) {
      double t = start + i * STEP;
      BallState at = fit.trajectory().stateAt(t);
      all.add(new Timed(nanos(t), "/path", pathPoint(fit, t, start).toByteArray()));
      line.add(ReplaySchemas.foxglove("Point3", "x", at.x(), "y", at.y(), "z", at.z() + BALL / 2));
    }
    all.add(new Timed(nanos(start), "/scene", scene(fit, nanos(start), line, end - start)));
    observed(fit, start, all);
    return all;
  }

  private DynamicMessage kick(CalibratedKick calibrated) {
    KickFit fit = calibrated.fit();
    Kick kick = fit.kick();
    boolean fitted = fit.failure().isEmpty();
    double vx = fitted ? fit.estimate("vx").value() : kick.vx();
    double vy = fitted ? fit.estimate("vy").value() : kick.vy();
    double vz = fitted && fit.kind() == KickKind.CHIP ? fit.estimate("vz").value() : 0;
    double ground = Math.hypot(vx, vy);
    return ReplaySchemas.of(
        ReplaySchemas.KICK,
        "kick",
        kick.id(),
        "kind",
        fit.kind().id(),
        "team",
        kick.robot().map(r -> r.team().name().toLowerCase(Locale.ROOT)).orElse(""),
        "robot",
        kick.robot().map(r -> r.number()).orElse(-1),
        "x_m",
        fitted ? fit.estimate("x").value() : kick.x(),
        "y_m",
        fitted ? fit.estimate("y").value() : kick.y(),
        "speed_mps",
        Math.hypot(ground, vz),
        "direction_deg",
        Math.toDegrees(Math.atan2(vy, vx)),
        "elevation_deg",
        Math.toDegrees(Math.atan2(vz, ground)),
        "rms_mm",
        fitted ? fit.rmsMm() : Double.NaN,
        "selected",
        calibrated.selected(),
        "rejected_because",
        calibrated.rejected().map(ParameterWords::spelledOut).orElse(""));
  }

  private static DynamicMessage pathPoint(KickFit fit, double t, double start) {
    BallTrajectory path = fit.trajectory();
    BallState at = path.stateAt(t);
    return ReplaySchemas.of(
        ReplaySchemas.PATH_POINT,
        "kick",
        fit.kick().id(),
        "t_s",
        t - start,
        "x_m",
        at.x(),
        "y_m",
        at.y(),
        "z_m",
        at.z(),
        "vx_mps",
        at.vx(),
        "vy_mps",
        at.vy(),
        "vz_mps",
        at.vz(),
        "speed_mps",
        at.groundSpeed(),
        "phase",
        path.phaseAt(t).name().toLowerCase(Locale.ROOT));
  }

  /** The residual of each detection, and the place that was reported, without the camera's offset, as a ball. */
  private void observed(KickFit fit, double start, List<Timed> all) {
    Observations seen = fit.kick().observations();
    for (int i = 0; i < seen.size(); i++) {
      CameraView view = outcome.calibration().cameras().get(seen.camera(i));
      double x = seen.x(i) - view.offsetX();
      double y = seen.y(i) - view.offsetY();
      DynamicMessage residual =
          ReplaySchemas.of(
              ReplaySchemas.RESIDUAL,
              "kick",
              fit.kick().id(),
              "t_s",
              seen.time(i) - start,
              "camera",
              seen.camera(i),
              "x_m",
              x,
              "y_m",
              y,
              "residual_x_mm",
              1000 * fit.residualX(i),
              "residual_y_mm",
              1000 * fit.residualY(i),
              "used",
              fit.used(i));
      long when = nanos(seen.time(i));
      all.add(new Timed(when, "/residual", residual.toByteArray()));
      all.add(new Timed(when, "/scene", ball(when, x, y, fit.used(i))));
    }
  }

  private static byte[] scene(KickFit fit, long when, List<DynamicMessage> points, double seconds) {
    DynamicMessage line =
        ReplaySchemas.foxglove(
            "LinePrimitive",
            "pose",
            pose(0, 0, 0),
            "thickness",
            BALL / 4,
            "points",
            points,
            "color",
            color(
                fit.kind() == KickKind.CHIP ? 0.9 : 0.2,
                0.5,
                fit.kind() == KickKind.CHIP ? 0.2 : 0.9));
    return entity(when, "path", seconds + AFTER, "lines", line);
  }

  private static byte[] ball(long when, double x, double y, boolean used) {
    DynamicMessage sphere =
        ReplaySchemas.foxglove(
            "SpherePrimitive",
            "pose",
            pose(x, y, BALL / 2),
            "size",
            ReplaySchemas.foxglove("Vector3", "x", BALL, "y", BALL, "z", BALL),
            "color",
            used ? color(1, 0.5, 0) : color(0.5, 0.5, 0.5));
    return entity(when, "ball", 1, "spheres", sphere);
  }

  private static byte[] entity(
      long when, String id, double seconds, String sort, DynamicMessage primitive) {
    long nanos = (long) (seconds * NANOS);
    DynamicMessage entity =
        ReplaySchemas.foxglove(
            "SceneEntity",
            "timestamp",
            Timestamp.newBuilder()
                .setSeconds(when / 1_000_000_000)
                .setNanos((int) (when % 1_000_000_000))
                .build(),
            "frame_id",
            "field",
            "id",
            id,
            "lifetime",
            Duration.newBuilder()
                .setSeconds(nanos / 1_000_000_000)
                .setNanos((int) (nanos % 1_000_000_000))
                .build(),
            sort,
            List.of(primitive));
    return ReplaySchemas.foxglove("SceneUpdate", "entities", List.of(entity)).toByteArray();
  }

  private static DynamicMessage pose(double x, double y, double z) {
    return ReplaySchemas.foxglove(
        "Pose",
        "position",
        ReplaySchemas.foxglove("Vector3", "x", x, "y", y, "z", z),
        "orientation",
        ReplaySchemas.foxglove("Quaternion", "w", 1.0));
  }

  private static DynamicMessage color(double r, double g, double b) {
    return ReplaySchemas.foxglove("Color", "r", r, "g", g, "b", b, "a", 1.0);
  }
}
