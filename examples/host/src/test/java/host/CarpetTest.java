package host;

import fieldcal.testing.Recorded;
import fieldcal.testing.RecordedKicks;
import org.junit.jupiter.api.Test;

/** What the team recorded at home stays what it was, with each new version of fieldcal and of the team's own code. */
@RecordedKicks(
    value = "../../test-data/erforce-flat.log.gz",
    expected = "src/test/kicks/erforce-flat.expected")
class CarpetTest {

  @Test
  void theModelsStay(Recorded kicks) {
    kicks.assertModelsStay();
  }

  /** The team's own predictor: it knows no sliding, and the file says how far off that is. */
  @Test
  void ourPredictorStays(Recorded kicks) {
    kicks.assertPredictionsStay(
        "rollingOnly",
        (kicked, seconds) -> {
          double speed = kicked.groundSpeed();
          double rolled = Math.max(0, speed * seconds - 0.5 * 0.35 * seconds * seconds);
          return new double[] {
            kicked.x() + rolled * kicked.vx() / speed, kicked.y() + rolled * kicked.vy() / speed
          };
        });
  }
}
