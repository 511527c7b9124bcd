package fieldcal.app.archive;

import java.util.List;

/**
 * What is in an archive.
 *
 * @param logs that it holds, broken ones included
 * @param skipped of them, those that were done before
 * @param broken of them, those that could not be read
 * @param play time between first and last message of all logs, s
 * @param kicks that were found
 * @param findings in words, one line each
 */
public record ArchiveOutcome(
    int logs, int skipped, int broken, double play, long kicks, List<String> findings) {

  /** Copies the list. {@inheritDoc} */
  public ArchiveOutcome {
    findings = List.copyOf(findings);
  }
}
