package fieldcal.simulation;

import fieldcal.simulation.imaging.RobotView;
import fieldcal.simulation.imaging.Scene;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.physics.BallHistory;
import fieldcal.simulation.physics.BallIntegrator;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.MotionPhase;
import fieldcal.vision.FieldGeometry;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;

/**
 * Repeats given kicks under the laws of a field and in view of its cameras. The ball starts at the same place, time and velocity, and robots are where they were; everything else is the field's. Where the spin of a
 * kick is not known, it is drawn from the field's kickers. Runs once; not thread-safe.
 */
public final class Replay {
  /** Step at which the cameras look, s. */
  private static final double TICK = 0.005;

  /** How much of the ball's path is kept for cameras that look back, s: far more than a rolling shutter takes. */
  private static final double KEPT = 0.5;

  private final SimulationSettings settings;
  private final List<Event> events;
  private final List<RobotTrack> robots;
  private final List<Span> spans;
  private final KickBehaviour behaviour;
  private final BallBody ball = new BallBody();
  private final BallHistory history = new BallHistory();
  private final BallIntegrator integrator;
  private final RandomStream spin;
  private final double ballRadius;
  private int next;
  private boolean visible;

  /**
   * A stretch of the session that is recorded.
   *
   * @param from session time, s
   * @param to session time, s
   */
  public record Span(double from, double to) {
    /**
     * Checks the order. {@inheritDoc}
     *
     * @throws IllegalArgumentException when a time is not finite or they are not in order
     */
    public Span {
      if (!(from <= to && Double.isFinite(to - from))) {
        throw new IllegalArgumentException("span from " + from + " s to " + to + " s");
      }
    }
  }

  /**
   * A replay.
   *
   * @param settings the field; its scenario does not count
   * @param kicks in any order; a kick that begins before the previous one has ended cuts it short
   * @param robots where they are
   * @param spans what is recorded, in order
   * @throws IllegalArgumentException when an effect leaves the range of the physics or nothing is to be recorded
   */
  public Replay(
      SimulationSettings settings,
      List<ReplayedKick> kicks,
      List<RobotTrack> robots,
      List<Span> spans) {
    this.settings = settings;
    events =
        events(kicks.stream().sorted(Comparator.comparingDouble(ReplayedKick::restFrom)).toList());
    this.robots = List.copyOf(robots);
    this.spans = List.copyOf(spans);
    if (spans.isEmpty()) {
      throw new IllegalArgumentException("nothing is to be recorded");
    }
    BallPhysics physics = Effects.physics(settings.physics(), settings.effects());
    behaviour = Effects.kicks(settings.kickBehaviour(), settings.effects());
    integrator = new BallIntegrator(physics);
    ballRadius = physics.ball().radius();
    spin = RandomStream.of(settings.seed(), "kick spin");
  }

  /**
   * Runs it.
   *
   * @param sink gets the packets in the order of their arrival
   * @param progress receives the share that is done, 0 … 1
   * @return the geometry as published
   */
  public FieldGeometry run(Consumer<SimulatedPacket> sink, DoubleConsumer progress) {
    double from = spans.get(0).from();
    double to = spans.get(spans.size() - 1).to();
    VisionSystem vision = new VisionSystem(settings, new Stage(), from, VisionSystem.SAFE_LAG);
    // Frames are exposed before they arrive: what is recorded is decided by the time of arrival.
    Consumer<SimulatedPacket> recorded =
        packet -> {
          if (isRecorded(packet.receivedTime())) {
            sink.accept(packet);
          }
        };
    history.hiddenNode(from - KEPT, ball);
    double time = from;
    for (long tick = 1; time < to; tick++) {
      double then = Math.min(to, from + tick * TICK);
      move(time, then);
      time = then;
      vision.observe(time, recorded);
      history.forgetBefore(time - KEPT);
      progress.accept((time - from) / Math.max(to - from, TICK));
    }
    vision.finish(recorded);
    return vision.geometry();
  }

  private boolean isRecorded(double time) {
    for (Span span : spans) {
      if (time >= span.from() && time <= span.to()) {
        return true;
      }
    }
    return false;
  }

  /** Moves the ball over a tick, from event to event. */
  private void move(double from, double to) {
    double time = from;
    while (next < events.size() && events.get(next).time() <= to) {
      Event event = events.get(next++);
      double at = Math.max(time, event.time());
      advance(time, at);
      time = at;
      happen(event, at);
    }
    advance(time, to);
  }

  private void advance(double from, double to) {
    if (to <= from) {
      return;
    }
    if (ball.phase() == MotionPhase.RESTING || !visible) {
      node(to);
    } else {
      integrator.advance(ball, from, to, history);
    }
  }

  private void node(double time) {
    if (visible) {
      history.node(time, ball);
    } else {
      history.hiddenNode(time, ball);
    }
  }

  private void happen(Event event, double now) {
    // Two nodes at the same time: the path is not continuous here.
    node(now);
    switch (event.what()) {
      case APPEAR -> {
        visible = true;
        ball.place(event.kick().x(), event.kick().y());
      }
      case KICK -> kick(event.kick());
      case HOLD -> ball.place(ball.x(), ball.y());
      case HIDE -> visible = false;
    }
    node(now);
  }

  /** All that happens to the ball, in order; a kick is cut short by the next one. */
  private static List<Event> events(List<ReplayedKick> kicks) {
    List<Event> events = new ArrayList<>();
    for (int i = 0; i < kicks.size(); i++) {
      ReplayedKick kick = kicks.get(i);
      double until = i + 1 < kicks.size() ? kicks.get(i + 1).restFrom() : Double.POSITIVE_INFINITY;
      events.add(new Event(kick.restFrom(), What.APPEAR, kick));
      events.add(new Event(kick.time(), What.KICK, kick));
      if (kick.heldAtEnd()) {
        events.add(new Event(kick.end(), What.HOLD, kick));
      }
      events.add(new Event(kick.hiddenFrom(), What.HIDE, kick));
      events.removeIf(e -> e.kick() == kick && e.time() > until && e.what() != What.APPEAR);
    }
    return events;
  }

  private enum What {
    APPEAR,
    KICK,
    HOLD,
    HIDE
  }

  private record Event(double time, What what, ReplayedKick kick) {}

  private void kick(ReplayedKick kick) {
    double rollError = spin.gaussian(behaviour.rollSpinScatter());
    double side = behaviour.sideSpin() + spin.gaussian(behaviour.sideSpinScatter());
    double speed = Math.hypot(kick.vx(), kick.vy());
    double direction = Math.atan2(kick.vy(), kick.vx());
    double roll =
        kick.rollSpin().orElse(behaviour.rollSpinOf(speed, direction, kick.vz() > 0) + rollError);
    ball.kick(kick.vx(), kick.vy(), kick.vz(), roll, side, ballRadius);
  }

  /** What the cameras see. */
  private final class Stage implements Scene {
    @Override
    public boolean ballAt(double time, double[] xyz) {
      return history.positionAt(time, xyz);
    }

    @Override
    public List<RobotView> robotsAt(double time) {
      List<RobotView> views = new ArrayList<>(robots.size());
      for (RobotTrack track : robots) {
        track.at(time).ifPresent(views::add);
      }
      return views;
    }
  }
}
