package fieldcal.app.cli;

import fieldcal.app.net.NetworkPlace;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.vision.RobotId;
import picocli.CommandLine.Option;

/** What both ends of the league's simulation protocol must agree on. */
final class SimulatorOptions {
  @Option(
      names = "--robots",
      paramLabel = "A,B",
      description = "the two robots, for example yellow3,blue5 (default: yellow0,yellow1)")
  private String robots = "yellow0,yellow1";

  @Option(
      names = "--vision",
      paramLabel = "ADDR:PORT",
      description =
          "on the network: multicast or broadcast address of the simulator's vision (default:"
              + " 224.5.23.2:10020)")
  private String vision = "224.5.23.2:10020";

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description =
          "on the network: the simulator's control port; those of blue and yellow follow (default:"
              + " 10300)")
  private int port = SimulatorPorts.LEAGUE.control();

  RobotId[] robots() {
    return RobotNames.pair(robots);
  }

  NetworkPlace vision(String networkInterface) {
    return NetworkPlace.parse(vision, networkInterface);
  }

  SimulatorPorts ports() {
    return new SimulatorPorts(port);
  }
}
