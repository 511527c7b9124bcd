package fieldcal.app.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files are replaced, links are followed, and what is no file is written to as it is. */
class WholeFileTest {
  @TempDir private Path folder;

  @Test
  void aLinkStaysAndItsTargetIsReplaced() throws IOException {
    Path target = Files.createDirectory(folder.resolve("elsewhere")).resolve("model.json");
    Files.writeString(target, "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.json"), target);
    WholeFile.write("new", link);
    assertThat(link).isSymbolicLink().hasContent("new");
    assertThat(target).hasContent("new");
    assertThat(files(target.getParent())).containsExactly("model.json");
  }

  @Test
  void aLinkToNothingYetGetsItsTarget() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("link.json"), Path.of("later.json"));
    WholeFile.write("new", link);
    assertThat(link).isSymbolicLink();
    assertThat(folder.resolve("later.json")).hasContent("new");
  }

  @Test
  void aLinkToALinkToNothingYetGetsTheLastTarget() throws IOException {
    Path second = Files.createSymbolicLink(folder.resolve("second.json"), Path.of("later.json"));
    Path first = Files.createSymbolicLink(folder.resolve("first.json"), second.getFileName());
    WholeFile.write("new", first);
    assertThat(first).isSymbolicLink();
    assertThat(second).isSymbolicLink();
    assertThat(folder.resolve("later.json")).hasContent("new");
  }

  @Test
  void aLinkThatLeadsToItselfIsAnErrorAndStays() throws IOException {
    Path self = Files.createSymbolicLink(folder.resolve("self.json"), Path.of("self.json"));
    Path there = Files.createSymbolicLink(folder.resolve("there.json"), Path.of("back.json"));
    Path back = Files.createSymbolicLink(folder.resolve("back.json"), Path.of("there.json"));
    for (Path link : List.of(self, there, back)) {
      assertThatThrownBy(() -> WholeFile.write("new", link))
          .isInstanceOf(FileSystemException.class)
          .hasMessage(link + ": is a symbolic link that leads to itself; name a file");
      assertThat(Files.isSymbolicLink(link)).isTrue();
    }
    assertThat(files(folder)).containsExactlyInAnyOrder("self.json", "there.json", "back.json");
  }

  @Test
  void aPipeIsWrittenToAndStaysOne() throws Exception {
    Path pipe = folder.resolve("pipe");
    assumeTrue(
        new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0, "no mkfifo here");
    CompletableFuture<String> read =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return Files.readString(pipe);
              } catch (IOException e) {
                return e.toString();
              }
            });
    WholeFile.write("through", pipe);
    assertThat(read.get(10, TimeUnit.SECONDS)).isEqualTo("through");
    assertThat(Files.isRegularFile(pipe)).isFalse();
    assertThat(files(folder)).containsExactly("pipe");
  }

  @Test
  void aFullDeviceIsAnErrorThatNamesIt() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "no /dev/full here");
    assertThatThrownBy(() -> WholeFile.write("x", full))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("/dev/full");
  }

  @Test
  void whatKilledProgramsLeftIsRemovedAndNothingElse() throws Exception {
    Process over = new ProcessBuilder("true").start();
    over.waitFor();
    // The number of a program that is no more, and of one that runs.
    Path left = old("report.html." + over.pid() + ".part");
    Path own = old("report.html." + ProcessHandle.current().pid() + ".part");
    Path recent = Files.createFile(folder.resolve("model.json." + over.pid() + ".part"));
    Path foreign = old("film.mkv.part");
    WholeFile.write("x", folder.resolve("model.json"));
    assertThat(left).doesNotExist();
    assertThat(own).exists();
    assertThat(recent).exists();
    assertThat(foreign).exists();
  }

  private Path old(String name) throws IOException {
    Path file = Files.createFile(folder.resolve(name));
    Files.setLastModifiedTime(file, FileTime.from(Instant.now().minusSeconds(3600)));
    return file;
  }

  @Test
  void aProgramThatIsToldToEndRemovesWhatItWasWriting() throws Exception {
    Process writing =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                "fieldcal.app.files.SlowWriter",
                folder.resolve("big.json").toString())
            .redirectErrorStream(true)
            .start();
    try {
      assertThat(writing.inputReader().readLine()).isEqualTo("writing");
      assertThat(files(folder)).containsExactly("big.json." + writing.pid() + ".part");
    } finally {
      writing.destroy();
    }
    writing.waitFor();
    assertThat(files(folder)).isEmpty();
  }

  private static Stream<String> names(Path directory) throws IOException {
    return Files.list(directory).map(f -> f.getFileName().toString()).sorted();
  }

  private static java.util.List<String> files(Path directory) throws IOException {
    try (Stream<String> names = names(directory)) {
      return names.toList();
    }
  }
}
