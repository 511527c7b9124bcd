package fieldcal.diagnosis;

import fieldcal.ball.Parameter;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.effect.Arena;
import fieldcal.effect.Effect;
import fieldcal.effect.KickerEffect;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.apache.commons.math3.distribution.TDistribution;

/**
 * Whether robots kick otherwise than commanded: compares the velocities of the fitted kicks with the commanded ones, in terms of the effects on kickers. A robot must differ from its command and from the other robots: an excess that all share would be an
 * error of scale and not of a kicker. How much kicks scatter is estimated from the kicks of all robots together.
 */
final class KickerBias {
  /** Fewest kicks from which a robot's bias is estimated. */
  private static final int FEWEST = 4;

  /** Chance of naming a sound robot. */
  private static final double CHANCE = 1e-3;

  /** How many standard errors a robot's bias must be from the others'. */
  private static final double FROM_OTHERS = 3;

  /** Smaller biases do not matter, in scales of the parameter: 0.5 % of the speed, 5 mrad of the direction. */
  private static final double LEAST = 0.5;

  /** A kick farther than this from the robot's median, in robust standard deviations, is not used. */
  private static final double UNCLEAN = 5;

  /** The median absolute deviation of a normal variable is its standard deviation over this. */
  private static final double NORMAL = 1.4826;

  private static final int BOOTSTRAPS = 1000;

  /** Commanded and fitted velocity of one kick, m/s. */
  private record Sample(double[] commanded, double[] measured) {}

  /** Estimates of one robot's parameters, and their standard errors. */
  private record Fit(double[] values, double[] errors, List<Sample> samples) {}

  private final FittedModel model;
  private final Map<Integer, KickCommand> commands;
  private final long seed;

  KickerBias(FittedModel model, Map<Integer, KickCommand> commands, long seed) {
    this.model = model;
    this.commands = commands;
    this.seed = seed;
  }

  /** The robots whose commands are known. */
  static List<RobotId> robots(Map<Integer, KickCommand> commands) {
    return commands.values().stream().map(KickCommand::robot).distinct().toList();
  }

  /** Causes among the effects of a catalogue that act on kickers. */
  List<Cause> causes(List<? extends Effect> effects, Arena arena) {
    List<Cause> causes = new ArrayList<>();
    for (Effect effect : effects) {
      if (effect instanceof KickerEffect && effect.canShowIn(arena)) {
        causes.addAll(biased(effect.candidates(arena)));
      }
    }
    return causes;
  }

  private List<Sample> samples(KickerEffect effect) {
    List<Sample> all = new ArrayList<>();
    for (int k = 0; k < model.kickCount(); k++) {
      KickCommand c = commands.get(model.kick(k).record().kick().id());
      if (c != null && c.robot().equals(effect.kicker())) {
        double[] own = model.solution().own(k);
        boolean chip = model.kick(k).record().timeIndex() == 5;
        double up = Math.sin(c.elevation()) * c.speed();
        double along = Math.cos(c.elevation()) * c.speed();
        all.add(
            new Sample(
                new double[] {along * Math.cos(c.direction()), along * Math.sin(c.direction()), up},
                new double[] {own[2], own[3], chip ? own[4] : 0}));
      }
    }
    return clean(all);
  }

  private static double scale(Effect effect, String name) {
    return effect.parameters().stream()
        .filter(p -> p.name().equals(name))
        .mapToDouble(Parameter::scale)
        .findFirst()
        .orElseThrow();
  }

  /** Relative excess of the speed over the command (–), and direction from the commanded one, rad, counter-clockwise. */
  private static double[] polar(Sample s) {
    double told = norm(s.commanded);
    double yaw =
        Math.atan2(s.measured[1], s.measured[0]) - Math.atan2(s.commanded[1], s.commanded[0]);
    return new double[] {norm(s.measured) / told - 1, Math.IEEEremainder(yaw, 2 * Math.PI)};
  }

