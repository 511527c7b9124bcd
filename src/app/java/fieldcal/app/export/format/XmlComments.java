package fieldcal.app.export.format;

import java.util.List;
import java.util.stream.Collectors;

/** Comments in XML. */
final class XmlComments {
  private XmlComments() {}

  /**
   * A comment for each line.
   *
   * @param lines any text; two hyphens, which end no comment but are not allowed in one, are set apart
   * @return lines of XML
   */
  static String of(List<String> lines) {
    return lines.stream()
        .map(line -> "<!-- " + line.replace("--", "- -") + " -->\n")
        .collect(Collectors.joining());
  }
}
