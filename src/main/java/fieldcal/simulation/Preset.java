package fieldcal.simulation;

import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.AirLaw;
import fieldcal.simulation.physics.Ball;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.GroundLaw;
import fieldcal.simulation.physics.ImpactLaw;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Fields as they were found. The numbers of the tournaments are those of ten matches of 2026, published by Immortals-Robotics/Simulator ({@code docs/calibration/}) and in issues 159, 160 and 173 of
 * RoboCup-SSL/ssl-vision; where these give a range over venues, each preset takes one end.
 */
public enum Preset {
  /** A quiet laboratory: ideal physics, cameras that agree, 1 mm of noise. */
  LAB {
    @Override
    public SimulationSettings applyTo(SimulationSettings settings) {
      return settings
          .withPhysics(BallPhysics.IDEAL)
          .withCameras(CameraSettings.DEFAULT.withNoise(0.001, 0.002))
          .withNuisance(Nuisance.TYPICAL);
    }
  },
  /** Two cameras that disagree by 20 mm, a fast carpet. */
  GERMAN_OPEN_2026 {
    @Override
    public SimulationSettings applyTo(SimulationSettings settings) {
      return settings
          .withPhysics(tournament(0.22, 0.03))
          .withKickBehaviour(tournamentKicks(settings.kickBehaviour()))
          .withCameras(
              new CameraSettings(
                  2, 5.6, -0.06, 0.0007, 0.0013, 0.008, 72.5, 73.5, 0.0215, 0.020, 0.6))
          .withNuisance(tournamentNuisance(0.2e-3));
    }
  },
  /** Four cameras that disagree by 26 mm and assume the ball at 30 mm, a slow carpet with a direction. */
  ROBOCUP_2026 {
    @Override
    public SimulationSettings applyTo(SimulationSettings settings) {
      return settings
          .withPhysics(tournament(0.253, 0.08))
          .withKickBehaviour(tournamentKicks(settings.kickBehaviour()))
          .withCameras(
              new CameraSettings(
                  4, 5.4, -0.04, 0.0007, 0.0013, 0.008, 72.5, 73.5, 0.030, 0.026, 0.6))
          .withNuisance(tournamentNuisance(1.3e-3));
    }
  };

  /**
   * Replaces physics, kickers, cameras and trouble; scenario, seed, field and effects stay.
   *
   * @param settings to start from
   * @return the changed settings
   */
  public abstract SimulationSettings applyTo(SimulationSettings settings);

  /**
   * The name on the command line.
   *
   * @return lower case with hyphens
   */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * The preset of a name.
   *
   * @param label as in {@link #label}
   * @return the preset
   * @throws IllegalArgumentException when there is none; the message lists all
   */
  public static Preset of(String label) {
    return Arrays.stream(values())
        .filter(p -> p.label().equals(label))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "unknown preset '"
                        + label
                        + "'; known are "
                        + Arrays.stream(values())
                            .map(Preset::label)
                            .collect(Collectors.joining(", "))));
  }

  private static BallPhysics tournament(double rolling, double nap) {
    // Measured: a = −(0.253 + 0.019·v²) in all; drag of c_d = 0.45 is 0.0061·v² of that on a
    // rolling solid sphere.
    GroundLaw ground =
        GroundLaw.uniform(3.3 / BallPhysics.GRAVITY, rolling)
            .withSpeedDependentRoll(0, 0.013)
            .withNap(nap, 0.6);
    ImpactLaw impact =
        new ImpactLaw(
            0.47, 0.38, 0, new ImpactLaw.FixedLoss(0.70, 0.87), 0, ImpactLaw.LEAGUE_MIN_HOP_HEIGHT);
    return new BallPhysics(Ball.GOLF_BALL, ground, impact, AirLaw.NONE.withDrag(0.45));
  }

  private static KickBehaviour tournamentKicks(KickBehaviour base) {
    // kSwitch = (1 + 0.4·spin)/1.4: a mean of 0.66 and a scatter of 0.075 from kick to kick.
    return base.withRollSpin(-0.19, 0.26);
  }

  private static Nuisance tournamentNuisance(double jitter) {
    return new Nuisance(
        0.003, 0.001, 0.004, 0.003, 0.004, 0.01, jitter, 0.05e-3, 0.002, true, List.of());
  }
}
