package fieldcal.app.recording;

import fieldcal.gamelog.GameLogException;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.RecordingReader;
import fieldcal.vision.Epoch;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Opens game logs, with one limit of packing for all that a command reads.
 *
 * @param largestRatio how many times its size a packed log may unpack to; {@link Double#POSITIVE_INFINITY}: no limit
 */
public record LogOpener(double largestRatio) implements Serializable {
  /** The limit that recordings of real and simulated fields keep. */
  public static final LogOpener USUAL = new LogOpener(GameLogReader.LARGEST_RATIO);

  /**
   * Checks the limit. {@inheritDoc}
   *
   * @throws IllegalArgumentException if the limit is below 1 or NaN
   */
  public LogOpener {
    if (!(largestRatio >= 1)) {
      throw new IllegalArgumentException("must be 1 or more, but is " + largestRatio);
    }
  }

  /**
   * Opens a log to read its messages.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @return a reader before the first message
   * @throws GameLogException when it cannot be read; the message names file and place
   */
  public GameLogReader messages(Path log) throws GameLogException {
    return GameLogReader.open(log, largestRatio);
  }

  /**
   * Opens a log to read frames, geometry and referee.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @return a reader at the recording's start
   * @throws GameLogException when it cannot be read; the message names file and place
   */
  public RecordingReader recording(Path log) throws GameLogException {
    return RecordingReader.open(log, Optional.empty(), largestRatio);
  }

  /**
   * The same with times that count from a given epoch.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @param epoch the epoch
   * @return a reader at the recording's start
   * @throws GameLogException when it cannot be read; the message names file and place
   */
  public RecordingReader recording(Path log, Epoch epoch) throws GameLogException {
    return RecordingReader.open(log, Optional.of(epoch), largestRatio);
  }
}
