package fieldcal.app.report.diagnosis;

import fieldcal.ball.BallState;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.diagnosis.StructureProfile;
import fieldcal.diagnosis.StructureVariable;
import fieldcal.kick.Observations;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Profiles of the residuals of {@link SampleKicks}, binned in the plainest way. */
final class SampleProfiles {
  private static final int BINS = 16;

  private record Sample(double at, double along, double across) {}

  private SampleProfiles() {}

  static List<StructureProfile> of(List<KickResiduals> kicks, boolean after) {
    List<StructureProfile> all = new ArrayList<>();
    for (StructureVariable variable : StructureVariable.values()) {
      if (variable != StructureVariable.IMAGE_COLUMN && variable != StructureVariable.IMAGE_ROW) {
        all.add(profile(variable, samples(variable, kicks, after)));
      }
    }
    return all;
  }

  private static List<Sample> samples(
      StructureVariable variable, List<KickResiduals> kicks, boolean after) {
    List<Sample> samples = new ArrayList<>();
    for (KickResiduals k : kicks) {
      Observations o = k.kick().observations();
      for (int i = 0; i < o.size(); i++) {
        if (o.time(i) >= k.kick().time()) {
          samples.add(sample(variable, k, i, after));
        }
      }
    }
    return samples;
  }

  private static Sample sample(StructureVariable variable, KickResiduals k, int i, boolean after) {
    Observations o = k.kick().observations();
    BallState s = k.before().stateAt(o.time(i));
    double direction = Math.atan2(k.kick().vy(), k.kick().vx());
    double rx = 1000 * (after ? k.xAfter()[i] : k.xBefore()[i]);
    double ry = 1000 * (after ? k.yAfter()[i] : k.yBefore()[i]);
    if (variable == StructureVariable.CAMERA) {
      return new Sample(o.camera(i), rx, ry);
    }
    double at =
        switch (variable) {
          case TIME_SINCE_KICK -> o.time(i) - k.kick().time();
          case SPEED -> s.groundSpeed();
          case X -> o.x(i);
          case Y -> o.y(i);
          case DIRECTION -> direction;
          case HEIGHT -> s.z();
          case SESSION_TIME -> o.time(i);
          default ->
              k.kick().robot().get().number()
                  + (k.kick().robot().get().team() == Team.BLUE ? 100 : 0);
        };
    double cos = Math.cos(direction);
    double sin = Math.sin(direction);
    return new Sample(at, rx * cos + ry * sin, ry * cos - rx * sin);
  }

  private static StructureProfile profile(StructureVariable variable, List<Sample> samples) {
    boolean named = variable.unit().isEmpty();
    double min = samples.stream().mapToDouble(Sample::at).min().getAsDouble();
    double max = samples.stream().mapToDouble(Sample::at).max().getAsDouble();
    double width = named ? 1 : (max - min) / BINS + 1e-9;
    Map<Long, List<Sample>> bins = new TreeMap<>();
    for (Sample s : samples) {
      long bin = (long) Math.floor((s.at() - (named ? 0 : min)) / width);
      bins.computeIfAbsent(bin, b -> new ArrayList<>()).add(s);
    }
    List<StructureProfile.Bin> result = new ArrayList<>();
    double chi = 0;
    for (Map.Entry<Long, List<Sample>> bin : bins.entrySet()) {
      List<Sample> in = bin.getValue();
      double along = in.stream().mapToDouble(Sample::along).average().getAsDouble();
      double across = in.stream().mapToDouble(Sample::across).average().getAsDouble();
      double error = 1.5 / Math.sqrt(in.size());
      chi += (along * along + across * across) / error / error;
      double at = named ? bin.getKey() : min + width * (bin.getKey() + 0.5);
      result.add(new StructureProfile.Bin(at, along, across, error, in.size()));
    }
    double deviation = (chi - 2 * result.size()) / Math.sqrt(4.0 * result.size());
    return new StructureProfile(
        variable, result, Math.min(1, Math.abs(deviation) / 1e4), deviation);
  }
}
