package fieldcal.app.net;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketAddress;
import java.net.SocketException;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * Receives UDP packets on a thread of its own, and keeps the newest of them until somebody takes them. Nobody waits for a slow taker: what does not fit is dropped, the oldest first, and counted, so that what
 * is taken is never old. When nothing comes for a while, or the network goes away, it joins the group again until packets come again.
 */
public final class PacketReceiver implements AutoCloseable {
  private static final int LARGEST = 65_536;
  private static final long SECOND = 1_000_000_000L;

  /** How long the channel is waited for before it is looked at again, ms: so well is known when packets came. One frame of vision takes 14 ms. */
  private static final long WAIT = 20;

  /** How long the end of the thread is waited for, ms. */
  private static final long END = 400;

  private final NetworkPlace place;
  private final int capacity;
  private final long patience;
  private final LongSupplier clock;
  private final Thread thread;

  private final Object shared = new Object();
  private final Deque<Packet> waiting = new ArrayDeque<>();
  private long received;
  private long dropped;
  private long rejoined;
  private List<String> joined = List.of();
  private long last;
  private String problem;
  private boolean closed;
  private int port;

  /** When nothing was waiting last; of the receiving thread. */
  private long lastEmpty;

  private long beforeLastLook;
  private boolean droppedBefore;
  private DatagramChannel channel;
  private Selector selector;

  /**
   * Begins to receive.
   *
   * @param place where
   * @param capacity how many packets may wait: what arrives in the longest pause of the taker that shall do no harm
   * @param patience after how long a silence the group is joined again, s
   * @throws IOException when the port cannot be opened at all, with place and reason; that no interface is there yet is no reason
   */
  public PacketReceiver(NetworkPlace place, int capacity, double patience) throws IOException {
    this(place, capacity, patience, System::nanoTime);
  }

