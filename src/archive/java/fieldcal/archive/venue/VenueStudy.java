package fieldcal.archive.venue;

import fieldcal.app.wording.Amount;
import fieldcal.app.wording.ParameterWords;
import fieldcal.calibration.Average;
import fieldcal.calibration.Sample;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.apache.commons.math3.stat.StatUtils;

/** One venue: which carpets it had, and when what changed. */
public final class VenueStudy {
  /** The parameters of the ball model, as the columns of matches are called. */
  public static final List<String> PARAMETERS =
      List.of(
          "acc_slide",
          "acc_roll",
          "k_switch",
          "damping_xy_first_hop",
          "damping_xy_other_hops",
          "damping_z");

  private static final String BALLS_OWN = "k_switch";

  /** kSwitch follows from the ball's moment of inertia alone; kicks scatter by a few per cent about it, so that a smaller change is none of the ball. */
  private static final double BALLS_CHANGE = 0.02;

  /** Differences below that many standard errors are not told. */
  private static final double SIGNIFICANT = 3;

  /** From match to match a parameter differs by at least that part of itself, chosen well below what calling it another carpet would need: else a hundred kicks more would make changes of a thousandth certain. */
  private static final double SAME_CARPET = 0.003;

  private static final double MICROS_PER_DAY = 24 * 3600 * 1e6;

  private final Venue venue;
  private final List<Carpet> carpets = new ArrayList<>();
  private final List<Change> changes = new ArrayList<>();

  private VenueStudy(Venue venue) {
    this.venue = venue;
  }

  /**
   * Studies a venue.
   *
   * @param venue with its matches
   * @return its carpets and changes
   */
  public static VenueStudy of(Venue venue) {
    VenueStudy study = new VenueStudy(venue);
    study.cutCarpets();
    study.compareCalibrations();
    study.changes.sort(
        Comparator.comparingLong((Change c) -> c.next().start())
            .thenComparing(Change::kind)
            .thenComparingInt(c -> c.camera().orElse(-1)));
    return study;
  }

  /**
   * The venue.
   *
   * @return as given
   */
  public Venue venue() {
    return venue;
  }

  /**
   * Its carpets.
   *
   * @return by time
   */
  public List<Carpet> carpets() {
    return List.copyOf(carpets);
  }

  /**
   * What changed.
   *
   * @return by time
   */
  public List<Change> changes() {
    return List.copyOf(changes);
  }

  static double[] days(List<MatchFacts> matches) {
    return matches.stream()
        .mapToDouble(match -> (match.start() - matches.get(0).start()) / MICROS_PER_DAY)
        .toArray();
  }

  static Measured usable(Measured measured) {
    return measured != null && measured.known() ? measured : null;
  }

  private void cutCarpets() {
    // A match in which nobody kicked does not show when the carpet changed.
    List<MatchFacts> telling =
        venue.matches().stream().filter(match -> !match.model().isEmpty()).toList();
    List<Measured[]> series = new ArrayList<>();
    for (String parameter : PARAMETERS) {
      series.add(
          telling.stream()
              .map(match -> usable(match.model().get(parameter)))
              .toArray(Measured[]::new));
    }
    ChangeFinder finder =
        new ChangeFinder(
            days(telling), series, series.stream().mapToDouble(VenueStudy::sameCarpet).toArray());
    List<Integer> ends = new ArrayList<>(telling.isEmpty() ? List.of() : finder.find());
    ends.add(telling.size());
    int begin = 0;
    for (int i = 0; i < ends.size(); i++) {
      int end = ends.get(i);
      if (end < telling.size()) {
        Optional<Change> change = carpetChange(finder, telling, begin, end, ends.get(i + 1));
        if (change.isEmpty()) {
          // Nothing is seen to differ: the same carpet goes on.
          continue;
        }
        changes.add(change.get());
      }
      long until = end < telling.size() ? telling.get(end).start() : Long.MAX_VALUE;
      long since = begin == 0 ? Long.MIN_VALUE : telling.get(begin).start();
      List<MatchFacts> all =
          venue.matches().stream()
              .filter(match -> match.start() >= since && match.start() < until)
              .toList();
      carpets.add(
          new Carpet(
              venue.name(),
              venue.name() + "-" + (carpets.size() + 1),
              all,
              pooled(finder, telling, begin, end)));
      begin = end;
    }
  }

  private static double sameCarpet(Measured[] series) {
    return SAME_CARPET
        * Arrays.stream(series)
            .filter(m -> m != null)
            .mapToDouble(m -> Math.abs(m.value()))
            .average()
            .orElse(0);
  }

  private static Map<String, Carpet.Pooled> pooled(
      ChangeFinder finder, List<MatchFacts> matches, int begin, int end) {
    Map<String, Carpet.Pooled> pooled = new LinkedHashMap<>();
    for (int s = 0; s < PARAMETERS.size(); s++) {
      String parameter = PARAMETERS.get(s);
      List<Sample> samples = new ArrayList<>();
      for (int i = begin; i < end; i++) {
        Measured m = usable(matches.get(i).model().get(parameter));
        if (m != null) {
          samples.add(new Sample(i, parameter, m.value(), m.error(), Optional.empty()));
        }
      }
      if (!samples.isEmpty()) {
        Average average = Average.of(samples).robust(samples);
        ChangeFinder.Line line = finder.line(s, begin, end);
        pooled.put(
            parameter,
            new Carpet.Pooled(
                average.mean(),
                average.standardError(),
                average.scatter(),
                average.n(),
                line.slope(),
                line.slopeError(),
                published(matches.subList(begin, end), parameter)));
      }
    }
    return pooled;
  }

