package fieldcal.benchmark;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.PlayField;
import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.NetworkPlayField;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.app.sslsim.SimulatorServer;
import fieldcal.simulation.InteractiveField;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;

/** What {@code simulate --serve} serves, on free ports of this machine and on a thread of its own, until it is closed. */
final class LoopbackSimulator implements AutoCloseable {
  private final SimulatorPorts ports;
  private final NetworkPlace vision;
  private final SimulatorServer server;
  private final CompletableFuture<Void> serving;
  private volatile boolean stop;

  /**
   * Begins to serve.
   *
   * @param field to be served
   * @param impairment of the network
   * @param seed of what is lost
   * @param eachRound called on the serving thread, between steps of the field
   * @param threads one of which serves
   */
  LoopbackSimulator(
      InteractiveField field,
      Impairment impairment,
      long seed,
      Runnable eachRound,
      ExecutorService threads)
      throws IOException {
    ports = new SimulatorPorts(FreePorts.threeInARow());
    vision = NetworkPlace.parse("224.5.23.2:" + FreePorts.one(), null);
    server = new SimulatorServer(field, ports, vision.address(), impairment, seed);
    serving =
        CompletableFuture.runAsync(
            () -> {
              try {
                server.serve(
                    () -> {
                      eachRound.run();
                      return stop;
                    });
              } catch (IOException e) {
                throw new UncheckedIOException(e);
              }
            },
            threads);
  }

  /** As {@code play --ssl-sim} reaches it. */
  PlayField open() throws IOException {
    return new NetworkPlayField("127.0.0.1", ports, vision, Optional.empty());
  }

  @Override
  public void close() throws IOException {
    stop = true;
    try (server) {
      serving.join();
    }
  }
}
