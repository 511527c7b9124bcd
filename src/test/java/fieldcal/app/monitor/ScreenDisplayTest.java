package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.Epoch;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ScreenDisplayTest {
  @Test
  void aScreenOfItsOwnIsLeftAsItWasAndTheSummaryStays() {
    StringWriter text = new StringWriter();
    MatchStatus status =
        new MatchStatus(
            new LiveMonitor(LiveSettings.defaults(), new Epoch(0), LiveListener.NONE).snapshot(),
            new FeedStatus("a match", List.of("a note"), false),
            Optional.empty());
    try (ScreenDisplay display = new ScreenDisplay(new PrintWriter(text, true), ZoneOffset.UTC)) {
      display.show(status);
      display.show(status);
      String shown = text.toString();
      assertThat(shown).contains("a match").contains("no referee messages").contains("Ctrl-C");
      // Calm: the second came too soon.
      assertThat(shown.split("\u001b\\[H", -1)).hasSize(2);
      assertThat(shown.lines().count()).isLessThan(40);
      display.summary(status);
    }
    String after = text.toString();
    int left = after.indexOf("\u001b[?1049l");
    assertThat(left).isPositive();
    assertThat(after.substring(left)).contains("a match").contains("a note");
    assertThat(after.indexOf("\u001b[?1049l", left + 1)).isNegative();
  }
}
