package fieldcal.app.monitor;

import fieldcal.app.wording.WordList;
import fieldcal.live.CameraFault;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Cameras whose geometry cannot be used, in lines. */
public final class CameraFaultText {
  private CameraFaultText() {}

  /**
   * One line for each reason: the placeholders of a simulator are the same for all cameras.
   *
   * @param faults by camera
   * @return for example "camera 1: no usable position: …"
   */
  public static List<String> lines(List<CameraFault> faults) {
    Map<String, List<String>> cameras = new LinkedHashMap<>();
    for (CameraFault fault : faults) {
      cameras.computeIfAbsent(fault.reason(), r -> new ArrayList<>()).add("" + fault.camera());
    }
    List<String> lines = new ArrayList<>();
    cameras.forEach(
        (reason, ids) ->
            lines.add(
                (ids.size() > 1 ? "cameras " : "camera ") + WordList.of(ids) + ": " + reason));
    return lines;
  }
}
