package fieldcal.movement;

import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Statistics that are taken apart into cells and put together again are the same. */
class MovementCellsTest {

  private static MovementStatistics drawn(long seed) {
    Random random = new Random(seed);
    MovementStatistics statistics = new MovementStatistics();
    for (int i = 0; i < 4000; i++) {
      Team team = random.nextBoolean() ? Team.YELLOW : Team.BLUE;
      double acceleration = i % 3 == 0 ? 0.01 : 3 * random.nextDouble();
      double direction = 2 * Math.PI * random.nextDouble();
      statistics
          .of(team)
          .add(
              new Manoeuvre(
                  new RobotId(team, random.nextInt(6)),
                  0,
                  0.3,
                  3 * random.nextDouble(),
                  0,
                  acceleration * Math.cos(direction),
                  acceleration * Math.sin(direction),
                  0.01,
                  0.02,
                  0.01,
                  0.03,
                  2 * Math.PI * random.nextDouble(),
                  30));
      double rate = 10 * random.nextDouble();
      statistics
          .of(team)
          .add(
              new Turn(
                  new RobotId(team, random.nextInt(6)),
                  0,
                  0.3,
                  rate,
                  i % 2 == 0 ? 0.1 : 40 * random.nextGaussian(),
                  1,
                  0.1,
                  0.01,
                  0.3));
      statistics.of(team).league().add(random.nextDouble(), 0, 12 * random.nextDouble(), 0, 0.013);
      statistics.standing().add(random.nextGaussian(), 20 * random.nextGaussian(), 1);
      statistics.standingSquares().add(200 * random.nextDouble());
    }
    return statistics;
  }

  private static List<MovementCells.Cell> cells(MovementStatistics statistics) {
    List<MovementCells.Cell> cells = new ArrayList<>();
    MovementCells.of(statistics, cells::add);
    return cells;
  }

  @Test
  void cellsOfManyMatchesInAnyOrderAreTheMergedStatistics() {
    MovementStatistics first = drawn(1);
    MovementStatistics second = drawn(2);
    List<MovementCells.Cell> all = new ArrayList<>(cells(first));
    all.addAll(cells(second));
    Collections.shuffle(all, new Random(3));

    MovementStatistics again = new MovementStatistics();
    assertThat(all).allMatch(cell -> MovementCells.add(again, cell));

    first.merge(second);
    // Without centres, of which NaN equals nothing.
    assertThat(cells(again).toString()).isEqualTo(cells(first).toString());
    for (Team team : Team.values()) {
      assertThat(LimitEstimator.estimate(team, again.of(team)).toString())
          .isEqualTo(LimitEstimator.estimate(team, first.of(team)).toString());
      assertThat(again.of(team).robots()).isEqualTo(6);
    }
    assertThat(again.standingNoiseMm()).isEqualTo(first.standingNoiseMm());
  }

  @Test
  void whatIsNoCellIsRefused() {
    MovementStatistics statistics = new MovementStatistics();
    for (String histogram :
        List.of("accelerating", "own_frame", "top_speeds", "cruising", "robots", "unheard_of")) {
      for (int number : new int[] {-1, Integer.MAX_VALUE}) {
        assertThat(
                MovementCells.add(
                    statistics,
                    new MovementCells.Cell(
                        Optional.of(Team.BLUE), histogram, Optional.of(1), number, 0, 0, 1)))
            .as(histogram + " " + number)
            .isFalse();
      }
    }
    assertThat(cells(statistics)).isEmpty();
  }
}
