package fieldcal.app.sslsim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Vision goes on when the network fails, and goes back to it. */
class VisionSenderTest {
  private final List<String> ways = new ArrayList<>();
  private boolean networkWorks = true;
  private boolean loopbackWorks = true;
  private long nanos;

  private VisionSender sender() {
    return new VisionSender(
        packet -> take("network", networkWorks),
        packet -> take("loopback", loopbackWorks),
        () -> nanos);
  }

  private void take(String way, boolean works) throws IOException {
    if (!works) {
      throw new IOException("Network is unreachable");
    }
    ways.add(way);
  }

  @Test
  void theNetworkIsTriedAgainEachSecond() {
    VisionSender sender = sender();
    sender.send(new byte[1]);
    networkWorks = false;
    sender.send(new byte[1]);
    networkWorks = true;
    nanos += 999_999_999;
    sender.send(new byte[1]);
    nanos += 1;
    sender.send(new byte[1]);
    sender.send(new byte[1]);
    assertThat(ways).containsExactly("network", "loopback", "loopback", "network", "network");
    assertThat(sender.lost()).isZero();
  }

  @Test
  void whatCannotBeSentIsCounted() {
    VisionSender sender = sender();
    networkWorks = false;
    loopbackWorks = false;
    sender.send(new byte[1]);
    sender.send(new byte[1]);
    assertThat(ways).isEmpty();
    assertThat(sender.lost()).isEqualTo(2);
  }
}
