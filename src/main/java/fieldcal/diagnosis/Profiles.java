package fieldcal.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.KickRecord;
import fieldcal.diagnosis.model.ModelState;
import fieldcal.diagnosis.validation.Leftover;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Shows what residuals depend on, by their means over ranges of each variable. */
final class Profiles {
  private static final int BINS = 14;

  /** Fewest observations of a range that is shown. */
  private static final int FEWEST = 12;

  /** A dependence must exceed what noise makes by this many standard deviations. */
  private static final double SIGNIFICANT = 6;

  /** It must also make up this share of what is not noise. */
  private static final double SHARE = 0.1;

  private static final int MOST_NAMED = 3;

  /** A slower ball is taken to travel in the direction of the kick, m/s: noise of 1 mm from frame to frame makes such a speed. */
  private static final double SLOW = 0.05;

  private record Sample(double at, double along, double across, double variance) {}

  private Profiles() {}

  static List<StructureProfile> of(FittedModel at, double sessionStart) {
    ModelState state = at.solution().state();
    Map<StructureVariable, List<Sample>> samples = new TreeMap<>();
    for (StructureVariable v : StructureVariable.values()) {
      samples.put(v, new ArrayList<>());
    }
    for (int k = 0; k < at.kickCount(); k++) {
      collect(at, k, state, sessionStart, samples);
    }
    Leftover whole = Leftover.ofSeen(at);
    List<StructureProfile> profiles = new ArrayList<>();
    samples.forEach(
        (variable, list) -> {
          StructureProfile p = profile(variable, list, whole);
          if (p.bins().size() > 1) {
            profiles.add(p);
          }
        });
    return profiles;
  }

  /** The variables that something unexplained depends on, strongest first. */
  static List<StructureVariable> named(List<StructureProfile> profiles) {
    List<StructureProfile> strong =
        profiles.stream()
            .filter(p -> p.deviation() > SIGNIFICANT)
            .sorted(Comparator.comparingDouble((StructureProfile p) -> -p.share()))
            .toList();
    List<StructureVariable> named =
        strong.stream().filter(p -> p.share() > SHARE).map(StructureProfile::variable).toList();
    if (named.isEmpty() && !strong.isEmpty()) {
      return List.of(strong.get(0).variable());
    }
    return named.subList(0, Math.min(MOST_NAMED, named.size()));
  }

  private static void collect(
      FittedModel at,
      int k,
      ModelState state,
      double sessionStart,
      Map<StructureVariable, List<Sample>> samples) {
    EffectKick term = at.kick(k);
    KickRecord d = term.record().asSeen();
    double[] own = at.solution().own(k);
    double[] rx = new double[d.size()];
    double[] ry = new double[d.size()];
    term.plainResiduals(own, state, rx, ry);
    BallTrajectory path = term.path(own, state);
    double t0 = own[d.timeIndex()];
    double heading = Math.atan2(own[3], own[2]);
    boolean[] used = d.used();
    for (int i = 0; i < rx.length; i++) {
      if (!used[i]) {
        continue;
      }
      BallState s = path.stateAt(d.time(i));
      double speed = s.groundSpeed();
      double ux = speed > SLOW ? s.vx() / speed : Math.cos(heading);
      double uy = speed > SLOW ? s.vy() / speed : Math.sin(heading);
      double along = rx[i] * ux + ry[i] * uy;
      double across = ry[i] * ux - rx[i] * uy;
      double variance = d.variance(i);
      Sample moving = new Sample(0, along, across, variance);
      add(samples, StructureVariable.TIME_SINCE_KICK, d.time(i) - t0, moving);
      add(samples, StructureVariable.SPEED, speed, moving);
      add(samples, StructureVariable.DIRECTION, Math.atan2(uy, ux), moving);
      add(samples, StructureVariable.SESSION_TIME, d.time(i) - sessionStart, moving);
      if (s.z() > 0) {
        add(samples, StructureVariable.HEIGHT, s.z(), moving);
      }
      d.kick().robot().ifPresent(r -> add(samples, StructureVariable.ROBOT, number(r), moving));
      add(samples, StructureVariable.X, d.x(i), moving);
      add(samples, StructureVariable.Y, d.y(i), moving);
      Sample still = new Sample(0, rx[i], ry[i], variance);
      add(samples, StructureVariable.CAMERA, d.camera(i), still);
      double column = d.kick().observations().pixelX(i);
      double row = d.kick().observations().pixelY(i);
      if (column > 0 && row > 0) {
        add(samples, StructureVariable.IMAGE_COLUMN, column, still);
        add(samples, StructureVariable.IMAGE_ROW, row, still);
      }
    }
  }

  static double number(RobotId robot) {
    return robot.number() + (robot.team() == Team.BLUE ? 100 : 0);
  }

  private static void add(
      Map<StructureVariable, List<Sample>> samples, StructureVariable v, double at, Sample s) {
    samples.get(v).add(new Sample(at, s.along, s.across, s.variance));
  }

  private static StructureProfile profile(
      StructureVariable variable, List<Sample> samples, Leftover whole) {
    boolean named = variable == StructureVariable.CAMERA || variable == StructureVariable.ROBOT;
    List<StructureProfile.Bin> bins = new ArrayList<>();
    double sum = 0;
    double power = 0;
    int count = 0;
    for (List<Sample> bin : named ? byValue(samples) : byRank(samples)) {
      if (bin.size() < FEWEST) {
        continue;
      }
      double weight = 0;
      double along = 0;
      double across = 0;
      double at = 0;
      for (Sample s : bin) {
        weight += 1 / s.variance;
        along += s.along / s.variance;
        across += s.across / s.variance;
        at += s.at;
      }
      double zz = (along * along + across * across) / weight;
      sum += zz - 2;
      power += Math.max(0, zz - 2);
      count += 2;
      bins.add(
          new StructureProfile.Bin(
              at / bin.size(),
              1000 * along / weight,
              1000 * across / weight,
              1000 / Math.sqrt(weight),
              bin.size()));
    }
    double total = Math.max(1e-9, whole.systematic()) * 2 * samples.size();
    double share = samples.isEmpty() ? 0 : Math.min(1, power / total);
    double deviation = count == 0 ? 0 : sum / Math.sqrt(2.0 * count);
    return new StructureProfile(variable, bins, share, deviation);
  }

  private static List<List<Sample>> byValue(List<Sample> samples) {
    Map<Double, List<Sample>> map = new TreeMap<>();
    samples.forEach(s -> map.computeIfAbsent(s.at, a -> new ArrayList<>()).add(s));
    return new ArrayList<>(map.values());
  }

  /** Ranges with equally many samples. */
  private static List<List<Sample>> byRank(List<Sample> samples) {
    List<Sample> sorted = new ArrayList<>(samples);
    sorted.sort(Comparator.comparingDouble(Sample::at));
    List<List<Sample>> bins = new ArrayList<>();
    for (int b = 0; b < BINS; b++) {
      bins.add(sorted.subList(b * sorted.size() / BINS, (b + 1) * sorted.size() / BINS));
    }
    return bins;
  }
}
