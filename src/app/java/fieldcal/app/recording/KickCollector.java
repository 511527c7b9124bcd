package fieldcal.app.recording;

import fieldcal.app.wording.CameraName;
import fieldcal.app.wording.ClockWords;
import fieldcal.app.wording.LensWords;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.effect.ObservedCamera;
import fieldcal.fit.CameraNoise;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.LensCheck;
import fieldcal.gamelog.ClockComparison;
import fieldcal.gamelog.GameLogException;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.gamelog.RecordingListener;
import fieldcal.gamelog.RecordingReader;
import fieldcal.gamelog.RecordingSummary;
import fieldcal.gamelog.RefereeState;
import fieldcal.gamelog.TrackerFrame;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderCounts;
import fieldcal.kick.KickFinderSettings;
import fieldcal.verdict.VisionFault;
import fieldcal.vision.BallModels;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Reads recordings and finds their kicks.
 *
 * <p>Camera ids repeat from field to field, and a camera may be calibrated again midway. Such a camera is another one for the fit:
 * it gets a number of its own, from 100 on, and the operator is told. Reads once.
 */
public final class KickCollector {
  /** As the search for kicks does: frames that are missing for longer are a gap, s. */
  private static final double GAP = 0.25;

  /** Told how far the reading is. */
  public interface Progress {
    /**
     * Some more was read.
     *
     * @param log which recording
     * @param bytesRead of that file
     * @param totalBytes of that file
     */
    void read(Path log, long bytesRead, long totalBytes);
  }

  private final Progress progress;
  private final LogOpener opener;
  private final RecordingListener beside;
  private final List<Kick> kicks = new ArrayList<>();
  private final Map<Integer, String> sources = new HashMap<>();
  private final Map<Integer, CameraCalibration> calibrations = new TreeMap<>();
  private final Map<Integer, Camera> cameras = new HashMap<>();
  private final Map<Integer, CameraStream> streams = new TreeMap<>();

  /** How many cameras looked at the field together with each. */
  private final Map<Integer, Integer> companions = new HashMap<>();

  /** Which cameras sent frames while each was calibrated as it is; not those of another field, or of a calibration before. */
  private final Map<Integer, Set<Integer>> together = new TreeMap<>();

  private final List<DataProblem> problems = new ArrayList<>();
  private Optional<FieldGeometry> geometry = Optional.empty();
  private BallModels published = BallModels.NONE;
  private Epoch epoch;
  private final List<RecordingFacts> recordings = new ArrayList<>();
  private double sessionStart = Double.NaN;
  private double duration;

  /**
   * A collector.
   *
   * @param progress told how far the reading is
   */
  public KickCollector(Progress progress) {
    this(progress, LogOpener.USUAL);
  }

  /**
   * A collector with a limit of its own.
   *
   * @param progress told how far the reading is
   * @param opener opens the recordings
   */
  public KickCollector(Progress progress, LogOpener opener) {
    this(progress, opener, new RecordingListener() {});
  }

  /**
   * A collector that lets somebody else read along, so that a recording is read once for several purposes.
   *
   * @param progress told how far the reading is
   * @param opener opens the recordings
   * @param beside is told all that the recordings hold, but no progress
   */
  public KickCollector(Progress progress, LogOpener opener, RecordingListener beside) {
    this.progress = progress;
    this.opener = opener;
    this.beside = beside;
  }

  /**
   * Reads the recordings in their order.
   *
   * @param logs at least one
   * @return what was found
   * @throws GameLogException when one cannot be read at all; the message names file and place
   * @throws IOException when a file cannot be closed
   */
  public CollectedKicks collect(List<Path> logs) throws IOException {
    List<RecordingFacts> all = RecordingFacts.of(DifferentRecordings.once(logs, problems), opener);
    DifferentRecordings readable = DifferentRecordings.among(all);
    readable.repeated().forEach(repeated -> problems.add(repeated.problem()));
    for (RecordingFacts facts : readable.different()) {
      Path log = facts.log();
      try (RecordingReader recording =
          epoch == null ? opener.recording(log) : opener.recording(log, epoch)) {
        epoch = recording.epoch();
        OneRecording one = new OneRecording(log);
        RecordingSummary summary = recording.read(one);
        one.finish();
        duration += Double.isFinite(summary.duration()) ? summary.duration() : 0;
        account(log, summary, one);
        recordings.add(facts.showing(one.faults(facts.isSimulated())));
      }
    }
    List<CameraView> views = new ArrayList<>();
    streams
        .keySet()
        .forEach(id -> views.add(CameraView.of(id, Optional.ofNullable(cameras.get(id)))));
    leaveUnusableLensesOut(logs, views);
    CameraNoise.coarseGrids(kicks).forEach((id, step) -> addGrid(logs.get(0), id, step));
    return new CollectedKicks(
        epoch,
        kicks,
        sources,
        CameraViews.of(views),
        streams.keySet().stream().map(this::observer).toList(),
        streams,
        geometry,
        published,
        problems,
        Double.isNaN(sessionStart) ? 0 : sessionStart,
        recordings,
        duration,
        together);
  }

