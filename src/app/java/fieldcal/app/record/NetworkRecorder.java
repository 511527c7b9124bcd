package fieldcal.app.record;

import fieldcal.app.calibrate.InputException;
import fieldcal.app.net.MatchNetwork;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.net.VisionWatch;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingGap;
import fieldcal.gamelog.RefereeState;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Clock;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * Records a network until it is stopped. The file is opened with the first frame of vision: where none comes, there is no file, and an older one that was to be replaced is still there. It begins with what came before that frame. What was recorded a
 * second ago is with the operating system, so that little is lost when this process is killed. One thread runs it; any may stop it.
 */
public final class NetworkRecorder implements Closeable {
  /** Waits so long for a packet before the clock is looked at, ms. */
  private static final long WAIT_MS = 50;

  private static final double FLUSH = 1;

  /** So many packets before the first frame are kept, the latest: more than a minute of geometry and of a referee. Chosen; the memory for it is 64 MB at most. */
  private static final int MOST_EARLY = 1000;

  /** The status is told so often, s. */
  private static final double TELL = 0.25;

  private final Path file;
  private final boolean replace;
  private final String places;
  private final long beginNanos = System.nanoTime();
  private final long beginUnixNanos;
  private final MatchNetwork network;
  private final CountDownLatch ended = new CountDownLatch(1);
  private final Set<Integer> cameras = new TreeSet<>();
  private volatile boolean stopped;
  private final Deque<Packet> waiting = new ArrayDeque<>();
  private GameLogWriter writer;
  private IOException failure;
  private boolean geometry;
  private boolean vision;
  private String referee = "";
  private final VisionWatch watch = new VisionWatch();
  private byte[] pending;
  private long pendingNanos;
  private long frames;
  private long bytes;

  /**
   * Begins to listen.
   *
   * @param file where to, {@code .log} or {@code .log.gz}
   * @param replace whether a file of that name may be overwritten
   * @param vision where vision sends to
   * @param referee where the referee sends to, if it is to be recorded
   * @param clock of this machine
   * @throws IOException when the file is there already, its folder is not, or a port cannot be opened; one line for the operator
   */
  public NetworkRecorder(
      Path file, boolean replace, NetworkPlace vision, Optional<NetworkPlace> referee, Clock clock)
      throws IOException {
    this.file = file;
    this.replace = replace;
    checkFile();
    places = vision + referee.map(r -> " and " + r).orElse("");
    beginUnixNanos = clock.millis() * 1_000_000L;
    network = new MatchNetwork(vision, referee, Epoch.atSecondOf(beginUnixNanos), new Sink());
  }

