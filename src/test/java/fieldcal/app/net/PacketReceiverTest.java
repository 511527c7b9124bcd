package fieldcal.app.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Sockets on the loopback interface. What is waited for comes within milliseconds; the limits only keep a failure from hanging. */
@Timeout(120)
class PacketReceiverTest {
  private static final long LONG = 10_000;

  private static NetworkPlace anyPort() {
    return NetworkPlace.parse(LoopbackSender.GROUP + ":0", "127.0.0.1");
  }

  @Test
  void receivesFromSeveralSendersAndTellsThemApart() throws Exception {
    try (PacketReceiver receiver = new PacketReceiver(anyPort(), 10, 60);
        LoopbackSender one = new LoopbackSender(receiver.port());
        LoopbackSender two = new LoopbackSender(receiver.port())) {
      one.send(new byte[] {1});
      two.send(new byte[] {2, 2});
      Packet first = receiver.take(LONG).orElseThrow();
      Packet second = receiver.take(LONG).orElseThrow();
      Packet ofOne = first.data().length == 1 ? first : second;
      assertThat(ofOne.source()).isEqualTo(one.address());
      assertThat(List.of(first.source(), second.source()))
          .containsExactlyInAnyOrder(one.address(), two.address());
      assertThat(receiver.counts().received()).isEqualTo(2);
      assertThat(receiver.counts().problem()).isEmpty();
    }
  }

  @Test
  void aTakerThatPausesMissesTheOldestAndDoesNotLag() throws Exception {
    try (PacketReceiver receiver = new PacketReceiver(anyPort(), 8, 60);
        LoopbackSender sender = new LoopbackSender(receiver.port())) {
      for (int i = 0; i < 100; i++) {
        sender.send(new byte[] {(byte) i});
      }
      awaitReceived(receiver, 100);
      List<Integer> taken = new ArrayList<>();
      Optional<Packet> next = receiver.take(0);
      while (next.isPresent()) {
        taken.add((int) next.get().data()[0]);
        next = receiver.take(0);
      }
      assertThat(taken).containsExactly(92, 93, 94, 95, 96, 97, 98, 99);
      assertThat(receiver.counts().dropped()).isEqualTo(92);
    }
  }

  @Test
  void afterASilenceItJoinsAnewAndReceivesOn() throws Exception {
    try (PacketReceiver receiver = new PacketReceiver(anyPort(), 8, 0.3);
        LoopbackSender sender = new LoopbackSender(receiver.port())) {
      sendUntilTaken(sender, receiver, 1);
      while (receiver.counts().rejoined() < 2) {
        Thread.sleep(20);
      }
      sendUntilTaken(sender, receiver, 2);
      assertThat(receiver.counts().problem()).isEmpty();
    }
  }

  /** The thread is held up at each of the places where it looks at the clock, while packets come in. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4})
  void whatComesWhileTheMachineIsLateIsNotLostToARejoin(int looks) throws Exception {
    LateClock clock = new LateClock();
    try (PacketReceiver receiver = new PacketReceiver(anyPort(), 100, 60, clock);
        LoopbackSender sender = new LoopbackSender(receiver.port())) {
      sendUntilTaken(sender, receiver, 1);
      clock.holdUpAfter(
          looks,
          () -> {
            for (int i = 0; i < 50; i++) {
              sender.send(new byte[] {2});
            }
          });
      int taken = 0;
      while (taken < 50) {
        taken += receiver.take(LONG).orElseThrow().data()[0] == 2 ? 1 : 0;
      }
    }
  }

  /** Counts how often the receiving thread looks at it; once it is held up for two minutes. */
  private static final class LateClock implements LongSupplier {
    private final Thread test = Thread.currentThread();
    private long late;
    private int looks;
    private Sending meanwhile;

    private interface Sending {
      void send() throws IOException;
    }

    synchronized void holdUpAfter(int number, Sending sending) {
      looks = number;
      meanwhile = sending;
    }

    @Override
    public synchronized long getAsLong() {
      if (looks > 0 && Thread.currentThread() != test && --looks == 0) {
        try {
          meanwhile.send();
        } catch (IOException e) {
          throw new UncheckedIOException(e);
        }
        late = 120_000_000_000L;
      }
      return System.nanoTime() + late;
    }
  }

