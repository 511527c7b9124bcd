package fieldcal.simulation.robot;

/** How acceleration and braking depend on the direction in the robot's own frame: the factor is 1 in the strongest direction and 1 − d in the weakest, where d is the {@linkplain RobotLimits#directionality directionality} and φ the angle from the robot's front. */
public enum DirectionShape {
  /** 1 − d·|sin φ|, the shape of {@code directional}: bends at the front and at the back. */
  SINE {
    @Override
    double factor(double d, double phi) {
      return 1 - d * Math.abs(Math.sin(phi));
    }
  },
  /** 1 − d·sin²φ. */
  SINE_SQUARED {
    @Override
    double factor(double d, double phi) {
      double sine = Math.sin(phi);
      return 1 - d * sine * sine;
    }
  },
  /** An ellipse with the semi-axes 1 along the front and 1 − d across, in polar coordinates about its centre. */
  ELLIPSE {
    @Override
    double factor(double d, double phi) {
      double across = 1 - d;
      return across / Math.hypot(across * Math.cos(phi), Math.sin(phi));
    }
  },
  /** 1 − d·sin²2φ: four wheels that pull best along and across. */
  FOUR_LOBES {
    @Override
    double factor(double d, double phi) {
      double sine = Math.sin(2 * phi);
      return 1 - d * sine * sine;
    }
  };

  abstract double factor(double d, double phi);
}
