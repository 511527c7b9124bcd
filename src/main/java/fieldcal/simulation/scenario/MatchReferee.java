package fieldcal.simulation.scenario;

import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulatedWorld;
import fieldcal.simulation.physics.BallBody;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Runs a match: kick-offs, restarts, halts, time-outs, half-time, score, its end after a time or a number of kicks. */
final class MatchReferee {
  /** Length of the half-time break, s. */
  static final double BREAK = 8;

  private static final double STUCK = 12;

  private final FieldSize field;
  private final RandomStream random;
  private final double halfLength;
  private final int wanted;
  private final List<RefereePhase> phases = new ArrayList<>();

  private State state = State.INTERRUPTED;
  private double until = 2;
  private double playStarted;
  private double nextInterruption;
  private boolean secondHalf;
  private boolean kickOff = true;
  private Team restart = Team.YELLOW;
  private String stage = "NORMAL_FIRST_HALF_PRE";
  private int yellowScore;
  private int blueScore;
  private double lastTouch;
  private int kicksSeen;

  private enum State {
    INTERRUPTED,
    STOPPED,
    PREPARING,
    PLAYING,
    OVER
  }

  MatchReferee(FieldSize field, ScenarioSettings match, RandomStream random) {
    this.field = field;
    this.random = random;
    wanted = match.kicks();
    halfLength = 30 * match.minutes();
    nextInterruption = random.uniform(0.25, 0.7) * halfLength;
    say(0, "HALT");
  }

  List<RefereePhase> phases() {
    return Collections.unmodifiableList(phases);
  }

  boolean playing() {
    return state == State.PLAYING;
  }

  boolean halted() {
    return state == State.INTERRUPTED || state == State.OVER;
  }

  boolean over(double now) {
    return state == State.OVER && now >= until;
  }

  /** The direction in which a team attacks: +1 or −1 along x. */
  int attack(Team team) {
    return (team == Team.YELLOW) != secondHalf ? 1 : -1;
  }

  /** Who may touch the ball first. */
  Team restart() {
    return restart;
  }

  /** Whether the last kick of a match with a number of kicks is under way or over: nobody may kick any more. */
  boolean enough(SimulatedWorld world) {
    return wanted > 0 && world.kicks().commanded() >= wanted;
  }

  /** Share of the ordered kicks that were begun; 0 without such an order. */
  double kicked(SimulatedWorld world) {
    return wanted == 0 ? 0 : (double) world.kicks().commanded() / wanted;
  }

  /** Whether the last kick's ball has come to rest, left the field or was taken, also after bounces off robots. */
  private boolean played(SimulatedWorld world) {
    return enough(world) && !world.kicks().running();
  }

  void tick(SimulatedWorld world) {
    double now = world.time();
    if (state != State.PLAYING && state != State.OVER && played(world)) {
      endMatch(now);
    }
    switch (state) {
      case INTERRUPTED -> {
        if (now >= until) {
          stop(world, kickOff, restart);
        }
      }
      case STOPPED -> {
        if (now >= until) {
          start(now);
        }
      }
      case PREPARING -> {
        if (now >= until) {
          stage = secondHalf ? "NORMAL_SECOND_HALF" : "NORMAL_FIRST_HALF";
          play(now, "NORMAL_START");
        }
      }
      case PLAYING -> watch(world);
      case OVER -> {}
    }
  }

  private void stop(SimulatedWorld world, boolean withKickOff, Team team) {
    state = State.STOPPED;
    kickOff = withKickOff;
    restart = team;
    until = world.time() + random.uniform(1.5, 3);
    say(world.time(), "STOP");
    BallBody ball = world.ball();
    double x = clamp(ball.x(), field.length() / 2 - 0.3);
    double y = clamp(ball.y(), field.width() / 2 - 0.3);
    if (withKickOff) {
      world.carryBall(0, 0, 0.9);
    } else if (x != ball.x() || y != ball.y()) {
      world.carryBall(x, y, 0.8);
    }
  }

