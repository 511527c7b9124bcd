package fieldcal.app.monitor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MonitorSessionTest {
  @TempDir private Path folder;

  /** Sends no frame, and falls silent and wakes up as it is asked for its state. */
  private static final class SilentFeed implements MatchFeed {
    private final boolean[] silent;
    private int asked;

    SilentFeed(boolean... silent) {
      this.silent = silent;
    }

    @Override
    public Epoch epoch() {
      return new Epoch(0);
    }

    @Override
    public Executor executor() {
      return Runnable::run;
    }

    @Override
    public LiveSettings suited(LiveSettings settings) {
      return settings;
    }

    @Override
    public void run(LiveMonitor monitor, Control control) {
      while (asked < silent.length && control.goOn()) {
        Thread.onSpinWait();
      }
    }

    @Override
    public FeedStatus status() {
      int now = Math.min(asked++, silent.length - 1);
      return new FeedStatus("a feed", List.of("vision: no packet"), silent[now]);
    }

    @Override
    public void close() {}
  }

  private MatchStatus watch(StringWriter text, MonitorRequest request, boolean... silent)
      throws IOException {
    LineDisplay display = new LineDisplay(new PrintWriter(text), ZoneOffset.UTC);
    return new MonitorSession(request, new SilentFeed(silent), display).run();
  }

  private static MonitorRequest request(Path changes, Path state) {
    return new MonitorRequest(
        Optional.empty(), Optional.ofNullable(changes), Optional.ofNullable(state));
  }

  @Test
  void silenceIsAChangeLikeOthers() throws IOException {
    Path changes = folder.resolve("changes.jsonl");
    StringWriter text = new StringWriter();
    watch(text, request(changes, null), false, false, true, true, false, false);
    List<String> events = new ArrayList<>();
    for (String line : Files.readAllLines(changes)) {
      events.add(new ObjectMapper().readTree(line).path("event").asText());
    }
    assertThat(events).containsExactly("start", "vision_lost", "vision_back", "summary");
    assertThat(text.toString()).contains("vision: no packet").contains("vision is back");
  }

  @Test
  void aStateThatCannotBeKeptIsToldBeforeTheMatch() throws IOException {
    StringWriter text = new StringWriter();
    Path file = Files.writeString(folder.resolve("file"), "");
    for (Path state : List.of(folder, file.resolve("state.json"))) {
      assertThatThrownBy(() -> watch(text, request(null, state), false))
          .isInstanceOf(IOException.class)
          .hasMessageStartingWith(state.toString());
    }
    assertThat(text.toString()).isEmpty();
  }

  @Test
  void theSummaryIsThereEvenWhenTheStateCannotBeKeptInTheEnd() {
    StringWriter text = new StringWriter();
    Path state = folder.resolve("later/state.json");
    LineDisplay display = new LineDisplay(new PrintWriter(text), ZoneOffset.UTC);
    assertThatThrownBy(
            () -> {
              MonitorSession session =
                  new MonitorSession(request(null, state), new SilentFeed(false), display);
              Files.writeString(folder.resolve("later"), "in the way");
              session.run();
            })
        .isInstanceOf(IOException.class)
        .hasMessageContaining("later");
    assertThat(text.toString()).contains("BALL     0 kicks");
  }
}
