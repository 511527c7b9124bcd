package fieldcal.archive.atlas;

import fieldcal.app.report.ReportPage;
import java.io.IOException;
import java.util.List;

/** {@code archive.html}. */
public final class AtlasPage {
  private static final String FOLDER = "/fieldcal/archive/atlas/";
  private static final ReportPage PAGE =
      new ReportPage(
          "Archive",
          "the Parquet tables beside it",
          FOLDER + "atlas.html",
          FOLDER + "atlas.css",
          List.of(FOLDER + "atlas.js"));

  private AtlasPage() {}

  /**
   * The page.
   *
   * @param view what it shows
   * @return HTML, the same for the same view
   * @throws IOException when a resource of the program is missing
   */
  public static String html(AtlasView view) throws IOException {
    return PAGE.html("Archive: " + view.logs() + " logs", view);
  }
}
