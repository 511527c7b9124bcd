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

  /** A camera that was knocked: 5 standard errors, which one of a million comparisons reaches by chance … */
  private static final double CERTAIN = 5;

  /** … and more than good cameras disagree anyway, m. */
  private static final double SMALLEST_MOVE = 0.002;

  /** From match to match a parameter differs by at least that part of itself, chosen well below what calling it another carpet would need: else a hundred kicks more would make changes of a thousandth certain. */
  private static final double SAME_CARPET = 0.003;

  /** The same of a camera's offset, m: a fifteenth of a good camera's noise. */
  private static final double SAME_OFFSET = 1e-4;

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

  private static double[] days(List<MatchFacts> matches) {
    return matches.stream()
        .mapToDouble(match -> (match.start() - matches.get(0).start()) / MICROS_PER_DAY)
        .toArray();
  }

  private static Measured usable(Measured measured) {
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
    int before = 0;
    for (int end : ends) {
      if (begin > 0) {
        changes.add(carpetChange(finder, telling, before, begin, end));
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
      before = begin;
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
    double[] values =
        matches.stream()
            .filter(match -> match.published().containsKey(parameter))
            .mapToDouble(match -> match.published().get(parameter))
            .sorted()
            .toArray();
    return values.length == 0 ? Double.NaN : values[values.length / 2];
  }

  private Change carpetChange(
      ChangeFinder finder, List<MatchFacts> matches, int before, int cut, int end) {
    List<String> words = new ArrayList<>();
    double most = 0;
    boolean ball = false;
    for (int s = 0; s < PARAMETERS.size(); s++) {
      ChangeFinder.Line was = finder.line(s, before, cut);
      ChangeFinder.Line is = finder.line(s, cut, end);
      double difference = is.mean() - was.mean();
      double sigmas = Math.abs(difference) / Math.hypot(was.meanError(), is.meanError());
      if (sigmas > SIGNIFICANT) {
        most = Math.max(most, sigmas);
        double share = difference / was.mean();
        ball |= PARAMETERS.get(s).equals(BALLS_OWN) && Math.abs(share) > BALLS_CHANGE;
        words.add(
            ParameterWords.ofFileName(PARAMETERS.get(s))
                + Amount.minus(
                    String.format(
                        Locale.ROOT,
                        " %.4g → %.4g (%+.0f %%)",
                        was.mean(),
                        is.mean(),
                        100 * share)));
      }
    }
    return new Change(
        venue.name(),
        ball ? Change.Kind.BALL : Change.Kind.CARPET_OR_BALL,
        OptionalInt.empty(),
        matches.get(cut - 1),
        matches.get(cut),
        String.join(", ", words),
        most);
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

  /** Cameras that report everything elsewhere from some match on, among matches with the same calibrations. */
  private void findMoves(List<MatchFacts> matches) {
    List<Integer> ids =
        matches.stream()
            .flatMap(match -> match.cameras().stream().map(CameraFacts::id))
            .distinct()
            .sorted()
            .toList();
    List<Measured[]> series = new ArrayList<>();
    for (int id : ids) {
      series.add(offsets(matches, id, true));
      series.add(offsets(matches, id, false));
    }
    ChangeFinder finder =
        new ChangeFinder(
            days(matches), series, series.stream().mapToDouble(one -> SAME_OFFSET).toArray());
    List<Integer> cuts = finder.find();
    for (int k = 0; k < cuts.size(); k++) {
      int begin = k == 0 ? 0 : cuts.get(k - 1);
      int end = k + 1 < cuts.size() ? cuts.get(k + 1) : matches.size();
      moved(finder, matches, ids, begin, cuts.get(k), end);
    }
  }

  private static Measured[] offsets(List<MatchFacts> matches, int id, boolean x) {
    return matches.stream()
        .map(
            match -> usable(camera(match, id).map(c -> x ? c.offsetX() : c.offsetY()).orElse(null)))
        .toArray(Measured[]::new);
  }

  private void moved(
      ChangeFinder finder,
      List<MatchFacts> matches,
      List<Integer> ids,
      int begin,
      int cut,
      int end) {
    double[] shift = new double[ids.size()];
    double[] sigmas = new double[ids.size()];
    String[] words = new String[ids.size()];
    double largest = 0;
    for (int i = 0; i < ids.size(); i++) {
      ChangeFinder.Line[] was = {
        finder.line(2 * i, begin, cut), finder.line(2 * i + 1, begin, cut)
      };
      ChangeFinder.Line[] is = {finder.line(2 * i, cut, end), finder.line(2 * i + 1, cut, end)};
      double dx = is[0].mean() - was[0].mean();
      double dy = is[1].mean() - was[1].mean();
      shift[i] = Math.hypot(dx, dy);
      sigmas[i] =
          Math.hypot(
              dx / Math.hypot(was[0].meanError(), is[0].meanError()),
              dy / Math.hypot(was[1].meanError(), is[1].meanError()));
      words[i] =
          Amount.minus(
              String.format(
                  Locale.ROOT,
                  "camera %d reports everything shifted by %+.1f mm in x and %+.1f mm in y",
                  ids.get(i),
                  1000 * dx,
                  1000 * dy));
      largest = Math.max(largest, shift[i]);
    }
    for (int i = 0; i < ids.size(); i++) {
      // Offsets are relative to the mean: when one camera moves, the others seem to move a little
      // the other way.
      if (shift[i] > SMALLEST_MOVE && shift[i] > 0.5 * largest && sigmas[i] > CERTAIN) {
        changes.add(
            new Change(
                venue.name(),
                Change.Kind.CAMERA_MOVED,
                OptionalInt.of(ids.get(i)),
                matches.get(cut - 1),
                matches.get(cut),
                words[i],
                sigmas[i]));
      }
    }
  }
}
