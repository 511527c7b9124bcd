package fieldcal.app.calibrate;

import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.ball.BallState;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What a robot made of one command. Only a kick of the commanded kind counts: a chip that was fitted as a flat kick has lost most of its speed at its first impact.
 *
 * @param command what was commanded, with a speed above 0
 * @param kind of the command and of the kick
 * @param speed measured, m/s
 * @param yaw to the left of what was commanded, rad
 * @param elevation above what was commanded, rad; 0 of a flat kick
 */
public record CommandedKick(
    Command command, KickKind kind, double speed, double yaw, double elevation) {

  /**
   * Compares a kick with its command.
   *
   * @param command of it, if there is one
   * @param kind of the kick
   * @param vx velocity after the kick along x, m/s
   * @param vy velocity along y, m/s
   * @param vz velocity upwards, m/s; 0 of a flat kick
   * @return empty without a command of this kind and of a speed above 0
   */
  public static Optional<CommandedKick> of(
      Optional<Command> command, KickKind kind, double vx, double vy, double vz) {
    return command
        .filter(c -> c.speed() > 0 && c.kind().equals(kind.id()))
        .map(
            c -> {
              double ground = Math.hypot(vx, vy);
              double yaw = Math.IEEEremainder(Math.atan2(vy, vx) - c.direction(), 2 * Math.PI);
              double elevation = kind == KickKind.CHIP ? Math.atan2(vz, ground) - c.elevation() : 0;
              return new CommandedKick(c, kind, Math.hypot(ground, vz), yaw, elevation);
            });
  }

  /**
   * The commanded kicks of a diagnosis.
   *
   * @param calibration with the commands
   * @param kicks of the diagnosis
   * @return those that followed a command of their kind, in order
   */
  public static List<CommandedKick> of(CalibrationOutcome calibration, List<KickResiduals> kicks) {
    List<CommandedKick> all = new ArrayList<>();
    for (KickResiduals k : kicks) {
      Kick kick = k.kick();
      BallState s = k.after().stateAt(k.after().kickTime());
      of(calibration.command(kick), k.kind(), s.vx(), s.vy(), s.vz()).ifPresent(all::add);
    }
    return all;
  }

  /**
   * How strong the kick was.
   *
   * @return measured over commanded speed (–)
   */
  public double gain() {
    return speed / command.speed();
  }
}
