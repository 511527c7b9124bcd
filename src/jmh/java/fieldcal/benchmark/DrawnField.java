package fieldcal.benchmark;

import fieldcal.fit.Estimate;
import fieldcal.fit.JointFit;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.BallPhysics;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * A field whose ball is drawn at random, with cameras that disagree by 20 mm and have 1.5 mm of noise.
 *
 * @param truth parameters by name, those of flat kicks first
 * @param settings of the simulation
 */
record DrawnField(Map<String, Double> truth, SimulationSettings settings) {

  static DrawnField of(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    Map<String, Double> truth = new LinkedHashMap<>();
    truth.put("accSlide", -random.nextDouble(2.6, 4));
    truth.put("accRoll", -random.nextDouble(0.2, 0.36));
    truth.put("kSwitch", random.nextDouble(0.58, 0.71));
    truth.put("dampingXyFirstHop", random.nextDouble(0.65, 0.85));
    truth.put("dampingXyOtherHops", random.nextDouble(0.85, 0.97));
    truth.put("dampingZ", random.nextDouble(0.4, 0.55));
    double[] p = truth.values().stream().mapToDouble(Double::doubleValue).toArray();
    CameraSettings cameras =
        CameraSettings.DEFAULT.withNoise(0.0015, 0.003).withRegistration(0.0215, 0.02);
    SimulationSettings settings =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withPhysics(BallPhysics.ideal(p[0], p[1], p[2], p[3], p[4], p[5]))
            .withCameras(cameras);
    return new DrawnField(truth, settings);
  }

  /** What a joint fit says of one of the parameters, when it is determined. */
  static Optional<Estimate> estimate(JointFit joint, String name) {
    Optional<Estimate> flat = joint.flat(name);
    return (flat.isPresent() ? flat : joint.chip(name)).filter(Estimate::usable);
  }
}
