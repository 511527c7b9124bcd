package fieldcal.fit;

import fieldcal.ball.BallTrajectory;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/**
 * The answer to a {@link FitProblem}.
 *
 * <p>The covariance assumes that residuals are independent between detections, and scales the cameras' noise by what the
 * residuals of this kick show. It covers the free unknowns; rows and columns of others are zero. Parameters that the kick did not
 * determine were tied to their start with a standard deviation of one scale, so that the errors of the other parameters include their uncertainty. Errors of chips whose bounces may differ from each other are those of {@link #withUnevenBounces}.
 */
public final class KickFit {
  private final Kick kick;
  private final KickKind kind;
  private final String failure;
  private final List<Estimate> estimates;
  private final double[][] covariance;
  private final BallTrajectory trajectory;
  private final double[] residualX;
  private final double[] residualY;
  private final boolean[] used;
  private final FitStatistics statistics;
  private final UnevenBounces bounces;

  KickFit(
      Kick kick,
      KickKind kind,
      List<Estimate> estimates,
      double[][] covariance,
      BallTrajectory trajectory,
      double[] residualX,
      double[] residualY,
      boolean[] used,
      FitStatistics statistics) {
    this(
        kick,
        kind,
        estimates,
        covariance,
        trajectory,
        residualX,
        residualY,
        used,
        statistics,
        UnevenBounces.NONE);
  }

  private KickFit(
      Kick kick,
      KickKind kind,
      List<Estimate> estimates,
      double[][] covariance,
      BallTrajectory trajectory,
      double[] residualX,
      double[] residualY,
      boolean[] used,
      FitStatistics statistics,
      UnevenBounces bounces) {
    this.kick = kick;
    this.kind = kind;
    this.failure = null;
    this.estimates = List.copyOf(estimates);
    this.covariance = covariance;
    this.trajectory = trajectory;
    this.residualX = residualX;
    this.residualY = residualY;
    this.used = used;
    this.statistics = statistics;
    this.bounces = bounces;
  }

  private KickFit(Kick kick, KickKind kind, String failure, FitStatistics statistics) {
    this.kick = kick;
    this.kind = kind;
    this.failure = Objects.requireNonNull(failure, "failure");
    this.estimates = List.of();
    this.covariance = new double[0][0];
    this.trajectory = null;
    this.residualX = new double[0];
    this.residualY = new double[0];
    this.used = new boolean[0];
    this.statistics = statistics;
    this.bounces = UnevenBounces.NONE;
  }

  /** The same fit with larger errors, and how the bounces of the chip may differ from each other. */
  KickFit with(double[][] moreCovariance, UnevenBounces uneven) {
    double[][] all = new double[covariance.length][];
    List<Estimate> wider = new ArrayList<>();
    for (int i = 0; i < all.length; i++) {
      all[i] = covariance[i].clone();
      for (int j = 0; j < all.length; j++) {
        all[i][j] += moreCovariance[i][j];
      }
      Estimate e = estimates.get(i);
      double error = Math.sqrt(all[i][i]);
      wider.add(
          e.standardError() > 0
              ? new Estimate(e.parameter(), error, e.undetermined(), e.atBound())
              : e);
    }
    return new KickFit(
        kick, kind, wider, all, trajectory, residualX, residualY, used, statistics, uneven);
  }

  /**
   * The same fit with errors that cover bounces which differ from each other: the horizontal damping of each bounce after the first differs from the kick's mean by a normal scatter, as it does when the ball spins. Values stay. A fit to
   * which that does not apply stays as it is: a flat kick, a chip with fewer than two such bounces.
   *
   * @param cameras with which it was made
   * @param scatter from bounce to bounce, standard deviation, 0 or more (–)
   * @return the fit; a joint fit of it estimates the deviations, too
   */
  public KickFit withUnevenBounces(CameraViews cameras, double scatter) {
    return UnevenBounces.cover(this, cameras, scatter);
  }

  /** The same fit of a chip whose bounces are all alike. */
  KickFit withEvenBounces() {
    return failure != null
        ? this
        : new KickFit(
            kick, kind, estimates, covariance, trajectory, residualX, residualY, used, statistics);
  }

  /** How the bounces of a chip may differ from each other. */
  UnevenBounces bounces() {
    return bounces;
  }

  static KickFit failed(Kick kick, KickKind kind, String reason, long seed) {
    return new KickFit(kick, kind, reason, FitStatistics.none(seed));
  }

