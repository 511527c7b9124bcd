package fieldcal.gamelog;

import fieldcal.vision.DecodingCounts;
import fieldcal.vision.DecodingProblem;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionFrame;
import fieldcal.vision.VisionPacket;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * Streams a recording as values: frames in the order of their capture times, geometry when it changes, referee messages.
 *
 * <p>Memory does not grow with the recording. What is damaged, doubled or impossible is left out, and counted with its place in the
 * {@link ProblemAccount}. Reads once; not thread-safe.
 *
 * <pre>{@code
 * try (RecordingReader recording = RecordingReader.open(file)) {
 *   RecordingSummary summary = recording.read(listener);
 * }
 * }</pre>
 */
public final class RecordingReader implements Closeable {
  /** A frame is put into order unless one that was captured later by more than this was received before it, s. Vision computers differ by some 10 ms. */
  public static final double DEFAULT_TOLERANCE = 0.1;

  private static final long PROGRESS_STEP = 1 << 18;

  private final GameLogReader log;
  private final Epoch epoch;
  private final boolean hasMessages;
  private final ProblemAccount problems;
  private final VisionDecoder vision;
  private final DecodingCounts counts;
  private final RefereeDecoder referee;
  private final RefereeOrder refereeOrder = new RefereeOrder();
  private final TrackerDecoder tracker;
  private final CameraClock[] clocks = new CameraClock[VisionDecoder.MAX_CAMERA_ID + 1];
  private final long[] messages = new long[MessageType.values().length];

  private RecordingListener listener;
  private CaptureOrder order;
  private FieldGeometry geometry;
  private final BitSet calibrated = new BitSet();
  private final BitSet everCalibrated = new BitSet();

  /** Cameras that sent frames after the first geometry, which did not name them, and before any that did. */
  private final Map<Integer, Unnamed> unnamed = new TreeMap<>();

  private boolean isRead;
  private long frames;
  private double lastTime = Double.NaN;

  /** Times of the first and the last message, of those whose neighbours confirm their times. A damaged time would turn minutes into years. */
  private double startTime = Double.NaN;

  private double endTime = Double.NaN;
  private long nextProgress;
  private long offset; // of the message at hand; kept, because at the end there is none

  private RecordingReader(GameLogReader log, Epoch epoch, boolean hasMessages) {
    this.log = log;
    this.epoch = epoch;
    this.hasMessages = hasMessages;
    problems = log.problems();
    vision = new VisionDecoder(epoch);
    counts = vision.counts();
    referee = new RefereeDecoder(epoch);
    tracker = new TrackerDecoder(epoch);
  }

  /**
   * Opens a recording. Its epoch is the full second of its first message.
   *
   * @param file a {@code .log} or {@code .log.gz}
   * @return a reader at the recording's start
   * @throws GameLogException if there is no such file, it cannot be read, is empty, or is no game log
   */
  public static RecordingReader open(Path file) throws GameLogException {
    return open(file, Optional.empty(), GameLogReader.LARGEST_RATIO);
  }

  /**
   * Opens a recording whose times shall count from a given epoch, so that several recordings share it.
   *
   * @param file a {@code .log} or {@code .log.gz}
   * @param epoch the epoch
   * @return a reader at the recording's start
   * @throws GameLogException if there is no such file, it cannot be read, is empty, or is no game log
   */
  public static RecordingReader open(Path file, Epoch epoch) throws GameLogException {
    return open(file, Optional.of(epoch), GameLogReader.LARGEST_RATIO);
  }

  /**
   * Opens a recording with another limit of the compression ratio.
   *
   * @param file a {@code .log} or {@code .log.gz}
   * @param epoch from which its times count; empty for the full second of its first message
   * @param largestRatio largest accepted ratio of the log's size to that of its compressed file; {@link Double#POSITIVE_INFINITY}: no limit
   * @return a reader at the recording's start
   * @throws GameLogException if there is no such file, it cannot be read, is empty, or is no game log
   * @throws IllegalArgumentException if the limit is below 1 or NaN
   */
  public static RecordingReader open(Path file, Optional<Epoch> epoch, double largestRatio)
      throws GameLogException {
    GameLogReader log = GameLogReader.open(file, largestRatio);
    boolean hasMessages = log.next();
    Epoch first = Epoch.atSecondOf(hasMessages ? log.receivedNanos() : 0);
    return new RecordingReader(log, epoch.orElse(first), hasMessages);
  }

  /**
   * The instant that all times of this recording count from.
   *
   * @return the epoch
   */
  public Epoch epoch() {
    return epoch;
  }

  /**
   * Reads all of it.
   *
   * @param to receives what is in it
   * @return what was read
   * @throws GameLogException if the file system fails, or a compressed log exceeds the limit of the compression ratio
   * @throws IllegalStateException if it was read already
   */
  public RecordingSummary read(RecordingListener to) throws GameLogException {
    return read(to, DEFAULT_TOLERANCE);
  }