  private void leaveUnusableLensesOut(List<Path> logs, List<CameraView> views) {
    CameraViews published = CameraViews.of(views);
    Map<Integer, Double> unseen = LensCheck.unusable(kicks, published);
    if (unseen.isEmpty()) {
      return;
    }
    views.clear();
    views.addAll(LensCheck.usable(kicks, published).all());
    views.forEach(view -> view.camera().ifPresent(camera -> cameras.put(view.id(), camera)));
    unseen.forEach(
        (id, share) ->
            problems.add(
                new DataProblem(
                    logs.get(0) + ", camera " + id,
                    LensWords.unseen(calibrations.get(id).distortion(), share),
                    1,
                    "only its position is used; calibrate it")));
  }

  private void addGrid(Path log, int camera, double step) {
    problems.add(
        new DataProblem(
            log + ", camera " + camera,
            String.format(
                Locale.ROOT, "the coordinates of its balls are multiples of %.3g mm", 1000 * step),
            1,
            "rounding makes all errors larger; send them as vision measured them"));
  }

  private ObservedCamera observer(int number) {
    int count = companions.getOrDefault(number, 1);
    Camera camera = cameras.get(number);
    return camera == null
        ? ObservedCamera.unknown(number, count)
        : ObservedCamera.of(calibrations.get(number), camera, count).withId(number);
  }

  private void account(Path log, RecordingSummary summary, OneRecording one) {
    ProblemAccount account = summary.problems();
    account.kinds().forEach(kind -> problems.add(DataProblem.of(log, account, kind)));
    if (summary.frames() == 0) {
      problems.add(
          new DataProblem(
              log.toString(),
              "no vision frame in the recording",
              1,
              "record SSL-Vision's multicast, message type 4"));
    } else if (summary.geometry().isEmpty()) {
      problems.add(
          new DataProblem(
              log.toString(),
              "no geometry in the recording",
              1,
              "chips cannot be fitted without camera positions; record some seconds longer"));
    }
    if (one.found == 0 && summary.frames() > 0) {
      problems.add(
          new DataProblem(
              log.toString(), "no kick found", 1, "is the ball seen, and faster than 0.7 m/s?"));
    }
    one.blind()
        .forEach(
            id ->
                problems.add(
                    new DataProblem(
                        log + ", camera " + id,
                        "never saw the ball",
                        1,
                        "nothing to do if no ball came into view")));
    KickFinderCounts counts = one.finder.counts();
    count(
        log,
        counts.deflections(),
        "balls that only bounced off a robot: not kicks",
        "nothing to do");
    count(
        log, counts.carried(), "balls that a robot pushed or dribbled: not kicks", "nothing to do");
    count(
        log,
        counts.tooShort(),
        "kicks that were seen too briefly",
        "let the ball roll on in view of a camera");
    if (!one.isPlaceholder()) {
      one.clocks.forEach((id, clock) -> addClock(log, id, clock));
    }
    one.layout.findings(one.published()).forEach(finding -> addMixedUp(log, finding));
    count(
        log,
        counts.recordingGaps() - one.lostGaps - one.jumps,
        "all cameras silent for more than 0.25 s",
        "kicks around a gap may be cut off");
    count(
        log,
        one.lostGaps,
        "the recorder's machine was busy and lost more than 0.25 s of frames",
        "kicks around a gap may be cut off; close other programs before you record again");
  }

  /** The fit uses the cameras' seconds alone; when they are none, speeds and accelerations are wrong. */
  private void addClock(Path log, int camera, ClockComparison clock) {
    if (clock.ratesDiffer()) {
      String what = "vision's clock " + ClockWords.rate(clock.rate());
      String advice = "if vision's clock is wrong, speeds and accelerations are wrong, too";
      problems.add(new DataProblem(log + ", camera " + camera, what, 1, advice));
    }
  }

  private void addMixedUp(Path log, CameraLayout.Finding finding) {
    String numbers =
        finding.cameras().stream().map(String::valueOf).collect(Collectors.joining(" and "));
    if (finding.swapped()) {
      problems.add(
          new DataProblem(
              log + ", cameras " + numbers,
              "each reports what lies below the other: their numbers are swapped",
              1,
              "give them the numbers of their calibrations, and record again; chips are wrong"));
      return;
    }
    boolean one = finding.cameras().size() == 1;
    problems.add(
        new DataProblem(
            log + (one ? ", camera " : ", cameras ") + numbers,
            (one ? "it is" : "one of them is")
                + " rotated by 180°: what it sees together with another camera is reported"
                + " point-mirrored",
            1,
            "calibrate it again, with the corners of the right half of the field"));
  }

