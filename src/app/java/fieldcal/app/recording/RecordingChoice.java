package fieldcal.app.recording;

import fieldcal.verdict.FieldSize;
import fieldcal.verdict.Surroundings;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Which recordings of a folder belong together. A ball model holds for one carpet, and a match is no calibration; so what was recorded for calibration on the field of the newest such recording is used, and
 * recordings of matches, of a simulated field and of other fields are kept apart, and so is a second file with the same frames or a part of them. Recordings of one of these sorts are used where there is nothing better. Somebody's decision overrides the rule.
 *
 * @param entries one for each recording, in order
 */
public record RecordingChoice(List<Entry> entries) {
  /** Copies the list. */
  public RecordingChoice {
    entries = List.copyOf(entries);
  }

  /** Why a recording is kept apart. */
  public enum Apart {
    /** It is not. */
    NO,
    /** Another recording holds the same frames. */
    COPY,
    /** The field was simulated. */
    SIMULATED,
    /** The referee let a match run. */
    MATCH,
    /** The field has another size. */
    OTHER_FIELD,
    /** Every camera is calibrated differently. */
    OTHER_CAMERAS
  }

  /**
   * One recording.
   *
   * @param facts where it comes from
   * @param used whether its kicks are calibrated
   * @param apart why the rule keeps it apart
   * @param byHand whether somebody decided
   * @param repeated of which recording it is a copy or a part; empty for all others
   */
  public record Entry(
      RecordingFacts facts,
      boolean used,
      Apart apart,
      boolean byHand,
      Optional<DifferentRecordings.Repeated> repeated) {
    /**
     * Its name.
     *
     * @return of the file
     */
    public String name() {
      return facts.log().getFileName().toString();
    }

    /**
     * Why it is used or not, for people.
     *
     * @return a few words
     */
    public String words() {
      String cut = "the file is cut off: its end is missing or damaged";
      return !facts.cut() ? choice() : choice().isEmpty() ? cut : choice() + "; " + cut;
    }

    private String choice() {
      if (byHand) {
        return used
            ? "used by hand" + (apart == Apart.NO ? "" : ", though " + why())
            : "left out by hand";
      }
      return used ? "" : why();
    }

    private String why() {
      return switch (apart) {
        case NO -> "";
        case COPY ->
            repeated.map(r -> r.words(r.original().log().getFileName().toString())).orElseThrow();
        case SIMULATED -> "from a simulated field";
        case MATCH -> String.format(Locale.ROOT, "of a match (%.0f s of play)", facts.playing());
        case OTHER_FIELD ->
            facts
                .geometry()
                .map(FieldSize::of)
                .map(
                    s ->
                        String.format(
                            Locale.ROOT,
                            "from another field (%.2f × %.2f m)",
                            s.length(),
                            s.width()))
                .orElse("from another field");
        case OTHER_CAMERAS ->
            "its cameras do not match: another field, or all were calibrated again";
      };
    }
  }

  /**
   * Chooses.
   *
   * @param all the recordings of a folder
   * @param byHand what somebody decided, by the name of the file: whether it is used
   * @return the choice, in the same order
   */
  public static RecordingChoice of(List<RecordingFacts> all, Map<String, Boolean> byHand) {
    DifferentRecordings divided = DifferentRecordings.among(all);
    List<RecordingFacts> different = divided.different();
    int best = different.stream().mapToInt(RecordingChoice::rank).min().orElse(0);
    Optional<FieldGeometry> field =
        different.stream()
            .filter(f -> rank(f) == best && f.geometry().isPresent())
            .max(Comparator.comparingLong(RecordingFacts::startUnixNanos))
            .flatMap(RecordingFacts::geometry);
    List<Entry> entries = new ArrayList<>();
    for (RecordingFacts facts : all) {
      Optional<DifferentRecordings.Repeated> repeated = divided.repetition(facts);
      Apart apart = repeated.isPresent() ? Apart.COPY : apart(facts, best, field);
      Boolean decided = byHand.get(facts.log().getFileName().toString());
      boolean used = decided == null ? apart == Apart.NO : decided;
      entries.add(new Entry(facts, used, apart, decided != null, repeated));
    }
    return new RecordingChoice(entries);
  }

  /**
   * The copies that are left out, as problems of the data: who sees two files expects the kicks of both.
   *
   * @return one for each
   */
  public List<DataProblem> copies() {
    return entries.stream()
        .filter(entry -> !entry.used())
        .flatMap(entry -> entry.repeated().stream())
        .map(DifferentRecordings.Repeated::problem)
        .toList();
  }

  /**
   * The recordings that come from the same place as a given one.
   *
   * @param all to choose from
   * @param reference one of them
   * @return those of the same origin, field and cameras
   */
  public static List<RecordingFacts> alike(List<RecordingFacts> all, RecordingFacts reference) {
    return all.stream()
        .filter(f -> f.origin() == reference.origin())
        .filter(f -> place(f, reference.geometry()) == Apart.NO)
        .toList();
  }

  /** The better suited for a calibration, the lower. */
  private static int rank(RecordingFacts facts) {
    return (facts.isSimulated() ? 2 : 0) + (facts.isMatch() ? 1 : 0);
  }

  private static Apart apart(RecordingFacts facts, int best, Optional<FieldGeometry> field) {
    if (rank(facts) == best) {
      return place(facts, field);
    }
    return facts.isSimulated() && best < 2 ? Apart.SIMULATED : Apart.MATCH;
  }

  /** What has no geometry is not known to be from elsewhere. */
  private static Apart place(RecordingFacts facts, Optional<FieldGeometry> field) {
    if (field.isEmpty() || facts.geometry().isEmpty()) {
      return Apart.NO;
    }
    FieldGeometry its = facts.geometry().get();
    if (!FieldSize.of(its).isLike(FieldSize.of(field.get()))) {
      return Apart.OTHER_FIELD;
    }
    return Surroundings.shareACamera(its, field.get()) ? Apart.NO : Apart.OTHER_CAMERAS;
  }
}