  /**
   * Reads all of it.
   *
   * @param to receives what is in it
   * @param tolerance how long a frame waits for older ones, s of capture time; 0 keeps the order of reception
   * @return what was read
   * @throws GameLogException if the file system fails, or a compressed log exceeds the limit of the compression ratio
   * @throws IllegalStateException if it was read already
   * @throws IllegalArgumentException if the tolerance is negative or NaN
   */
  public RecordingSummary read(RecordingListener to, double tolerance) throws GameLogException {
    if (isRead) {
      throw new IllegalStateException("a recording is read once; open it again");
    }
    if (!(tolerance >= 0)) {
      throw new IllegalArgumentException("tolerance must not be negative, got " + tolerance);
    }
    isRead = true;
    listener = Objects.requireNonNull(to, "listener");
    order = new CaptureOrder(tolerance, new Counter());
    startTime = hasMessages ? epoch.secondsOfNanos(log.receivedNanos()) : Double.NaN;
    for (boolean more = hasMessages; more; more = log.next()) {
      take();
      if (log.bytesRead() >= nextProgress) {
        listener.onProgress(log.bytesRead(), log.totalBytes());
        nextProgress = log.bytesRead() + PROGRESS_STEP;
      }
    }
    for (CameraClock clock : clocks) {
      if (clock != null && clock.hasSuspect()) {
        stray(clock.takeSuspect());
      }
    }
    order.flush();
    reportUnnamed(LogProblem.FRAME_BEFORE_CAMERA, true);
    reportUnnamed(LogProblem.UNCALIBRATED_CAMERA, false);
    if (!hasMessages) {
      problems.add(
          LogProblem.NO_MESSAGES, log.logBytes(), () -> problems.file().getFileName().toString());
    }
    listener.onProgress(log.totalBytes(), log.totalBytes());
    return summary();
  }

  @Override
  public void close() throws IOException {
    log.close();
  }

  private void take() {
    double received = epoch.secondsOfNanos(log.receivedNanos());
    double last = lastTime;
    offset = log.offset();
    if (received < lastTime - CameraClock.MAX_STEP) {
      problem(
          LogProblem.CLOCK_JUMP_BACK,
          () -> String.format(Locale.ROOT, "the recorder's clock, by %.3f s", last - received));
    }
    if (Math.abs(received - last) <= RecordHeader.LONGEST_STEP) {
      startTime = Double.isNaN(endTime) ? last : startTime;
      endTime = received;
    }
    lastTime = received;
    MessageType type = log.type();
    messages[type.ordinal()]++;
    switch (type) {
      case SSL_VISION_2010 -> takeVision(received, false);
      case SSL_VISION_2014 -> takeVision(received, true);
      case SSL_REFBOX_2013 -> takeReferee(received);
      case SSL_VISION_TRACKER_2020 -> takeTracker(received);
      case UNKNOWN -> problem(LogProblem.UNKNOWN_MESSAGE_TYPE, () -> "type " + log.typeCode());
      default -> {
        // Fillers and indices are counted by type; nothing else in them is needed.
        if (RecordingGap.isMark(log)) {
          listener.onLost(received);
        } else if (RecordingOrigin.isSimulationMark(log)) {
          listener.onSimulationMark();
        }
      }
    }
  }

  private void takeVision(double received, boolean hasGeometry) {
    long before = counts.total();
    long[] known = before == 0 ? null : snapshot();
    VisionPacket packet = vision.decode(log.buffer(), log.payloadOffset(), log.payloadLength());
    if (counts.total() != before) {
      reportDecoding(known);
    }
    // The geometry message of 2010 had other fields under the same numbers.
    if (hasGeometry && packet.geometry().isPresent()) {
      takeGeometry(packet.geometry().get());
    }
    if (packet.frame().isPresent()) {
      takeFrame(packet.frame().get(), received);
    }
  }

  private void takeGeometry(FieldGeometry next) {
    // The decoder gives the same object for the same bytes.
    if (next == geometry || next.equals(geometry)) {
      return;
    }
    if (geometry != null && !next.completes(geometry)) {
      FieldGeometry before = geometry;
      problem(LogProblem.GEOMETRY_CHANGED, () -> difference(before, next));
    }
    geometry = next;
    calibrated.clear();
    next.cameras().forEach(camera -> calibrated.set(camera.id()));
    everCalibrated.or(calibrated);
    order.add(next);
  }

  private void takeFrame(VisionFrame frame, double received) {
    if (geometry == null) {
      problem(LogProblem.FRAME_BEFORE_GEOMETRY, () -> "camera " + frame.cameraId());
    } else if (!calibrated.get(frame.cameraId())) {
      takeUncalibrated(frame.cameraId());
    }
    CameraClock clock = clocks[frame.cameraId()];
    if (clock == null) {
      clock = new CameraClock();
      clocks[frame.cameraId()] = clock;
    }
    switch (clock.judge(frame, received)) {
      case GOOD -> {
        if (clock.hasSuspect()) {
          stray(clock.takeSuspect());
        }
        order.add(frame, received);
      }
      case DUPLICATE -> problem(LogProblem.DUPLICATE_FRAME, () -> describe(frame));
      case JUMPED -> jump(clock, frame, received);
      default -> {
        if (clock.hasSuspect()) {
          stray(clock.takeSuspect());
        }
        clock.keepSuspect(frame, received);
      }
    }
  }

