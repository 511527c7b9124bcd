package fieldcal.gamelog;

import fieldcal.proto.Referee;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * What the referee did in a recording.
 *
 * @param messages how many messages it sent
 * @param commands how often each command was given
 * @param stages the parts of the match, in order
 * @param last the last message
 */
public record RefereeStatistics(
    long messages,
    Map<Referee.Command, Long> commands,
    List<StageStart> stages,
    RefereeState last) {

  /**
   * Copies the collections. {@inheritDoc}
   *
   * @throws NullPointerException if one is null
   */
  public RefereeStatistics {
    Map<Referee.Command, Long> copy = new EnumMap<>(Referee.Command.class);
    copy.putAll(commands);
    commands = Collections.unmodifiableMap(copy);
    stages = List.copyOf(stages);
  }

  /**
   * The start of a part of the match.
   *
   * @param time when its first message was received, s since the recording's epoch
   * @param stage the part
   */
  public record StageStart(double time, Referee.Stage stage) {}
}