  private static double published(List<MatchFacts> matches, String parameter) {
    double[] known =
        matches.stream()
            .filter(match -> match.published().containsKey(parameter))
            .mapToDouble(match -> match.published().get(parameter))
            .toArray();
    return StatUtils.percentile(known, 50);
  }

  /** What changed at a cut: a jump between the lines on either side, or else their slopes; empty when neither is significant. */
  private Optional<Change> carpetChange(
      ChangeFinder finder, List<MatchFacts> matches, int before, int cut, int end) {
    List<String> jumps = new ArrayList<>();
    List<String> drifts = new ArrayList<>();
    double most = 0;
    double mostOfDrift = 0;
    boolean ball = false;
    for (int s = 0; s < PARAMETERS.size(); s++) {
      String words = ParameterWords.ofFileName(PARAMETERS.get(s));
      ChangeFinder.Line first = finder.line(s, before, cut);
      ChangeFinder.Line second = finder.line(s, cut, end);
      Measured was = first.at(finder.between(cut));
      Measured is = second.at(finder.between(cut));
      double share = (is.value() - was.value()) / was.value();
      double sigmas = Math.abs(is.value() - was.value()) / Math.hypot(was.error(), is.error());
      if (sigmas > SIGNIFICANT) {
        most = Math.max(most, sigmas);
        ball |= PARAMETERS.get(s).equals(BALLS_OWN) && Math.abs(share) > BALLS_CHANGE;
        jumps.add(
            words
                + fromTo(was.value(), is.value())
                + Amount.minus(String.format(Locale.ROOT, " (%+.0f %%)", 100 * share)));
      }
      double bend =
          Math.abs(second.slope() - first.slope())
              / Math.hypot(first.slopeError(), second.slopeError());
      if (bend > SIGNIFICANT) {
        mostOfDrift = Math.max(mostOfDrift, bend);
        drifts.add("drift of " + words + fromTo(first.slope(), second.slope()) + " per day");
      }
    }
    if (jumps.isEmpty() && drifts.isEmpty()) {
      return Optional.empty();
    }
    Change.Kind jump = ball ? Change.Kind.BALL : Change.Kind.CARPET_OR_BALL;
    return Optional.of(
        new Change(
            venue.name(),
            jumps.isEmpty() ? Change.Kind.DRIFT : jump,
            OptionalInt.empty(),
            matches.get(cut - 1),
            matches.get(cut),
            String.join(", ", jumps.isEmpty() ? drifts : jumps),
            jumps.isEmpty() ? mostOfDrift : most));
  }

  private static String fromTo(double was, double is) {
    return Amount.minus(String.format(Locale.ROOT, " %.4g → %.4g", was, is));
  }

  private void compareCalibrations() {
    List<MatchFacts> matches = venue.matches();
    int begin = 0;
    for (int i = 1; i <= matches.size(); i++) {
      List<Integer> again =
          i < matches.size() ? calibratedAgain(matches.get(i - 1), matches.get(i)) : List.of();
      if (i == matches.size() || !again.isEmpty()) {
        findMoves(matches.subList(begin, i));
        begin = i;
      }
      if (again.isEmpty()) {
        continue;
      }
      MatchFacts last = matches.get(i - 1);
      MatchFacts next = matches.get(i);
      if (again.size() == next.cameras().size()) {
        changes.add(
            calibrated(last, next, OptionalInt.empty(), "all cameras were calibrated again"));
      } else {
        for (int camera : again) {
          String what = "camera " + camera + " was calibrated again";
          changes.add(calibrated(last, next, OptionalInt.of(camera), what));
        }
      }
    }
  }

  private Change calibrated(MatchFacts last, MatchFacts next, OptionalInt camera, String what) {
    return new Change(
        venue.name(), Change.Kind.CAMERA_CALIBRATED, camera, last, next, what, Double.NaN);
  }

  private static List<Integer> calibratedAgain(MatchFacts last, MatchFacts next) {
    List<Integer> again = new ArrayList<>();
    for (CameraFacts camera : next.cameras()) {
      Optional<CameraFacts> before = camera(last, camera.id());
      boolean both =
          camera.calibration() != null && before.map(CameraFacts::calibration).isPresent();
      if (both && !camera.calibration().equals(before.get().calibration())) {
        again.add(camera.id());
      }
    }
    return again;
  }

  private static Optional<CameraFacts> camera(MatchFacts match, int id) {
    return match.cameras().stream().filter(camera -> camera.id() == id).findFirst();
  }

  private void findMoves(List<MatchFacts> matches) {
    for (CameraMoves.Move move : CameraMoves.among(matches)) {
      changes.add(
          new Change(
              venue.name(),
              Change.Kind.CAMERA_MOVED,
              move.camera(),
              move.last(),
              move.next(),
              move.what(),
              move.sigmas()));
    }
  }
}
