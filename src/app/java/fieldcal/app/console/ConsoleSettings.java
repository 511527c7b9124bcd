package fieldcal.app.console;

import fieldcal.app.recording.LogOpener;
import fieldcal.vision.BallModels;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * What an operator asks of a console.
 *
 * @param directory the session: recordings and results; made if needed
 * @param address to listen on, a name or a number
 * @param port to listen on; 0 for any that is free
 * @param token that visitors must know; without one nobody is asked, which is refused on addresses that others reach
 * @param initial published model to start from and to compare with; without it, what the recordings publish
 * @param seed of the random search
 * @param opener opens recordings
 */
public record ConsoleSettings(
    Path directory,
    String address,
    int port,
    Optional<String> token,
    Optional<BallModels> initial,
    long seed,
    LogOpener opener) {
  /** The address of this machine that no other reaches. */
  public static final String LOOPBACK = "127.0.0.1";

  /** A token that is shorter could be found by trying. */
  public static final int SHORTEST_TOKEN = 12;

  /**
   * Checks that a console that others reach has a token. {@inheritDoc}
   *
   * @throws IllegalArgumentException if the port is none, the token is too short or has other characters, or one is needed and missing
   */
  public ConsoleSettings {
    Objects.requireNonNull(directory, "directory");
    Objects.requireNonNull(address, "address");
    Objects.requireNonNull(token, "token");
    Objects.requireNonNull(initial, "initial");
    Objects.requireNonNull(opener, "opener");
    if (port < 0 || port > 65535) {
      throw new IllegalArgumentException("--port must be 0 to 65535, but is " + port);
    }
    if (token.isPresent() && !token.get().matches("[A-Za-z0-9._~-]{" + SHORTEST_TOKEN + ",}")) {
      // Such as may stand in an address and in a cookie as they are.
      throw new IllegalArgumentException(
          "a token needs at least " + SHORTEST_TOKEN + " letters, digits or any of . _ ~ -");
    }
    if (token.isEmpty() && !isLoopback(address)) {
      throw new IllegalArgumentException("others reach " + address + ": a token is needed");
    }
  }

  /**
   * A console of this machine alone.
   *
   * @param directory the session
   * @param port to listen on; 0 for any that is free
   * @return the settings
   */
  public static ConsoleSettings local(Path directory, int port) {
    return new ConsoleSettings(
        directory, LOOPBACK, port, Optional.empty(), Optional.empty(), 20260101, LogOpener.USUAL);
  }

  /**
   * Whether only this machine reaches an address.
   *
   * @param address a name or a number
   * @return false also when it cannot be resolved
   */
  public static boolean isLoopback(String address) {
    try {
      return InetAddress.getByName(address).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false;
    }
  }
}
