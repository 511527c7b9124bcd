package fieldcal.app.play;

import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Average;
import fieldcal.calibration.CalibratedKick;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.Calibrator;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayedKick;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/** Finds the session's kicks in the frames and fits each as soon as its ball is done. Not thread-safe. */
final class LiveFits {
  /** The finder may need that long after the play to see that a ball has stopped, s. */
  private static final double FINDER_LAG = 3;

  /** A kick that was found is the one that was played when they are that near in time, s. */
  private static final double SAME = 0.4;

  private static final String NOT_FOUND = "no kick was found in the detections";

  /** Offsets that moved by less need no new fits: a quarter of the noise of good cameras, m. */
  private static final double MOVED = 3e-4;

  /** m/s². */
  private static final double GRAVITY = 9.81;

  /** Fewer kicks do not show what differs from kick to kick. */
  static final int FEWEST = 6;

  private static final Map<KickKind, List<String>> PARAMETERS =
      Map.of(
          KickKind.FLAT,
          List.of("accSlide", "accRoll", "kSwitch"),
          KickKind.CHIP,
          List.of("dampingXyFirstHop", "dampingXyOtherHops", "dampingZ"));

  private final KickKind kind;
  private final long seed;
  private final KickFitter fitter;
  private final KickFinder finder = new KickFinder(KickFinderSettings.defaults(), this::found);
  private final List<Kick> kicks = new ArrayList<>();
  private final List<KickResult> results = new ArrayList<>();
  private final Map<Integer, Kick> found = new TreeMap<>();
  private final Map<Integer, KickFit> fits = new TreeMap<>();
  private final FlightWatch flight = new FlightWatch();
  private final List<KickResult> missed = new ArrayList<>();
  private final Executor executor;

  /** What is being fitted; null while nothing is. */
  private CompletableFuture<Done> running;

  private CameraViews fittedWith;
  private double newest = Double.NEGATIVE_INFINITY;
  private boolean ended;
  private boolean pending;
  private Map<String, Average> averages = Map.of();
  private Map<String, Double> precisions = Map.of();
  private final Map<Integer, Camera> cameras = new TreeMap<>();
  private final Map<Integer, SeeingCamera> seeing = new TreeMap<>();
  private final Map<Integer, Boolean> seen = new TreeMap<>();
  private FlatModel flat = FlatModel.typical();
  private ChipModel chip = ChipModel.typical();

  /** Fits are made by an executor: at once, or beside the play, whose robots must not wait for them. */
  LiveFits(KickKind kind, long seed, Executor executor) {
    this.executor = executor;
    this.kind = kind;
    this.seed = seed;
    fitter = new KickFitter(FitSettings.defaults().withSeed(seed));
  }

  void geometry(FieldGeometry geometry) {
    Map<Integer, Camera> now = new HashMap<>();
    for (CameraCalibration c : geometry.cameras()) {
      try {
        Camera camera = Camera.of(c);
        now.put(c.id(), camera);
        seeing.put(c.id(), new SeeingCamera(camera, c.imageWidth(), c.imageHeight()));
      } catch (IllegalArgumentException unusable) {
        // The calibration at the end names it; chips seen by it alone will not count.
        cameras.remove(c.id());
        seeing.remove(c.id());
      }
    }
    cameras.putAll(now);
    geometry.flat().ifPresent(m -> flat = m);
    geometry.chip().ifPresent(m -> chip = m);
    finder.geometry(geometry, now);
  }

  void accept(VisionFrame frame) {
    seen.put(frame.cameraId(), true);
    newest = Math.max(newest, frame.captureTime());
    flight.accept(frame);
    finder.accept(frame);
  }

  /** No more frames come: what is not found by now never will be. */
  void end() {
    if (!ended) {
      ended = true;
      finder.finish();
    }
  }

  /** Whether a judgement may still change without another frame. */
  boolean isOpen() {
    return running != null || pending || results.stream().anyMatch(r -> r.verdict().isEmpty());
  }

