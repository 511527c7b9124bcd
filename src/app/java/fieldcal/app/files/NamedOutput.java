package fieldcal.app.files;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;

/** What a name stands for to which something is written: a file, a pipe, a device, or the output that the shell gave to this program. */
public final class NamedOutput {
  /** Linux and macOS: /dev/stdout and the like lead to whatever the shell has opened, also when that is a file. */
  private static final List<Path> STREAMS =
      List.of(Path.of("/dev/stdout"), Path.of("/dev/stderr"), Path.of("/dev/fd"), Path.of("/proc"));

  private NamedOutput() {}

  /**
   * Opens it for bytes that are written as they come.
   *
   * @param name a file is replaced, and its directory made if needed; all else is written to as it is
   * @return takes the bytes, unbuffered
   * @throws IOException when it cannot be opened
   */
  public static OutputStream open(Path name) throws IOException {
    Optional<FileDescriptor> own = own(name);
    if (own.isPresent()) {
      // Not opened again: where it leads to a file, what is printed would overwrite what is written
      // here.
      System.out.flush();
      return new LeftOpen(own.get());
    }
    if (isStream(name)) {
      return Files.newOutputStream(name, StandardOpenOption.WRITE, StandardOpenOption.APPEND);
    }
    Files.createDirectories(name.toAbsolutePath().getParent());
    return Files.newOutputStream(name);
  }

  /** Whether a name stands for something that takes bytes one after the other: a pipe, a device, or what this program was given as its output. */
  static boolean isStream(Path name) {
    boolean descriptor = STREAMS.stream().anyMatch(name.toAbsolutePath().normalize()::startsWith);
    return descriptor
        || Files.exists(name) && !Files.isRegularFile(name) && !Files.isDirectory(name);
  }

  /** This program's own output or error stream, when the name stands for it. */
  private static Optional<FileDescriptor> own(Path name) {
    return switch (name.toAbsolutePath().normalize().toString()) {
      case "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1" -> Optional.of(FileDescriptor.out);
      case "/dev/stderr", "/dev/fd/2", "/proc/self/fd/2" -> Optional.of(FileDescriptor.err);
      default -> Optional.empty();
    };
  }

  /** Others go on writing to it. */
  private static final class LeftOpen extends FileOutputStream {
    LeftOpen(FileDescriptor descriptor) {
      super(descriptor);
    }

    @Override
    public void close() {
      // Each write went through to the system.
    }
  }
}
