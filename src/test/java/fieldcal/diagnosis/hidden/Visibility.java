package fieldcal.diagnosis.hidden;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectModel;
import fieldcal.diagnosis.model.Effort;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelFitter;
import fieldcal.diagnosis.model.MovingNoise;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.fit.joint.SharedSolver;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.ImpactLaw;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.Truth;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * How much of what is hidden there is to see: the same world without noise and trouble, and what the simple model, fitted jointly, leaves of it, in units of the noise that the diagnosis has to cope
 * with. Independent noise of σ and a systematic part of s·σ make a residual of σ·√(1+s²).
 *
 * @param left what the simple model cannot absorb, root mean square, σ
 * @param leftWithOffsets the same when each camera may also have an offset, σ
 * @param kicks how many kicks it is measured on
 */
public record Visibility(double left, double leftWithOffsets, int kicks) {
  /** From there on an effect is clear, σ. */
  public static final double CLEAR = 1;

  /** From there on it is marginal, σ. */
  public static final double MARGINAL = 0.2;

  /** Kicks of truth and vision within that are the same, s. */
  private static final double SAME = 0.08;

  /** Detections so near the end of a flight may be of something else, s. */
  private static final double END = 0.03;

  /** Damping along the carpet after the first impact of a contact, between the second's 0.91 to 0.95 and later ones' 0.975 and more (–). */
  private static final double LATER_IMPACTS_OF_A_CONTACT = 0.95;

  /** A kick that fits so much worse on its own than the others has too many hops or too few, σ. */
  private static final double WRONG_MINIMUM = 6;

  /** How well an effect can be seen. */
  public enum Class {
    /** The right model lowers the residuals by a σ or more. */
    CLEAR,
    /** By at least a fifth of that. */
    MARGINAL,
    /** By less. */
    INVISIBLE
  }

  /**
   * Measures a case.
   *
   * @param hidden the case
   * @return how visible all of its effects together are
   */
  public static Visibility of(HiddenCase hidden) {
    return of(hidden, hidden.hidden());
  }

  /**
   * Measures some effects in the world of a case.
   *
   * @param hidden the case
   * @param effects which
   * @return how visible they are together
   */
  public static Visibility of(HiddenCase hidden, List<EffectSetting> effects) {
    SimulationSettings settings = hidden.settingsWith(effects);
    CameraSettings cameras = settings.cameras();
    SeenKicks seen =
        SeenKicks.of(
            settings
                .withCameras(cameras.withNoise(0, cameras.robotNoise()))
                .withNuisance(Nuisance.NONE));
    CameraViews views =
        CameraViews.of(
            seen.cameras().values().stream()
                .map(c -> new CameraView(c.id(), Optional.of(c), 0, 0, cameras.ballNoise()))
                .toList());
    // Nothing is an outlier here: what does not fit is what is to be measured.
    FitSettings all = new FitSettings(1, 350, 72, 1e4, 2.4);
    List<KickFit> fits =
        withoutWrongMinima(
            fits(seen, views, new KickFitter(all)), 1000 * WRONG_MINIMUM * cameras.ballNoise());
    if (fits.isEmpty()) {
      return new Visibility(0, 0, 0);
    }
    return new Visibility(
        left(fits, seen, views, false), left(fits, seen, views, true), fits.size());
  }

  private static List<KickFit> fits(SeenKicks seen, CameraViews views, KickFitter fitter) {
    Truth truth = seen.truth();
    List<KickFit> fits = new ArrayList<>();
    for (KickTruth t : truth.commandedKicks()) {
      Optional<Kick> found =
          seen.kicks().stream().filter(k -> Math.abs(k.time() - t.time()) < SAME).findFirst();
      if (found.isPresent()) {
        Kick kick = until(found.get(), t.time() + t.duration() - END);
        KickKind kind =
            t.kind() == fieldcal.simulation.truth.KickKind.CHIP ? KickKind.CHIP : KickKind.FLAT;
        KickFit fit = fitter.fit(FitProblem.of(kick, views, flatOf(truth), chipOf(truth)), kind);
        if (fit.failure().isEmpty()) {
          fits.add(fit);
        }
      }
    }
    return fits;
  }

  /** What the simple model would be without effects: the best start of a search for hops. */
  private static FlatModel flatOf(Truth truth) {
    BallPhysics physics = truth.settings().physics();
    return new FlatModel(
        -physics.ground().slidingFriction() * BallPhysics.GRAVITY,
        -physics.ground().rollingDeceleration(),
        1 / (1 + physics.ball().inertiaFactor()));
  }

