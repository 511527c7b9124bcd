package fieldcal.app.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Recordings without those whose frames another one of them holds, too: what is counted twice only makes the errors too small. Decides for all commands which of them is used.
 *
 * @param different those that are used, in order
 * @param repeated the others, in order
 */
public record DifferentRecordings(List<RecordingFacts> different, List<Repeated> repeated) {
  private static final String ADVICE =
      "counting the same frames twice would only make the errors too small";

  /**
   * A copy without the file that marks it as simulated is still a recording of a simulated field; so a marked one is never left out for one that is not. Apart from that, the longer one holds more.
   */
  private static final Comparator<RecordingFacts> MARKED_THEN_LONGEST =
      Comparator.comparing((RecordingFacts facts) -> !facts.isSimulated())
          .thenComparing(facts -> -facts.content().messages());

  /** Copies the lists. {@inheritDoc} */
  public DifferentRecordings {
    different = List.copyOf(different);
    repeated = List.copyOf(repeated);
  }

  /**
   * A recording that is not used.
   *
   * @param facts the recording
   * @param original the one that is used
   */
  public record Repeated(RecordingFacts facts, RecordingFacts original) {
    /** If it had less in common, more of its kicks would be lost than counted twice. */
    private static final double SHARE = 0.5;

    private static boolean holds(RecordingFacts facts, RecordingFacts other) {
      return facts.content().messages() <= other.content().messages()
          && facts.content().mayBeHalfIn(other.content())
          && facts.content().shareIn(other.content()) > SHARE;
    }

    /**
     * What it is.
     *
     * @param name of the original
     * @return for example "a copy of a.log"
     */
    public String words(String name) {
      if (facts.content().equals(original.content())) {
        return "a copy of " + name;
      }
      double share = facts.content().shareIn(original.content());
      return share == 1
          ? "a part of " + name
          : (int) (100 * share) + " % of its frames are in " + name;
    }

    /**
     * That it is left out.
     *
     * @return one line for the operator
     */
    public DataProblem problem() {
      String what = words(original.log().toString()) + "; left out";
      return new DataProblem(facts.log().toString(), what, 1, ADVICE);
    }
  }

  /**
   * Divides recordings.
   *
   * @param all in any order
   * @return which are used
   */
  public static DifferentRecordings among(List<RecordingFacts> all) {
    List<RecordingFacts> different = new ArrayList<>();
    List<Repeated> repeated = new ArrayList<>();
    for (RecordingFacts facts : all.stream().sorted(MARKED_THEN_LONGEST).toList()) {
      Optional<RecordingFacts> original =
          different.stream().filter(other -> Repeated.holds(facts, other)).findFirst();
      original.ifPresentOrElse(
          other -> repeated.add(new Repeated(facts, other)), () -> different.add(facts));
    }
    Comparator<RecordingFacts> asGiven = Comparator.comparingInt(all::indexOf);
    different.sort(asGiven);
    repeated.sort(Comparator.comparing(Repeated::facts, asGiven));
    return new DifferentRecordings(different, repeated);
  }

  /**
   * Why a recording is not used.
   *
   * @param facts one of all
   * @return empty when it is used
   */
  public Optional<Repeated> repetition(RecordingFacts facts) {
    return repeated.stream().filter(r -> r.facts().equals(facts)).findFirst();
  }

  /**
   * Files without those that are named a second time.
   *
   * @param logs as they were named
   * @param problems is given one for each that is named again
   * @return each file once
   * @throws IOException when a path cannot be resolved
   */
  public static List<Path> once(List<Path> logs, List<DataProblem> problems) throws IOException {
    Set<Path> seen = new HashSet<>();
    List<Path> once = new ArrayList<>();
    for (Path log : logs) {
      if (seen.add(Files.exists(log) ? log.toRealPath() : log)) {
        once.add(log);
      } else {
        problems.add(new DataProblem(log.toString(), "named twice; read once", 1, ADVICE));
      }
    }
    return once;
  }
}