  private void start(double now) {
    if (kickOff) {
      state = State.PREPARING;
      until = now + 1.5;
      say(now, "PREPARE_KICKOFF_" + restart.name());
    } else {
      play(now, random.happens(0.5) ? "FORCE_START" : "DIRECT_FREE_" + restart.name());
    }
  }

  private void play(double now, String command) {
    state = State.PLAYING;
    kickOff = false;
    playStarted = now;
    lastTouch = now;
    say(now, command);
  }

  private void watch(SimulatedWorld world) {
    double now = world.time();
    BallBody ball = world.ball();
    int kicks = world.kicks().finished().size();
    if (kicks != kicksSeen) {
      kicksSeen = kicks;
      lastTouch = now;
    }
    double half = halfLength * (secondHalf ? 2 : 1) + (secondHalf ? BREAK : 0);
    if (now > half) {
      endHalf(now);
    } else if (inGoal(ball) || played(world) && lastEnded(world) == EndReason.GOAL) {
      goal(world);
    } else if (played(world)) {
      endMatch(now);
    } else if (Math.abs(ball.x()) > field.length() / 2 + SimulatedWorld.OUT
        || Math.abs(ball.y()) > field.width() / 2 + SimulatedWorld.OUT) {
      stop(world, false, random.happens(0.5) ? Team.YELLOW : Team.BLUE);
    } else if (now - lastTouch > STUCK) {
      stop(world, false, restart.opponent());
      world.carryBall(
          random.uniform(-0.2, 0.2) * field.length(),
          random.uniform(-0.2, 0.2) * field.width(),
          0.8);
    } else if (now > nextInterruption && now - playStarted > 5) {
      interrupt(now);
    }
  }

  /** A kick is over as soon as the whole ball is behind the line, a little before the referee sees a goal. */
  private static EndReason lastEnded(SimulatedWorld world) {
    List<KickTruth> kicks = world.kicks().finished();
    return kicks.get(kicks.size() - 1).end();
  }

  private boolean inGoal(BallBody ball) {
    return Math.abs(ball.x()) > field.length() / 2 + 0.03
        && Math.abs(ball.y()) < field.goalWidth() / 2
        && ball.z() < 0.16;
  }

  private void goal(SimulatedWorld world) {
    Team scorer = attack(Team.YELLOW) * world.ball().x() > 0 ? Team.YELLOW : Team.BLUE;
    if (scorer == Team.YELLOW) {
      yellowScore++;
    } else {
      blueScore++;
    }
    stop(world, true, scorer.opponent());
  }

  private void interrupt(double now) {
    nextInterruption = now + random.uniform(0.5, 1.2) * halfLength;
    state = State.INTERRUPTED;
    boolean timeOut = random.happens(0.5);
    until = now + (timeOut ? random.uniform(5, 8) : random.uniform(2, 5));
    say(now, timeOut ? "TIMEOUT_" + (random.happens(0.5) ? "YELLOW" : "BLUE") : "HALT");
  }

  private void endHalf(double now) {
    if (secondHalf) {
      endMatch(now);
      return;
    }
    kickOff = true;
    stage = "NORMAL_HALF_TIME";
    say(now, "HALT");
    secondHalf = true;
    stage = "NORMAL_SECOND_HALF_PRE";
    restart = Team.BLUE;
    state = State.INTERRUPTED;
    until = now + BREAK;
  }

  private void endMatch(double now) {
    state = State.OVER;
    until = now + 2;
    stage = "POST_GAME";
    say(now, "HALT");
  }

  private static double clamp(double value, double limit) {
    return Math.max(-limit, Math.min(limit, value));
  }

  private void say(double now, String command) {
    phases.add(
        new RefereePhase(now, command, stage, yellowScore, blueScore, attack(Team.YELLOW) < 0));
  }
}
