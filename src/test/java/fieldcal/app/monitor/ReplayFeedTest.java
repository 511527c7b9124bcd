package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.recording.LogOpener;
import fieldcal.gamelog.RefereeState;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** A match that is replayed at a pace. */
class ReplayFeedTest {
  private static final Path LOG =
      Path.of(
          System.getProperty("fieldcal.projectDir", "."),
          "test-data",
          "mujoco-rolling-chip.log.gz");

  /** So slow that there are more than a second between two frames; that is no pause of the recording. */
  @Test
  void framesThatAreFarApartAreWaitedFor() throws Exception {
    MatchFeed.Control control =
        new MatchFeed.Control() {
          private int asked;

          @Override
          public boolean goOn() {
            return ++asked < 5;
          }

          @Override
          public void referee(RefereeState state) {}

          @Override
          public void refereeLost() {}
        };
    try (ReplayFeed feed = new ReplayFeed(LOG, 1e-6, LogOpener.USUAL)) {
      LiveMonitor monitor =
          new LiveMonitor(
              LiveSettings.defaults(), feed.epoch(), LiveListener.NONE, feed.executor());
      feed.run(monitor, control);
      assertThat(monitor.snapshot().frames()).isLessThan(20);
    }
  }
}