  /** Geometry may come one camera at a time, so only the end tells whether a camera is named in it. */
  private void takeUncalibrated(int camera) {
    if (everCalibrated.get(camera)) {
      problem(LogProblem.UNCALIBRATED_CAMERA, () -> "camera " + camera);
    } else {
      unnamed.computeIfAbsent(camera, id -> new Unnamed(offset)).frames++;
    }
  }

  private void reportUnnamed(LogProblem kind, boolean named) {
    List<Integer> ids =
        unnamed.keySet().stream().filter(id -> everCalibrated.get(id) == named).toList();
    String all =
        (ids.size() == 1 ? "camera " : "cameras ")
            + ids.stream().map(String::valueOf).collect(Collectors.joining(", "));
    long first = ids.stream().mapToLong(id -> unnamed.get(id).offset).min().orElse(0);
    long count = ids.stream().mapToLong(id -> unnamed.get(id).frames).sum();
    for (long i = 0; i < count; i++) {
      problems.add(kind, first, () -> all);
    }
  }

  private void jump(CameraClock clock, VisionFrame frame, double received) {
    double suspectReceived = clock.suspectReceived();
    VisionFrame suspect = clock.takeSuspect();
    double jump = clock.jump(suspect, suspectReceived);
    problem(
        jump > 0 ? LogProblem.CLOCK_JUMP_FORWARD : LogProblem.CLOCK_JUMP_BACK,
        () -> String.format(Locale.ROOT, "camera %d, by %.3f s", frame.cameraId(), Math.abs(jump)));
    clock.accept(suspect, suspectReceived, frame, received);
    order.flush();
    listener.onClockJump(frame.cameraId(), jump);
    order.add(suspect, suspectReceived);
    order.add(frame, received);
  }

  private void takeReferee(double received) {
    Optional<RefereeState> state =
        referee.decode(log.buffer(), log.payloadOffset(), log.payloadLength());
    if (state.isPresent()) {
      if (refereeOrder.accept(state.get())) {
        order.add(state.get(), received);
      }
    } else {
      problem(LogProblem.MALFORMED_REFEREE, () -> log.payloadLength() + " bytes");
    }
  }

  private void takeTracker(double received) {
    if (!listener.wantsTrackers()) {
      return;
    }
    Optional<TrackerFrame> frame =
        tracker.decode(log.buffer(), log.payloadOffset(), log.payloadLength());
    if (frame.isPresent()) {
      listener.onTracker(frame.get(), received);
    } else {
      problem(LogProblem.MALFORMED_TRACKER, () -> log.payloadLength() + " bytes");
    }
  }

  private void stray(VisionFrame frame) {
    problem(LogProblem.STRAY_TIME, () -> describe(frame));
  }

  private void problem(LogProblem kind, Supplier<String> detail) {
    problems.add(kind, offset, detail);
  }

  private long[] snapshot() {
    DecodingProblem[] kinds = DecodingProblem.values();
    long[] copy = new long[kinds.length];
    for (DecodingProblem kind : kinds) {
      copy[kind.ordinal()] = counts.of(kind);
    }
    return copy;
  }

  private void reportDecoding(long[] before) {
    for (DecodingProblem kind : DecodingProblem.values()) {
      long known = before == null ? 0 : before[kind.ordinal()];
      for (long i = known; i < counts.of(kind); i++) {
        problems.add(kind, offset, () -> "");
      }
    }
  }

  private RecordingSummary summary() {
    Map<MessageType, Long> byType = new EnumMap<>(MessageType.class);
    for (MessageType type : MessageType.values()) {
      if (messages[type.ordinal()] > 0) {
        byType.put(type, messages[type.ordinal()]);
      }
    }
    return new RecordingSummary(
        epoch,
        startTime,
        Double.isNaN(endTime) ? lastTime : endTime,
        byType,
        frames,
        Optional.ofNullable(geometry),
        log.totalBytes(),
        log.logBytes(),
        problems);
  }

  private static String describe(VisionFrame frame) {
    return String.format(Locale.ROOT, "camera %d, frame %d", frame.cameraId(), frame.frameNumber());
  }

  private static String difference(FieldGeometry before, FieldGeometry after) {
    if (!before.cameras().equals(after.cameras())) {
      return "cameras";
    }
    if (!before.flat().equals(after.flat()) || !before.chip().equals(after.chip())) {
      return "ball models";
    }
    return "field";
  }

  /** Frames of a camera that no geometry has named so far. */
  private static final class Unnamed {
    private final long offset;
    private long frames;

    Unnamed(long offset) {
      this.offset = offset;
    }
  }

  /** Counts frames on their way to the listener. */
  private final class Counter implements RecordingListener {
    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      frames++;
      listener.onFrame(frame, receivedTime);
    }

    @Override
    public void onGeometry(FieldGeometry field) {
      listener.onGeometry(field);
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      listener.onReferee(state, receivedTime);
    }
  }
}
