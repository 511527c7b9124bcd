package fieldcal.app.export.format;

import java.util.List;

/**
 * A single value in a file.
 *
 * @param path names of what it stands in, from the outside in, and its own
 * @param start first character of the value
 * @param end character after it
 */
public record Leaf(List<String> path, int start, int end) {
  /** Copies the path. {@inheritDoc} */
  public Leaf {
    path = List.copyOf(path);
  }
}
