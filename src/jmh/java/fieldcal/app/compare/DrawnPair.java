package fieldcal.app.compare;

import fieldcal.simulation.RandomStream;
import fieldcal.simulation.SimulationSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;

/**
 * A field and a simulator that differ in what was drawn; each fifth pair differs in nothing.
 *
 * @param seed of all that was drawn
 * @param base what both have in common
 * @param differences what was drawn
 * @param ofTheField whether it is the field that has it, for each, and the simulator that lacks it
 */
public record DrawnPair(
    long seed, FieldDraw base, List<DrawnDifference> differences, List<Boolean> ofTheField) {
  private static final int ALIKE_EVERY = 5;

  /**
   * Draws.
   *
   * @param seed of all pairs
   * @param index of this one, from 0
   * @return always the same for the same arguments
   */
  public static DrawnPair of(long seed, int index) {
    RandomStream random = RandomStream.of(seed, "pair " + index);
    boolean alike = index % ALIKE_EVERY == ALIKE_EVERY - 1;
    // The catalogue's causes of a rolling ball are those of a solid ball, whose kSwitch is known.
    boolean solid = random.happens(0.5);
    FieldDraw base = FieldDraw.of(random, solid);
    List<DrawnDifference> drawn = new ArrayList<>();
    if (!alike) {
      if (solid) {
        drawn.add(DrawnDifference.cause(random.below(DrawnDifference.KINDS_OF_CAUSES), random));
      }
      several(1 + random.below(2), DrawnDifference.KINDS_OF_BALL, DrawnDifference::ball, random)
          .stream()
          .filter(d -> !(solid && d.named().contains("kSwitch")))
          .forEach(drawn::add);
      drawn.addAll(
          several(
              1 + random.below(2),
              DrawnDifference.KINDS_OF_CAMERAS,
              DrawnDifference::camera,
              random));
      drawn.addAll(several(1, DrawnDifference.KINDS_OF_KICKERS, DrawnDifference::kicker, random));
      drawn.addAll(several(1, DrawnDifference.KINDS_OF_LIMITS, DrawnDifference::limit, random));
    }
    List<Boolean> sides = drawn.stream().map(d -> random.happens(0.5)).toList();
    return new DrawnPair(
        RandomStream.of(seed, "field " + index).below(1 << 30), base, drawn, sides);
  }

  /** Some of several kinds, no kind twice. */
  private static List<DrawnDifference> several(
      int count,
      int kinds,
      BiFunction<Integer, RandomStream, DrawnDifference> draw,
      RandomStream random) {
    List<Integer> left = new ArrayList<>();
    for (int kind = 0; kind < kinds; kind++) {
      left.add(kind);
    }
    List<DrawnDifference> drawn = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      drawn.add(draw.apply(left.remove(random.below(left.size())), random));
    }
    return drawn;
  }

  SimulationSettings field(int kicks) {
    return made(true, Optional.empty()).settings(kicks, seed);
  }

  /**
   * The simulator.
   *
   * @param kicks half of them flat, half chips
   * @return what to simulate
   */
  public SimulationSettings simulator(int kicks) {
    return made(false, Optional.empty()).settings(kicks, seed + 1);
  }

  /** The simulator with one thing as on the field. */
  SimulationSettings simulatorBut(DrawnDifference one, int kicks) {
    return made(false, Optional.of(one)).settings(kicks, seed + 1);
  }

  private FieldDraw made(boolean field, Optional<DrawnDifference> swapped) {
    FieldDraw made = base;
    for (int i = 0; i < differences.size(); i++) {
      boolean has = ofTheField.get(i) == field;
      if (has != swapped.filter(differences.get(i)::equals).isPresent()) {
        made = differences.get(i).change().apply(made);
      }
    }
    return made;
  }
}
