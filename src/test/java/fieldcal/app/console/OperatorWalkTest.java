package fieldcal.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** From an empty folder to a model that is sent: the walk of {@code docs/operator.md}, with its times. */
class OperatorWalkTest {
  @TempDir private Path folder;

  @Test
  void aNewcomerGetsFromAnEmptyFolderToAModelThatIsSent() throws Exception {
    Path session = Files.createDirectory(folder.resolve("session"));
    try (ServedKicks field = new ServedKicks();
        RunningConsole console = RunningConsole.start(session);
        Browser browser = new Browser()) {
      OperatorWalk walk = new OperatorWalk(browser, field, session);
      walk.walk(console.url());
      walk.times().forEach(System.out::println);
      assertThat(walk.times()).hasSize(5);
      browser.assertNoComplaints();
    }
  }
}
