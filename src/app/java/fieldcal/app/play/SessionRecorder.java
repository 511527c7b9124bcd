package fieldcal.app.play;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.play.PlayedKick;
import fieldcal.vision.Epoch;
import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Locale;

/**
 * Writes what happens as it happens: a game log of all that vision sends, and the commands beside it. What was recorded half a second ago, and every finished kick, is with the operating
 * system, so that nothing of it is lost when this process is killed. Not thread-safe.
 */
public final class SessionRecorder implements Closeable {
  private static final double FLUSH = 0.5;

  private final Path log;
  private final Path commands;
  private final Epoch epoch;
  private final GameLogWriter writer;
  private boolean marked;
  private double flushed = Double.NEGATIVE_INFINITY;

  private SessionRecorder(Path log, Path commands, Epoch epoch, RecordingOrigin origin)
      throws IOException {
    this.log = log;
    this.commands = commands;
    this.epoch = epoch;
    marked = origin == RecordingOrigin.FIELD;
    try {
      Files.writeString(commands, CommandFile.HEADER + "\n", StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw notBegun(commands, e);
    }
    try {
      writer = GameLogWriter.create(log);
      // A process that is killed before vision sends anything leaves a recording of nothing, not an
      // unreadable one.
      writer.flush();
    } catch (IOException e) {
      Files.deleteIfExists(commands);
      throw notBegun(log, e);
    }
  }

  /** An empty file would look like a recording of nothing. */
  private static IOException notBegun(Path file, IOException e) throws IOException {
    if (Files.isRegularFile(file)) {
      Files.delete(file);
    }
    return named(file, e);
  }

  /**
   * Begins a recording under a name that is not taken yet: NAME.log, NAME-2.log …
   *
   * @param directory made if needed
   * @param name for example {@code session-flat}
   * @param epoch of all times
   * @param origin a real field or a simulated one, which the recording then says of itself
   * @return the recorder
   * @throws IOException when it cannot be written
   */
  public static SessionRecorder begin(
      Path directory, String name, Epoch epoch, RecordingOrigin origin) throws IOException {
    Files.createDirectories(directory);
    Path log = directory.resolve(name + ".log");
    Path commands = directory.resolve(name + ".commands.csv");
    for (int i = 2; Files.exists(log) || Files.exists(commands); i++) {
      log = directory.resolve(name + "-" + i + ".log");
      commands = directory.resolve(name + "-" + i + ".commands.csv");
    }
    return new SessionRecorder(log, commands, epoch, origin);
  }

  /**
   * The game log.
   *
   * @return its file
   */
  public Path log() {
    return log;
  }

  /**
   * What the robots were commanded.
   *
   * @return its file
   */
  public Path commands() {
    return commands;
  }

  /**
   * Writes a message.
   *
   * @param receivedTime s since the epoch
   * @param type what it is
   * @param payload its bytes
   * @throws IOException when it cannot be written
   */
  public void message(double receivedTime, MessageType type, byte[] payload) throws IOException {
    try {
      if (!marked) {
        marked = true;
        byte[] mark = RecordingOrigin.simulationMark();
        writer.write(epoch.unixNanosOf(receivedTime), MessageType.BLANK, mark);
      }
      writer.write(epoch.unixNanosOf(receivedTime), type, payload);
      if (receivedTime - flushed > FLUSH) {
        flush(receivedTime);
      }
    } catch (IOException e) {
      throw named(log, e);
    }
  }

  /**
   * Writes what a robot was commanded, once its ball is done.
   *
   * @param kick the kick
   * @throws IOException when it cannot be written
   */
  public void command(PlayedKick kick) throws IOException {
    String line =
        String.format(
            Locale.ROOT,
            "%.6f,%s,%d,%s,%.4f,%.3f,%.3f%n",
            epoch.unixSeconds(kick.time() - PlaySession.NOTICED),
            kick.robot().team().label(),
            kick.robot().number(),
            kick.planned().chip() ? "chip" : "flat",
            kick.planned().speed(),
            Math.toDegrees(Math.IEEEremainder(kick.direction(), 2 * Math.PI)),
            Math.toDegrees(kick.planned().elevation()));
    long complete = Files.size(commands);
    try {
      Files.writeString(commands, line, StandardCharsets.UTF_8, StandardOpenOption.APPEND);
    } catch (IOException e) {
      // Half a line would make all of the file unreadable.
      try (FileChannel file = FileChannel.open(commands, StandardOpenOption.WRITE)) {
        file.truncate(complete);
      }
      throw named(commands, e);
    }
    flush(kick.ended());
  }

  /**
   * Gives the operating system all that was written, for somebody who reads it now.
   *
   * @throws IOException when it cannot be written
   */
  public void flush() throws IOException {
    try {
      writer.flush();
    } catch (IOException e) {
      throw named(log, e);
    }
  }

  private void flush(double now) throws IOException {
    writer.flush();
    flushed = now;
  }

  /** A full disk does not say which file it was. */
  private static IOException named(Path file, IOException e) {
    return e instanceof FileSystemException ? e : new IOException(file + ": " + e.getMessage(), e);
  }

  /**
   * Ends a recording in which nothing happened, and takes its files away: it would only be in the way of the next session.
   *
   * @throws IOException when they cannot be deleted
   */
  void discard() throws IOException {
    close();
    Files.deleteIfExists(log);
    Files.deleteIfExists(commands);
  }

  @Override
  public void close() throws IOException {
    try {
      writer.close();
    } catch (IOException e) {
      throw named(log, e);
    }
  }
}
