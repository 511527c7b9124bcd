package fieldcal.app.report.diagnosis;

import fieldcal.app.report.Rounded;
import fieldcal.app.wording.StructureWords;
import fieldcal.diagnosis.StructureProfile;
import fieldcal.diagnosis.StructureVariable;
import java.util.List;

/**
 * How residuals depend on one variable, with the simple and with the extended model.
 *
 * @param variable its id
 * @param label a button's text
 * @param words for a sentence
 * @param unit of the variable; empty for things that have names
 * @param names of the bins, for cameras and robots; otherwise empty
 * @param axes what the two residuals are along: the path and to its left, or x and y of the field
 * @param before the simple model
 * @param after the extended model
 */
public record ProfilePicture(
    String variable,
    String label,
    String words,
    String unit,
    List<String> names,
    List<String> axes,
    Bins before,
    Bins after) {

  /** Copies the lists. */
  public ProfilePicture {
    names = List.copyOf(names);
    axes = List.copyOf(axes);
  }

  /**
   * Mean residuals; columns of equal length.
   *
   * @param at middle of the bin; directions in degrees
   * @param first mean along the first axis, mm
   * @param second mean along the second axis, mm
   * @param error what noise alone would make of the means, one standard deviation, mm
   * @param share of what is systematic that these means make up, 0 to 1
   * @param deviation standard deviations of noise that the means are above it
   */
  public record Bins(
      @Rounded(3) double[] at,
      @Rounded(2) double[] first,
      @Rounded(2) double[] second,
      @Rounded(2) double[] error,
      @Rounded(3) double share,
      @Rounded(1) double deviation) {

    /** Nothing. */
    static final Bins NONE =
        new Bins(
            new double[0], new double[0], new double[0], new double[0], Double.NaN, Double.NaN);

    static Bins of(StructureProfile profile) {
      boolean angle = profile.variable() == StructureVariable.DIRECTION;
      List<StructureProfile.Bin> bins = profile.bins();
      return new Bins(
          bins.stream().mapToDouble(b -> angle ? Math.toDegrees(b.at()) : b.at()).toArray(),
          bins.stream().mapToDouble(StructureProfile.Bin::alongMm).toArray(),
          bins.stream().mapToDouble(StructureProfile.Bin::acrossMm).toArray(),
          bins.stream().mapToDouble(StructureProfile.Bin::errorMm).toArray(),
          profile.share(),
          profile.deviation());
    }
  }

  /** The same variable before and after; an empty list of {@code after} when there is none. */
  static ProfilePicture of(StructureProfile before, List<StructureProfile> after) {
    StructureVariable variable = before.variable();
    boolean named = variable == StructureVariable.CAMERA || variable == StructureVariable.ROBOT;
    boolean inImage =
        variable == StructureVariable.CAMERA
            || variable == StructureVariable.IMAGE_COLUMN
            || variable == StructureVariable.IMAGE_ROW;
    return new ProfilePicture(
        variable.id(),
        StructureWords.brief(variable),
        StructureWords.of(variable),
        variable == StructureVariable.DIRECTION ? "°" : variable.unit(),
        named ? before.bins().stream().map(b -> name(variable, b.at())).toList() : List.of(),
        inImage ? List.of("x", "y") : List.of("along the path", "across, + is to the left"),
        Bins.of(before),
        after.stream()
            .filter(p -> p.variable() == variable)
            .findFirst()
            .map(Bins::of)
            .orElse(Bins.NONE));
  }

  /** Blue robots' numbers have 100 added. */
  private static String name(StructureVariable variable, double at) {
    int number = (int) Math.round(at);
    if (variable == StructureVariable.CAMERA) {
      return "camera " + number;
    }
    return number >= 100 ? "blue " + (number - 100) : "yellow " + number;
  }
}
