package fieldcal.app.twin;

import fieldcal.simulation.SimulationSettings;
import java.util.List;
import java.util.Objects;

/**
 * A simulated field that behaves like a recorded one.
 *
 * @param sources the recordings it was made from
 * @param settings of the simulation; their scenario and seed do not belong to the field
 * @param notes what the recordings do not tell and was assumed, or what they tell and the simulator does not have; sentences
 */
public record Twin(List<String> sources, SimulationSettings settings, List<String> notes) {

  /** Copies the lists. {@inheritDoc} */
  public Twin {
    sources = List.copyOf(sources);
    Objects.requireNonNull(settings, "settings");
    notes = List.copyOf(notes);
  }
}
