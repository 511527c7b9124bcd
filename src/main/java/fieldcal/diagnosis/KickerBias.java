package fieldcal.diagnosis;

import fieldcal.effect.motion.RobotKickBias;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.apache.commons.math3.distribution.TDistribution;

/**
 * Whether a robot kicks faster or aside of what it was told: its fitted kicks against its commands. It must differ from the command and from the other robots, whose common excess would be an error
 * of scale and no kicker's; all robots' kicks together say how much kicks scatter.
 */
final class KickerBias {
  /** Fewer kicks say nothing of a robot. */
  private static final int FEWEST = 4;

  /** Chance of naming a sound robot. */
  private static final double CHANCE = 1e-3;

  /** How many standard errors a robot's bias must be from the others'. */
  private static final double FROM_OTHERS = 3;

  /** Smaller biases matter to nobody: share of the speed, and rad. */
  private static final double LEAST_SPEED = 0.01;

  private static final double LEAST_YAW = 0.005;

  /** A kick farther than that from the robot's median, in robust standard deviations, was no clean kick. */
  private static final double UNCLEAN = 5;

  private static final int BOOTSTRAPS = 2000;

  /** One kick: speed over the command's minus one, and direction minus the command's; and how far the ball is from where the command has it after a second, m. */
  private record Sample(double speed, double yaw, double told) {}

  /** Mean and its standard error of something, over one robot's kicks. */
  private record Mean(double value, double error, double fromOthers, double errorFromOthers) {
    boolean isBiased(double least, double limit, boolean alone) {
      return Math.abs(value) > least
          && Math.abs(value) > limit * error
          && (alone || Math.abs(fromOthers) > FROM_OTHERS * errorFromOthers);
    }
  }

  private final Map<RobotId, List<Sample>> robots =
      new TreeMap<>(Comparator.comparing(RobotId::team).thenComparing(RobotId::number));
  private final long seed;

  KickerBias(
      HypothesisFitter fitter,
      FittedHypothesis best,
      Map<Integer, KickCommand> commands,
      long seed) {
    this.seed = seed;
    for (int k = 0; k < fitter.kicks.size(); k++) {
      KickCommand command = commands.get(fitter.kicks.get(k).kick.id());
      if (command != null) {
        double[] own = best.own().get(k);
        double vz = KickData.ownSize(fitter.kicks.get(k).kind) == 6 ? own[4] : 0;
        double speed = Math.sqrt(own[2] * own[2] + own[3] * own[3] + vz * vz);
        double yaw =
            Math.IEEEremainder(Math.atan2(own[3], own[2]) - command.direction(), 2 * Math.PI);
        robots
            .computeIfAbsent(command.robot(), r -> new ArrayList<>())
            .add(new Sample(speed / command.speed() - 1, yaw, command.speed()));
      }
    }
    robots.replaceAll((r, list) -> clean(list));
    robots.values().removeIf(list -> list.size() < FEWEST);
  }

