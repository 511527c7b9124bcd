package fieldcal.app.report;

import fieldcal.app.recording.CollectedKicks;
import fieldcal.vision.Epoch;
import java.util.List;
import java.util.Objects;

/**
 * What a report was made from, and by what. No time of writing: the same input gives the same bytes.
 *
 * @param sources the recordings, as the operator named them
 * @param generatedBy program and version, for example "fieldcal 0.1.0"
 * @param seed the seed of the search, to repeat it
 * @param recordedUnix when the first recording begins, Unix time in s; NaN if unknown
 * @param duration length of all recordings together, s; NaN if unknown
 */
public record Provenance(
    List<String> sources,
    String generatedBy,
    long seed,
    @Rounded(3) double recordedUnix,
    @Rounded(1) double duration) {

  /** Copies the list. */
  public Provenance {
    sources = List.copyOf(sources);
    Objects.requireNonNull(generatedBy, "generatedBy");
  }

  /**
   * What a report of collected kicks was made from.
   *
   * @param sources the recordings, as the operator named them
   * @param data what was found in them
   * @param seed the seed of the search
   * @return with this program's version
   */
  public static Provenance of(List<String> sources, CollectedKicks data, long seed) {
    // The library's jar carries the version.
    String version = Epoch.class.getPackage().getImplementationVersion();
    return new Provenance(
        sources,
        "fieldcal " + (version == null ? "(development)" : version),
        seed,
        data.epoch().unixSeconds(0),
        data.duration());
  }
}
