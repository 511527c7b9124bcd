package fieldcal.app.net;

import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.InterfaceAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Where packets are received: an address with a port, and the network interface.
 *
 * @param address a multicast group; a broadcast address (255.255.255.255, or the highest of a network that this machine is in), for all that is broadcast to the port; or one of this machine's own addresses, whose
 *     packets are received as they are
 * @param networkInterface the name or an address of an interface; empty: every interface that can
 */
public record NetworkPlace(InetSocketAddress address, Optional<String> networkInterface) {
  /** 255.255.255.255: everybody on the networks of the sender. */
  private static final int ALL_ONES = -1;

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws IllegalArgumentException when the address is not resolved
   */
  public NetworkPlace {
    Objects.requireNonNull(networkInterface, "networkInterface");
    if (address.isUnresolved()) {
      throw new IllegalArgumentException("'" + address.getHostString() + "' is not an address");
    }
  }

  /**
   * Reads {@code ADDR:PORT}.
   *
   * @param text for example {@code 224.5.23.2:10006}
   * @param networkInterface the name or an address of an interface; null: every interface that can
   * @return the place
   * @throws IllegalArgumentException when it is none; the message says why
   */
  public static NetworkPlace parse(String text, String networkInterface) {
    int colon = text.lastIndexOf(':');
    if (colon <= 0) {
      throw new IllegalArgumentException(
          "'" + text + "' is not an address with a port, like 224.5.23.2:10006");
    }
    int port;
    try {
      port = Integer.parseInt(text.substring(colon + 1));
    } catch (NumberFormatException e) {
      port = -1;
    }
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException(
          "'" + text.substring(colon + 1) + "' is not a port; ports are 0 to 65535");
    }
    String host = text.substring(0, colon);
    try {
      InetAddress address = InetAddress.getByName(host);
      if (networkInterface != null) {
        find(networkInterface);
      }
      if (networkInterface != null && isBroadcast(address)) {
        throw new IllegalArgumentException(
            "broadcasts to "
                + host
                + " are received on all interfaces; leave out the interface '"
                + networkInterface
                + "'");
      }
      return new NetworkPlace(
          new InetSocketAddress(address, port), Optional.ofNullable(networkInterface));
    } catch (UnknownHostException e) {
      throw new IllegalArgumentException("'" + host + "' is not an address", e);
    } catch (SocketException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * The interfaces that are there now and can receive.
   *
   * @return the one that is named, or all that are up and can multicast; may be empty while the network is away
   * @throws SocketException when the machine does not tell
   */
  List<NetworkInterface> interfaces() throws SocketException {
    if (networkInterface.isPresent()) {
      NetworkInterface named = find(networkInterface.get());
      return named.isUp() ? List.of(named) : List.of();
    }
    List<NetworkInterface> able = new ArrayList<>();
    for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      boolean v4 = one.inetAddresses().anyMatch(Inet4Address.class::isInstance);
      if (one.isUp() && v4 && (one.supportsMulticast() || one.isLoopback())) {
        able.add(one);
      }
    }
    return able;
  }

  /** Whether it is a multicast group, which has to be joined. */
  boolean isGroup() {
    return address.getAddress().isMulticastAddress();
  }

  /**
   * Whether it is a broadcast address. What is sent there needs a socket that may broadcast.
   *
   * @return true for 255.255.255.255, and for the highest address of a network that this machine is in
   */
  public boolean isBroadcast() {
    return isBroadcast(address.getAddress());
  }

  private static boolean isBroadcast(InetAddress address) {
    if (!(address instanceof Inet4Address)) {
      return false;
    }
    if (bits(address) == ALL_ONES) {
      return true;
    }
    try {
      for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
        for (InterfaceAddress own : one.getInterfaceAddresses()) {
          // Java knows no broadcast address of the loopback interface, so it is computed of all.
          int hostBits = Integer.SIZE - own.getNetworkPrefixLength();
          if (own.getAddress() instanceof Inet4Address && hostBits > 1 && hostBits < Integer.SIZE) {
            int hosts = (1 << hostBits) - 1;
            if (bits(address) == (bits(own.getAddress()) | hosts)) {
              return true;
            }
          }
        }
      }
    } catch (SocketException e) {
      // Nobody can tell.
    }
    return false;
  }

  private static int bits(InetAddress address) {
    return ByteBuffer.wrap(address.getAddress()).getInt();
  }

  /** Whether anything can be received there at all. */
  boolean isOwnOrGroup() {
    InetAddress here = address.getAddress();
    try {
      return isGroup()
          || isBroadcast(here)
          || here.isAnyLocalAddress()
          || NetworkInterface.getByInetAddress(here) != null;
    } catch (SocketException e) {
      return true; // nobody can tell
    }
  }

  private static NetworkInterface find(String wanted) throws SocketException {
    List<String> names = new ArrayList<>();
    for (NetworkInterface one : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      boolean has = one.inetAddresses().anyMatch(a -> a.getHostAddress().equals(wanted));
      if (one.getName().equals(wanted) || has) {
        return one;
      }
      names.add(one.getName());
    }
    throw new SocketException(
        "there is no network interface '" + wanted + "'; there are " + String.join(", ", names));
  }

  /** As written on the command line. */
  @Override
  public String toString() {
    String place = address.getAddress().getHostAddress() + ":" + address.getPort();
    return place + networkInterface.map(name -> " on " + name).orElse("");
  }
}