  @Test
  void anAddressOfThisMachineIsListenedToAsItIs() throws Exception {
    NetworkPlace place = NetworkPlace.parse("127.0.0.1:0", null);
    try (PacketReceiver receiver = new PacketReceiver(place, 8, 60);
        DatagramSocket sender = new DatagramSocket()) {
      InetAddress here = InetAddress.getLoopbackAddress();
      sender.send(new java.net.DatagramPacket(new byte[] {3}, 1, here, receiver.port()));
      assertThat(receiver.take(LONG).orElseThrow().data()).containsExactly(3);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"255.255.255.255:0", "127.255.255.255:0"})
  void whatIsBroadcastIsHeardByAll(String listened) throws Exception {
    NetworkPlace place = NetworkPlace.parse(listened, null);
    try (PacketReceiver receiver = new PacketReceiver(place, 8, 60);
        PacketReceiver other =
            new PacketReceiver(
                NetworkPlace.parse("255.255.255.255:" + receiver.port(), null), 8, 60);
        DatagramSocket sender = new DatagramSocket()) {
      // The loopback interface's own: a broadcast that leaves no machine.
      InetAddress all = InetAddress.getByName("127.255.255.255");
      sender.setBroadcast(true);
      sender.send(new java.net.DatagramPacket(new byte[] {5}, 1, all, receiver.port()));
      assertThat(receiver.take(LONG).orElseThrow().data()).containsExactly(5);
      assertThat(other.take(LONG).orElseThrow().data()).containsExactly(5);
    }
  }

  @Test
  void broadcastsAreNotOfOneInterface() {
    assertThatThrownBy(() -> NetworkPlace.parse("255.255.255.255:10006", "127.0.0.1"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("leave out the interface '127.0.0.1'");
  }

  @Test
  void twoProgramsCanListenToOneGroup() throws Exception {
    try (PacketReceiver receiver = new PacketReceiver(anyPort(), 8, 60)) {
      NetworkPlace same =
          NetworkPlace.parse(LoopbackSender.GROUP + ":" + receiver.port(), "127.0.0.1");
      try (PacketReceiver other = new PacketReceiver(same, 8, 60);
          LoopbackSender sender = new LoopbackSender(receiver.port())) {
        sender.send(new byte[] {4});
        assertThat(receiver.take(LONG)).isPresent();
        assertThat(other.take(LONG)).isPresent();
      }
    }
  }

  @Test
  void aPlaceThatCannotBeListenedToIsNamed() {
    // An address of the documentation's range, which no machine has.
    assertThatThrownBy(
            () -> new PacketReceiver(NetworkPlace.parse("203.0.113.7:10006", null), 8, 60))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("203.0.113.7:10006: cannot be listened to");
  }

  @ParameterizedTest
  @CsvSource({
    "224.5.23.2, is not an address with a port",
    "224.5.23.2:, is not a port",
    "224.5.23.2:99999, is not a port",
    "not an address:10006, is not an address"
  })
  void whatIsNoPlaceIsRefused(String text, String message) {
    assertThatThrownBy(() -> NetworkPlace.parse(text, null))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(message);
  }

  @Test
  void anInterfaceThatIsNotThereIsRefusedWithThoseThatAre() {
    assertThatThrownBy(() -> NetworkPlace.parse("224.5.23.2:10006", "moon0"))
        .hasMessageContaining("moon0")
        .hasMessageContaining("there are");
  }

  /** A packet that comes in the moment of joining is lost, as it is on a network that was away. */
  private static void sendUntilTaken(LoopbackSender sender, PacketReceiver receiver, int content)
      throws Exception {
    Optional<Packet> taken = Optional.empty();
    while (taken.isEmpty() || taken.get().data()[0] != content) {
      sender.send(new byte[] {(byte) content});
      taken = receiver.take(100);
    }
  }

  private static void awaitReceived(PacketReceiver receiver, long count) throws Exception {
    while (receiver.counts().received() < count) {
      Thread.sleep(5);
    }
  }
}
