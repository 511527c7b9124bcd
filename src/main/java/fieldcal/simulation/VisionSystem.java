package fieldcal.simulation;

import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraRig;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Scene;
import fieldcal.simulation.imaging.SimulatedCamera;
import fieldcal.simulation.truth.CameraTruth;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.Consumer;

/** All cameras over a simulated world and the vision behind them: frames and geometry in the order of their arrival. Not thread-safe. */
public final class VisionSystem {
  /** From vision to the recorder, s. */
  private static final double NETWORK = 0.0003;

  /** Longest time from the exposure of a frame to its arrival, s: a recorder that waits this long has all frames in order. */
  static final double SAFE_LAG = 0.1;

  /** When the first geometry is sent, s after the beginning of the recording. */
  private static final double FIRST_GEOMETRY = 0.004;

  private static final double GEOMETRY_INTERVAL = 1;

  private final Scene scene;
  private final double lag;
  private final List<SimulatedCamera> cameras;
  private final FieldGeometry geometry;
  private final double ballPlane;
  private final double rollingShutter;
  private final long[] frameCounts;
  private final List<VisionFrame> frames = new ArrayList<>(2);
  private final PriorityQueue<Arrival> waiting =
      new PriorityQueue<>(
          Comparator.comparingDouble((Arrival a) -> a.packet().receivedTime())
              .thenComparingLong(Arrival::order));
  private long order;
  private double nextGeometry;

  private record Arrival(SimulatedPacket packet, long order) {}

  /**
   * Cameras over a world.
   *
   * @param settings cameras, trouble, effects, published models, seed
   * @param world what there is to see
   */
  public VisionSystem(SimulationSettings settings, SimulatedWorld world) {
    this(settings, world, 0, SAFE_LAG);
  }

  /**
   * With a lag of 0, packets are delivered when they arrive, as somebody who drives robots needs them; order of arrival is kept up to a rolling shutter of 10 ms. The recording begins at session time
   * {@code from}.
   */
  VisionSystem(SimulationSettings settings, Scene scene, double from, double lag) {
    this.scene = scene;
    this.lag = lag;
    nextGeometry = from + FIRST_GEOMETRY;
    CameraSettings cameraSettings = Effects.cameras(settings.cameras(), settings.effects());
    List<CameraErrors> errors = Effects.cameraErrors(settings.cameraIds(), settings.effects());
    ballPlane = cameraSettings.ballPlane();
    rollingShutter = Effects.rollingShutter(0, settings.effects());
    FieldSize field = settings.field();
    long seed = settings.seed();
    cameras =
        settings.installed().isEmpty()
            ? CameraRig.over(
                field, cameraSettings, settings.nuisance(), errors, rollingShutter, seed)
            : CameraRig.of(
                settings.installed(), cameraSettings, errors, rollingShutter, from, seed);
    frameCounts = new long[cameras.size()];
    List<CameraCalibration> published =
        cameras.stream().map(SimulatedCamera::announcedCalibration).toList();
    geometry =
        FieldGeometry.of(
                field.length(),
                field.width(),
                field.goalWidth(),
                field.goalDepth(),
                field.boundary(),
                published)
            .withLines(field.lines(), field.arcs())
            .withModels(settings.publishedModels().flat(), settings.publishedModels().chip());
  }

  /**
   * The geometry as published.
   *
   * @return field, cameras, ball models
   */
  public FieldGeometry geometry() {
    return geometry;
  }

  /**
   * Height of the ball's centre that vision assumes.
   *
   * @return m
   */
  public double ballPlane() {
    return ballPlane;
  }

  /**
   * Time from the first to the last image row.
   *
   * @return s
   */
  public double rollingShutter() {
    return rollingShutter;
  }

  /**
   * Takes the frames that are due now; call it after each tick of the world.
   *
   * @param now session time, s
   * @param sink gets the packets that no other can overtake any more, in the order of their arrival
   */
  public void observe(double now, Consumer<SimulatedPacket> sink) {
    for (int i = 0; i < cameras.size(); i++) {
      SimulatedCamera camera = cameras.get(i);
      while (camera.nextExposure() + camera.exposureSpan() <= now) {
        frames.clear();
        camera.expose(scene, frames);
        for (VisionFrame frame : frames) {
          frameCounts[i]++;
          // A copy of the frame does not arrive at the very same moment.
          double received = frame.sentTime() + NETWORK * (1 + 0.1 * (order % 7));
          add(received, VisionPacket.of(frame));
        }
      }
    }
    if (now >= nextGeometry) {
      add(nextGeometry, VisionPacket.of(geometry));
      nextGeometry += GEOMETRY_INTERVAL;
    }
    deliver(now - lag, sink);
  }

  /**
   * The recording is over.
   *
   * @param sink gets the packets that are still on their way
   */
  public void finish(Consumer<SimulatedPacket> sink) {
    deliver(Double.POSITIVE_INFINITY, sink);
  }

  private void add(double received, VisionPacket packet) {
    waiting.add(new Arrival(new SimulatedPacket(received, packet), order++));
  }

  private void deliver(double until, Consumer<SimulatedPacket> sink) {
    while (!waiting.isEmpty() && waiting.peek().packet().receivedTime() <= until) {
      sink.accept(waiting.poll().packet());
    }
  }

  /**
   * The cameras as they are.
   *
   * @return by number
   */
  public List<CameraTruth> truth() {
    List<CameraTruth> truths = new ArrayList<>();
    for (int i = 0; i < cameras.size(); i++) {
      SimulatedCamera c = cameras.get(i);
      truths.add(
          new CameraTruth(
              c.trueCalibration(), c.publishedCalibration(), c.errors(), c.rate(), frameCounts[i]));
    }
    return truths;
  }
}