  private void found(Kick kick) {
    kicks.add(kick.withId(kicks.size() + 1));
  }

  void played(PlayedKick kick) {
    results.add(KickResult.open(kick));
  }

  /**
   * Results that became known or changed; to be called in every tick. A kick that was not found by some time after it is not waited for any longer: by the time of the frames, since while vision is silent nothing is
   * found. A kick is judged again with every kick that follows, as a calibration would judge it: the first ones were fitted before anybody
   * knew by how much the cameras disagree.
   */
  List<KickResult> judge() {
    boolean fresh = false;
    for (int i = 0; i < results.size(); i++) {
      KickResult open = results.get(i);
      if (open.verdict().isEmpty() && !found.containsKey(open.played().number())) {
        Optional<Kick> kick = kickOf(open.played());
        if (kick.isPresent()) {
          found.put(open.played().number(), kick.get());
          fresh = true;
        } else if (ended || newest - open.played().ended() > FINDER_LAG) {
          results.set(i, bad(open.played(), NOT_FOUND));
          missed.add(results.get(i));
        }
      }
    }
    List<KickResult> changed = new ArrayList<>(missed);
    missed.clear();
    pending |= fresh;
    if (pending && running == null) {
      begin();
    }
    if (running != null && running.isDone()) {
      CompletableFuture<Done> ready = running;
      running = null;
      changed.addAll(take(of(ready)));
    }
    return changed;
  }

  private Optional<Kick> kickOf(PlayedKick played) {
    Kick best = null;
    for (Kick kick : kicks) {
      double off = Math.abs(kick.time() - played.time());
      boolean his = kick.robot().map(played.robot()::equals).orElse(true);
      if (his && off < SAME && (best == null || off < Math.abs(best.time() - played.time()))) {
        best = kick;
      }
    }
    return Optional.ofNullable(best);
  }

  private KickResult bad(PlayedKick played, String reason) {
    Optional<String> out = outOfView(played);
    return new KickResult(
        played, Optional.empty(), Optional.of(false), out.orElse(reason), false, out.isPresent());
  }

  /** Why nothing better came of a chip: no camera saw it over a part of its flight. */
  private Optional<String> outOfView(PlayedKick played) {
    if (!played.planned().chip()) {
      return Optional.empty();
    }
    double up = played.planned().speed() * Math.sin(played.planned().elevation());
    double flies = 2 * up / GRAVITY / (1 - chip.dampingZ());
    return flight
        .between(played.time() - PlaySession.NOTICED, played.time() + flies)
        .map(
            gap ->
                String.format(
                    Locale.ROOT,
                    "the ball flew out of the images of all cameras: not seen from %.2f s to %.2f s"
                        + " after the kick",
                    gap.from() - played.time(),
                    gap.to() - played.time()));
  }

  /** What is fitted, without anything that changes meanwhile. */
  private record Work(
      Map<Integer, Kick> kicks,
      Map<Integer, KickFit> fits,
      Optional<CameraViews> fittedWith,
      CameraViews published,
      FlatModel flat,
      ChipModel chip) {}

  /** What came of it. */
  private record Done(
      Map<Integer, KickFit> fits,
      CameraViews fittedWith,
      Calibration judged,
      Map<String, Double> precisions) {}

  private void begin() {
    List<CameraView> views = new ArrayList<>();
    seen.keySet().forEach(id -> views.add(CameraView.of(id, Optional.ofNullable(cameras.get(id)))));
    Work work =
        new Work(
            new TreeMap<>(found),
            new TreeMap<>(fits),
            Optional.ofNullable(fittedWith),
            CameraViews.of(views),
            flat,
            chip);
    pending = false;
    running = CompletableFuture.supplyAsync(() -> fitAll(work), executor);
  }

  /** What came of it; what was thrown there is thrown here, errors of the machine too, since nothing would come any more. */
  private static Done of(CompletableFuture<Done> ready) {
    try {
      return ready.join();
    } catch (CompletionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw e.getCause() instanceof RuntimeException cause ? cause : e;
    }
  }

