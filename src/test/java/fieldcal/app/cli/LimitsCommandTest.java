package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.proto.Referee;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The command as an operator runs it: exit codes, one line on bad input, the contract's JSON, the page. */
class LimitsCommandTest {
  @TempDir private static Path shared;

  private static Path first;
  private static Path second;

  @TempDir private Path folder;

  private record Answer(int exit, String out, String err) {}

  private static Answer run(Object... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine commands = Main.commandLine();
    commands.setOut(new PrintWriter(out));
    commands.setErr(new PrintWriter(err));
    int exit = commands.execute(Arrays.stream(args).map(Object::toString).toArray(String[]::new));
    return new Answer(exit, out.toString(), err.toString());
  }

  private static Path match(String name, int seed) {
    Path log = shared.resolve(name);
    Answer answer =
        run(
            "simulate",
            "--scenario=match",
            "--minutes=1",
            "--team-size=4",
            "--cameras=2",
            "--yellow-limits=2.5,3,4",
            "--blue-limits=3,3.5,5",
            "--seed=" + seed,
            "--out=" + log);
    assertThat(answer.exit()).as(answer.err()).isZero();
    return log;
  }

  @BeforeAll
  static void simulate() {
    first = match("first.log.gz", 5);
    second = match("second.log.gz", 6);
  }

  private JsonNode json(Object... logs) throws IOException {
    Path file = folder.resolve("limits" + logs.length + ".json");
    List<Object> args = new ArrayList<>(List.of("limits"));
    args.addAll(List.of(logs));
    args.add("--json=" + file);
    Answer answer = run(args.toArray());
    assertThat(answer.exit()).as(answer.err()).isZero();
    return new ObjectMapper().readTree(file.toFile());
  }

  @Test
  void theContractIsKept() throws IOException {
    JsonNode root = json(first, second);
    assertThat(root.path("schema").asText()).isEqualTo("fieldcal.limits/1");
    JsonNode yellow = root.at("/teams/yellow");
    JsonNode blue = root.at("/teams/blue");
    assertThat(yellow.path("velocity_max").asDouble()).isEqualTo(2.5, within(0.125));
    assertThat(yellow.path("acceleration_max").asDouble()).isEqualTo(3, within(0.15));
    assertThat(yellow.path("braking_max").asDouble()).isEqualTo(4, within(0.2));
    assertThat(blue.path("velocity_max").asDouble()).isEqualTo(3, within(0.15));
    assertThat(blue.path("acceleration_max").asDouble()).isEqualTo(3.5, within(0.175));
    assertThat(blue.path("braking_max").asDouble()).isEqualTo(5, within(0.25));
    for (JsonNode team : List.of(yellow, blue)) {
      for (String name : List.of("velocity_max", "acceleration_max", "braking_max")) {
        assertThat(team.at("/samples/" + name).asLong()).isPositive();
        assertThat(team.at("/standard_errors/" + name).asDouble()).isBetween(1e-6, 0.2);
        assertThat(team.at("/league/" + name).asDouble()).isPositive();
      }
      assertThat(team.path("effects")).isEmpty();
      assertThat(team.path("robots")).isEmpty();
      assertThat(team.at("/angular/acceleration_max").asDouble()).isEqualTo(40, within(2.0));
      assertThat(team.at("/angular/standard_errors/acceleration_max").asDouble())
          .isBetween(0.1, 2.0);
      for (JsonNode envelope : team.path("envelopes")) {
        assertThat(envelope.path("shaped").asBoolean()).isFalse();
        double limit = team.path(envelope.path("seen_in").asText() + "_max").asDouble();
        for (JsonNode point : envelope.path("points")) {
          assertThat(point.path("angle").asDouble()).isBetween(0.0, 2 * Math.PI);
          assertThat(point.path("value").asDouble()).isEqualTo(limit, within(0.15 * limit));
          assertThat(point.path("standard_error").asDouble()).isPositive();
        }
      }
      assertThat(team.path("envelopes")).isNotEmpty();
    }
    assertThat(root.path("referee_seen").asBoolean()).isTrue();
    assertThat(root.path("sources")).hasSize(2);
  }

  @Test
  void recordingsMergeExactlyInAnyOrder() throws IOException {
    JsonNode forth = json(first, second);
    JsonNode back = json(second, first);
    assertThat(back.path("teams")).isEqualTo(forth.path("teams"));
    long apart =
        json(first).at("/teams/blue/manoeuvres").asLong()
            + json(second).at("/teams/blue/manoeuvres").asLong();
    assertThat(forth.at("/teams/blue/manoeuvres").asLong()).isEqualTo(apart);
  }

  @Test
  void aRecordingNamedTwiceIsReadOnce() throws IOException {
    JsonNode once = json(first);
    JsonNode twice = json(first, first);
    assertThat(twice.path("teams")).isEqualTo(once.path("teams"));
    assertThat(twice.at("/problems/0/what").asText()).contains("named twice");
  }

