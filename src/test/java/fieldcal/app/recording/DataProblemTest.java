package fieldcal.app.recording;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.gamelog.LogProblem;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What was wrong with the data, in as few lines as say it all. */
class DataProblemTest {
  private static DataProblem of(String where, String what) {
    return new DataProblem(where, what, 1, "calibrate it again");
  }

  @Test
  void whatDiffersByTheCameraAloneIsOneLine() {
    List<DataProblem> folded =
        DataProblem.folded(
            List.of(
                of("a.log, camera 0", "the pose is wrong"),
                of("a.log", "no geometry"),
                of("a.log, camera 2", "the pose is wrong"),
                of("b.log, camera 1", "the pose is wrong"),
                of("a.log, camera 10", "the pose is wrong"),
                of("a.log, camera 3", "another thing")));
    assertThat(folded)
        .extracting(DataProblem::toString)
        .containsExactly(
            "a.log, cameras 0, 2 and 10: the pose is wrong. Calibrate it again.",
            "a.log: no geometry. Calibrate it again.",
            "b.log, camera 1: the pose is wrong. Calibrate it again.",
            "a.log, camera 3: another thing. Calibrate it again.");
  }

  /** Only the camera of the first of them is known, so none is named. */
  @Test
  void framesBeforeTheGeometryAreCounted() {
    String one = LogProblem.FRAME_BEFORE_GEOMETRY.text();
    assertThat(new DataProblem("a.log", one, 11, "nothing to do: the frames are used"))
        .hasToString(
            "a.log: 11 frames come before the first geometry. Nothing to do: the frames are used.");
    assertThat(new DataProblem("a.log", one, 1, "nothing to do: the frames are used"))
        .hasToString(
            "a.log: a frame comes before the first geometry. Nothing to do: the frames are used.");
  }
}
