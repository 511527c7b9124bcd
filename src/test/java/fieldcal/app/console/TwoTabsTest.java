package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same button in two tabs at once. */
class TwoTabsTest {
  @TempDir private Path folder;

  private final List<Exception> refused = Collections.synchronizedList(new ArrayList<>());
  private RecordDesk desk;
  private JsonNode body;
  private Thread other;

  /** While the one begins it is asked for the time: then the other one comes. */
  private final class Interrupting extends Clock {
    @Override
    public Instant instant() {
      if (other == null) {
        other = new Thread(TwoTabsTest.this::start);
        other.start();
        try {
          // For long enough to begin a recording, if it were let.
          other.join(500);
        } catch (InterruptedException e) {
          throw new AssertionError(e);
        }
      }
      return Instant.EPOCH;
    }

    @Override
    public ZoneId getZone() {
      return ZoneOffset.UTC;
    }

    @Override
    public Clock withZone(ZoneId zone) {
      return this;
    }
  }

  private void start() {
    try {
      desk.start(body);
    } catch (IOException | RuntimeException e) {
      refused.add(e);
    }
  }

  @Test
  void oneRecordsAndCanBeEnded() throws Exception {
    int port;
    try (DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
      port = socket.getLocalPort();
    }
    body =
        JsonNodeFactory.instance.objectNode().put("vision", "127.0.0.1:" + port).put("referee", "");
    desk =
        new RecordDesk(
            SessionDirectory.open(folder), null, new Interrupting(), new EventHub(), () -> {});
    start();
    other.join();
    assertThat(refused).hasSize(1);
    assertThat(refused.get(0)).hasMessageContaining("running already");
    assertThat(desk.state().path("running").asBoolean()).isTrue();
    desk.close();
    assertThat(desk.state().path("running").asBoolean()).isFalse();
  }
}