  /** Better told now than after the first minute. */
  private void checkFile() throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    if (Files.isDirectory(file)) {
      throw new InputException(file + ": is a directory; a file is needed");
    }
    if (Files.exists(file) && !replace) {
      throw new InputException(file + ": exists already and is not overwritten");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw new InputException(file + ": there is no folder " + folder);
    }
    if (!Files.isWritable(folder)) {
      throw new InputException(file + ": the folder " + folder + " cannot be written to");
    }
  }

  /**
   * Whether a name is one of a game log.
   *
   * @param file to be written
   * @return true for {@code .log} and {@code .log.gz}
   */
  public static boolean isLogName(Path file) {
    String name = file.getFileName() == null ? "" : file.getFileName().toString();
    return name.endsWith(".log") || name.endsWith(".log.gz");
  }

  /**
   * Records until it is stopped or the time is over.
   *
   * @param seconds how long, s; infinity without an end
   * @param listener told the status a few times a second
   * @return the status at the end
   * @throws IOException when nothing was heard, or the file cannot be written; one line for the operator
   */
  public RecordStatus run(double seconds, Consumer<RecordStatus> listener) throws IOException {
    try {
      double told = Double.NEGATIVE_INFINITY;
      double flushed = 0;
      for (double now = now(); now < seconds && !stopped && failure == null; now = now()) {
        network.receive(WAIT_MS);
        writePending();
        if (writer != null && now - flushed > FLUSH) {
          flushed = now;
          flush();
        }
        if (now - told > TELL) {
          told = now;
          listener.accept(status());
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      network.close();
      end();
      ended.countDown();
    }
    if (failure != null) {
      throw failure;
    }
    if (frames == 0) {
      throw new InputException(nothingHeard());
    }
    return status();
  }

  private double now() {
    return 1e-9 * (System.nanoTime() - beginNanos);
  }

  private RecordStatus status() {
    return new RecordStatus(
        now(), frames, cameras, geometry, referee, bytes, network.withoutFrames(), network.notes());
  }

  private String nothingHeard() {
    return String.format(
        Locale.ROOT,
        "no frame of vision was heard in %.0f s on %s. Is vision running? %s. %s",
        now(),
        places,
        network.notes().stream().map(String::strip).collect(Collectors.joining(". ")),
        Files.exists(file) ? file + " is as it was." : "No file was written.");
  }

  /** A packet that is not in the file yet. */
  private record Packet(MessageType type, byte[] message, long arrivedNanos) {}

  /** What was heard, with the moment of its arrival. */
  private void write(MessageType type, byte[] message, long arrivedNanos) {
    if (failure != null) {
      return;
    }
    waiting.add(new Packet(type, message, arrivedNanos));
    if (frames == 0) {
      if (waiting.size() > MOST_EARLY) {
        waiting.remove();
      }
      return;
    }
    try {
      if (writer == null) {
        writer = open();
      }
      for (Packet one = waiting.poll(); one != null; one = waiting.poll()) {
        writer.write(beginUnixNanos + (one.arrivedNanos - beginNanos), one.type, one.message);
        bytes += one.message.length;
      }
    } catch (IOException e) {
      failure = named(e);
    }
  }

  /** Writes the packet at hand; whether a gap comes before it is known only when its frame was looked at. */
  private void writePending() {
    if (pending != null) {
      write(MessageType.SSL_VISION_2014, pending, pendingNanos);
      pending = null;
    }
  }

  private GameLogWriter open() throws IOException {
    return replace
        ? GameLogWriter.create(file)
        : GameLogWriter.create(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  private void flush() {
    try {
      writer.flush();
    } catch (IOException e) {
      failure = named(e);
    }
  }

  private void end() {
    if (writer == null) {
      return;
    }
    try {
      writer.close();
    } catch (IOException e) {
      failure = failure == null ? named(e) : failure;
    }
  }

  /** A full disk does not say which file it was. */
  private IOException named(IOException e) {
    if (e instanceof FileSystemException) {
      return e;
    }
    return new IOException(
        String.format(
            Locale.ROOT,
            "%s: %s; the recording ended after %.0f s, and what is in the file may be incomplete",
            file,
            e.getMessage(),
            now()),
        e);
  }

  /** Ends it, from any thread. */
  public void stop() {
    stopped = true;
  }

  /**
   * Waits until the file is complete.
   *
   * @param millis how long at most, ms
   * @return whether it is
   * @throws InterruptedException when the thread is interrupted
   */
  public boolean awaitEnd(long millis) throws InterruptedException {
    return ended.await(millis, TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    stop();
    network.close();
  }

  private final class Sink implements MatchNetwork.Sink {
    @Override
    public void visionMessage(byte[] message, long arrivedNanos) {
      vision = true;
      writePending();
      pending = message;
      pendingNanos = arrivedNanos;
    }

    @Override
    public void frame(VisionFrame frame) {
      frames++;
      if (!watch.frame(frame.captureTime(), network.arrival())) {
        write(MessageType.BLANK, RecordingGap.mark(), pendingNanos);
      }
      writePending();
      cameras.add(frame.cameraId());
    }

    @Override
    public void geometry(FieldGeometry published) {
      geometry = true;
    }

    @Override
    public void refereeMessage(byte[] message, long arrivedNanos) {
      // A recording of a referee alone is of no use.
      if (vision) {
        write(MessageType.SSL_REFBOX_2013, message, arrivedNanos);
      }
    }

    @Override
    public void referee(RefereeState state) {
      referee = state.command().name();
    }
  }
}
