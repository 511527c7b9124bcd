package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Components that a search may add at once: one effect, or a group that belongs together (the offsets of all cameras).
 *
 * @param components one or more
 * @param group whether only some of them may be needed
 */
record Proposal(List<Component> components, boolean group) {
  Proposal {
    components = List.copyOf(components);
  }

  static Proposal of(Component component) {
    return new Proposal(List.of(component), false);
  }

  @Override
  public String toString() {
    return group
        ? "all " + components.get(0).template().id()
        : components.stream().map(Component::toString).collect(Collectors.joining(" and "));
  }
}
