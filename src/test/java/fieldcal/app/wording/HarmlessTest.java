package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Names of others do not steer the operator's terminal. */
class HarmlessTest {
  @Test
  void whatSteersATerminalIsShownInstead() {
    assertThat(Harmless.text("Team\u001b]0;owned\u0007")).isEqualTo("Team␛]0;owned␇");
    assertThat(Harmless.text("\u001b[2J\u001b[H")).isEqualTo("␛[2J␛[H");
    assertThat(Harmless.text("a\rb\bc\u007f")).isEqualTo("a␍b␈c␡");
    assertThat(Harmless.text("\u009b2J")).isEqualTo("\ufffd2J");
    assertThat(Harmless.text("abc\u202edef")).isEqualTo("abc\ufffddef");
    assertThat(Harmless.text("\u001b[31")).isEqualTo("␛[31");
  }

  @Test
  void coloursThatHideWhatFollowsAreShownInstead() {
    assertThat(Harmless.text("a\u001b[8mb")).isEqualTo("a␛[8mb");
    assertThat(Harmless.text("\u001b[1;30;40m")).isEqualTo("␛[1;30;40m");
    assertThat(Harmless.text("\u001b[38;5;0m")).isEqualTo("␛[38;5;0m");
    assertThat(Harmless.text("\u001b[١m")).isEqualTo("␛[١m");
  }

  @Test
  void aNameEndsNoLine() {
    assertThat(Harmless.line("a\r\nfieldcal: all is well")).isEqualTo("a␍␊fieldcal: all is well");
    assertThat(Harmless.line("a\u001b[2Jb\tc")).isEqualTo("a␛[2Jb\tc");
  }

  @Test
  void linesTabsColoursAndLettersStay() {
    String text = "Größe\t3 m/s²\n\u001b[1;31mred\u001b[0m …\r\n日本";
    assertThat(Harmless.text(text)).isEqualTo(text);
  }
}
