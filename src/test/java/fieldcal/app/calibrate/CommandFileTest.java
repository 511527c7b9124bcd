package fieldcal.app.calibrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CommandFileTest {
  private static final Path DATA =
      Path.of(System.getProperty("fieldcal.projectDir", "."), "test-data");
  private static final RobotId YELLOW_5 = new RobotId(Team.YELLOW, 5);

  @TempDir Path folder;

  @Test
  void readsWhatTheRobotsWereTold() throws IOException {
    List<CommandFile.Command> commands =
        CommandFile.read(DATA.resolve("world-null-chip.commands.csv"));
    assertThat(commands).hasSize(24);
    CommandFile.Command first = commands.get(0);
    assertThat(first.unixTime()).isEqualTo(1762102001.130);
    assertThat(first.robot()).isEqualTo(new RobotId(Team.YELLOW, 0));
    assertThat(first.kind()).isEqualTo("chip");
    assertThat(first.speed()).isEqualTo(3.6364);
    assertThat(first.direction()).isEqualTo(Math.toRadians(91.859), within(1e-12));
    assertThat(first.elevation()).isEqualTo(Math.toRadians(46.436), within(1e-12));
  }

  @Test
  void blankLinesAreNothing() throws IOException {
    Path file = write("\n100.5,blue,3,flat,2,10,0\n\n");
    assertThat(CommandFile.read(file)).hasSize(1);
    assertThat(CommandFile.read(write(""))).isEmpty();
  }

  private Path write(String rows) throws IOException {
    return Files.writeString(folder.resolve("c.csv"), CommandFile.HEADER + "\n" + rows);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1,yellow,5,flat,2,0 | 7 columns expected, found 6",
        "1,yellow,5,flat,2,0,0,9 | 7 columns expected, found 8",
        "1,green,5,flat,2,0,0 | team must be yellow or blue",
        "1,yellow,five,flat,2,0,0 | five",
        "1,yellow,-1,flat,2,0,0 | -1",
        "soon,yellow,5,flat,2,0,0 | soon",
        "NaN,yellow,5,flat,2,0,0 | t_unix must be a number",
        "1,yellow,5,banana,2,0,0 | kind must be flat or chip",
        "1,yellow,5,flat,-1,0,0 | must not be negative",
        "1,yellow,5,flat,Infinity,0,0 | speed_mps must be a number"
      })
  void aWrongLineIsNamedWithFileAndNumber(String line, String what) throws IOException {
    Path file = write("1,yellow,5,flat,2,0,0\n" + line + "\n");
    assertThatThrownBy(() -> CommandFile.read(file))
        .isInstanceOf(InputException.class)
        .hasMessageStartingWith(file + ", line 3: ")
        .hasMessageContaining(what)
        .hasMessageNotContaining("\n");
  }

  @Test
  void aFileThatIsNoCommandFileIsNamed() throws IOException {
    Path other = Files.writeString(folder.resolve("x.csv"), "a,b,c\n1,2,3\n");
    assertThatThrownBy(() -> CommandFile.read(other))
        .isInstanceOf(InputException.class)
        .hasMessageContaining(other + ", line 1")
        .hasMessageContaining(CommandFile.HEADER);
    Path empty = Files.writeString(folder.resolve("empty.csv"), "");
    assertThatThrownBy(() -> CommandFile.read(empty)).isInstanceOf(InputException.class);
    Path binary = Files.write(folder.resolve("b.csv"), new byte[] {(byte) 0xff, (byte) 0xfe, 0});
    assertThatThrownBy(() -> CommandFile.read(binary))
        .isInstanceOf(InputException.class)
        .hasMessageContaining("line 1: the columns must be");
    Path missing = folder.resolve("missing.csv");
    assertThatThrownBy(() -> CommandFile.read(missing))
        .isInstanceOf(InputException.class)
        .hasMessage(missing + ": no such file");
  }

  @Test
  void aKickFollowsItsCommandWithinHalfASecond() throws IOException {
    List<CommandFile.Command> c =
        CommandFile.read(
            write("100,yellow,5,flat,2,0,0\n100.2,blue,5,flat,3,0,0\n101,yellow,5,flat,4,0,0\n"));
    assertThat(CommandFile.of(c, 100.1, Optional.of(YELLOW_5))).contains(c.get(0));
    assertThat(CommandFile.of(c, 100.3, Optional.of(YELLOW_5))).contains(c.get(0));
    assertThat(CommandFile.of(c, 100.25, Optional.empty())).contains(c.get(1));
    assertThat(CommandFile.of(c, 100.95, Optional.of(YELLOW_5)))
        .as("clocks may differ by a little")
        .contains(c.get(2));
    assertThat(CommandFile.of(c, 102, Optional.of(YELLOW_5))).isEmpty();
    assertThat(CommandFile.of(c, 100.1, Optional.of(new RobotId(Team.YELLOW, 6)))).isEmpty();
    assertThat(CommandFile.of(List.of(), 100.1, Optional.empty())).isEmpty();
  }
}
