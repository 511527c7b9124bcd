package fieldcal.simulation;

import fieldcal.simulation.imaging.RobotView;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** The robots' poses of the last ticks. */
final class RobotHistory {
  private static final int KEPT = 60;

  private final Deque<Snapshot> snapshots = new ArrayDeque<>();

  private record Snapshot(double time, List<RobotView> robots) {}

  void add(double time, List<RobotView> robots) {
    snapshots.addLast(new Snapshot(time, robots));
    if (snapshots.size() > KEPT) {
      snapshots.removeFirst();
    }
  }

  /** Poses at a time, linear between ticks; outside of what is kept, those of the nearest tick. */
  List<RobotView> at(double time) {
    Snapshot later = snapshots.getLast();
    for (var i = snapshots.descendingIterator(); i.hasNext(); ) {
      Snapshot snapshot = i.next();
      if (snapshot.time() <= time) {
        double span = later.time() - snapshot.time();
        return span <= 0
            ? snapshot.robots()
            : between(snapshot, later, (time - snapshot.time()) / span);
      }
      later = snapshot;
    }
    return later.robots();
  }

  private static List<RobotView> between(Snapshot a, Snapshot b, double share) {
    List<RobotView> result = new ArrayList<>(a.robots().size());
    for (int i = 0; i < a.robots().size(); i++) {
      RobotView from = a.robots().get(i);
      RobotView to = b.robots().get(i);
      result.add(
          new RobotView(
              from.id(),
              from.x() + share * (to.x() - from.x()),
              from.y() + share * (to.y() - from.y()),
              from.orientation() + share * (to.orientation() - from.orientation()),
              from.height()));
    }
    return result;
  }
}