  /** New kicks are fitted, and the earlier ones again when the cameras are known better now. */
  private Done fitAll(Work work) {
    CameraViews measured =
        Calibrator.measured(List.copyOf(work.kicks().values()), work.published());
    boolean anew = work.fittedWith().isEmpty() || moved(work.fittedWith().get(), measured) > MOVED;
    CameraViews views = anew ? measured : work.fittedWith().get();
    Map<Integer, KickFit> made = work.fits();
    for (Map.Entry<Integer, Kick> entry : work.kicks().entrySet()) {
      KickFit before = made.get(entry.getKey());
      FitProblem problem = FitProblem.of(entry.getValue(), views, work.flat(), work.chip());
      if (before == null || anew && before.failure().isPresent()) {
        // What the kick is, the detections say, as they do when the recording is calibrated.
        made.put(entry.getKey(), fitter.fit(problem));
      } else if (anew) {
        made.put(entry.getKey(), fitter.refit(problem, before));
      }
    }
    Calibration judged = Calibrator.judged(List.copyOf(made.values()), views, seed);
    Map<String, Double> known = new HashMap<>();
    PARAMETERS.get(kind).forEach(name -> known.put(name, judged.leastPrecision(kind, name)));
    return new Done(made, views, judged, known);
  }

  private List<KickResult> take(Done ready) {
    fits.putAll(ready.fits());
    fittedWith = ready.fittedWith();
    precisions = ready.precisions();
    return judgeAll(ready.judged());
  }

  /** By how much offsets differ, m; a camera that was not known before is new. */
  private static double moved(CameraViews from, CameraViews to) {
    Map<Integer, CameraView> old = new HashMap<>();
    from.all().forEach(v -> old.put(v.id(), v));
    double most = 0;
    for (CameraView v : to.all()) {
      CameraView o = old.get(v.id());
      double off =
          o == null
              ? Double.POSITIVE_INFINITY
              : Math.hypot(v.offsetX() - o.offsetX(), v.offsetY() - o.offsetY());
      most = Math.max(most, off);
    }
    return most;
  }

