package fieldcal.effect.motion;

import fieldcal.ball.Parameter;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectParameters;
import fieldcal.effect.KickerEffect;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.List;

/**
 * Bias of one robot's kicker: measured speed = commanded speed × (1 + percent/100), the vertical part included; measured direction = commanded direction + yaw; elevation as commanded.
 *
 * @param percent excess of speed, %
 * @param yaw how far to the left of the command (counter-clockwise), rad
 * @param team whose robot
 * @param robot which
 */
public record RobotKickBias(double percent, double yaw, Team team, int robot)
    implements KickerEffect {
  private static final String ID = "robot_kick_bias";

  /**
   * Checks the numbers. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is not finite
   */
  public RobotKickBias {
    EffectParameters.requireFinite(ID, percent, yaw);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String sentence() {
    return "One robot kicks harder or in another direction than commanded.";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        new Parameter(
            "percent",
            "%",
            percent,
            1,
            -50,
            100,
            true,
            "uncalibrated kickers are off by some percent to tens of percent"),
        new Parameter(
            "yaw", "rad", yaw, 0.01, -0.5, 0.5, true, "kickers are off by some hundredths"),
        EffectParameters.place(
            "team", "", team == Team.YELLOW ? 0 : 1, 0, 1, "0 = yellow, 1 = blue"),
        EffectParameters.place("robot", "", robot, 0, 15, "which robot, by its number"));
  }

  @Override
  public boolean isAllowedForByCalibration() {
    return true;
  }

  @Override
  public RobotKickBias withParameters(double... values) {
    double[] v = EffectParameters.require(ID, values, 4);
    return new RobotKickBias(v[0], v[1], v[2] == 0 ? Team.YELLOW : Team.BLUE, (int) v[3]);
  }

  @Override
  public boolean canShowIn(Arena arena) {
    return !arena.robots().isEmpty();
  }

  @Override
  public List<Effect> candidates(Arena arena) {
    return arena.robots().stream()
        .<Effect>map(r -> new RobotKickBias(0, 0, r.team(), r.number()))
        .toList();
  }

  @Override
  public boolean isAbsent() {
    return percent == 0 && yaw == 0;
  }

  @Override
  public List<String> magnitudes() {
    return List.of("percent", "yaw");
  }

  @Override
  public RobotId kicker() {
    return new RobotId(team, robot);
  }

  @Override
  public void kick(RobotId who, double[] velocity) {
    if (who.team() == team && who.number() == robot) {
      double factor = 1 + percent / 100;
      double along = factor * Math.cos(yaw);
      double left = factor * Math.sin(yaw);
      double vx = velocity[0];
      velocity[0] = along * vx - left * velocity[1];
      velocity[1] = along * velocity[1] + left * vx;
      velocity[2] *= factor;
    }
  }
}
