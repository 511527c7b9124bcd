package fieldcal.app.play;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Average;
import fieldcal.camera.Camera;
import fieldcal.camera.CameraCalibration;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.Estimate;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.OverlapOffsets;
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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

/** Finds the session's kicks in the frames and fits each as soon as its ball is done. Not thread-safe. */
final class LiveFits {
  /** The finder may need that long after the play to see that a ball has stopped, s. */
  private static final double FINDER_LAG = 3;

  /** A kick that was found is the one that was played when they are that near in time, s. */
  private static final double SAME = 0.4;

  /** A fit worse than that, and that many times worse than the others, says that something happened to the ball on its way, mm. */
  private static final double BAD_FIT = 15;

  private static final double WORSE_THAN_OTHERS = 3;

  private static final Map<KickKind, List<String>> PARAMETERS =
      Map.of(
          KickKind.FLAT,
          List.of("accSlide", "accRoll", "kSwitch"),
          KickKind.CHIP,
          List.of("dampingXyFirstHop", "dampingXyOtherHops", "dampingZ"));

  private final KickKind kind;
  private final KickFitter fitter = new KickFitter(FitSettings.defaults());
  private final KickFinder finder = new KickFinder(KickFinderSettings.defaults(), this::found);
  private final List<Kick> kicks = new ArrayList<>();
  private final List<KickResult> results = new ArrayList<>();
  private final Map<Integer, Camera> cameras = new TreeMap<>();
  private final Map<Integer, SeeingCamera> seeing = new TreeMap<>();
  private final Map<Integer, Boolean> seen = new TreeMap<>();
  private FlatModel flat = FlatModel.typical();
  private ChipModel chip = ChipModel.typical();

  LiveFits(KickKind kind) {
    this.kind = kind;
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
    finder.accept(frame);
  }

  private void found(Kick kick) {
    kicks.add(kick.withId(kicks.size() + 1));
  }

  void played(PlayedKick kick) {
    results.add(KickResult.open(kick));
  }

  /** Results that became known; to be called in every tick. */
  List<KickResult> judge(double now) {
    List<KickResult> judged = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      KickResult open = results.get(i);
      if (open.verdict().isPresent()) {
        continue;
      }
      Optional<Kick> kick = kickOf(open.played());
      if (kick.isPresent()) {
        results.set(i, fitted(open.played(), kick.get()));
        judged.add(results.get(i));
      } else if (now - open.played().ended() > FINDER_LAG) {
        results.set(i, bad(open.played(), Optional.empty(), "no kick was found in the detections"));
        judged.add(results.get(i));
      }
    }
    return judged;
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

  private static KickResult bad(PlayedKick played, Optional<KickFit> fit, String reason) {
    return new KickResult(played, fit, Optional.of(false), reason);
  }

  private KickResult fitted(PlayedKick played, Kick kick) {
    List<CameraView> views = new ArrayList<>();
    seen.keySet().forEach(id -> views.add(CameraView.of(id, Optional.ofNullable(cameras.get(id)))));
    CameraViews published = CameraViews.of(views);
    KickFit asPublished = fitter.fit(FitProblem.of(kick, published, flat, chip), kind);
    // Offsets from a handful of kicks may be wrong, of chips above all: they have to prove
    // themselves.
    CameraViews measured = OverlapOffsets.estimate(kicks, published);
    KickFit corrected = fitter.fit(FitProblem.of(kick, measured, flat, chip), kind);
    KickFit fit = better(corrected, asPublished) ? corrected : asPublished;
    Optional<KickFit> there = Optional.of(fit);
    if (fit.failure().isPresent()) {
      return bad(played, there, fit.failure().get());
    }
    if (fit.rmsMm() > Math.max(BAD_FIT, WORSE_THAN_OTHERS * typicalRms())) {
      String how = String.format(Locale.ROOT, "the fit is poor, %.0f mm rms", fit.rmsMm());
      return bad(played, there, how);
    }
    // What a chip's roll is, flat kicks say.
    List<Estimate> needed = fit.modelEstimates().subList(0, 3);
    for (Estimate e : needed) {
      if (!e.usable()) {
        return bad(played, there, "does not determine " + e.name());
      }
    }
    return new KickResult(played, there, Optional.of(true), "");
  }

  private static boolean better(KickFit a, KickFit b) {
    return b.failure().isPresent()
        || a.failure().isEmpty() && a.statistics().meanLoss() < b.statistics().meanLoss();
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

  /** Largest relative standard error of the three parameters; infinite while one is not determined. */
  double precision() {
    Map<String, Average> measured = model();
    double worst = 0;
    for (String name : PARAMETERS.get(kind)) {
      Average a = measured.get(name);
      double relative =
          a == null ? Double.POSITIVE_INFINITY : a.standardError() / Math.abs(a.mean());
      worst = Math.max(worst, relative);
    }
    return worst;
  }

  /** Weighted mean of what the good kicks say. */
  Map<String, Average> model() {
    Map<String, List<Estimate>> all = new LinkedHashMap<>();
    for (KickResult r : results) {
      if (r.good()) {
        r.parameters().forEach(e -> all.computeIfAbsent(e.name(), n -> new ArrayList<>()).add(e));
      }
    }
    Map<String, Average> model = new LinkedHashMap<>();
    all.forEach(
        (name, list) ->
            model.put(
                name,
                Average.of(
                    list.stream().mapToDouble(Estimate::value).toArray(),
                    list.stream().mapToDouble(Estimate::standardError).toArray())));
    return model;
  }
}
