package fieldcal.app.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;

/** What commands that end well print. */
final class Told {
  private Told() {}

  /** Runs a command in this process; returns its standard output. */
  static String by(String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status =
        Main.commandLine()
            .setOut(new PrintWriter(out, true))
            .setErr(new PrintWriter(err, true))
            .execute(arguments);
    assertThat(status).as(err.toString()).isZero();
    return out.toString();
  }
}
