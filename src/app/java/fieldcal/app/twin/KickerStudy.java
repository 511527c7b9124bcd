package fieldcal.app.twin;

import fieldcal.app.calibrate.CommandedKick;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.SideSpin;
import fieldcal.kick.KickKind;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.commons.math3.stat.StatUtils;

/** How kicks differ from commands: each robot's gain and aim, the scatter of all, and the spin that a diagnosis found. */
final class KickerStudy {
  /** Fewest kicks of a robot whose gain is measured. */
  private static final int FEWEST = 3;

  private final List<CommandedKick> kicks;
  private final List<String> notes;

  /** Of kicks whose commands are known. */
  KickerStudy(List<CommandedKick> kicks, List<String> notes) {
    this.kicks = kicks;
    this.notes = notes;
  }

  /** With the mean and scatter of spins by the effect's id. */
  KickBehaviour behaviour(Map<String, Spin> spins) {
    KickBehaviour usual = KickBehaviour.DEFAULT;
    List<Bias> biases = new ArrayList<>();
    List<double[]> gains = new ArrayList<>();
    List<double[]> yaws = new ArrayList<>();
    List<CommandedKick> known = new ArrayList<>();
    byRobot()
        .forEach(
            (robot, list) -> {
              if (list.size() >= FEWEST) {
                double[] gain = list.stream().mapToDouble(CommandedKick::gain).toArray();
                double[] yaw = list.stream().mapToDouble(CommandedKick::yaw).toArray();
                double usualGain = median(gain);
                biases.add(
                    new Bias(
                        usualGain - 1, median(yaw), robot.team(), Optional.of(robot.number())));
                gains.add(Arrays.stream(gain).map(g -> g / usualGain).toArray());
                yaws.add(yaw);
                known.addAll(list);
              }
            });
    Spin roll = spins.getOrDefault("kick_spin", new Spin(new KickSpin(0), 0));
    Spin side = spins.getOrDefault("side_spin", new Spin(new SideSpin(0), 0));
    if (known.isEmpty()) {
      notes.add(
          "No commands are known (--commands): the kickers do what is commanded, with a usual"
              + " scatter.");
      return usual
          .withRollSpin(roll.number("fraction"), roll.scatter())
          .withChipSpin(roll.number("chips"))
          .withSideSpin(side.number("fraction"), side.scatter());
    }
    double[] elevations =
        known.stream()
            .filter(k -> k.kind() == KickKind.CHIP)
            .mapToDouble(CommandedKick::elevation)
            .toArray();
    return new KickBehaviour(
        deviation(gains),
        deviation(yaws),
        elevations.length < FEWEST ? usual.elevationScatter() : deviation(List.of(elevations)),
        roll.number("fraction"),
        roll.scatter(),
        roll.number("chips"),
        side.number("fraction"),
        side.scatter(),
        biases,
        List.of());
  }

  private Map<RobotId, List<CommandedKick>> byRobot() {
    Map<RobotId, List<CommandedKick>> byRobot = new TreeMap<>();
    for (CommandedKick kick : kicks) {
      byRobot.computeIfAbsent(kick.command().robot(), r -> new ArrayList<>()).add(kick);
    }
    return byRobot;
  }

  private static double median(double[] values) {
    return StatUtils.percentile(values, 50);
  }

  /** Of all values about the mean of their group, each of which takes one degree of freedom; about medians the squares would be larger. */
  private static double deviation(List<double[]> groups) {
    double squares = 0;
    int free = 0;
    for (double[] values : groups) {
      squares += (values.length - 1) * StatUtils.variance(values);
      free += values.length - 1;
    }
    return Math.sqrt(squares / free);
  }
}
