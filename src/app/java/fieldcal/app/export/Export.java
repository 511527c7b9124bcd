package fieldcal.app.export;

import fieldcal.app.export.Target.TargetFile;
import fieldcal.app.export.format.Editor.Change;
import java.util.List;

/**
 * A file for a target.
 *
 * @param target where it goes
 * @param file which of the target's files it is
 * @param bytes its content
 * @param changes the values, with what was there before; empty text where there was nothing
 * @param notes what it does not carry and what else somebody should know, whole sentences
 */
public record Export(
    Target target, TargetFile file, byte[] bytes, List<Change> changes, List<String> notes) {
  /** Copies the lists. {@inheritDoc} */
  public Export {
    changes = List.copyOf(changes);
    notes = List.copyOf(notes);
  }
}
