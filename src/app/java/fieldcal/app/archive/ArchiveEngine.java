package fieldcal.app.archive;

import java.io.IOException;
import java.util.Optional;
import java.util.ServiceLoader;

/** Turns many game logs into tables and an atlas. Found at run time, since its class path is not that of the tools. */
public interface ArchiveEngine {

  /** Told how far the work is; called from several threads, one after the other. */
  interface Progress {
    /**
     * Some more is done.
     *
     * @param progress how far it is
     */
    void at(ArchiveProgress progress);
  }

  /**
   * Reads the logs that are not in the archive yet, and writes everything that follows from all of them.
   *
   * @param request what is wanted
   * @param progress told how far it is
   * @return what is in the archive now
   * @throws IOException when the directory cannot be used, or nothing was named that is a log; one line for the operator
   */
  ArchiveOutcome run(ArchiveRequest request, Progress progress) throws IOException;

  /**
   * The engine on this class path.
   *
   * @return empty where Spark is not
   */
  static Optional<ArchiveEngine> find() {
    return ServiceLoader.load(ArchiveEngine.class).findFirst();
  }
}
