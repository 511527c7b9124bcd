package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.HiddenCase.Category;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.ScenarioKind;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The cases of the unit tests: drawn once, by their size alone, and never exchanged. What is hidden stands in the list, so that it stays when the draw learns more effects; the field follows from the seed. With each stands how well its effects can be seen, which takes longer to measure than the
 * rest.
 */
public final class FrozenCases {
  private static final String FILE = "frozen-cases.txt";
  private static final int MOST_KICKS = 14;
  private static final int MOST_CAMERAS = 4;

  private FrozenCases() {}

  /**
   * A case of the list.
   *
   * @param hidden the case
   * @param visibility of each of its effects, as measured when it was drawn
   */
  record Frozen(HiddenCase hidden, List<Visibility> visibility) {}

  /**
   * Whether a case is small enough for a unit test.
   *
   * @param c the case
   * @return true with few kicks and few cameras
   */
  public static boolean small(HiddenCase c) {
    return c.settings().scenario().kicks() <= MOST_KICKS
        && c.settings().cameras().count() <= MOST_CAMERAS;
  }

  /**
   * A case as a line of the list.
   *
   * @param c the case
   * @param visibility of each of its effects
   * @return seed, kind, scenario, effects, and for each effect what is left without and with offsets of cameras, and of how many kicks
   */
  public static String line(HiddenCase c, List<Visibility> visibility) {
    String effects =
        c.hidden().stream().map(EffectSetting::toString).collect(Collectors.joining(";"));
    String seen =
        visibility.stream()
            .map(
                v ->
                    String.format(
                        Locale.ROOT, "%.2f/%.2f/%d", v.left(), v.leftWithOffsets(), v.kicks()))
            .collect(Collectors.joining(";"));
    return String.join(
        "|",
        Long.toString(c.seed()),
        c.category().name().toLowerCase(Locale.ROOT),
        c.settings().scenario().kind().label(),
        effects,
        seen);
  }

  /** The list; each case is drawn again. */
  static List<Frozen> all() {
    try (InputStream in = FrozenCases.class.getResourceAsStream(FILE)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.isBlank() && !line.startsWith("#"))
          .map(FrozenCases::parse)
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Frozen parse(String line) {
    String[] fields = line.split("[|]", -1);
    List<EffectSetting> hidden = parts(fields[3]).map(EffectSetting::parse).toList();
    List<Visibility> visibility = parts(fields[4]).map(FrozenCases::visibility).toList();
    if (hidden.size() != visibility.size()) {
      throw new IllegalStateException("effects and visibilities differ in number: " + line);
    }
    return new Frozen(
        HiddenCase.of(
            Long.parseLong(fields[0]),
            Category.valueOf(fields[1].toUpperCase(Locale.ROOT)),
            ScenarioKind.valueOf(fields[2].toUpperCase(Locale.ROOT)),
            hidden),
        visibility);
  }

  private static Stream<String> parts(String text) {
    return text.isEmpty() ? Stream.of() : Arrays.stream(text.split(";"));
  }

  private static Visibility visibility(String text) {
    String[] parts = text.split("/");
    return new Visibility(
        Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), Integer.parseInt(parts[2]));
  }
}
