package fieldcal.archive.venue;

import java.util.List;

/**
 * A field in a hall, with its cameras.
 *
 * @param name V01 and so on, by the first match on it
 * @param matches on it, by their start
 */
public record Venue(String name, List<MatchFacts> matches) {

  /** Copies the list. {@inheritDoc} */
  public Venue {
    matches = List.copyOf(matches);
  }
}
