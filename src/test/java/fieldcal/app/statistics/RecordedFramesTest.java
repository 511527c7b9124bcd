package fieldcal.app.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.vision.VisionFrame;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Frames by camera. */
class RecordedFramesTest {
  /** Statistics, and reports of them, are made in this order: the same from run to run. */
  @Test
  void camerasComeInTheOrderOfTheirIds() {
    Map<Integer, List<VisionFrame>> frames = new HashMap<>();
    List<Integer> ids = IntStream.range(0, 12).map(i -> 37 * i).boxed().toList();
    ids.forEach(id -> frames.put(id, List.of()));
    RecordedFrames made = new RecordedFrames(Path.of("one.log"), frames, List.of(), List.of(), 0);
    assertThat(made.frames().keySet()).containsExactlyElementsOf(ids);
  }
}
