package fieldcal.app.cli;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.sslsim.Impairment;
import fieldcal.app.sslsim.ServedField;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.app.sslsim.SimulatorServer;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.vision.RobotId;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code simulate --serve}: the field as a simulator on the network. */
final class ServeOptions {
  @Option(
      names = "--serve",
      description =
          "serves the field by the league's simulation protocol, in real time, until Ctrl-C; for"
              + " play --ssl-sim, or a team's AI")
  private boolean serve;

  @Mixin private SimulatorOptions simulator;

  @Option(
      names = "--loss",
      paramLabel = "PERCENT",
      description = "served: share of packets that are lost (default: 0 %%)")
  private double loss;

  @Option(
      names = "--delay-ms",
      paramLabel = "MS",
      description = "served: delay of packets in each direction (default: 0 ms)")
  private double delayMs;

  boolean wanted() {
    return serve;
  }

  /** Serves until the program is told to end. */
  void serve(SimulationSettings settings, Set<RobotCharacter> robots, PrintWriter out)
      throws IOException {
    RobotId[] pair = simulator.robots();
    SimulatorPorts ports = simulator.ports();
    NetworkPlace place = simulator.vision(null);
    Impairment impairment = new Impairment(loss / 100, delayMs / 1000);
    InteractiveField field =
        ServedField.now(
                settings, pair[0], pair[1], List.of(), System.currentTimeMillis() * 1_000_000L)
            .robotsLike(robots);
    AtomicBoolean stop = new AtomicBoolean();
    try (SimulatorServer server =
        new SimulatorServer(field, ports, place.address(), impairment, settings.seed())) {
      Runtime.getRuntime().addShutdownHook(new Thread(() -> stop.set(true)));
      out.printf(
          Locale.ROOT,
          "serving %s and %s on %.0f x %.0f m: vision to %s, control %d, blue %d, yellow %d;"
              + " seed %d; Ctrl-C ends it%n",
          pair[0],
          pair[1],
          settings.field().length(),
          settings.field().width(),
          place,
          ports.control(),
          ports.blue(),
          ports.yellow(),
          settings.seed());
      out.flush();
      server.serve(stop::get);
      if (server.lost() > 0) {
        out.printf(Locale.ROOT, "%d packets could not be sent%n", server.lost());
        out.flush();
      }
    }
  }
}
