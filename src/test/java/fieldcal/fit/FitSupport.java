package fieldcal.fit;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.IntPredicate;

/** What the tests of the fit share: problems that start from a published model 15 % off, kicks with parts cut away. */
final class FitSupport {
  static final IdealKicks.Conditions CLEAN = new IdealKicks.Conditions(0.0014, 0, 0);

  /** Of the thousand estimates of a test none should be that far off by chance (5·10⁻⁷ each). */
  static final double FAR = 5;

  private FitSupport() {}

  /** Starts 15 % off; accRoll of chips is known, as from a flat calibration. */
  static FitProblem problem(IdealKicks.Sample s, CameraViews views, SplittableRandom published) {
    return problem(s, s.kick(), views, published);
  }

  static FitProblem problem(
      IdealKicks.Sample s, Kick kick, CameraViews views, SplittableRandom published) {
    if (s.kind() == KickKind.FLAT) {
      FlatModel start = IdealKicks.publishedFlat(s.truth(), published);
      return FitProblem.of(kick, views, start, ChipModel.typical());
    }
    ChipModel start = IdealKicks.publishedChip(s.truth(), published);
    return FitProblem.of(kick, views, FlatModel.typical(), start).withChipRollFixed(s.truth()[9]);
  }

  static KickFit fit(FitProblem problem, KickKind kind) {
    return new KickFitter(FitSettings.defaults()).fit(problem, kind);
  }

  /** Error over reported standard error of every usable estimate. */
  static List<Double> pulls(KickFit fit, double[] truth) {
    List<Double> pulls = new ArrayList<>();
    for (int k = 0; k < truth.length; k++) {
      Estimate e = fit.estimates().get(k);
      if (e.usable()) {
        pulls.add((e.value() - truth[k]) / e.standardError());
      }
    }
    return pulls;
  }

  static void assertRecovered(KickFit fit, IdealKicks.Sample s) {
    assertThat(fit.failure()).isEmpty();
    for (int k = 0; k < s.truth().length; k++) {
      Estimate e = fit.estimates().get(k);
      if (e.usable()) {
        assertThat(Math.abs(e.value() - s.truth()[k]) / e.standardError())
            .as("%s of %s%ntruth %s", e.name(), fit, java.util.Arrays.toString(s.truth()))
            .isLessThan(FAR);
      }
    }
  }

  static Kick with(Kick k, boolean fromRest, Observations observations) {
    return new Kick(
        k.id(),
        k.time(),
        k.x(),
        k.y(),
        k.vx(),
        k.vy(),
        k.robot(),
        fromRest,
        k.end(),
        Math.max(k.time(), observations.time(observations.size() - 1)),
        observations);
  }

  static Kick until(Kick k, double time) {
    return with(k, k.fromRest(), k.observations().between(Double.NEGATIVE_INFINITY, time));
  }

  static Observations pick(Observations all, IntPredicate which) {
    Observations.Builder b = new Observations.Builder();
    for (int i = 0; i < all.size(); i++) {
      if (which.test(i)) {
        b.add(all.time(i), all.camera(i), all.x(i), all.y(i), all.pixelX(i), all.pixelY(i));
      }
    }
    return b.build();
  }

  /** Cameras of which only the position is known, so that nothing depends on the image's axes. */
  static CameraViews positionsOnly(double noise, double[]... positions) {
    List<CameraView> views = new ArrayList<>();
    for (int id = 0; id < positions.length; id++) {
      double[] p = positions[id];
      Camera camera = Camera.ofPosition(id, p[0], p[1], p[2]);
      views.add(CameraView.of(id, Optional.of(camera)).withNoise(noise));
    }
    return CameraViews.of(views);
  }
}