  private List<KickResult> judgeAll(Calibration judged) {
    averages = kind == KickKind.FLAT ? judged.flat() : judged.chip();
    Map<Kick, CalibratedKick> byKick = new IdentityHashMap<>();
    judged.kicks().forEach(k -> byKick.put(k.fit().kick(), k));
    List<KickResult> changed = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      KickResult before = results.get(i);
      KickFit fit = fits.get(before.played().number());
      if (fit != null) {
        CalibratedKick kick = byKick.get(fit.kick());
        String reason = reason(kick);
        boolean good = reason.isEmpty();
        Optional<String> out = good ? Optional.empty() : outOfView(before.played());
        KickResult now =
            new KickResult(
                before.played(),
                Optional.of(kick.fit()),
                Optional.of(good),
                out.orElse(reason),
                kick.selected(),
                out.isPresent());
        results.set(i, now);
        if (!before.verdict().equals(now.verdict()) || before.outOfView() != now.outOfView()) {
          changed.add(now);
        }
      }
    }
    return changed;
  }

  /** Why a kick does not count; empty when it does. */
  private String reason(CalibratedKick kick) {
    if (kick.fit().failure().isEmpty() && kick.fit().kind() != kind) {
      return kind == KickKind.CHIP
          ? "the ball did not fly: a flat kick, not a chip"
          : "the ball flew: a chip, not a flat kick";
    }
    if (kick.rejected().isPresent()) {
      return ParameterWords.spelledOut(kick.rejected().get());
    }
    // What a chip's roll is, flat kicks say.
    for (Estimate e : kick.fit().modelEstimates().subList(0, 3)) {
      if (e.atBound() && e.undetermined().isEmpty()) {
        return String.format(
            Locale.ROOT,
            "its %s is at a bound of the search (%s%s)",
            ParameterWords.of(e.name()),
            Amount.minus(String.format(Locale.ROOT, "%.3g", e.value())),
            e.parameter().unit().isEmpty() ? "" : " " + e.parameter().unit());
      }
      if (!e.usable()) {
        return "does not determine the " + ParameterWords.of(e.name());
      }
    }
    return "";
  }

  private double typicalRms() {
    double[] all =
        results.stream().mapToDouble(KickResult::rmsMm).filter(Double::isFinite).sorted().toArray();
    return all.length == 0 ? 0 : all[all.length / 2];
  }

  List<KickResult> results() {
    return List.copyOf(results);
  }

  /** The three parameters as far as they are known: measured, else published, else typical. */
  double[] current() {
    double[] values =
        kind == KickKind.FLAT
            ? new double[] {flat.accSlide(), flat.accRoll(), flat.kSwitch()}
            : new double[] {chip.dampingXyFirstHop(), chip.dampingXyOtherHops(), chip.dampingZ()};
    Map<String, Average> measured = model();
    for (int i = 0; i < 3; i++) {
      Average a = measured.get(PARAMETERS.get(kind).get(i));
      values[i] = a == null ? values[i] : a.mean();
    }
    return values;
  }

  /** What the good kicks together tell of the three parameters, as an information matrix. */
  RealMatrix information() {
    RealMatrix sum = MatrixUtils.createRealMatrix(3, 3);
    for (KickResult r : results) {
      if (r.good()) {
        KickFit fit = r.fit().orElseThrow();
        int first = fit.estimates().size() - fit.modelEstimates().size();
        RealMatrix covariance = MatrixUtils.createRealMatrix(3, 3);
        for (int i = 0; i < 3; i++) {
          for (int j = 0; j < 3; j++) {
            covariance.setEntry(i, j, fit.covariance(first + i, first + j));
          }
        }
        sum = sum.add(KickInformation.inverse(covariance));
      }
    }
    return sum;
  }

  /** Cameras whose place is known. */
  Collection<SeeingCamera> cameras() {
    return List.copyOf(seeing.values());
  }

  /** Noise of a detection, from the kicks so far, m. */
  double noise() {
    double rms = typicalRms();
    return rms > 0 ? rms / 1000 : CameraView.DEFAULT_NOISE;
  }

  /**
   * Largest relative standard error of the three parameters, whichever kick is left out. Infinite while one is not determined, and while there are too few kicks to see what differs from kick to kick: {@link #FEWEST}, of both
   * robots, slow, middling and fast.
   *
   * @param slowest of the kicks that are wanted, m/s
   * @param fastest m/s
   */
  double precision(double slowest, double fastest) {
    int fewest = Integer.MAX_VALUE;
    for (int third = 0; third < 3; third++) {
      fewest = Math.min(fewest, goodOf(third, slowest, fastest));
    }
    List<KickResult> good = results.stream().filter(KickResult::good).toList();
    long robots = good.stream().map(r -> r.played().robot()).distinct().count();
    if (good.size() < FEWEST || robots < 2 || fewest == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double worst = 0;
    for (String name : PARAMETERS.get(kind)) {
      worst = Math.max(worst, precisions.getOrDefault(name, Double.POSITIVE_INFINITY));
    }
    return worst;
  }

  /** How many good kicks there are in a third of the range of speeds, 0 the slowest. */
  int goodOf(int third, double slowest, double fastest) {
    double width = (fastest - slowest) / 3;
    return (int)
        results.stream()
            .filter(KickResult::good)
            .filter(
                r ->
                    width == 0
                        || third
                            == Math.max(
                                0,
                                Math.min(
                                    2, (int) ((r.played().planned().speed() - slowest) / width))))
            .count();
  }

  /** How many good kicks there are. */
  int good() {
    return (int) results.stream().filter(KickResult::good).count();
  }

  /** Means of what the good kicks say, as a calibration takes them. */
  Map<String, Average> model() {
    Map<String, Average> known = new LinkedHashMap<>();
    averages.forEach(
        (name, average) -> {
          if (average.n() > 0) {
            known.put(name, average);
          }
        });
    return known;
  }
}
