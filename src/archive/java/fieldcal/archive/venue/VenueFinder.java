package fieldcal.archive.venue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * Groups matches by the field they were played on.
 *
 * <p>Cameras hang still. A match with a camera calibration that a venue has had is of that venue. One whose cameras were all calibrated again is, too, when they hang where that venue's hung in its
 * last match, the field has the same size, the last match is not long over, and the two were not played at the same time.
 */
public final class VenueFinder {
  /** Fields that differ by more are others; painted lines are measured to the centimetre, m. */
  private static final double SAME_SIZE = 0.05;

  /** Root mean square distance of the cameras' positions. Calibrating a camera again moves it by a few centimetres; cameras of two halls hang decimetres apart, m. */
  private static final double SAME_PLACE = 0.06;

  /** A tournament lasts a week; after a month the cameras have been taken down, µs. */
  private static final long LONGEST_PAUSE = 30L * 24 * 3600 * 1_000_000;

  private VenueFinder() {}

  /** A venue that grows. */
  private static final class Growing {
    private final List<MatchFacts> matches = new ArrayList<>();
    private final Set<String> calibrations = new HashSet<>();

    void add(MatchFacts match) {
      matches.add(match);
      match.cameras().stream()
          .map(CameraFacts::calibration)
          .filter(calibration -> calibration != null)
          .forEach(calibrations::add);
    }

    private MatchFacts last() {
      return matches.get(matches.size() - 1);
    }

    boolean sharesACamera(MatchFacts match) {
      return sameSize(match)
          && match.cameras().stream().anyMatch(c -> calibrations.contains(c.calibration()));
    }

    boolean looksLike(MatchFacts match) {
      long pause = match.start() - last().end();
      return sameSize(match)
          && pause >= 0
          && pause <= LONGEST_PAUSE
          && distance(last(), match) < SAME_PLACE;
    }

    private boolean sameSize(MatchFacts match) {
      return Math.abs(match.fieldLength() - last().fieldLength()) < SAME_SIZE
          && Math.abs(match.fieldWidth() - last().fieldWidth()) < SAME_SIZE;
    }
  }

  /**
   * Groups.
   *
   * @param matches in any order
   * @return the venues; matches without a geometry are of none
   */
  public static List<Venue> find(List<MatchFacts> matches) {
    List<Growing> venues = new ArrayList<>();
    List<MatchFacts> sorted = new ArrayList<>(matches);
    sorted.sort(Comparator.comparingLong(MatchFacts::start).thenComparing(MatchFacts::log));
    for (MatchFacts match : sorted) {
      if (match.geometry() == null) {
        continue;
      }
      Optional<Growing> known =
          venues.stream()
              .filter(venue -> venue.sharesACamera(match))
              .findFirst()
              .or(() -> nearest(venues, match));
      Growing venue = known.orElseGet(Growing::new);
      if (known.isEmpty()) {
        venues.add(venue);
      }
      venue.add(match);
    }
    List<Venue> named = new ArrayList<>();
    for (Growing venue : venues) {
      named.add(new Venue(String.format(Locale.ROOT, "V%02d", named.size() + 1), venue.matches));
    }
    return named;
  }

  private static Optional<Growing> nearest(List<Growing> venues, MatchFacts match) {
    return venues.stream()
        .filter(venue -> venue.looksLike(match))
        .min(Comparator.comparingDouble(venue -> distance(venue.last(), match)));
  }

  /** Root mean square over all cameras; infinite when they are not the same ones. */
  private static double distance(MatchFacts a, MatchFacts b) {
    if (a.cameras().size() != b.cameras().size() || a.cameras().isEmpty()) {
      return Double.POSITIVE_INFINITY;
    }
    double sum = 0;
    for (int i = 0; i < a.cameras().size(); i++) {
      CameraFacts one = a.cameras().get(i);
      CameraFacts other = b.cameras().get(i);
      double dx = one.x() - other.x();
      double dy = one.y() - other.y();
      double dz = one.height() - other.height();
      sum += one.id() == other.id() ? dx * dx + dy * dy + dz * dz : Double.POSITIVE_INFINITY;
    }
    double distance = Math.sqrt(sum / a.cameras().size());
    return Double.isNaN(distance) ? Double.POSITIVE_INFINITY : distance;
  }
}
