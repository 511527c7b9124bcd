package fieldcal.app.wording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.kick.KickKind;
import fieldcal.verdict.PublishDecision;
import fieldcal.verdict.PublishVerdict;
import fieldcal.verdict.Reason;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The verdict on a model in words that are read once. */
class PublishWordsTest {
  private static Reason few(String parameter, int used) {
    return new Reason.FewKicks(KickKind.FLAT, parameter, used, 5, 8);
  }

  @Test
  void parametersWithAsManyKicksShareThem() {
    PublishWords words =
        PublishWords.of(
            new PublishVerdict(
                PublishDecision.RECORD_MORE,
                List.of(few("accSlide", 3), few("accRoll", 0), few("kSwitch", 3)),
                false));
    assertThat(words.reasons())
        .containsExactly(
            "The flat model has 3 of 8 kicks for the sliding deceleration (acc_slide) and the"
                + " switch to rolling (k_switch); no kick for the rolling deceleration"
                + " (acc_roll). Each parameter needs at least 5 kicks.");
    assertThat(words.headline())
        .isEqualTo(
            "Verdict: record more. Record fast flat kicks (4 to 6.5 m/s), flat kicks that roll"
                + " until they stop (2 to 4 m/s) and flat kicks that roll for two metres or more.");
  }

  /** Who rehearses must not carry the rehearsal's numbers to the field. */
  @Test
  void aRehearsalIsNotForSslVision() {
    List<Reason> real = List.of(new Reason.NothingPublished(KickKind.FLAT));
    List<Reason> rehearsed =
        List.of(new Reason.NothingPublished(KickKind.FLAT), new Reason.SimulatedField(2, 2));
    assertThat(headline(real)).contains("SSL-Vision");
    assertThat(headline(rehearsed))
        .isEqualTo(
            "Verdict: publish. Use the numbers on this simulated field only; for a real one, record"
                + " kicks there.");
  }

  private static String headline(List<Reason> reasons) {
    return PublishWords.of(new PublishVerdict(PublishDecision.PUBLISH, reasons, false)).headline();
  }
}
