package fieldcal.app.wording;

import fieldcal.verdict.VisionFault;
import java.util.List;
import java.util.Locale;

/** Faults of cameras in an operator's words. */
final class VisionFaultWords {
  private VisionFaultWords() {}

  static String sentence(VisionFault fault) {
    if (fault instanceof VisionFault.ClockRate clock) {
      double wrong = 100 * Math.abs(1 - clock.rate() * clock.rate());
      return cameras(clock.cameras())
          + ": vision's clock "
          + ClockWords.rate(clock.rate())
          + "."
          + (clock.simulator()
              ? " In a simulator this does no harm; on a real field, find out which clock is wrong."
              : String.format(
                  Locale.ROOT,
                  " If vision's clock is wrong, accelerations are %.0f %% wrong.",
                  wrong));
    }
    VisionFault.MixedUp mixed = (VisionFault.MixedUp) fault;
    String cameras = cameras(mixed.cameras());
    if (mixed.swapped()) {
      return cameras + " have swapped numbers.";
    }
    return mixed.cameras().size() == 1
        ? cameras + " is rotated by 180°."
        : "One of the " + cameras.replaceFirst("C", "c") + " is rotated by 180°.";
  }

  static String advice(VisionFault fault) {
    if (fault instanceof VisionFault.ClockRate) {
      return "Find out whether vision's or the recorder's clock is wrong; if it is vision's,"
          + " correct it and record again.";
    }
    return ((VisionFault.MixedUp) fault).swapped()
        ? "Give the cameras the numbers of their calibrations, and record again."
        : "Calibrate that camera again, and record again.";
  }

  private static String cameras(List<Integer> ids) {
    List<String> names = ids.stream().map(String::valueOf).toList();
    return (ids.size() == 1 ? "Camera " : "Cameras ") + WordList.of(names);
  }
}
