package fieldcal.archive;

import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** One run at a time on one archive. The system releases it when the process ends, however it ends. */
final class ArchiveLock implements AutoCloseable {
  /** Folders whose lock this process has. Another run in it must not even open the file: closing it would release the lock, which the system keeps for the process as a whole. */
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

  private final Path folder;
  private final FileChannel channel;

  private ArchiveLock(Path folder, FileChannel channel) {
    this.folder = folder;
    this.channel = channel;
  }

  /** Takes the lock of a folder, which is made if needed. */
  static ArchiveLock take(Path folder) throws IOException {
    Files.createDirectories(folder);
    Path real = folder.toRealPath();
    if (!HELD.add(real)) {
      throw taken(folder, self());
    }
    try {
      return new ArchiveLock(real, locked(folder));
    } catch (IOException | RuntimeException e) {
      HELD.remove(real);
      throw e;
    }
  }

  private static FileChannel locked(Path folder) throws IOException {
    Path file = folder.resolve("lock");
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    try {
      if (channel.tryLock() == null) {
        throw taken(folder, Files.readString(file).strip());
      }
      channel.truncate(0);
      channel.write(ByteBuffer.wrap((self() + "\n").getBytes(StandardCharsets.UTF_8)));
      channel.force(false);
      return channel;
    } catch (IOException e) {
      channel.close();
      throw e;
    }
  }

  private static String self() {
    return "process " + ProcessHandle.current().pid();
  }

  private static InputException taken(Path folder, String holder) {
    return new InputException(
        folder
            + ": another run is working on this archive"
            + (holder.isEmpty() ? "" : " (" + holder + ")"));
  }

  @Override
  public void close() throws IOException {
    try {
      channel.close();
    } finally {
      HELD.remove(folder);
    }
  }
}