  private void count(Path log, int times, String what, String advice) {
    if (times > 0) {
      problems.add(new DataProblem(log.toString(), what, times, advice));
    }
  }

  /** Feeds the frames of one recording to a kick finder. */
  private final class OneRecording implements RecordingListener {
    private final Path log;
    private final KickFinder finder = new KickFinder(KickFinderSettings.defaults(), this::found);
    private final Map<Integer, Integer> numbers = new HashMap<>();
    private final Map<Integer, Long> ballsBefore = new HashMap<>();

    /** Ids as sent, so that a camera that was calibrated again midway counts once. */
    private final Set<Integer> ids = new HashSet<>();

    private final Set<Integer> seen = new HashSet<>();

    /** The cameras with their calibrations of this moment. */
    private final Set<Integer> current = new TreeSet<>();

    private final CameraLayout layout = new CameraLayout();
    private final Map<Integer, ClockComparison> clocks = new TreeMap<>();
    private int found;

    /** When the frame before was received, and when the recorder last went on after it may have lost frames, s. */
    private double received = Double.NEGATIVE_INFINITY;

    private double lostAt = Double.NaN;

    /** When the frame before was captured, and by how much a camera's clock last jumped forward, s. */
    private double captured = Double.NaN;

    private double forward = Double.NaN;

    /** Gaps that are the recorder's, and those that are jumps of the cameras' clocks. */
    private int lostGaps;

    private int jumps;

    OneRecording(Path log) {
      this.log = log;
      streams.forEach((id, s) -> ballsBefore.put(id, s.balls()));
    }

    /** What makes numbers wrong; a simulator's time may run at any pace, and only its own counts there. */
    List<VisionFault> faults(boolean simulated) {
      List<VisionFault> all = new ArrayList<>();
      List<Integer> off =
          clocks.keySet().stream().filter(c -> clocks.get(c).ratesDiffer()).toList();
      if (!off.isEmpty()) {
        double farthest =
            off.stream()
                .map(c -> clocks.get(c).rate())
                .max(Comparator.comparingDouble(r -> Math.abs(r - 1)))
                .orElseThrow();
        all.add(new VisionFault.ClockRate(off, farthest, simulated || isPlaceholder()));
      }
      layout
          .findings(published())
          .forEach(
              f ->
                  all.add(
                      new VisionFault.MixedUp(
                          List.copyOf(new TreeSet<>(f.cameras())), f.swapped())));
      return all;
    }

    /** Whether none of the published poses is above the field: only a simulator publishes that, and its time need not keep pace with the recorder's clock. */
    boolean isPlaceholder() {
      Map<Integer, Camera> own = published();
      return !own.isEmpty() && own.values().stream().noneMatch(Camera::hasPixels);
    }

    private void found(Kick kick) {
      Kick numbered = kick.withId(kicks.size() + 1);
      kicks.add(numbered);
      sources.put(numbered.id(), log.toString());
      found++;
    }

    @Override
    public boolean wantsTrackers() {
      return beside.wantsTrackers();
    }

    @Override
    public void onTracker(TrackerFrame frame, double receivedTime) {
      beside.onTracker(frame, receivedTime);
    }

    @Override
    public void onGeometry(FieldGeometry next) {
      beside.onGeometry(next);
      if (geometry.isEmpty() || next.completes(geometry.get())) {
        geometry = Optional.of(next);
      }
      FieldGeometry first = geometry.get();
      if (first.length() != next.length() || first.width() != next.width()) {
        problems.add(
            new DataProblem(
                log.toString(),
                "the field differs from that of the previous recording",
                1,
                "a ball model holds for one carpet; calibrate each field on its own"));
      }
      BallModels models = new BallModels(next.flat(), next.chip());
      if (published.equals(BallModels.NONE)) {
        published = models;
      } else if (!models.equals(published) && !models.equals(BallModels.NONE)) {
        problems.add(
            new DataProblem(
                log.toString(),
                "the published model differs from that of the previous recording",
                1,
                "the first one is used for the comparison"));
      }
      Map<Integer, Camera> known = new HashMap<>();
      for (CameraCalibration c : next.cameras()) {
        int number = numberOf(c);
        if (cameras.containsKey(number)) {
          known.put(number, cameras.get(number));
        }
      }
      finder.geometry(next, known);
    }

