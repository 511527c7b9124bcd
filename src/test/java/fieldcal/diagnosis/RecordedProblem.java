package fieldcal.diagnosis;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.calibration.Calibration;
import fieldcal.calibration.CalibrationProblem;
import fieldcal.calibration.Calibrator;
import fieldcal.calibration.HandSelection;
import fieldcal.fit.FitSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Recordings of {@code test-data}, calibrated, as the diagnosis gets them. */
public final class RecordedProblem {
  private static final long SEED = 1;

  private RecordedProblem() {}

  /** Reads and calibrates a recording; nobody knows what its robots were told. */
  public static DiagnosisProblem of(String name) throws IOException {
    return of(name, SEED);
  }

  /** The same with another seed of the diagnosis. */
  public static DiagnosisProblem of(String name, long seed) throws IOException {
    Path log =
        Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data", name + ".log.gz");
    CollectedKicks data = new KickCollector((l, read, total) -> {}).collect(List.of(log));
    Calibration calibration =
        new Calibrator(FitSettings.defaults())
            .calibrate(
                new CalibrationProblem(
                    data.kicks(),
                    data.epoch(),
                    data.cameras(),
                    data.published().flat().orElse(FlatModel.typical()),
                    data.published().chip().orElse(ChipModel.typical()),
                    Optional.empty(),
                    HandSelection.none()),
                kick -> {});
    return new DiagnosisProblem(
        calibration.fitted(),
        calibration.cameras(),
        data.observers(),
        data.sessionStart(),
        Map.of(),
        DiagnosisProblem.DEFAULT_MAX_CAUSES,
        seed);
  }
}
