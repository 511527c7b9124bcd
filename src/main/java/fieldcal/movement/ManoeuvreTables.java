package fieldcal.movement;

import java.util.Map;
import java.util.TreeMap;

/** The manoeuvres of one kind of a team's robots, a {@link ManoeuvreTable} for each. Two of them merge exactly. Mutable, for one thread. */
final class ManoeuvreTables {
  private final ManoeuvreTable.Scale scale;
  private final Map<Integer, ManoeuvreTable> robots = new TreeMap<>();

  ManoeuvreTables(ManoeuvreTable.Scale scale) {
    this.scale = scale;
  }

  /** The table of a robot, by its number; made when it is not there. */
  ManoeuvreTable of(int robot) {
    return robots.computeIfAbsent(robot, key -> new ManoeuvreTable(scale));
  }

  /** By the robot's number. */
  Map<Integer, ManoeuvreTable> robots() {
    return robots;
  }

  /** Those of all robots together: a copy. */
  ManoeuvreTable all() {
    ManoeuvreTable all = new ManoeuvreTable(scale);
    robots.values().forEach(all::merge);
    return all;
  }

  void merge(ManoeuvreTables other) {
    other.robots.forEach((robot, table) -> of(robot).merge(table));
  }

  void clear() {
    robots.clear();
  }
}
