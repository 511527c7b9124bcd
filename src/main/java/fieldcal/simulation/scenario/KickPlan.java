package fieldcal.simulation.scenario;

import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import java.util.ArrayList;
import java.util.List;

/**
 * One kick to be made.
 *
 * @param chip whether the ball is to fly
 * @param speed m/s
 * @param elevation rad, 0 for a flat kick
 * @param mirrored whether a flat kick goes along the other diagonal
 * @param aside by how much it aims to the left of the receiver, rad
 * @param received whether the receiver tries to stop the ball
 * @param driveUpSpeed how fast the kicker drives to the ball, m/s
 * @param standing how long it stands at the ball before it kicks, s; 0 = it kicks on arrival
 */
record KickPlan(
    boolean chip,
    double speed,
    double elevation,
    boolean mirrored,
    double aside,
    boolean received,
    double driveUpSpeed,
    double standing) {

  /** Kicks with evenly spread speeds in random order; flat kicks before chips, one diagonal after the other. */
  static List<KickPlan> of(ScenarioSettings s, RandomStream random) {
    int flat =
        switch (s.kind()) {
          case FLAT -> s.kicks();
          case MIXED -> (s.kicks() + 1) / 2;
          default -> 0;
        };
    List<KickPlan> plans = new ArrayList<>();
    addBlock(plans, s, false, false, flat - flat / 2, random);
    addBlock(plans, s, false, true, flat / 2, random);
    if (s.kind() != ScenarioKind.FLAT) {
      addBlock(plans, s, true, false, s.kicks() - flat, random);
    }
    return plans;
  }

  private static void addBlock(
      List<KickPlan> plans,
      ScenarioSettings s,
      boolean chip,
      boolean mirrored,
      int count,
      RandomStream random) {
    double min = chip ? s.chipSpeedMin() : s.flatSpeedMin();
    double max = chip ? s.chipSpeedMax() : s.flatSpeedMax();
    double[] speeds = new double[count];
    for (int i = 0; i < count; i++) {
      speeds[i] = min + (max - min) * (count == 1 ? 0.5 : (double) i / (count - 1));
    }
    for (int i = count - 1; i > 0; i--) {
      int j = random.below(i + 1);
      double swap = speeds[i];
      speeds[i] = speeds[j];
      speeds[j] = swap;
    }
    for (double speed : speeds) {
      double elevation = chip ? s.elevation() + random.gaussian(0.012) : 0;
      double aside = random.gaussian(0.02);
      plans.add(
          new KickPlan(
              chip,
              speed,
              elevation,
              mirrored,
              aside,
              random.happens(s.reception()),
              random.uniform(0.15, 0.5),
              random.happens(0.4) ? random.uniform(0.2, 0.8) : 0));
    }
  }
}
