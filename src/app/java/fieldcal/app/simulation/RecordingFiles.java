package fieldcal.app.simulation;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.files.WholeFile;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.proto.Referee;
import fieldcal.simulation.SimulatedPacket;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionEncoder;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.DoubleConsumer;

/**
 * A simulated recording on disk.
 *
 * @param log game log, {@code NAME.log} or {@code NAME.log.gz}
 * @param truth {@code NAME.truth.json} beside it
 * @param commands {@code NAME.commands.csv} beside it: what the robots were commanded
 */
public record RecordingFiles(Path log, Path truth, Path commands) {
  private static final double REFEREE_INTERVAL = 0.1;

  /**
   * The files that belong to a log.
   *
   * @param log the log
   * @return the log and its neighbours
   */
  public static RecordingFiles besides(Path log) {
    String name =
        log.getFileName().toString().replaceFirst("\\.gz$", "").replaceFirst("\\.log$", "");
    return new RecordingFiles(
        log, log.resolveSibling(name + ".truth.json"), log.resolveSibling(name + ".commands.csv"));
  }

  /**
   * Simulates and writes all three files; existing ones are replaced, or stay as they are when one of the three cannot be written.
   *
   * @param settings what is to be simulated
   * @param progress is told which share is done, 0 … 1
   * @return what really happened
   * @throws IOException when a file cannot be written
   * @throws IllegalArgumentException when the settings contradict each other
   */
  public Truth write(SimulationSettings settings, DoubleConsumer progress) throws IOException {
    Simulation simulation = Simulation.of(settings);
    AtomicReference<Truth> happened = new AtomicReference<>();
    // Each is complete before the one around it replaces an older file.
    WholeFile.streamBytes(
        log,
        logBytes -> {
          happened.set(record(simulation, logBytes, progress));
          WholeFile.streamBytes(
              truth,
              truthBytes -> {
                truthBytes.write(
                    new ObjectMapper().writeValueAsBytes(TruthJson.of(happened.get())));
                truthBytes.flush();
                WholeFile.write(commandsCsv(happened.get()), commands);
              });
        });
    return happened.get();
  }

  private Truth record(Simulation simulation, OutputStream to, DoubleConsumer progress)
      throws IOException {
    try (GameLogWriter writer = GameLogWriter.to(to, log)) {
      return simulation.run(new Sink(simulation, writer, progress)::accept);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  /**
   * The commands file's text.
   *
   * @param truth of a recording
   * @return CSV with the columns of DESIGN section 7
   */
  public static String commandsCsv(Truth truth) {
    StringBuilder csv =
        new StringBuilder("t_unix,team,id,kind,speed_mps,direction_deg,elevation_deg\n");
    for (KickTruth kick : truth.commandedKicks()) {
      csv.append(
          String.format(
              Locale.ROOT,
              "%.6f,%s,%d,%s,%.4f,%.3f,%.3f%n",
              truth.epoch().unixSeconds(kick.time()),
              kick.robot().team().label(),
              kick.robot().number(),
              kick.kind().label(),
              kick.command().speed(),
              Math.toDegrees(kick.command().direction()),
              Math.toDegrees(kick.command().elevation())));
    }
    return csv.toString();
  }

  /** Writes packets as they come, and the referee's messages between them. */
  private static final class Sink {
    private final Simulation simulation;
    private final GameLogWriter writer;
    private final DoubleConsumer progress;
    private final VisionEncoder encoder;
    private double nextReferee;
    private boolean marked;

    Sink(Simulation simulation, GameLogWriter writer, DoubleConsumer progress) {
      this.simulation = simulation;
      this.writer = writer;
      this.progress = progress;
      encoder = new VisionEncoder(simulation.epoch());
    }

    void accept(SimulatedPacket packet) {
      Epoch epoch = simulation.epoch();
      try {
        if (!marked) {
          marked = true;
          writer.write(
              epoch.unixNanosOf(packet.receivedTime()),
              MessageType.BLANK,
              RecordingOrigin.simulationMark());
        }
        while (!simulation.phases().isEmpty() && nextReferee <= packet.receivedTime()) {
          writer.write(
              epoch.unixNanosOf(nextReferee),
              MessageType.SSL_REFBOX_2013,
              referee(simulation.phases(), nextReferee, epoch).toByteArray());
          nextReferee += REFEREE_INTERVAL;
        }
        writer.write(
            epoch.unixNanosOf(packet.receivedTime()),
            MessageType.SSL_VISION_2014,
            encoder.encode(packet.packet()));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
      progress.accept(simulation.progress());
    }
  }

  private static Referee referee(List<RefereePhase> phases, double time, Epoch epoch) {
    int index = 0;
    while (index + 1 < phases.size() && phases.get(index + 1).time() <= time) {
      index++;
    }
    RefereePhase phase = phases.get(index);
    return Referee.newBuilder()
        .setPacketTimestamp(epoch.unixNanosOf(time) / 1000)
        .setStage(Referee.Stage.valueOf(phase.stage()))
        .setCommand(Referee.Command.valueOf(phase.command()))
        .setCommandCounter(index + 1)
        .setCommandTimestamp(epoch.unixNanosOf(phase.time()) / 1000)
        .setYellow(team("Yellow", phase.yellowScore()))
        .setBlue(team("Blue", phase.blueScore()))
        .setBlueTeamOnPositiveHalf(!phase.yellowOnPositiveHalf())
        .build();
  }

  private static Referee.TeamInfo team(String name, int score) {
    return Referee.TeamInfo.newBuilder()
        .setName(name)
        .setScore(score)
        .setRedCards(0)
        .setYellowCards(0)
        .setTimeouts(4)
        .setTimeoutTime(300_000_000)
        .setGoalkeeper(0)
        .build();
  }
}
