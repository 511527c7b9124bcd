package fieldcal.movement;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class GridTest {
  @Test
  void occupiedCellsHaveTheirCentresAndCounts() {
    Grid grid = new Grid(-1, 0.5, 4, 0, 0.25, 2);
    grid.add(0.9, 0.01, 3);
    grid.add(-1, 0.3, 2);
    grid.add(-0.6, 0.49, 5);
    grid.add(1, 0.1, 7);

    Grid.Occupied cells = grid.occupied();

    assertEquals(0.5, cells.widthX());
    assertEquals(0.25, cells.widthY());
    assertArrayEquals(new double[] {0.75, -0.75}, cells.x(), 1e-12);
    assertArrayEquals(new double[] {0.125, 0.375}, cells.y(), 1e-12);
    assertArrayEquals(new long[] {3, 7}, cells.count());
  }
}
