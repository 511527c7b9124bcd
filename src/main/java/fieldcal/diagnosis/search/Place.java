package fieldcal.diagnosis.search;

import fieldcal.diagnosis.model.Component;
import fieldcal.effect.Mosaic;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A component at one of the places at which a search may begin.
 *
 * @param component at this place
 * @param tiles components whose actions add up to that of the component if all have its number; the component itself where it has no parts
 */
record Place(Component component, List<Component> tiles) {
  /** Two places are nearly the same if they have more than this share of their tiles in common; chosen: then the steps of a {@link PlaceSearch} lead from one to the other. */
  private static final double ALIKE = 0.5;

  Place {
    tiles = List.copyOf(tiles);
  }

  /** A component without parts. */
  static Place of(Component component) {
    return new Place(component, List.of(component));
  }

  /** All places of a mosaic. */
  static List<Place> of(Mosaic mosaic) {
    List<Component> tiles =
        mosaic.tiles().stream().map(e -> Component.of(e, e.magnitudes())).toList();
    List<Place> places = new ArrayList<>();
    for (Mosaic.Piece piece : mosaic.pieces()) {
      places.add(
          new Place(
              Component.of(piece.effect(), piece.effect().magnitudes()),
              piece.tiles().stream().map(tiles::get).toList()));
    }
    return places;
  }

  /** The tiles of several places, each once. */
  static Set<Component> tiles(Collection<Place> places) {
    Set<Component> all = new LinkedHashSet<>();
    places.forEach(p -> all.addAll(p.tiles));
    return all;
  }

  Proposal proposal() {
    return Proposal.of(component);
  }

  /** What it would gain beside what is swept in, to first order. */
  double gain(Scorer scorer, Sweep at) {
    return tiles.size() == 1
        ? scorer.gain(Proposal.of(tiles.get(0)), at)
        : scorer.gainTogether(tiles, at);
  }

  /** The places that would gain most, best first, without those that are nearly the same as a better one. */
  static List<Place> best(List<Place> places, int most, Scorer scorer, Sweep at) {
    Map<Place, Double> gains = new IdentityHashMap<>();
    places.forEach(p -> gains.put(p, p.gain(scorer, at)));
    List<Place> ordered = new ArrayList<>(places);
    ordered.sort((p, q) -> Double.compare(gains.get(q), gains.get(p)));
    List<Place> kept = new ArrayList<>();
    for (Place p : ordered) {
      if (kept.size() == most) {
        break;
      }
      if (kept.stream().noneMatch(p::isNearly)) {
        kept.add(p);
      }
    }
    return kept;
  }

  private boolean isNearly(Place other) {
    Set<Component> own = Collections.newSetFromMap(new IdentityHashMap<>());
    own.addAll(tiles);
    long common = other.tiles.stream().filter(own::contains).count();
    return common > ALIKE * (tiles.size() + other.tiles.size() - common);
  }
}
