package fieldcal.app.twin;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.statistics.Comparison;
import fieldcal.app.statistics.FieldRecording;
import fieldcal.app.statistics.FieldStatistics;
import fieldcal.calibration.Average;
import fieldcal.kick.Kick;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * How like a field its twin is.
 *
 * @param comparisons of all statistics, the recording first
 * @param parameters of the ball model, calibrated from both
 * @param kicks of the recording
 * @param found how many of them were found in the twin's recording
 */
public record TwinCheck(
    List<Comparison> comparisons, List<Parameter> parameters, int kicks, int found) {
  /** Two times of one kick in two recordings differ by less, s: the finder's error and half a frame of a slow camera. */
  private static final double SAME_KICK = 0.15;

  /** Copies the lists. {@inheritDoc} */
  public TwinCheck {
    comparisons = List.copyOf(comparisons);
    parameters = List.copyOf(parameters);
  }

  /**
   * A parameter from both recordings.
   *
   * @param name as in {@code calibration.json}
   * @param recorded mean of the recording
   * @param recordedError its standard error
   * @param twin mean of the twin's recording
   * @param twinError its standard error
   */
  public record Parameter(
      String name, double recorded, double recordedError, double twin, double twinError) {
    /**
     * How far apart they are.
     *
     * @return in standard errors of the difference
     */
    public double sigmas() {
      return Math.abs(twin - recorded) / Math.hypot(recordedError, twinError);
    }
  }

  static TwinCheck of(FieldRecording recorded, FieldRecording twin) {
    Map<Kick, String> names = new HashMap<>();
    int found = 0;
    for (Kick kick : recorded.calibration().data().kicks()) {
      names.put(kick, name(kick));
    }
    Map<Kick, String> again = new HashMap<>();
    for (Kick kick : recorded.calibration().data().kicks()) {
      Optional<Kick> match = match(recorded, kick, twin);
      match.ifPresent(m -> again.put(m, name(kick)));
      found += match.isPresent() ? 1 : 0;
    }
    List<Comparison> comparisons =
        Comparison.of(
            FieldStatistics.of(recorded, k -> Optional.ofNullable(names.get(k))),
            FieldStatistics.of(
                twin,
                k -> Optional.ofNullable(again.get(k)),
                AlikeFits.of(
                    twin.calibration().calibration().fitted(),
                    twin.calibration().calibration().cameras(),
                    recorded.calibration().calibration().cameras())));
    return new TwinCheck(
        comparisons, parameters(recorded.calibration(), twin.calibration()), names.size(), found);
  }

  private static String name(Kick kick) {
    return String.format(Locale.ROOT, "kick %04d", kick.id());
  }

  private static Optional<Kick> match(FieldRecording recorded, Kick kick, FieldRecording twin) {
    double unix = recorded.calibration().data().epoch().unixSeconds(kick.time());
    double time = twin.calibration().data().epoch().seconds(unix);
    return twin.calibration().data().kicks().stream()
        .filter(k -> Math.abs(k.time() - time) < SAME_KICK)
        .min(java.util.Comparator.comparingDouble(k -> Math.abs(k.time() - time)));
  }

  private static List<Parameter> parameters(CalibrationOutcome a, CalibrationOutcome b) {
    List<Parameter> all = new ArrayList<>();
    add(a.calibration().flat(), b.calibration().flat(), all);
    add(a.calibration().chip(), b.calibration().chip(), all);
    return all;
  }

  private static void add(
      Map<String, Average> a, Map<String, Average> b, List<Parameter> parameters) {
    a.forEach(
        (name, average) -> {
          Average other = b.get(name);
          if (other != null && average.n() > 1 && other.n() > 1) {
            parameters.add(
                new Parameter(
                    name,
                    average.mean(),
                    average.standardError(),
                    other.mean(),
                    other.standardError()));
          }
        });
  }

  /**
   * What the twin does not reproduce.
   *
   * @return the comparisons that differ, the most certain first
   */
  public List<Comparison> different() {
    return comparisons.stream()
        .filter(Comparison::differs)
        .sorted(java.util.Comparator.comparingDouble(Comparison::p))
        .toList();
  }

  /**
   * Share of the statistics that do not differ.
   *
   * @return 0 … 1; 1 without any
   */
  public double share() {
    return comparisons.isEmpty() ? 1 : 1 - (double) different().size() / comparisons.size();
  }

  /**
   * What the twin does not reproduce, in words.
   *
   * @return one sentence for each
   */
  public List<String> sentences() {
    List<String> all = new ArrayList<>();
    if (found < kicks) {
      all.add(
          String.format(
              Locale.ROOT,
              "%d of %d kicks were not found in the twin's recording.",
              kicks - found,
              kicks));
    }
    for (Comparison c : different()) {
      all.add(TwinWords.sentence(c));
    }
    return all;
  }
}
