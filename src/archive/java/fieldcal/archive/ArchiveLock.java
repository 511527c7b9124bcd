package fieldcal.archive;

import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** One run at a time on one archive. The system releases it when the process ends, however it ends. */
final class ArchiveLock implements AutoCloseable {
  private final FileChannel channel;

  private ArchiveLock(FileChannel channel) {
    this.channel = channel;
  }

  /** Takes the lock of a folder, which is made if needed. */
  static ArchiveLock take(Path folder) throws IOException {
    Files.createDirectories(folder);
    Path file = folder.resolve("lock");
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    FileLock lock = null;
    try {
      lock = channel.tryLock();
    } catch (OverlappingFileLockException e) {
      // Another run in this very process: taken all the same.
    }
    if (lock == null) {
      String holder = Files.readString(file).strip();
      channel.close();
      throw new InputException(
          folder
              + ": another run is working on this archive"
              + (holder.isEmpty() ? "" : " (" + holder + ")"));
    }
    channel.truncate(0);
    channel.write(
        ByteBuffer.wrap(
            ("process " + ProcessHandle.current().pid() + "\n").getBytes(StandardCharsets.UTF_8)));
    channel.force(false);
    return new ArchiveLock(channel);
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
