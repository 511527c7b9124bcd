package fieldcal.app.console;

import fieldcal.app.report.ReportPage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.zip.GZIPOutputStream;

/** The page's own files, held in memory: what is not in the list is not there, whatever is asked for. Immutable. */
final class Assets {
  private static final String HTML = "text/html; charset=utf-8";
  private static final String CSS = "text/css; charset=utf-8";
  private static final String JS = "text/javascript; charset=utf-8";

  /** Charts with brushing, which the reports' smaller build does not have. */
  private static final String CHARTS =
      "/META-INF/resources/_static/echarts/5.6.0/dist/echarts.min.js";

  private static final List<String> OWN =
      List.of(
          "index.html",
          "token.html",
          "console.css",
          "app.js",
          "server.js",
          "token.js",
          "parts.js",
          "kicks.js",
          "kick-table.js",
          "replay.js",
          "sessions.js",
          "diagnosis.js",
          "publish.js",
          "export.js",
          "match.js",
          "play.js",
          "recordings.js");

  /** What the console shares with the reports. */
  private static final List<String> SHARED =
      List.of(
          "charts.js",
          "frame.js",
          "frame.css",
          "calibration-plots.js",
          "calibration-views.js",
          "calibration.css");

  private final Map<String, Asset> assets = new LinkedHashMap<>();

  /**
   * One file.
   *
   * @param type for the browser
   * @param bytes its contents; not to be changed
   * @param packed the same, compressed by gzip; not to be changed
   * @param tag of these contents, so that a browser that has them need not be sent them again
   */
  record Asset(String type, byte[] bytes, byte[] packed, String tag) {
    static Asset of(String type, byte[] bytes) throws IOException {
      ByteArrayOutputStream packed = new ByteArrayOutputStream();
      try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
        gzip.write(bytes);
      }
      String tag = UUID.nameUUIDFromBytes(bytes).toString();
      return new Asset(type, bytes, packed.toByteArray(), '"' + tag + '"');
    }
  }

  Assets() throws IOException {
    for (String name : OWN) {
      put(name, Assets.class, name);
    }
    for (String name : SHARED) {
      put(name, ReportPage.class, name);
    }
    put("echarts.js", Assets.class, CHARTS);
  }

  private void put(String name, Class<?> beside, String resource) throws IOException {
    try (InputStream in = beside.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IOException("the program is incomplete: resource " + resource + " is missing");
      }
      assets.put(name, Asset.of(type(name), in.readAllBytes()));
    }
  }

  private static String type(String name) {
    return name.endsWith(".html") ? HTML : name.endsWith(".css") ? CSS : JS;
  }

  Optional<Asset> find(String name) {
    return Optional.ofNullable(assets.get(name));
  }
}
