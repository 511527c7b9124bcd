package fieldcal.testing;

import fieldcal.app.hardening.ParserFuzz;
import fieldcal.testing.Expectations.Value;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The file of expected values beside a team's recording, for {@link ParserFuzz}. */
public final class ExpectationsFuzz {
  private ExpectationsFuzz() {}

  /**
   * The file.
   *
   * @param scratch a folder
   * @return reads it, compares, accepts new values, and reads what that wrote
   */
  public static ParserFuzz.Target target(Path scratch) {
    Path file = scratch.resolve("home.expected");
    String good =
        """
        # What is expected of home.log.gz: name = value ± tolerance, or name = words.
        diagnosis.verdict = explained
        model.flat.accRoll = -0.27998 ± 0.0012
        model.flat.kSwitch = 0.65 ± 0.01
        predictions.ours.1.0 = 12.5 ± 1
        """;
    Map<String, Value> now =
        Map.of(
            "model.flat.accRoll", Value.of(-0.28, 0.001), "model.flat.accSlide", Value.of("none"));
    ParserFuzz.Parser parser =
        bytes -> {
          ParserFuzz.replace(file, bytes);
          Expectations read = Expectations.read(file);
          read.differences("", now);
          read.accept("model.", now, "home.log.gz");
          try {
            Expectations.read(file);
          } catch (IOException e) {
            throw new IllegalStateException("cannot read what it wrote: " + e.getMessage(), e);
          }
        };
    return new ParserFuzz.Target(parser, List.of(good.getBytes(StandardCharsets.UTF_8)));
  }
}
