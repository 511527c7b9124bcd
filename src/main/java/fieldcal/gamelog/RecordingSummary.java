package fieldcal.gamelog;

import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What was read of a recording.
 *
 * @param epoch the instant that the recording's times count from
 * @param firstTime when the first message was received, s; NaN without messages; a message whose time differs from its neighbours' by more than an hour does not count
 * @param lastTime when the last message was received, s; NaN without messages
 * @param messages the number of messages of each type that occurs
 * @param frames the number of frames given to the listener
 * @param geometry the last geometry, if there was one
 * @param fileBytes the size of the file, bytes
 * @param logBytes the size of the log after decompression, bytes
 * @param problems what was wrong
 */
public record RecordingSummary(
    Epoch epoch,
    double firstTime,
    double lastTime,
    Map<MessageType, Long> messages,
    long frames,
    Optional<FieldGeometry> geometry,
    long fileBytes,
    long logBytes,
    ProblemAccount problems) {

  /**
   * Copies the map. {@inheritDoc}
   *
   * @throws NullPointerException if an object is null
   */
  public RecordingSummary {
    Objects.requireNonNull(epoch, "epoch");
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(problems, "problems");
    Map<MessageType, Long> copy = new EnumMap<>(MessageType.class);
    copy.putAll(messages);
    messages = Collections.unmodifiableMap(copy);
  }

  /**
   * The time between the first and the last message.
   *
   * @return s; NaN without messages
   */
  public double duration() {
    return lastTime - firstTime;
  }
}