    /** Positions as published in this recording. */
    Map<Integer, Camera> published() {
      Map<Integer, Camera> own = new TreeMap<>();
      for (int number : numbers.values()) {
        if (cameras.containsKey(number)) {
          own.put(number, cameras.get(number));
        }
      }
      return own;
    }

    private int numberOf(CameraCalibration c) {
      int number = c.id();
      while (calibrations.containsKey(number) && !calibrations.get(number).equals(c)) {
        number = CameraName.next(number);
      }
      if (!calibrations.containsKey(number)) {
        calibrations.put(number, c);
        open(number, c);
      }
      Integer before = numbers.put(c.id(), number);
      boolean another = before == null || before != number;
      if (another) {
        current.remove(before == null ? Integer.valueOf(c.id()) : before);
      }
      if (another && number != c.id()) {
        problems.add(
            new DataProblem(
                log.toString(),
                "camera " + c.id() + " has another calibration than in the previous recording",
                1,
                "it is treated as camera " + number + " here"));
      }
      return number;
    }

    private void open(int number, CameraCalibration c) {
      Optional<Camera> usable = Optional.empty();
      try {
        usable = Optional.of(Camera.of(c));
      } catch (IllegalArgumentException unusable) {
        // Why not is said below.
      }
      usable.ifPresent(camera -> cameras.put(number, camera));
      String advice =
          usable.isEmpty()
              ? "its view of flying balls cannot be used; calibrate the camera"
              : usable.get().hasPixels()
                  ? "calibrate the camera"
                  : "on a real field, calibrate the camera; a simulator often publishes"
                      + " placeholders, and then there is nothing to do";
      Camera.faultOf(c)
          .ifPresent(
              fault -> problems.add(new DataProblem(log + ", camera " + number, fault, 1, advice)));
    }

    @Override
    public void onFrame(VisionFrame frame, double receivedTime) {
      beside.onFrame(frame, receivedTime);
      int number = numbers.getOrDefault(frame.cameraId(), frame.cameraId());
      VisionFrame known = number == frame.cameraId() ? frame : renumbered(frame, number);
      // The recordings of a session may be named in any order.
      sessionStart =
          Double.isNaN(sessionStart)
              ? frame.captureTime()
              : Math.min(sessionStart, frame.captureTime());
      ids.add(frame.cameraId());
      seen.add(number);
      if (current.add(number)) {
        current.forEach(id -> together.computeIfAbsent(id, key -> new TreeSet<>()).addAll(current));
      }
      streams.computeIfAbsent(number, id -> new CameraStream()).accept(known);
      layout.accept(known);
      int gaps = finder.counts().recordingGaps();
      finder.accept(known);
      if (finder.counts().recordingGaps() > gaps) {
        gap(frame.captureTime() - captured, receivedTime);
      }
      captured = frame.captureTime();
      received = receivedTime;
      clocks
          .computeIfAbsent(frame.cameraId(), id -> new ClockComparison())
          .add(frame.captureTime(), receivedTime);
    }

    /** Whose gap it is: the recorder's, that of a clock that jumped, or else that of vision. */
    private void gap(double length, double receivedTime) {
      if (lostAt <= receivedTime && lostAt >= received) {
        lostGaps++;
      } else if (Math.abs(length - forward) < GAP) {
        jumps++;
      }
    }

    @Override
    public void onLost(double receivedTime) {
      beside.onLost(receivedTime);
      lostAt = receivedTime;
    }

    @Override
    public void onReferee(RefereeState state, double receivedTime) {
      beside.onReferee(state, receivedTime);
    }

    @Override
    public void onClockJump(int cameraId, double jump) {
      beside.onClockJump(cameraId, jump);
      forward = jump;
      clocks.computeIfAbsent(cameraId, id -> new ClockComparison()).jumped();
    }

    private VisionFrame renumbered(VisionFrame f, int number) {
      return new VisionFrame(
          number,
          f.frameNumber(),
          f.captureTime(),
          f.sentTime(),
          f.cameraClockTime(),
          f.balls(),
          f.robots());
    }

    @Override
    public void onProgress(long bytesRead, long totalBytes) {
      progress.read(log, bytesRead, totalBytes);
    }

    void finish() {
      finder.finish();
      seen.forEach(number -> companions.merge(number, ids.size(), Math::max));
    }

    List<Integer> blind() {
      return streams.entrySet().stream()
          .filter(e -> e.getValue().balls() == ballsBefore.getOrDefault(e.getKey(), 0L))
          .filter(e -> numbers.isEmpty() || numbers.containsValue(e.getKey()))
          .map(Map.Entry::getKey)
          .toList();
    }
  }
}
