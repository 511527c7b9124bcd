package fieldcal.app.report;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A report's page: one HTML file with charts, styles, scripts and data inside, which opens without a network. All reports share the frame: heading, what they
 * were made from, problems in the data, light and dark, printing.
 *
 * @param heading what kind of report it is
 * @param numbers the file that holds the numbers, for readers whose browser runs no scripts
 * @param main resource with the sections of the page
 * @param style resource with the style of these sections
 * @param scripts resources with what draws them, in order
 */
public record ReportPage(
    String heading, String numbers, String main, String style, List<String> scripts) {
  /** The smallest of ECharts' builds with scatter plots; a third smaller than the full one. */
  public static final String CHARTS =
      "/META-INF/resources/_static/echarts/5.6.0/dist/echarts.common.min.js";

  private static final List<String> FRAME_SCRIPTS = List.of(CHARTS, "charts.js", "frame.js");
  private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z.]+)}}");

  /** Copies the list. */
  public ReportPage {
    scripts = List.copyOf(scripts);
  }

  /**
   * The page as text.
   *
   * @param title of the window
   * @param data view model that the scripts find in the page; any texts in it
   * @return HTML, the same for the same data
   * @throws IOException when a resource of the program is missing
   */
  public String html(String title, Object data) throws IOException {
    List<String> code = new ArrayList<>();
    for (String script : Stream.concat(FRAME_SCRIPTS.stream(), scripts.stream()).toList()) {
      code.add("<script>\n" + resource(script) + "\n</script>");
    }
    Map<String, String> contents =
        Map.of(
            "title", escapeHtml(title),
            "heading", escapeHtml(heading),
            "numbers", escapeHtml(numbers),
            "styles", "<style>\n" + resource("frame.css") + resource(style) + "</style>",
            "main", resource(main),
            "data", ReportJson.inScript(data),
            "scripts", String.join("\n", code));
    // One pass: what is put in is not searched for slots again.
    Matcher slot = SLOT.matcher(resource("page.html"));
    StringBuilder page = new StringBuilder();
    while (slot.find()) {
      slot.appendReplacement(page, "");
      page.append(contents.get(slot.group(1)));
    }
    return slot.appendTail(page).toString();
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