  private static ChipModel chipOf(Truth truth) {
    BallPhysics physics = truth.settings().physics();
    double first;
    double other;
    if (physics.impact().tangential() instanceof ImpactLaw.FixedLoss loss) {
      first = loss.firstHop();
      other = loss.otherHops();
    } else {
      // A contact takes this share of a velocity that is all slip, and little later.
      ImpactLaw.Contact contact = (ImpactLaw.Contact) physics.impact().tangential();
      double beta = physics.ball().inertiaFactor();
      first = 1 - (1 + contact.restitution()) * beta / (1 + beta);
      other = LATER_IMPACTS_OF_A_CONTACT;
    }
    return new ChipModel(
        first,
        other,
        physics.impact().dampingZOtherHops(),
        -physics.ground().rollingDeceleration());
  }

  private static List<KickFit> withoutWrongMinima(List<KickFit> fits, double limitMm) {
    double[] sorted = fits.stream().mapToDouble(KickFit::rmsMm).sorted().toArray();
    double median = sorted.length == 0 ? 0 : sorted[sorted.length / 2];
    return fits.stream().filter(f -> f.rmsMm() < 3 * median + limitMm).toList();
  }

  private static Kick until(Kick k, double time) {
    double end = Math.max(k.time(), Math.min(k.endTime(), time));
    Observations some = k.observations().between(Double.NEGATIVE_INFINITY, end);
    return new Kick(
        k.id(),
        k.time(),
        k.x(),
        k.y(),
        k.vx(),
        k.vy(),
        k.robot(),
        k.fromRest(),
        k.end(),
        end,
        some);
  }

  /** What a joint fit of the kicks leaves, all of them with the same ball: a scatter from kick to kick would hide what changes over the session. */
  private static double left(
      List<KickFit> fits, SeenKicks seen, CameraViews views, boolean offsets) {
    List<KickRecord> records =
        fits.stream()
            .map(
                f -> {
                  boolean[] all = new boolean[f.kick().observations().size()];
                  Arrays.fill(all, true);
                  return new KickRecord(f, all, new MovingNoise(views, 0, 0, 0));
                })
            .toList();
    List<ObservedCamera> observers =
        seen.geometry().cameras().stream()
            .map(
                c ->
                    ObservedCamera.of(
                        c, seen.cameras().get(c.id()), seen.geometry().cameras().size()))
            .toList();
    EffectModel model =
        EffectModel.simple(
            flatOf(seen.truth()),
            chipOf(seen.truth()),
            fits.stream().anyMatch(f -> f.kind() == KickKind.FLAT),
            fits.stream().anyMatch(f -> f.kind() == KickKind.CHIP),
            observers);
    if (offsets) {
      model =
          model.with(
              observers.stream()
                  .map(c -> new CameraOffset(0, 0, c.id()))
                  .map(e -> Component.of(e, e.magnitudes()))
                  .toList());
    }
    FittedModel fit =
        new ModelFitter(records, seen.firstFrame(), new Effort(Long.MAX_VALUE), fitted -> {})
            .fit(model, SharedSolver.withDefaults().settlingVariants());
    return rms(fit);
  }

  /** In standard deviations of the noise. */
  private static double rms(FittedModel fit) {
    double squares = 0;
    int rows = 0;
    for (int k = 0; k < fit.kickCount(); k++) {
      KickRecord record = fit.kick(k).record();
      double[] rx = new double[record.size()];
      double[] ry = new double[record.size()];
      fit.kick(k).plainResiduals(fit.solution().own(k), fit.solution().state(), rx, ry);
      for (int i = 0; i < rx.length; i++) {
        squares += (rx[i] * rx[i] + ry[i] * ry[i]) / record.variance(i);
        rows += 2;
      }
    }
    return Math.sqrt(squares / rows);
  }

  /**
   * What there is to see beyond something else.
   *
   * @param less of the same without the effect that is asked for
   * @return the difference of the squares, as of independent parts
   */
  Visibility beyond(Visibility less) {
    return new Visibility(
        Math.sqrt(Math.max(0, left * left - less.left * less.left)),
        Math.sqrt(
            Math.max(
                0,
                leftWithOffsets * leftWithOffsets - less.leftWithOffsets * less.leftWithOffsets)),
        kicks);
  }

  /**
   * By how much the right model lowers the residuals.
   *
   * @return σ
   */
  public double gain() {
    return gain(left);
  }

  /**
   * The same against a model that already has an offset for each camera.
   *
   * @return σ
   */
  public double gainBeyondOffsets() {
    return gain(leftWithOffsets);
  }

  private static double gain(double s) {
    return Math.sqrt(1 + s * s) - 1;
  }

  /**
   * The class.
   *
   * @return by {@link #gain}
   */
  public Class level() {
    return gain() >= CLEAR ? Class.CLEAR : gain() >= MARGINAL ? Class.MARGINAL : Class.INVISIBLE;
  }
}
