package fieldcal.simulation.physics;

import java.util.ArrayList;
import java.util.List;

/** Keeps the events and the path of a ball. */
final class RecordedTrace implements BallTrace {
  final List<BallEvent> events = new ArrayList<>();
  final List<double[]> nodes = new ArrayList<>();

  @Override
  public void node(double time, BallBody ball) {
    nodes.add(
        new double[] {
          time,
          ball.x(),
          ball.y(),
          ball.z(),
          ball.vx(),
          ball.vy(),
          ball.vz(),
          ball.spinX(),
          ball.spinY(),
          ball.spinZ()
        });
  }

  @Override
  public void event(BallEvent event) {
    events.add(event);
  }

  BallEvent first(BallEvent.Kind kind) {
    return events.stream().filter(e -> e.kind() == kind).findFirst().orElseThrow();
  }

  long count(BallEvent.Kind kind) {
    return events.stream().filter(e -> e.kind() == kind).count();
  }

  double[] last() {
    return nodes.get(nodes.size() - 1);
  }
}
