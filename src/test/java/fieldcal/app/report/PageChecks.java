package fieldcal.app.report;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What every report's page must hold, and reading of what is in it. */
public final class PageChecks {
  /** A file name that tries everything. */
  public static final String HOSTILE = "a\"'<img src=x onerror=alert(1)></script><!--{{data}}.log";

  private static final Pattern DATA =
      Pattern.compile(
          "<script type=\"application/json\" id=\"data\">(.*?)</script>", Pattern.DOTALL);

  private PageChecks() {}

  /** Charts are inlined; nothing else is asked for; the page has its data and so many scripts. */
  public static void assertSelfContained(String page, int scripts) throws IOException {
    String own = page.replace(charts(), "");
    assertThat(own.length()).as("the charts are inlined").isLessThan(page.length() - 500_000);
    assertThat(found(own, "(?i)<[a-z]+[^>]*\\s(src|href|srcset|action)\\s*=")).isEmpty();
    assertThat(found(own, "(?i)@import|\\burl\\(|<link|<img|<iframe|<object|<embed")).isEmpty();
    assertThat(found(own, "(?i)fetch\\(|XMLHttpRequest|WebSocket|importScripts")).isEmpty();
    assertThat(found(own, "https?://(?!www\\.w3\\.org/2000/svg)")).isEmpty();
    assertScriptsAreWhole(page, scripts);
  }

  /** The data and so many scripts: no text ends one of them early. */
  public static void assertScriptsAreWhole(String page, int scripts) {
    assertThat(page.split("<script", -1).length).isEqualTo(scripts + 2);
    assertThat(page.split("</script>", -1).length).isEqualTo(scripts + 2);
    assertThat(found(page, "<img src=x|<!--\\{\\{")).isEmpty();
  }

  /** Texts become text nodes only. */
  public static void assertScriptsBuildNoMarkup(String page) throws IOException {
    assertThat(
            found(
                page.replace(charts(), ""),
                "innerHTML|outerHTML|insertAdjacentHTML|document\\.write|eval\\("))
        .isEmpty();
  }

  /** What matches, with little around it: the page itself would make a failure of megabytes. */
  public static List<String> found(String text, String regex) {
    return Pattern.compile(".{0,30}(?:" + regex + ").{0,30}")
        .matcher(text)
        .results()
        .map(MatchResult::group)
        .toList();
  }

  /** The view model in a page. */
  public static JsonNode data(String page) throws IOException {
    Matcher matcher = DATA.matcher(page);
    assertThat(matcher.find()).isTrue();
    return new ObjectMapper().readTree(matcher.group(1));
  }

  private static String charts() throws IOException {
    try (InputStream in = PageChecks.class.getResourceAsStream(ReportPage.CHARTS)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
