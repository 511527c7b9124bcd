package fieldcal.testing;

import fieldcal.ball.BallState;
import org.junit.jupiter.api.Test;

/** What docs/library.md shows, so that it compiles; examples/host runs such a test. */
final class CarpetExample {
  private CarpetExample() {}

  @RecordedKicks("src/test/kicks/home.log.gz")
  class CarpetTest {

    @Test
    void nothingChanges(Recorded kicks) {
      kicks.assertModelsStay();
      kicks.assertPredictionsStay();
      kicks.assertDiagnosisStays();
    }

    @Test
    void ourPredictorStays(Recorded kicks) {
      kicks.assertPredictionsStay(
          "ours", (kicked, seconds) -> ourBall(kicked, seconds)); // x and y, m
    }
  }

  private static double[] ourBall(BallState kicked, double seconds) {
    return new double[] {kicked.x() + kicked.vx() * seconds, kicked.y() + kicked.vy() * seconds};
  }
}
