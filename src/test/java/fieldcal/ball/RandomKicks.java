package fieldcal.ball;

import java.util.Random;

/** Kicks and models at random, over the range that matches and simulators show. All from one seeded generator. */
final class RandomKicks {
  private final Random random;

  RandomKicks(long seed) {
    random = new Random(seed);
  }

  double uniform(double min, double max) {
    return min + (max - min) * random.nextDouble();
  }

  int integer(int min, int max) {
    return min + random.nextInt(max - min + 1);
  }

  double direction() {
    return uniform(-Math.PI, Math.PI);
  }

  FlatModel flatModel() {
    return new FlatModel(uniform(-6, -2), uniform(-0.8, -0.1), uniform(0.4, 0.8));
  }

  ChipModel chipModel() {
    return new ChipModel(uniform(0.4, 1), uniform(0.5, 1), uniform(0.3, 0.8), uniform(-0.8, -0.1));
  }

  /** The numbers behind a flat kick, in the order of the sensitivities. */
  double[] flatNumbers() {
    double speed = uniform(0.5, 7);
    double direction = direction();
    FlatModel model = flatModel();
    return new double[] {
      uniform(-6, 6),
      uniform(-4.5, 4.5),
      speed * Math.cos(direction),
      speed * Math.sin(direction),
      uniform(-1, 1),
      model.accSlide(),
      model.accRoll(),
      model.kSwitch()
    };
  }

  /** The numbers behind a chip, in the order of the sensitivities. */
  double[] chipNumbers() {
    double speed = uniform(1, 5);
    double direction = direction();
    ChipModel model = chipModel();
    return new double[] {
      uniform(-6, 6),
      uniform(-4.5, 4.5),
      speed * Math.cos(direction),
      speed * Math.sin(direction),
      uniform(1, 5),
      uniform(-1, 1),
      model.dampingXyFirstHop(),
      model.dampingXyOtherHops(),
      model.dampingZ(),
      model.accRoll()
    };
  }

  static FlatTrajectory flat(double[] n) {
    FlatModel model = new FlatModel(n[5], n[6], n[7]);
    return FlatTrajectory.fromKick(model, n[4], n[0], n[1], n[2], n[3]);
  }

  static ChipTrajectory chip(double[] n, int flights) {
    ChipModel model = new ChipModel(n[6], n[7], n[8], n[9]);
    return ChipTrajectory.fromKickWithHops(model, n[5], n[0], n[1], n[2], n[3], n[4], flights);
  }

  static ChipTrajectory chip(double[] n) {
    ChipModel model = new ChipModel(n[6], n[7], n[8], n[9]);
    return ChipTrajectory.fromKick(model, n[5], n[0], n[1], n[2], n[3], n[4]);
  }
}
