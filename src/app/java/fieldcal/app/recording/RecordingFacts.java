package fieldcal.app.recording;

import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.LogProblem;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.gamelog.RefereeDecoder;
import fieldcal.gamelog.RefereeState;
import fieldcal.verdict.Surroundings;
import fieldcal.verdict.VisionFault;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.VisionDecoder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Where a recording comes from, found without looking at its frames.
 *
 * @param log the recording
 * @param origin a real field or a simulated one
 * @param playing how long the referee let a match run, s
 * @param geometry the first one; empty when the recording has none
 * @param startUnixNanos when the first message was received, Unix time, ns; 0 without messages
 * @param bytes size of the file
 * @param cut whether the end of the file is missing or damaged
 * @param content what vision sent in it
 * @param faults what its frames show of its cameras; empty until somebody looked at them
 */
public record RecordingFacts(
    Path log,
    RecordingOrigin origin,
    double playing,
    Optional<FieldGeometry> geometry,
    long startUnixNanos,
    long bytes,
    boolean cut,
    VisionContent content,
    List<VisionFault> faults) {
  /** A shorter start is somebody who tries out the game controller, s. */
  private static final double MATCH_FROM = 10;

  /** The referee sends ten messages a second; a longer pause between two is a gap in the recording, s. */
  private static final double LONGEST_PAUSE = 1;

  /** Vision publishes its geometry every few seconds; who has not heard it by then never will, s. */
  private static final double GEOMETRY_WITHIN = 120;

  /**
   * Looks at a recording.
   *
   * @param log a {@code .log} or {@code .log.gz}
   * @param opener opens it
   * @return what it is
   * @throws IOException when it cannot be read; the message names file and place
   */
  public static RecordingFacts of(Path log, LogOpener opener) throws IOException {
    try (GameLogReader reader = opener.messages(log)) {
      return new Scan(reader, hasTruth(log)).run(log);
    }
  }

  /**
   * Of several recordings.
   *
   * @param logs in order
   * @param opener opens them
   * @return the facts of each
   * @throws IOException when one cannot be read; the message names file and place
   */
  public static List<RecordingFacts> of(List<Path> logs, LogOpener opener) throws IOException {
    List<RecordingFacts> all = new ArrayList<>();
    for (Path log : logs) {
      all.add(of(log, opener));
    }
    return List.copyOf(all);
  }

  /**
   * What a verdict must know of recordings.
   *
   * @param all of them
   * @return where they come from
   */
  public static Surroundings surroundings(List<RecordingFacts> all) {
    return new Surroundings(
        all.stream()
            .map(
                f ->
                    new Surroundings.Recorded(
                        f.name(all), f.isSimulated(), f.geometry(), f.faults()))
            .toList(),
        Optional.empty());
  }

  /** The name of its file, with the path where another recording has the same name. */
  private String name(List<RecordingFacts> all) {
    Path file = log.getFileName();
    boolean ambiguous = all.stream().filter(f -> f.log.getFileName().equals(file)).count() > 1;
    return (ambiguous ? log : file).toString();
  }

  /**
   * The same recording after its frames were looked at.
   *
   * @param found what they show of its cameras
   * @return the changed copy
   */
  RecordingFacts showing(List<VisionFault> found) {
    return new RecordingFacts(
        log, origin, playing, geometry, startUnixNanos, bytes, cut, content, found);
  }

  /**
   * What tells this recording from others, whatever its file is called and wherever it is.
   *
   * @return start and size
   */
  public String identity() {
    return startUnixNanos + " ns, " + bytes + " bytes";
  }

  /**
   * Whether the field was simulated.
   *
   * @return true when the recording says so, or a file with the simulation's truth lies beside it
   */
  public boolean isSimulated() {
    return origin == RecordingOrigin.SIMULATION;
  }

  /**
   * Whether it is the recording of a match.
   *
   * @return true when the referee let one run for longer than 10 s
   */
  public boolean isMatch() {
    return playing > MATCH_FROM;
  }

  private static boolean hasTruth(Path log) {
    return Files.exists(truthOf(log));
  }

  /**
   * The file that holds the truth of a simulated recording; a recording beside which it lies counts as simulated.
   *
   * @param log the recording
   * @return where that file would be
   */
  public static Path truthOf(Path log) {
    String name = log.getFileName().toString().replaceFirst("\\.log(\\.gz)?$", "");
    return log.resolveSibling(name + ".truth.json");
  }

  /** One pass over the messages. */
  private static final class Scan {
    private final GameLogReader reader;
    private boolean simulated;
    private Optional<FieldGeometry> geometry = Optional.empty();
    private double playing;
    private double refereeAt = Double.NaN;
    private final VisionContent.Reading content = new VisionContent.Reading();

    Scan(GameLogReader reader, boolean simulated) {
      this.reader = reader;
      this.simulated = simulated;
    }

    RecordingFacts run(Path log) throws IOException {
      long start = 0;
      VisionDecoder vision = null;
      RefereeDecoder referee = null;
      Epoch epoch = null;
      while (reader.next()) {
        if (epoch == null) {
          start = reader.receivedNanos();
          epoch = Epoch.atSecondOf(start);
          vision = new VisionDecoder(epoch);
          referee = new RefereeDecoder(epoch);
        }
        double time = epoch.secondsOfNanos(reader.receivedNanos());
        simulated |= RecordingOrigin.isSimulationMark(reader);
        if (reader.type() == MessageType.SSL_VISION_2014) {
          content.accept(reader.buffer(), reader.payloadOffset(), reader.payloadLength());
        }
        if (reader.type() == MessageType.SSL_REFBOX_2013) {
          referee(referee, time);
        } else if (reader.type() == MessageType.SSL_VISION_2014
            && geometry.isEmpty()
            && time < GEOMETRY_WITHIN) {
          geometry =
              vision
                  .decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength())
                  .geometry();
        }
      }
      RecordingOrigin origin = simulated ? RecordingOrigin.SIMULATION : RecordingOrigin.FIELD;
      return new RecordingFacts(
          log,
          origin,
          playing,
          geometry,
          start,
          Files.size(log),
          isCut(),
          content.content(),
          List.of());
    }

    private boolean isCut() {
      ProblemAccount problems = reader.problems();
      return Stream.of(
              LogProblem.TRUNCATED_GZIP, LogProblem.DAMAGED_GZIP, LogProblem.TRUNCATED_RECORD)
          .anyMatch(kind -> problems.count(kind) > 0);
    }

    private void referee(RefereeDecoder decoder, double time) {
      Optional<RefereeState> state =
          decoder.decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength());
      boolean follows = time > refereeAt && time - refereeAt < LONGEST_PAUSE;
      if (follows && state.map(RefereeState::isPlaying).orElse(false)) {
        playing += time - refereeAt;
      }
      refereeAt = time;
    }
  }
}
