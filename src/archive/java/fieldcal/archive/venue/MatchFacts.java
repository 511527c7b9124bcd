package fieldcal.archive.venue;

import java.io.Serializable;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A match, as far as many of them are compared.
 *
 * @param log fingerprint of its log
 * @param tournament that it belongs to
 * @param file name of its log
 * @param start Unix time, µs
 * @param end Unix time, µs
 * @param fieldLength m; NaN without a geometry
 * @param fieldWidth m; NaN without a geometry
 * @param geometry fingerprint of the geometry; null without one
 * @param cameras by id
 * @param model parameters that it determines, by the names of the table's columns
 * @param published parameters that vision published
 */
public record MatchFacts(
    String log,
    String tournament,
    String file,
    long start,
    long end,
    double fieldLength,
    double fieldWidth,
    String geometry,
    List<CameraFacts> cameras,
    Map<String, Measured> model,
    Map<String, Double> published)
    implements Serializable {

  /** Copies the collections, into such as can be sent. {@inheritDoc} */
  public MatchFacts {
    cameras = List.copyOf(cameras);
    model = new HashMap<>(model);
    published = new HashMap<>(published);
  }
}