  private static List<Sample> clean(List<Sample> samples) {
    double[] speeds = samples.stream().mapToDouble(Sample::speed).toArray();
    double[] yaws = samples.stream().mapToDouble(Sample::yaw).toArray();
    double speed = median(speeds);
    double yaw = median(yaws);
    double speedScale =
        Math.max(
            1e-3, 1.48 * median(Arrays.stream(speeds).map(s -> Math.abs(s - speed)).toArray()));
    double yawScale =
        Math.max(1e-3, 1.48 * median(Arrays.stream(yaws).map(y -> Math.abs(y - yaw)).toArray()));
    return samples.stream()
        .filter(s -> Math.abs(s.speed - speed) < UNCLEAN * speedScale)
        .filter(s -> Math.abs(s.yaw - yaw) < UNCLEAN * yawScale)
        .toList();
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  /** The robots that kick otherwise than told. */
  List<Cause> causes() {
    List<Cause> causes = new ArrayList<>();
    int kicks = robots.values().stream().mapToInt(List::size).sum();
    int freedom = kicks - robots.size();
    if (freedom < FEWEST) {
      return causes;
    }
    double chance = CHANCE / (4.0 * robots.size());
    double limit = new TDistribution(null, freedom).inverseCumulativeProbability(1 - chance);
    boolean alone = robots.size() == 1;
    robots.forEach(
        (robot, samples) -> {
          Mean speed = mean(robot, true, freedom);
          Mean yaw = mean(robot, false, freedom);
          if (speed.isBiased(LEAST_SPEED, limit, alone) || yaw.isBiased(LEAST_YAW, limit, alone)) {
            causes.add(cause(robot, samples, speed, yaw, freedom));
          }
        });
    return causes;
  }

  private static double of(Sample s, boolean speed) {
    return speed ? s.speed : s.yaw;
  }

  private Mean mean(RobotId robot, boolean speed, int freedom) {
    double within = 0;
    double own = 0;
    double others = 0;
    int otherKicks = 0;
    for (Map.Entry<RobotId, List<Sample>> e : robots.entrySet()) {
      double mean = e.getValue().stream().mapToDouble(s -> of(s, speed)).average().orElse(0);
      for (Sample s : e.getValue()) {
        within += (of(s, speed) - mean) * (of(s, speed) - mean);
      }
      if (e.getKey().equals(robot)) {
        own = mean;
      } else {
        others += mean * e.getValue().size();
        otherKicks += e.getValue().size();
      }
    }
    double variance = within / freedom;
    int n = robots.get(robot).size();
    double error = Math.sqrt(variance / n);
    if (otherKicks == 0) {
      return new Mean(own, error, own, error);
    }
    double fromOthers = own - others / otherKicks;
    return new Mean(own, error, fromOthers, Math.sqrt(variance / n + variance / otherKicks));
  }

  private Cause cause(RobotId robot, List<Sample> samples, Mean speed, Mean yaw, int freedom) {
    RobotKickBias bias =
        new RobotKickBias(100 * speed.value, yaw.value, robot.team(), robot.number());
    Map<String, Double> errors = new LinkedHashMap<>();
    errors.put("percent", 100 * speed.error);
    errors.put("yaw", yaw.error);
    double t = speed.value * speed.value / (speed.error * speed.error);
    t += yaw.value * yaw.value / (yaw.error * yaw.error);
    int n = samples.size();
    // Student's likelihood ratio, and a unit of information for each of two numbers.
    double evidence = 0.5 * (freedom + 1) * Math.log1p(t / freedom) - Math.log(n);
    return new Cause(bias, errors, 0, evidence, gain(samples), List.of(), "");
  }

  /** Of the ball's place a second after the kick as the command has it, the bias taken from the robot's other kicks. */
  private Gain gain(List<Sample> samples) {
    int n = samples.size();
    double[] before = new double[n];
    double[] after = new double[n];
    double speeds = samples.stream().mapToDouble(Sample::speed).sum();
    double yaws = samples.stream().mapToDouble(Sample::yaw).sum();
    for (int i = 0; i < n; i++) {
      Sample s = samples.get(i);
      double speed = (speeds - s.speed) / (n - 1);
      double yaw = (yaws - s.yaw) / (n - 1);
      before[i] = s.told * s.told * (s.speed * s.speed + s.yaw * s.yaw);
      double ds = s.speed - speed;
      double dy = s.yaw - yaw;
      after[i] = s.told * s.told * (ds * ds + dy * dy);
    }
    Random random = new Random(seed);
    double[] gains = new double[BOOTSTRAPS];
    for (int b = 0; b < BOOTSTRAPS; b++) {
      double s0 = 0;
      double s1 = 0;
      for (int i = 0; i < n; i++) {
        int k = random.nextInt(n);
        s0 += before[k];
        s1 += after[k];
      }
      gains[b] = 1000 * (Math.sqrt(s0 / (2 * n)) - Math.sqrt(s1 / (2 * n)));
    }
    Arrays.sort(gains);
    double rms0 = 1000 * Math.sqrt(Arrays.stream(before).sum() / (2 * n));
    double rms1 = 1000 * Math.sqrt(Arrays.stream(after).sum() / (2 * n));
    return new Gain(
        rms0 - rms1,
        100 * (rms0 - rms1) / rms0,
        gains[(int) (0.025 * BOOTSTRAPS)],
        gains[(int) (0.975 * BOOTSTRAPS)]);
  }
}