  private static double norm(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  private static List<Sample> clean(List<Sample> samples) {
    List<Sample> kept = new ArrayList<>(samples);
    for (int axis = 0; axis < 2; axis++) {
      int a = axis;
      double[] values = samples.stream().mapToDouble(s -> polar(s)[a]).toArray();
      if (values.length == 0) {
        return kept;
      }
      double median = median(values);
      double scale =
          Math.max(
              1e-3,
              NORMAL * median(Arrays.stream(values).map(v -> Math.abs(v - median)).toArray()));
      kept.removeIf(s -> Math.abs(polar(s)[a] - median) > UNCLEAN * scale);
    }
    return kept;
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private List<Cause> biased(List<Effect> candidates) {
    Map<KickerEffect, List<Sample>> all = new LinkedHashMap<>();
    for (Effect e : candidates) {
      List<Sample> samples = samples((KickerEffect) e);
      if (samples.size() >= FEWEST) {
        all.put((KickerEffect) e, samples);
      }
    }
    int kicks = all.values().stream().mapToInt(List::size).sum();
    int freedom = kicks - all.size();
    if (freedom < FEWEST) {
      return List.of();
    }
    int size = candidates.get(0).magnitudes().size();
    double[] within = new double[size];
    Map<KickerEffect, double[]> means = new LinkedHashMap<>();
    all.forEach(
        (effect, samples) -> {
          double[] mean = new double[size];
          List<double[]> each = samples.stream().map(s -> single(effect, s)).toList();
          for (int j = 0; j < size; j++) {
            int column = j;
            mean[j] = each.stream().mapToDouble(e -> e[column]).average().orElse(0);
            for (double[] e : each) {
              within[j] += (e[j] - mean[j]) * (e[j] - mean[j]);
            }
          }
          means.put(effect, mean);
        });
    double chance = CHANCE / (2.0 * size * all.size());
    double limit = new TDistribution(null, freedom).inverseCumulativeProbability(1 - chance);
    List<Cause> causes = new ArrayList<>();
    means.forEach(
        (effect, mean) -> {
          double[] errors = new double[size];
          boolean named = false;
          for (int j = 0; j < size; j++) {
            double variance = within[j] / freedom;
            int n = all.get(effect).size();
            errors[j] = Math.sqrt(variance / n);
            double least = LEAST * scale(effect, effect.magnitudes().get(j));
            named |=
                Math.abs(mean[j]) > least
                    && Math.abs(mean[j]) > limit * errors[j]
                    && differs(effect, j, means, all, variance);
          }
          if (named) {
            causes.add(cause(effect, new Fit(mean, errors, all.get(effect)), freedom));
          }
        });
    return causes;
  }

  private static boolean differs(
      KickerEffect effect,
      int j,
      Map<KickerEffect, double[]> means,
      Map<KickerEffect, List<Sample>> all,
      double variance) {
    double others = 0;
    int count = 0;
    for (Map.Entry<KickerEffect, double[]> e : means.entrySet()) {
      if (e.getKey() != effect) {
        int n = all.get(e.getKey()).size();
        others += n * e.getValue()[j];
        count += n;
      }
    }
    if (count == 0) {
      return true;
    }
    double error = Math.sqrt(variance / all.get(effect).size() + variance / count);
    return Math.abs(means.get(effect)[j] - others / count) > FROM_OTHERS * error;
  }

  /** The magnitudes of the effect that reproduce one kick: three Newton steps for speed and direction. */
  private static double[] single(KickerEffect effect, Sample s) {
    List<String> names = effect.magnitudes();
    int size = names.size();
    double[] at = new double[size];
    double[] wanted = polar(s);
    for (int step = 0; step < 3; step++) {
      double[] now = predicted(effect, names, at, s);
      double[][] j = new double[2][size];
      for (int k = 0; k < size; k++) {
        double h = 0.1 * scale(effect, names.get(k));
        double[] moved = at.clone();
        moved[k] += h;
        double[] there = predicted(effect, names, moved, s);
        for (int r = 0; r < 2; r++) {
          j[r][k] = (there[r] - now[r]) / h;
        }
      }
      // Each magnitude changes either speed or direction, the one with the larger entry in its
      // column.
      for (int k = 0; k < size; k++) {
        int r = Math.abs(j[0][k]) > Math.abs(j[1][k]) ? 0 : 1;
        at[k] += j[r][k] == 0 ? 0 : (wanted[r] - now[r]) / j[r][k];
      }
    }
    return at;
  }

  private static double[] predicted(
      KickerEffect effect, List<String> names, double[] values, Sample s) {
    return polar(new Sample(s.commanded, kicked(effect, names, values, s)));
  }

  private static double[] kicked(
      KickerEffect effect, List<String> names, double[] values, Sample s) {
    KickerEffect with = effect;
    for (int k = 0; k < values.length; k++) {
      with = (KickerEffect) with.with(names.get(k), values[k]);
    }
    double[] v = s.commanded.clone();
    with.kick(effect.kicker(), v);
    return v;
  }

  private Cause cause(KickerEffect effect, Fit fit, int freedom) {
    List<String> names = effect.magnitudes();
    KickerEffect found = effect;
    Map<String, Double> errors = new LinkedHashMap<>();
    double t = 0;
    for (int j = 0; j < fit.values.length; j++) {
      found = (KickerEffect) found.with(names.get(j), fit.values[j]);
      errors.put(names.get(j), fit.errors[j]);
      t += fit.values[j] * fit.values[j] / (fit.errors[j] * fit.errors[j]);
    }
    int n = fit.samples.size();
    // Half of the likelihood-ratio statistic of Student's distribution, less the penalty for two
    // parameters (Schwarz 1978).
    double evidence = 0.5 * (freedom + 1) * Math.log1p(t / freedom) - Math.log(n);
    return new Cause(found, errors, 0, evidence, gain(effect, fit), List.of());
  }

  /** The gain for where the ball would be after one second at the speed of the kick. Each kick is predicted with the bias of the robot's other kicks. */
  private Gain gain(KickerEffect effect, Fit fit) {
    int n = fit.samples.size();
    List<String> names = effect.magnitudes();
    List<double[]> each = fit.samples.stream().map(s -> single(effect, s)).toList();
    double[] before = new double[n];
    double[] after = new double[n];
    for (int i = 0; i < n; i++) {
      double[] others = new double[names.size()];
      for (int j = 0; j < others.length; j++) {
        others[j] = (n * fit.values[j] - each.get(i)[j]) / (n - 1);
      }
      Sample s = fit.samples.get(i);
      before[i] = squared(s.commanded, s.measured);
      after[i] = squared(kicked(effect, names, others, s), s.measured);
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

  private static double squared(double[] a, double[] b) {
    double dx = a[0] - b[0];
    double dy = a[1] - b[1];
    return dx * dx + dy * dy;
  }
}
