package fieldcal.simulation;

import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.truth.KickTruth.KickCommand;

/** Turns a command into the ball's velocity and spin, with the scatter and the bias of real kickers. */
final class Kicker {
  private final KickBehaviour behaviour;
  private final double ballRadius;
  private final RandomStream scatter;
  private final RandomStream spin;

  Kicker(KickBehaviour behaviour, double ballRadius, long seed) {
    this.behaviour = behaviour;
    this.ballRadius = ballRadius;
    scatter = RandomStream.of(seed, "kick scatter");
    spin = RandomStream.of(seed, "kick spin");
  }

  void kick(SimulatedRobot robot, KickCommand command, BallBody ball) {
    // All numbers are drawn for every kick, so that the kind of one kick does not change the
    // next one.
    double speedError = scatter.gaussian(behaviour.speedScatter());
    double directionError = scatter.gaussian(behaviour.directionScatter());
    double elevationError = scatter.gaussian(behaviour.elevationScatter());
    double rollError = spin.gaussian(behaviour.rollSpinScatter());
    double side = behaviour.sideSpin() + spin.gaussian(behaviour.sideSpinScatter());
    double speed = command.speed() * (1 + speedError);
    double direction = command.direction() + directionError;
    for (Bias bias : behaviour.biases()) {
      if (bias.concerns(robot.id())) {
        speed *= 1 + bias.speed();
        direction += bias.yaw();
      }
    }
    double elevation = command.elevation() > 0 ? command.elevation() + elevationError : 0;
    double along = speed * Math.cos(elevation);
    double roll = behaviour.rollSpinOf(along, direction, elevation > 0) + rollError;
    ball.kick(
        along * Math.cos(direction),
        along * Math.sin(direction),
        speed * Math.sin(elevation),
        roll,
        side,
        ballRadius);
  }
}
