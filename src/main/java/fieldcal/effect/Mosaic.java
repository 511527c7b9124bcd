package fieldcal.effect;

import java.util.List;

/**
 * Places at which a search may begin, all made of the same tiles. To first order in its magnitude, what an effect does in one of them is the sum of what it does in each of its tiles. So a search that knows what each tile would explain knows it for all
 * places, however many there are. Immutable.
 *
 * @param tiles the effect, absent, in each tile; it has one magnitude
 * @param pieces the places
 */
public record Mosaic(List<Effect> tiles, List<Piece> pieces) {
  /**
   * Copies the lists. {@inheritDoc}
   *
   * @throws IllegalArgumentException when a piece names a tile that does not exist
   */
  public Mosaic {
    tiles = List.copyOf(tiles);
    pieces = List.copyOf(pieces);
    int count = tiles.size();
    if (pieces.stream().flatMap(p -> p.tiles.stream()).anyMatch(i -> i < 0 || i >= count)) {
      throw new IllegalArgumentException("a piece has a tile that is none of the " + count);
    }
  }

  /**
   * One place.
   *
   * @param effect absent, at this place
   * @param tiles indices of its tiles, from 0
   */
  public record Piece(Effect effect, List<Integer> tiles) {
    /** Copies the list. {@inheritDoc} */
    public Piece {
      tiles = List.copyOf(tiles);
    }
  }
}