  /** Movements that count twice would make the errors too small. */
  @Test
  void aCopyIsReadOnce() throws IOException {
    Path copy = Files.copy(first, folder.resolve("copy.log.gz"));
    JsonNode once = json(first, second);
    JsonNode twice = json(first, second, copy);
    assertThat(twice.path("teams")).isEqualTo(once.path("teams"));
    assertThat(twice.path("sources")).isEqualTo(once.path("sources"));
    assertThat(twice.at("/problems/0/where").asText()).isEqualTo(copy.toString());
    assertThat(twice.at("/problems/0/what").asText())
        .isEqualTo("a copy of " + first + "; left out");
  }

  /** A copy in which the referee calls yellow by another name, or says nothing at all. */
  private static Path withReferee(Path from, Path to, String yellow) throws IOException {
    try (GameLogReader reader = GameLogReader.open(from);
        GameLogWriter writer = GameLogWriter.create(to)) {
      while (reader.next()) {
        byte[] payload =
            Arrays.copyOfRange(
                reader.buffer(),
                reader.payloadOffset(),
                reader.payloadOffset() + reader.payloadLength());
        if (reader.type() == MessageType.SSL_REFBOX_2013) {
          if (yellow.isEmpty()) {
            continue;
          }
          Referee.Builder referee = Referee.parseFrom(payload).toBuilder();
          referee.getYellowBuilder().setName(yellow);
          payload = referee.build().toByteArray();
        }
        writer.write(reader.receivedNanos(), reader.type(), payload);
      }
    }
    return to;
  }

  @Test
  void anotherTeamUnderTheSameColourIsTold() throws IOException {
    Path other = withReferee(second, folder.resolve("other.log.gz"), "Somebody Else");
    Answer answer = run("limits", first, other);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out()).contains("yellow is 'Somebody Else' here").doesNotContain("blue is");
    assertThat(json(other).at("/teams/yellow/name").asText()).isEqualTo("Somebody Else");
  }

  @Test
  void withoutARefereeItSaysSo() throws IOException {
    Path log = withReferee(first, folder.resolve("silent.log.gz"), "");
    Answer answer = run("limits", log);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out().replaceAll("\\s+", " "))
        .contains("no referee message", "Everything was counted");
    assertThat(json(log).path("referee_seen").asBoolean()).isFalse();
  }

  @Test
  void aRecordingWithoutRobotsHasNullsAndReasons() throws IOException {
    Path log = EditedLog.copy(first, folder.resolve("empty.log.gz"), p -> VisionPacket.EMPTY);
    JsonNode root = json(log);
    assertThat(root.at("/teams/yellow/velocity_max").isNull()).isTrue();
    assertThat(root.at("/teams/yellow/notes/acceleration_max").asText()).isNotEmpty();
    Path out = folder.resolve("out");
    Answer answer = run("limits", log, "--out=" + out);
    assertThat(answer.out()).contains("yellow   no manoeuvre was seen");
    assertThat(out.resolve("limits.html")).exists();
  }

  @Test
  void thePageLoadsNothingFromOutsideAndIsReproducible() throws IOException {
    Path out = folder.resolve("out");
    Answer answer = run("limits", first, "--out=" + out);
    assertThat(answer.exit()).as(answer.err()).isZero();
    assertThat(answer.out())
        .contains("yellow", "blue", "braking", "turning, rad/s", "limits.html")
        .contains("The league's estimate is the 99.5th percentile");
    assertThat(answer.out()).doesNotContain("NaN");
    String page = Files.readString(out.resolve("limits.html"));
    assertThat(page).contains("Movement limits").doesNotContain("{{");
    assertThat(page).doesNotContainPattern("(?i)<[a-z]+[^>]*\\s(src|href)\\s*=\\s*[\"']?http");
    assertThat(page.length()).isLessThan(2_500_000);
    assertThat(out.resolve("limits.json")).exists();
    Path again = folder.resolve("again");
    run("limits", first, "--out=" + again);
    assertThat(Files.readString(again.resolve("limits.html"))).isEqualTo(page);
  }

  @Test
  void badInputIsOneLine() throws IOException {
    Path missing = folder.resolve("missing.log.gz");
    oneLine(run("limits", first, missing), missing);
    Path notes = Files.writeString(folder.resolve("notes.log.gz"), "these are notes, no recording");
    oneLine(run("limits", notes, first), notes);
    oneLine(run("limits", first, "--out=" + notes), notes);
    oneLine(run("limits", first, "--json=" + folder), folder);
  }

  private static void oneLine(Answer answer, Path file) {
    assertThat(answer.exit()).as(answer.toString()).isEqualTo(1);
    assertThat(answer.err().lines()).as(answer.err()).hasSize(1);
    assertThat(answer.err()).startsWith("fieldcal: ").contains(file.toString());
    assertThat(answer.err()).doesNotContain("defect");
  }

  @Test
  void wrongUsageIsTwo() {
    assertThat(run("limits").exit()).isEqualTo(2);
    assertThat(run("limits", first, "--colour=red").exit()).isEqualTo(2);
    Answer help = run("limits", "--help");
    assertThat(help.exit()).isZero();
    assertThat(help.out()).contains("--out", "--json", "LOG");
  }
}
