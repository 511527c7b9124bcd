package fieldcal.app.monitor;

import java.util.List;
import java.util.Objects;

/**
 * How a feed does.
 *
 * @param title where frames come from
 * @param notes lines for the operator: how far a recording is read, packets lost, sources that are not listened to
 * @param silent whether frames should come and do not
 */
public record FeedStatus(String title, List<String> notes, boolean silent) {

  /** Copies the list. {@inheritDoc} */
  public FeedStatus {
    Objects.requireNonNull(title, "title");
    notes = List.copyOf(notes);
  }
}
