package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import fieldcal.app.net.NetworkPlace;
import fieldcal.app.play.PlayField;
import fieldcal.app.play.SessionRequest;
import fieldcal.app.sslsim.NetworkPlayField;
import fieldcal.app.sslsim.SimulatorPorts;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayLine.Half;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The play that an operator orders.
 *
 * @param request what is wanted
 * @param pace of the simulated field, times real time; infinite for as fast as it can
 * @param network where the robots are; empty for the simulated field in this process
 */
record PlayOrder(SessionRequest request, double pace, Optional<Network> network) {
  private static final int LONGEST_PLACE = 200;

  private static final Pattern ROBOT = Pattern.compile("(yellow|blue)(\\d{1,2})");

  /** Where a play takes place. */
  enum Field {
    /** On the simulated field in this process. */
    SIMULATED,
    /** On a simulator that speaks the league's simulation protocol. */
    SIMULATOR,
    /** On the field, with the robots behind a team's bridge. */
    ROBOTS
  }

  /** Robots on the network. */
  @FunctionalInterface
  interface Network {
    /**
     * Begins to listen and to talk.
     *
     * @throws IOException when the host is unknown or a port cannot be opened
     * @throws IllegalArgumentException when there can be no such place
     */
    PlayField open() throws IOException;
  }

  /** How the next kick is chosen. */
  enum Choice {
    /** Speeds spread evenly. */
    SPREAD,
    /** By how well it determines the least certain parameter, or distinguishes causes that the session's kicks cannot tell apart. */
    ADAPTIVE
  }

  private static Network network(Field field, JsonNode body, SessionRequest request) {
    NetworkPlace vision = NetworkPlace.parse(place(body, "vision"), null);
    String whistle = place(body, "referee");
    Optional<NetworkPlace> referee =
        whistle.isEmpty() ? Optional.empty() : Optional.of(NetworkPlace.parse(whistle, null));
    if (field == Field.ROBOTS) {
      String bridge = place(body, "bridge");
      return () ->
          NetworkPlayField.ofRobots(bridge, request.first(), request.second(), vision, referee);
    }
    String host = place(body, "host");
    if (host.isEmpty()) {
      throw ApiException.badRequest("host must name the machine of the simulator");
    }
    long port = Requests.number(body, "port").orElse(SimulatorPorts.LEAGUE.control());
    SimulatorPorts ports = new SimulatorPorts((int) Math.max(-1, Math.min(port, 100_000)));
    return () -> new NetworkPlayField(host, ports, vision, referee);
  }

  private static String place(JsonNode body, String field) {
    return Requests.text(body, field, LONGEST_PLACE).strip();
  }

  /**
   * Reads an order.
   *
   * @throws ApiException when it is none, with what is wrong
   */
  static PlayOrder of(JsonNode body) {
    KickKind kind = Requests.oneOf(body, "kind", KickKind.values());
    Half half = Requests.oneOf(body, "half", Half.values());
    Choice choice =
        body.has("choice") ? Requests.oneOf(body, "choice", Choice.values()) : Choice.SPREAD;
    try {
      SessionRequest usual =
          SessionRequest.of(kind, (int) Requests.number(body, "kicks").orElse(12));
      SessionRequest request =
          usual
              .withRobots(robot(body, "first"), robot(body, "second"))
              .withPlace(half, value(body, "across", 0))
              .withSpeeds(
                  value(body, "slowest", usual.slowest()),
                  value(body, "fastest", usual.fastest()),
                  Math.toRadians(value(body, "elevation", 45)))
              .withChoice(choice == Choice.ADAPTIVE, Requests.number(body, "seed").orElse(1))
              .withLimits(
                  usual
                      .limits()
                      .withDriveSpeed(value(body, "driveSpeed", usual.limits().driveSpeed())),
                  usual.margin());
      double pace = value(body, "pace", 0);
      if (!(pace >= 0 && pace <= 100)) {
        throw ApiException.badRequest("pace must be 0 (as fast as possible) to 100");
      }
      Field field = Requests.oneOf(body, "field", Field.values());
      return new PlayOrder(
          request,
          pace == 0 ? Double.POSITIVE_INFINITY : pace,
          field == Field.SIMULATED ? Optional.empty() : Optional.of(network(field, body, request)));
    } catch (IllegalArgumentException e) {
      throw ApiException.badRequest(e.getMessage());
    }
  }

  private static RobotId robot(JsonNode body, String field) {
    Matcher matcher = ROBOT.matcher(Requests.text(body, field, 20).strip());
    if (!matcher.matches()) {
      throw ApiException.badRequest(field + " must be a robot such as yellow3 or blue10");
    }
    Team team = matcher.group(1).equals("yellow") ? Team.YELLOW : Team.BLUE;
    return new RobotId(team, Integer.parseInt(matcher.group(2)));
  }

  private static double value(JsonNode body, String field, double usual) {
    JsonNode value = body.path(field);
    if (value.isMissingNode() || value.isNull()) {
      return usual;
    }
    if (!value.isNumber()) {
      throw ApiException.badRequest(field + " must be a number");
    }
    return value.asDouble();
  }
}
