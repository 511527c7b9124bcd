package fieldcal.app.twin;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.app.report.diagnosis.SampleDiagnosis;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.diagnosis.KickResiduals;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class FittedPathTest {
  /** Of {@code world/flat-kick-backspin}, the diagnosis leaves one kick out, which its fit explains to 4.3 mm; the twin did not make it. */
  @Test
  void aKickThatTheDiagnosisLeavesOutIsMadeFromItsOwnFit() {
    List<KickResiduals> diagnosed = SampleDiagnosis.adequate(3).kicks();
    FlatTrajectory simple = FlatTrajectory.fromKick(FlatModel.typical(), 0, 1, 2, 3, 4);
    List<FittedPath> alone =
        diagnosed.stream().map(k -> new FittedPath(k.kick(), KickKind.FLAT, simple)).toList();
    Kick left = diagnosed.get(1).kick();
    Map<Integer, FittedPath> all =
        FittedPath.all(alone, List.of(diagnosed.get(0), diagnosed.get(2)));
    assertThat(all).hasSize(3);
    assertThat(all.get(left.id()).path()).isSameAs(simple);
    assertThat(all.get(diagnosed.get(2).kick().id()).path()).isSameAs(diagnosed.get(2).after());
  }
}
