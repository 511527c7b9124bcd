package fieldcal.app.archive;

import fieldcal.app.recording.LogOpener;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What {@code archive} is asked for.
 *
 * @param paths game logs, and folders that are searched for them
 * @param out directory of the archive
 * @param master Spark's master; empty for all cores of this machine
 * @param resume whether an archive that is there is continued
 * @param opener opens the logs
 */
public record ArchiveRequest(
    List<Path> paths, Path out, Optional<String> master, boolean resume, LogOpener opener) {

  /** Copies the list and checks that nothing is missing. {@inheritDoc} */
  public ArchiveRequest {
    paths = List.copyOf(paths);
    Objects.requireNonNull(out, "out");
    Objects.requireNonNull(master, "master");
    Objects.requireNonNull(opener, "opener");
  }
}
