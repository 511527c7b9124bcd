package fieldcal.app.net;

import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.util.List;
import java.util.Optional;

/**
 * From packets of vision to frames and geometry.
 *
 * <p>Senders are distinguished, since a second field's vision or a simulator is often on the same group: of each camera's number only the first sender's frames are taken, and only the first sender's geometry, as
 * long as it does not fall silent. So several computers that each send cameras of their own work together, and two that send the same do not get mixed up.
 */
public final class VisionSource {
  private static final String GEOMETRY = "geometry";

  /** Receives what came. */
  public interface Sink {
    /**
     * A frame.
     *
     * @param frame of the epoch's time
     */
    void frame(VisionFrame frame);

    /**
     * The geometry; comes over and over.
     *
     * @param geometry as published
     */
    void geometry(FieldGeometry geometry);

    /**
     * The bytes of a packet whose frame or geometry is given next, for whoever records it.
     *
     * @param message not to be changed
     * @param arrivedNanos when it came, on the clock of {@link System#nanoTime}, ns
     */
    default void visionMessage(byte[] message, long arrivedNanos) {}
  }

  private final Sources<VisionDecoder> sources;
  private final Sink sink;
  private final MixedFields mixed = new MixedFields();
  private volatile long frames;
  private volatile long lastFrame;
  private Arrival arrival;
  private boolean seamless = true;

  /**
   * A source.
   *
   * @param epoch that frames' times count from
   * @param sink receives what came
   */
  public VisionSource(Epoch epoch, Sink sink) {
    sources = new Sources<>(address -> new VisionDecoder(epoch));
    this.sink = sink;
  }

  /** Takes a packet. */
  void accept(Packet packet) {
    long now = packet.received();
    seamless &= packet.seamless();
    Sources.Source<VisionDecoder> source = sources.of(packet.source(), now);
    if (source == null) {
      return;
    }
    VisionPacket content = source.decoder().decode(packet.data());
    if (content.equals(VisionPacket.EMPTY)) {
      sources.wrong(source);
      return;
    }
    Optional<FieldGeometry> geometry =
        content.geometry().filter(g -> sources.owns(source, GEOMETRY, now));
    Optional<VisionFrame> frame = content.frame().filter(f -> listensTo(source, f, now));
    if (geometry.isPresent() || frame.isPresent()) {
      sink.visionMessage(packet.data(), now);
    }
    geometry.ifPresent(sink::geometry);
    if (frame.isPresent()) {
      frames++;
      lastFrame = now;
      arrival = new Arrival(1e-9 * packet.earliest(), 1e-9 * now, seamless);
      seamless = true;
      sink.frame(frame.get());
    }
  }

  private boolean listensTo(Sources.Source<VisionDecoder> source, VisionFrame frame, long now) {
    int camera = frame.cameraId();
    if (sources.owns(source, camera, now)) {
      mixed.frame(source.address(), frame);
      return true;
    }
    mixed.ignored(source.address(), camera, sources.owner(camera), sources.age(camera, now));
    return false;
  }

  /** Where two fields come in at once; from the thread that calls {@link #accept}. */
  MixedFields mixed() {
    return mixed;
  }

  /**
   * How many frames the sink received; from any thread.
   *
   * @return those of senders that are listened to
   */
  public long frames() {
    return frames;
  }

  /** When the newest of these frames came, ns; from any thread. */
  long lastFrame() {
    return lastFrame;
  }

  /** Of the newest of these frames; from the thread that calls {@link #accept}. */
  Arrival arrival() {
    return arrival;
  }

  /** Packets of senders that were too many; from any thread. */
  long tooMany() {
    return sources.tooMany();
  }

  /**
   * What came from whom; from any thread.
   *
   * @return one entry per sender that is remembered, in the order of their first packet
   */
  public List<SourceCounts> counts() {
    return sources.counts();
  }
}
