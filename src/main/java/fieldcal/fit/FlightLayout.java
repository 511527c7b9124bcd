package fieldcal.fit;

import fieldcal.ball.BallTrajectory;
import fieldcal.ball.ChipModel;
import fieldcal.ball.ChipTrajectory;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.ball.Gravity;
import fieldcal.ball.Parameter;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Order, names, scales and bounds of the unknowns of one flight: first those of the kick (position, velocity, time), then those
 * of the model. The same order as the sensitivities of the trajectories.
 */
final class FlightLayout {
  private static final String KICK = "one kick's own unknown";

  /** Penalty in chi-square of a number of flights that contradicts the rule; noise reaches it once in ten thousand kicks. */
  private static final double RULE_PRICE = 15;

  /** How far a hop's height may be from the rule's limit by the errors of the fit alone, as a share. */
  private static final double RULE_TOLERANCE = 0.05;

  private FlightLayout() {}

  static int timeIndex(KickKind kind) {
    return kind == KickKind.FLAT ? FlatTrajectory.T0 : ChipTrajectory.T0;
  }

  /** How many unknowns belong to the kick alone. */
  static int kickSize(KickKind kind) {
    return timeIndex(kind) + 1;
  }

  static int size(KickKind kind) {
    return kickSize(kind) + (kind == KickKind.FLAT ? 3 : 4);
  }

  /** All unknowns with the kick's ones at {@code start} (position, velocity, time) and the model's as given. */
  static List<Parameter> parameters(KickKind kind, double[] start, List<Parameter> model) {
    List<Parameter> all = new ArrayList<>();
    all.add(new Parameter("x", "m", start[0], 0.01, start[0] - 1, start[0] + 1, true, KICK));
    all.add(new Parameter("y", "m", start[1], 0.01, start[1] - 1, start[1] + 1, true, KICK));
    all.add(new Parameter("vx", "m/s", start[2], 0.1, -15, 15, true, KICK));
    all.add(new Parameter("vy", "m/s", start[3], 0.1, -15, 15, true, KICK));
    if (kind == KickKind.CHIP) {
      all.add(new Parameter("vz", "m/s", start[4], 0.1, 0.05, 12, true, KICK));
    }
    double t0 = start[timeIndex(kind)];
    all.add(new Parameter("t0", "s", t0, 0.005, t0 - 0.1, t0 + 0.1, true, KICK));
    all.addAll(model);
    return all;
  }

  static FlatModel flatModel(double[] theta) {
    return new FlatModel(
        theta[FlatTrajectory.ACC_SLIDE],
        theta[FlatTrajectory.ACC_ROLL],
        theta[FlatTrajectory.K_SWITCH]);
  }

  static ChipModel chipModel(double[] theta) {
    return new ChipModel(
        theta[ChipTrajectory.DAMPING_XY_FIRST_HOP],
        theta[ChipTrajectory.DAMPING_XY_OTHER_HOPS],
        theta[ChipTrajectory.DAMPING_Z],
        theta[ChipTrajectory.ACC_ROLL]);
  }

  /** The path that these unknowns describe; {@code flights} matters for chips only. */
  static BallTrajectory trajectory(KickKind kind, double[] p, int flights) {
    if (kind == KickKind.FLAT) {
      return FlatTrajectory.fromKick(
          flatModel(p),
          p[FlatTrajectory.T0],
          p[FlatTrajectory.X0],
          p[FlatTrajectory.Y0],
          p[FlatTrajectory.VX0],
          p[FlatTrajectory.VY0]);
    }
    return ChipTrajectory.fromKickWithHops(
        chipModel(p),
        p[ChipTrajectory.T0],
        p[ChipTrajectory.X0],
        p[ChipTrajectory.Y0],
        p[ChipTrajectory.VX0],
        p[ChipTrajectory.VY0],
        p[ChipTrajectory.VZ0],
        flights);
  }

  /** The cost of a chip, with the penalty of a number of flights that contradicts the 10 mm rule: noise alone must not decide for it. */
  static double pricedCost(double[] theta, int flights, double cost) {
    return cost + rulePenalty(theta, flights);
  }

  /** Penalty of a chip's number of flights in chi-square; 0 where the 10 mm rule allows it. */
  static double rulePenalty(double[] theta, int flights) {
    double lift = theta[ChipTrajectory.DAMPING_Z];
    double last = theta[ChipTrajectory.VZ0] * Math.pow(lift, flights - 1.0);
    double lastHeight = last * last / (2 * Gravity.ACCELERATION);
    boolean tooLow = flights > 1 && lastHeight < ChipModel.MIN_HOP_HEIGHT * (1 - RULE_TOLERANCE);
    boolean goesOn = lastHeight * lift * lift > ChipModel.MIN_HOP_HEIGHT * (1 + RULE_TOLERANCE);
    return tooLow || goesOn ? RULE_PRICE : 0;
  }

  /** Why a kick does not determine a parameter of the model, with the error it would have, in its scales, where that is finite. */
  static String whyUndetermined(Parameter parameter, double error) {
    String why =
        switch (parameter.name()) {
          case "accRoll" -> "the ball was hardly seen rolling";
          case "kSwitch" -> "the change from sliding to rolling was hardly seen";
          case "accSlide" -> "the ball was hardly seen sliding";
          case "dampingXyFirstHop" -> "little was seen after the first landing";
          case "dampingXyOtherHops" -> "little was seen after the second landing";
          default -> "too few landings were seen";
        };
    return error < 1e6 * parameter.scale()
        ? String.format(Locale.ROOT, "%s: error %.2g", why, error)
        : why;
  }
}