  /**
   * The kick that was fitted.
   *
   * @return as in the problem
   */
  public Kick kick() {
    return kick;
  }

  /**
   * Which model was fitted; of a fit that failed, the one that was tried.
   *
   * @return flat or chip, never null
   */
  public KickKind kind() {
    return kind;
  }

  /**
   * Why there is no fit.
   *
   * @return empty when there is one; otherwise all lists and arrays are empty
   */
  public Optional<String> failure() {
    return Optional.ofNullable(failure);
  }

  /**
   * All unknowns in the order of the trajectory's sensitivities: x, y (m), vx, vy, of chips also vz (m/s), and t0 (s since the recording's epoch) of the kick in the field frame, then the model's parameters.
   *
   * @return unmodifiable; flat kicks have 8, chips 10; empty when the fit failed
   */
  public List<Estimate> estimates() {
    return estimates;
  }

  /**
   * The parameters of the model only.
   *
   * @return unmodifiable, in the order of the model's record
   */
  public List<Estimate> modelEstimates() {
    return estimates.isEmpty()
        ? estimates
        : estimates.subList(FlightLayout.kickSize(kind), estimates.size());
  }

  /**
   * One unknown.
   *
   * @param name as in the model's record (accSlide, not acc_slide), or x, y, vx, vy, vz, t0
   * @return the estimate, its value and error in SI units
   * @throws IllegalArgumentException when there is none of that name: always when the fit failed, and for vz of a flat kick
   */
  public Estimate estimate(String name) {
    for (Estimate e : estimates) {
      if (e.name().equals(name)) {
        return e;
      }
    }
    throw new IllegalArgumentException(
        "no parameter " + name + " in a fit of a " + kind.id() + " kick");
  }

  /**
   * Values of all unknowns.
   *
   * @return a new array in the order and the units of {@link #estimates()}; empty when the fit failed
   */
  public double[] values() {
    return estimates.stream().mapToDouble(Estimate::value).toArray();
  }

  /**
   * Covariance of two unknowns; symmetric, the variance where i = j.
   *
   * @param i index into {@link #estimates()}
   * @param j index into {@link #estimates()}
   * @return in the product of their units; 0 when one of the two was fixed
   * @throws ArrayIndexOutOfBoundsException when there is no such unknown, as when the fit failed
   */
  public double covariance(int i, int j) {
    return covariance[i][j];
  }

  /**
   * The fitted path in the field frame, on the clock of the observations; of the ball itself, not as a camera reports it.
   *
   * @return the trajectory
   * @throws IllegalStateException when the fit failed
   */
  public BallTrajectory trajectory() {
    if (trajectory == null) {
      throw new IllegalStateException("kick " + kick.id() + " has no trajectory: " + failure);
    }
    return trajectory;
  }

  /**
   * Seen minus predicted x of an observation in the ground plane, the camera's offset taken out.
   *
   * @param i index of the observation
   * @return m
   */
  public double residualX(int i) {
    return residualX[i];
  }

  /**
   * Seen minus predicted y of an observation in the ground plane, the camera's offset taken out.
   *
   * @param i index of the observation
   * @return m
   */
  public double residualY(int i) {
    return residualY[i];
  }

  /**
   * Whether an observation took part in the last fit.
   *
   * @param i index of the observation
   * @return false for outliers
   */
  public boolean used(int i) {
    return used[i];
  }

  /**
   * Root mean square of the residuals per axis, outliers left out.
   *
   * @return mm
   */
  public double rmsMm() {
    return statistics.rmsMm();
  }

  /**
   * Counts, stop reason and quality.
   *
   * @return the statistics; never null, with counts of 0 when the fit failed
   */
  public FitStatistics statistics() {
    return statistics;
  }

  /** The whole fit for people. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    text.append(String.format(Locale.ROOT, "kick %d (%s): ", kick.id(), kind.id()));
    if (failure != null) {
      return text.append(failure).toString();
    }
    text.append(statistics);
    for (Estimate e : estimates) {
      text.append(
          String.format(
              Locale.ROOT,
              "%n  %-22s %12.6f ± %.6f %s%s%s",
              e.name(),
              e.value(),
              e.standardError(),
              e.parameter().unit(),
              e.atBound() ? " (at its bound)" : "",
              e.undetermined().map(r -> " (" + r + ")").orElse("")));
    }
    return text.toString();
  }
}