  /** With a clock like {@link System#nanoTime}. */
  PacketReceiver(NetworkPlace place, int capacity, double patience, LongSupplier clock)
      throws IOException {
    this.place = place;
    this.capacity = capacity;
    this.patience = (long) (patience * SECOND);
    this.clock = clock;
    last = clock.getAsLong();
    lastEmpty = last;
    try {
      open();
    } catch (IOException e) {
      boolean foreign = e instanceof BindException && !place.isOwnOrGroup();
      String why =
          foreign ? "is neither a multicast group nor an address of this machine" : e.getMessage();
      throw new IOException(place + ": cannot be listened to: " + why, e);
    }
    port = ((InetSocketAddress) channel.getLocalAddress()).getPort();
    thread = new Thread(this::receive, "fieldcal-receiver-" + port);
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * The port that packets are received on.
   *
   * @return the place's; when that is 0, the one the machine chose
   */
  public int port() {
    return port;
  }

  private void open() throws IOException {
    InetAddress address = place.address().getAddress();
    selector = Selector.open();
    channel = DatagramChannel.open(StandardProtocolFamily.INET);
    channel.setOption(StandardSocketOptions.SO_REUSEADDR, true);
    if (channel.supportedOptions().contains(StandardSocketOptions.SO_REUSEPORT)) {
      channel.setOption(StandardSocketOptions.SO_REUSEPORT, place.isGroup() || place.isBroadcast());
    }
    bind(address);
    channel.configureBlocking(false);
    channel.register(selector, SelectionKey.OP_READ);
    if (place.isGroup()) {
      join(address);
    }
  }

  /**
   * Bound to the group itself, packets of other groups that other programs join do not come in; not all systems can. Broadcasts go to 255.255.255.255 or to the network's own broadcast address, as the sender
   * likes it, and only a socket that is bound to no address hears both.
   */
  private void bind(InetAddress address) throws IOException {
    int wanted = port == 0 ? place.address().getPort() : port;
    if (place.isBroadcast()) {
      channel.bind(new InetSocketAddress(wanted));
      return;
    }
    try {
      channel.bind(new InetSocketAddress(address, wanted));
    } catch (SocketException e) {
      if (!address.isMulticastAddress()) {
        throw e;
      }
      channel.bind(new InetSocketAddress(wanted));
    }
  }

  private void join(InetAddress group) throws IOException {
    List<NetworkInterface> interfaces = place.interfaces();
    List<String> on = new ArrayList<>();
    String reason = "no network interface is up";
    for (NetworkInterface one : interfaces) {
      try {
        channel.join(group, one);
        on.add(one.getName());
      } catch (IOException | IllegalArgumentException e) {
        reason = one.getName() + ": " + e.getMessage();
      }
    }
    synchronized (shared) {
      joined = List.copyOf(on);
      problem = on.isEmpty() ? reason : null;
    }
  }

  private void receive() {
    ByteBuffer buffer = ByteBuffer.allocate(LARGEST);
    long joinedAt = clock.getAsLong();
    while (!isClosed()) {
      try {
        if (!channel.isOpen()) {
          open();
          joinedAt = clock.getAsLong();
        }
        selector.select(WAIT);
        selector.selectedKeys().clear();
        // Before the look: a machine that is late after it finds a silence that packets have ended.
        long now = clock.getAsLong();
        take(buffer);
        if (now - lastPacket() > patience && now - joinedAt > patience) {
          reopen();
          joinedAt = now;
        }
      } catch (ClosedByInterruptException e) {
        return;
      } catch (IOException e) {
        synchronized (shared) {
          problem = e.getMessage();
        }
        closeChannel();
        pause();
      }
    }
  }

  private void take(ByteBuffer buffer) throws IOException {
    for (SocketAddress from = next(buffer); from != null; from = next(buffer)) {
      byte[] data = new byte[buffer.flip().remaining()];
      buffer.get(data);
      offer(new Packet(data, (InetSocketAddress) from, clock.getAsLong(), lastEmpty, true));
    }
    lastEmpty = beforeLastLook;
  }

  private SocketAddress next(ByteBuffer buffer) throws IOException {
    buffer.clear();
    // Before the look, since a pause may follow it.
    beforeLastLook = clock.getAsLong();
    return channel.receive(buffer);
  }

  private void offer(Packet packet) {
    synchronized (shared) {
      received++;
      last = packet.received();
      waiting.addLast(packet);
      if (waiting.size() > capacity) {
        waiting.removeFirst();
        dropped++;
        droppedBefore = true;
      }
      shared.notifyAll();
    }
  }

  private void reopen() throws IOException {
    closeChannel();
    synchronized (shared) {
      rejoined++;
    }
    open();
  }

  private void closeChannel() {
    try {
      channel.close();
      selector.close();
    } catch (IOException e) {
      // It is gone either way.
    }
  }

  private void pause() {
    try {
      Thread.sleep(Math.min(1000, patience / 1_000_000));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean isClosed() {
    synchronized (shared) {
      return closed;
    }
  }

  private long lastPacket() {
    synchronized (shared) {
      return last;
    }
  }

  /**
   * Takes the oldest packet that waits.
   *
   * @param millis how long to wait for one at most, ms
   * @return empty when none came
   * @throws InterruptedException when the thread is interrupted
   */
  Optional<Packet> take(long millis) throws InterruptedException {
    long until = System.nanoTime() + millis * 1_000_000;
    synchronized (shared) {
      long left = millis;
      while (waiting.isEmpty() && left > 0 && !closed) {
        shared.wait(left);
        left = (until - System.nanoTime()) / 1_000_000;
      }
      Packet first = waiting.pollFirst();
      if (first != null && droppedBefore) {
        first = first.afterDropped();
        droppedBefore = false;
      }
      return Optional.ofNullable(first);
    }
  }

  /**
   * How it does.
   *
   * @return counts up to now
   */
  public ReceiverCounts counts() {
    synchronized (shared) {
      double silent = (clock.getAsLong() - last) / (double) SECOND;
      return new ReceiverCounts(
          received, dropped, rejoined, joined, silent, Optional.ofNullable(problem));
    }
  }

  /** Ends the receiving; packets that wait can still be taken. */
  @Override
  public void close() {
    synchronized (shared) {
      closed = true;
      shared.notifyAll();
    }
    selector.wakeup();
    try {
      thread.join(END);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    closeChannel();
  }
}
