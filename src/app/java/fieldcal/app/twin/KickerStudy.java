package fieldcal.app.twin;

import fieldcal.app.calibrate.CommandFile.Command;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.ball.BallState;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.SideSpin;
import fieldcal.kick.KickKind;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.commons.math3.stat.StatUtils;

/** How kicks differ from commands: each robot's gain and aim, the scatter of all, and the spin that a diagnosis found. */
final class KickerStudy {
  /** Fewest kicks of a robot whose gain is measured. */
  private static final int FEWEST = 3;

  private final DiagnosisOutcome diagnosis;
  private final List<String> notes;

  KickerStudy(DiagnosisOutcome diagnosis, List<String> notes) {
    this.diagnosis = diagnosis;
    this.notes = notes;
  }

  /** One commanded kick: speed over command, direction and elevation off the command, rad. */
  private record Deviation(double gain, double yaw, double elevation) {}

  /** With the mean and scatter of spins by the effect's id. */
  KickBehaviour behaviour(Map<String, Spin> spins) {
    Map<RobotId, List<Deviation>> byRobot = deviations();
    KickBehaviour usual = KickBehaviour.DEFAULT;
    List<Bias> biases = new ArrayList<>();
    List<Deviation> rest = new ArrayList<>();
    byRobot.forEach(
        (robot, list) -> {
          if (list.size() >= FEWEST) {
            double gain = median(list.stream().mapToDouble(Deviation::gain).toArray());
            double yaw = median(list.stream().mapToDouble(Deviation::yaw).toArray());
            biases.add(new Bias(gain - 1, yaw, robot.team(), Optional.of(robot.number())));
            list.forEach(d -> rest.add(new Deviation(d.gain / gain - 1, d.yaw - yaw, d.elevation)));
          }
        });
    Spin roll = spins.getOrDefault("kick_spin", new Spin(new KickSpin(0), 0));
    Spin side = spins.getOrDefault("side_spin", new Spin(new SideSpin(0), 0));
    if (rest.isEmpty()) {
      notes.add(
          "No commands are known (--commands): the kickers do what is commanded, with a usual"
              + " scatter.");
      return usual
          .withRollSpin(roll.number("fraction"), roll.scatter())
          .withChipSpin(roll.number("chips"))
          .withSideSpin(side.number("fraction"), side.scatter());
    }
    double[] elevations =
        rest.stream().mapToDouble(Deviation::elevation).filter(Double::isFinite).toArray();
    return new KickBehaviour(
        deviation(rest.stream().mapToDouble(Deviation::gain).toArray()),
        deviation(rest.stream().mapToDouble(Deviation::yaw).toArray()),
        elevations.length < FEWEST ? usual.elevationScatter() : deviation(elevations),
        roll.number("fraction"),
        roll.scatter(),
        roll.number("chips"),
        side.number("fraction"),
        side.scatter(),
        biases,
        List.of());
  }

  private Map<RobotId, List<Deviation>> deviations() {
    Map<RobotId, List<Deviation>> byRobot = new TreeMap<>();
    for (KickResiduals kick : diagnosis.diagnosis().kicks()) {
      Optional<Command> command = diagnosis.calibration().command(kick.kick());
      if (command.isEmpty() || !(command.get().speed() > 0)) {
        continue;
      }
      Command c = command.get();
      BallState start = kick.after().stateAt(kick.after().kickTime());
      double flat = Math.hypot(start.vx(), start.vy());
      double speed = Math.hypot(flat, start.vz());
      double yaw =
          Math.IEEEremainder(Math.atan2(start.vy(), start.vx()) - c.direction(), 2 * Math.PI);
      double elevation =
          kick.kind() == KickKind.CHIP ? Math.atan2(start.vz(), flat) - c.elevation() : Double.NaN;
      byRobot
          .computeIfAbsent(c.robot(), r -> new ArrayList<>())
          .add(new Deviation(speed / c.speed(), yaw, elevation));
    }
    return byRobot;
  }

  private static double median(double[] values) {
    return StatUtils.percentile(values, 50);
  }

  private static double deviation(double[] values) {
    return values.length < 2 ? 0 : Math.sqrt(StatUtils.variance(values));
  }
}
