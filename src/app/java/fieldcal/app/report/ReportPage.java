package fieldcal.app.report;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The page as text: the template with styles, scripts and data put in. */
final class ReportPage {
  /** The smallest of ECharts' builds with scatter plots; a third smaller than the full one. */
  static final String CHARTS =
      "/META-INF/resources/_static/echarts/5.6.0/dist/echarts.common.min.js";

  private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z.]+)}}");

  private ReportPage() {}

  static String of(CalibrationReport report) throws IOException {
    Map<String, String> contents =
        Map.of(
            "title", escapeHtml(Verdict.of(report).title()),
            "style", resource("report.css"),
            "charts", resource(CHARTS),
            "plots", resource("plots.js"),
            "page", resource("report.js"),
            "data", ReportJson.inScript(report));
    // One pass: what is put in is not searched for slots again.
    return SLOT.matcher(resource("report.html"))
        .replaceAll(slot -> Matcher.quoteReplacement(contents.get(slot.group(1))));
  }

  private static String escapeHtml(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  private static String resource(String name) throws IOException {
    try (InputStream in = ReportPage.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IOException("the program is incomplete: resource " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
