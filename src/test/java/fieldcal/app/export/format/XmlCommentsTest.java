package fieldcal.app.export.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Two hyphens within a comment make XML that no parser reads. */
class XmlCommentsTest {
  @Test
  void noLineEndsItsComment() {
    assertThat(XmlComments.of(List.of("Written.", "Calibrate without --kind chip.")))
        .isEqualTo("<!-- Written. -->\n<!-- Calibrate without - -kind chip. -->\n");
  }
}
