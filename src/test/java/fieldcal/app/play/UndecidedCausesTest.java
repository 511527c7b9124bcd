package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CalibrationSession;
import fieldcal.app.diagnose.DiagnosisOutcome;
import fieldcal.app.diagnose.SampleOutcome;
import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.diagnosis.Cause;
import fieldcal.diagnosis.Diagnoser;
import fieldcal.diagnosis.DiagnosisProblem;
import fieldcal.kick.KickKind;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.physics.BallPhysics;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A floor that is 0.4 mm per metre lower at one end of the diagonal brakes one way along it; so would the carpet's nap. Kicks along the other diagonal tell which it is. */
class UndecidedCausesTest {
  private static final long SEED = 3;
  private static final int KICKS = 12;

  /** An operator ended two sessions early: with fewer kicks along one diagonal none can be held out of a fit of the cause. */
  private static final int FIRST = 6;

  private static final int SECOND = 2;
  private static final int BEFORE = FIRST + SECOND;

  @TempDir Path directory;

  private PlaySession.Outcome play(boolean adaptive, double later, int enough) throws IOException {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, KICKS).withChoice(adaptive, SEED).into(directory);
    SimulationSettings world =
        SimulationSettings.DEFAULT
            .withSeed(SEED)
            .withPhysics(BallPhysics.ideal(-3.1, -0.28, 5.0 / 7, 0.75, 0.95, 0.52))
            .withEffects(List.of(EffectSetting.parse("field_slope:percent=0.04,direction=0.6")));
    return EndedSession.play(world, request, later, enough);
  }

  private void playBefore() throws IOException {
    play(false, 0, FIRST);
    play(false, 1800, SECOND);
  }

  private DiagnosisOutcome first(int kicks) throws IOException {
    CalibrationOutcome c = PlayRun.calibrate(directory, CalibrationSession.Progress.UNSEEN);
    DiagnosisProblem problem = EndedSession.firstKicks(c, kicks);
    return new DiagnosisOutcome(c, problem, new Diagnoser().diagnose(problem, said -> {}));
  }

  private Cause only(int kicks) throws IOException {
    List<Cause> causes = first(kicks).diagnosis().causes();
    assertThat(causes).hasSize(1);
    return causes.get(0);
  }

  @Disabled(
      "known defect: from so few kicks along one diagonal the diagnosis names neither of the two"
          + " any more")
  @Test
  void kicksAreChosenToTellCausesApart() throws Exception {
    playBefore();
    UndecidedCauses open = UndecidedCauses.of(first(BEFORE));
    assertThat(open.words()).containsExactly("sloping field or direction of the carpet");
    assertThat(open.advice().get(0)).contains("straight across the direction");
    // Along the diagonal that was kicked along, and along the other.
    double along = open.expected(plan(open, 0.59));
    double across = open.expected(plan(open, -0.59));
    assertThat(across).isGreaterThan(3 * along);

    PlaySession.Outcome third = play(true, 3600, 1);
    assertThat(third.last().kicks().get(0).played().planned().otherLine()).isTrue();
    Cause cause = only(BEFORE + 1);
    assertThat(cause.effect().id()).isEqualTo("field_slope");
    assertThat(cause.indistinguishableFrom()).isEmpty();
  }

  @Disabled(
      "known defect: from so few kicks along one diagonal the diagnosis names neither of the two"
          + " any more")
  @Test
  void spreadKicksLeaveThemUndecidedForLonger() throws Exception {
    playBefore();
    play(false, 3600, 1);
    assertThat(only(BEFORE + 1).indistinguishableFrom()).isNotEmpty();
  }

  /** Which of two cameras is shifted no kick shows: then kicks are chosen as without such a tie. */
  @Test
  void whatNoKickTellsApartChoosesNoKick() {
    UndecidedCauses open = UndecidedCauses.of(SampleOutcome.of(SampleDiagnosis.explained(8), 0));
    assertThat(open.words()).contains("offset of camera 1 or offset of camera 0");
    assertThat(open.wordsByKicks()).isEmpty();
    assertThat(open.mayBeTold()).isFalse();
    assertThat(open.expected(plan(open, 0.59))).isZero();
    assertThat(open.advice().get(0)).startsWith("No kick shows which camera is right");
  }

  private static SeenKick.Plan plan(UndecidedCauses open, double direction) {
    double x = -4.5 * Math.cos(direction);
    double y = -4.5 * Math.sin(direction);
    return new SeenKick.Plan(KickKind.FLAT, open.time(), x, y, direction, 3, 0, 8, 0.6);
  }
}
