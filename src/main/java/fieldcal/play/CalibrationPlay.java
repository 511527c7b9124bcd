package fieldcal.play;

import fieldcal.play.PlayWorld.Permission;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Two robots collect kicks. It is given the world each tick and returns what both robots are to do.
 *
 * <p>Call {@link #tick} at 30 Hz or more, always from one thread, and send the answered orders at once. Tell {@link #judge} how each kick turned out: one that does not count is made again. Nothing
 * is thrown once it runs: the play waits until a problem is over, or ends with a reason in {@link #state}. Not thread-safe.
 */
public final class CalibrationPlay {
  /** When no frame has arrived for longer, it is not known where the robots are, s. */
  private static final double NO_VISION = 0.15;

  /** Longest wait for the last fits, s. */
  private static final double LAST_FITS = 60;

  /** Longest that a ball is watched after the play was stopped, s; chosen: a kick of 6.5 m/s has left the field by then, and of a slower one enough was seen. */
  private static final double LAST_BALL = 5;

  /** Longest time that passes for the play from one tick to the next, s; chosen: twice that of the slowest host. */
  private static final double LONGEST_TICK = 0.2;

  private final PlayPlan plan;
  private final Ledger ledger;
  private final BallMemory ball = new BallMemory();
  private final Driver driver;
  private final Safety safety;
  private final List<Motion> motions = List.of(new Motion(), new Motion());
  private final List<Following> following;
  private final VisionDelay vision = new VisionDelay();

  private Step step;
  private Optional<String> waiting = Optional.empty();
  private WaitingFor waitingFor = WaitingFor.NOTHING;
  private boolean paused;
  private Optional<String> hostReason = Optional.empty();
  private String holding;
  private double heldSince;
  private double lastTick = Double.NaN;
  private double passed;
  private double idle;
  private int madeBefore;
  private double enoughSince = Double.NaN;
  private Optional<String> stopped = Optional.empty();
  private double stoppedAt;
  private boolean endsNow;

  /**
   * A play that has not begun.
   *
   * @param plan what is to be played
   * @param chooser decides which kicks are played
   * @param listener gets each kick when its ball is no longer left alone, from within {@link #tick}; it may call {@link #judge} at once
   * @throws NullPointerException when an argument is null
   */
  public CalibrationPlay(PlayPlan plan, KickChooser chooser, Consumer<PlayedKick> listener) {
    this.plan = Objects.requireNonNull(plan, "plan");
    Objects.requireNonNull(chooser, "chooser");
    Objects.requireNonNull(listener, "listener");
    ledger = new Ledger(plan, chooser, listener);
    driver = new Driver(new PathPlanner(plan.area()), plan.limits().braking());
    safety = new Safety(plan.area(), plan.limits());
    double braking = plan.limits().braking();
    following = List.of(new Following(braking), new Following(braking));
    step = new CheckStep(ledger, -1);
  }

  /**
   * One tick; call it with every world frame, at least some ten times per second. Never throws on what a world holds.
   *
   * @param world what is known of the field now: m, m/s, rad and s in the field frame
   * @return one order for each of the two robots, valid until the next tick, and where a ball is to be placed, if somebody must do so
   */
  public PlayAnswer tick(PlayWorld world) {
    // A host that paused for long has not been idle, nor has one whose clock jumped.
    double sinceLast = world.time() - lastTick;
    double span = sinceLast > 0 ? Math.min(LONGEST_TICK, sinceLast) : 0;
    passed += span;
    lastTick = world.time();
    if (step.phase().over()) {
      return standStill();
    }
    ball.update(world.ball(), world.time());
    vision.update(world.time(), world.visionTime(), span);
    double delay = vision.delay();
    Situation s =
        new Situation(plan, ball, driver, safety, motions, following, world, passed, delay);
    for (int i = 0; i < 2; i++) {
      following.get(i).look(s.robot(i), span);
    }
    if (stopped.isPresent()) {
      return followed(s, watchLastBall(s), span);
    }
    Optional<Hold> hold = reasonToHold(s);
    if (hold.isPresent()) {
      return followed(s, hold(s, hold.get()), span);
    }
    release();
    Step next = step.tick(s);
    step = next;
    waiting = s.waiting();
    // The play ends with the reason that it last waited for.
    waitingFor = step.phase().over() ? waitingFor : s.waitingFor();
    PlayAnswer answer = s.answer();
    watchProgress(s, answer, span);
    return followed(s, step.phase().over() ? standStill() : answer, span);
  }

  /** The answer; also records how the robots follow it. */
  private PlayAnswer followed(Situation s, PlayAnswer answer, double span) {
    for (int i = 0; i < 2; i++) {
      following.get(i).update(s.robot(i), s.sees(i), answer.orders().get(i).velocity(), span);
    }
    return answer;
  }

  private PlayAnswer standStill() {
    return new PlayAnswer(
        List.of(RobotOrder.stop(plan.first()), RobotOrder.stop(plan.second())), Optional.empty());
  }

  /** Why both robots stand, and the robot or place that this is about. */
  private record Hold(String reason, WaitingFor object) {}

  private Optional<Hold> reasonToHold(Situation s) {
    if (paused) {
      return held("paused");
    }
    if (hostReason.isPresent()) {
      return held(hostReason.get());
    }
    Permission permission = s.world().permission();
    if (permission != Permission.RUN) {
      return held("referee: " + permission.name());
    }
    if (!(vision.silent() < NO_VISION)) {
      return held("no vision");
    }
    if (s.visionDelay() > Situation.TOO_LATE) {
      return held(
          String.format(Locale.ROOT, "vision is more than %.1f s late", Situation.TOO_LATE));
    }
    for (int i = 0; i < 2; i++) {
      if (!s.sees(i)) {
        RobotId id = plan.robot(i);
        WaitingFor missing = WaitingFor.robot(id);
        // It is looked for where it was last.
        WaitingFor there = s.world().robot(id).map(r -> missing.at(r.x(), r.y())).orElse(missing);
        return Optional.of(new Hold(missing(s), there));
      }
    }
    return Optional.empty();
  }

  /** Who is not seen; when that is neither of our robots ever, also who is: the numbers or the teams may be wrong. */
  private String missing(Situation s) {
    List<RobotId> gone =
        IntStream.range(0, 2).filter(i -> !s.sees(i)).mapToObj(plan::robot).toList();
    String names = gone.stream().map(RobotId::toString).collect(Collectors.joining(" and "));
    String reason = names + (gone.size() == 1 ? " is not seen" : " are not seen");
    boolean never = gone.stream().allMatch(id -> s.world().robot(id).isEmpty());
    List<RobotId> others = s.others().stream().map(PlayWorld.Robot::id).sorted().toList();
    if (!never || others.isEmpty()) {
      return reason;
    }
    return reason
        + " (vision sees "
        + others.stream().map(RobotId::toString).collect(Collectors.joining(", "))
        + ")";
  }

  private static Optional<Hold> held(String reason) {
    return Optional.of(new Hold(reason, WaitingFor.NOTHING));
  }

  private PlayAnswer hold(Situation s, Hold hold) {
    String reason = hold.reason();
    if (holding == null) {
      heldSince = passed;
    }
    holding = reason;
    waiting = Optional.of(reason);
    waitingFor = hold.object();
    step = step.watch(s);
    boolean allowed = paused || s.world().permission() != Permission.RUN;
    if (allowed) {
      // Somebody asked for it: wait as long as it takes.
      heldSince = passed;
    } else if (passed - heldSince > plan.limits().patience()) {
      stop(String.format(Locale.ROOT, "%s for %.0f s", reason, passed - heldSince));
    }
    return standStill();
  }

  private void release() {
    if (holding == null) {
      return;
    }
    holding = null;
    if (!step.isUnderWay()) {
      // It is not known what happened meanwhile.
      step = new CheckStep(ledger, -1);
    }
  }

  private void watchProgress(Situation s, PlayAnswer answer, double span) {
    for (int i = 0; i < 2; i++) {
      Motion motion = motions.get(i);
      boolean before = motion.stuck();
      boolean kicks = step instanceof TaskStep && step.kicker() == i;
      motion.update(s.robot(i), answer.orders().get(i).velocity().speed(), kicks, span);
      if (!motion.stuck()) {
        continue;
      }
      waiting = Optional.of(s.doesNotMove(i));
      waitingFor = heading(answer.orders().get(i));
      if (motion.stuckForGood()) {
        stop(waiting.get());
      } else if (!before && kicks) {
        // The other robot may be able to do it.
        ledger.remember(waiting.get());
        step = new CheckStep(ledger, -1);
      }
    }
    if (!ledger.complete()) {
      ledger.hopeless().ifPresent(this::stop);
    }
    if (ledger.complete() && step instanceof CheckStep) {
      step = new EndStep(PlayPhase.FINISHED, "");
      waiting = Optional.empty();
    } else if (ledger.enough() && step instanceof CheckStep) {
      enoughSince = Double.isNaN(enoughSince) ? passed : enoughSince;
      if (passed - enoughSince > LAST_FITS) {
        stop("the last kicks were not judged");
      }
    } else {
      enoughSince = Double.NaN;
      watchStall(span);
    }
  }

  private static WaitingFor heading(RobotOrder order) {
    WaitingFor robot = WaitingFor.robot(order.robot());
    return order.target().map(target -> robot.at(target.x(), target.y())).orElse(robot);
  }

  private void watchStall(double span) {
    idle = ledger.made() > madeBefore ? 0 : idle + span;
    madeBefore = ledger.made();
    if (idle > plan.limits().stall()) {
      String last = ledger.lastReason().isEmpty() ? waiting.orElse("") : ledger.lastReason();
      stop(
          String.format(
              Locale.ROOT,
              "no kick for %.0f s while %s%s",
              idle,
              step.phase().text(),
              last.isEmpty() ? "" : ": " + last));
    }
  }

  /** No robot drives any more. The ball of a kick that is under way is watched to its end, so that this kick is like every other. */
  private void stop(String reason) {
    if (step.phase().over() || stopped.isPresent()) {
      return;
    }
    stopped = Optional.of(reason);
    stoppedAt = passed;
    waiting = stopped;
    if (!step.isUnderWay()) {
      step = new EndStep(PlayPhase.STOPPED, reason);
    }
  }

  private PlayAnswer watchLastBall(Situation s) {
    step = step.watch(s);
    boolean enough = endsNow || passed - stoppedAt > LAST_BALL;
    if (enough && step instanceof WatchStep watch) {
      step = watch.cut(s);
    }
    if (enough || !step.isUnderWay()) {
      step = new EndStep(PlayPhase.STOPPED, stopped.orElseThrow());
    }
    return standStill();
  }

  /**
   * Ends the play: from the next tick on both robots are commanded to stand still. While the ball of a kick rolls, the play is not {@link #over} yet, for 5 s at most: keep ticking, so that this kick counts like
   * every other.
   *
   * @param reason for the operator
   */
  public void abort(String reason) {
    stop(Objects.requireNonNull(reason, "reason"));
  }

  /** After {@link #abort}, the ball of the last kick is no longer waited for: the play is over with the next tick. */
  public void endNow() {
    endsNow = true;
  }

  /** No more kicks are wanted: the play is finished as soon as the one that is under way is over. */
  public void conclude() {
    ledger.conclude();
  }

  /** Both robots stand from the next tick on, until {@link #resume}. A rolling ball is still watched. */
  public void pause() {
    paused = true;
  }

  /**
   * Both robots stand while there is a reason, for example that the program that drives them does not answer; after the play's patience the play ends. A rolling ball is still watched.
   *
   * @param reason for the operator; empty to go on
   */
  public void hold(Optional<String> reason) {
    hostReason = Objects.requireNonNull(reason, "reason");
  }

  /** Goes on after {@link #pause}. */
  public void resume() {
    paused = false;
  }

  /**
   * Whether a kick counts. Kicks that are not judged are waited for at the end. A kick may be judged again when later ones have changed the judgement.
   *
   * @param number of the {@link PlayedKick}; of an unknown one nothing happens
   * @param good false to make it again
   */
  public void judge(int number, boolean good) {
    judge(number, good, "");
  }

  /**
   * Whether a kick counts, and why not. When too few kicks count, the play ends and says what most of them lacked.
   *
   * @param number of the {@link PlayedKick}
   * @param good false to make it again
   * @param reason why it does not count, for the operator; empty when it counts, or when the reason is not known
   */
  public void judge(int number, boolean good, String reason) {
    ledger.judge(number, good, Objects.requireNonNull(reason, "reason"), false);
  }

  /**
   * A kick does not count, because its ball left the images of all cameras: later ones are slower. The chooser hears of it ({@link KickChooser#outOfView}).
   *
   * @param number of the {@link PlayedKick}
   * @param reason for the operator
   */
  public void judgeOutOfView(int number, String reason) {
    ledger.judge(number, false, Objects.requireNonNull(reason, "reason"), true);
  }

  /**
   * How far the play is.
   *
   * @return a snapshot: phase, kicks that counted, and what is waited for
   */
  public PlayState state() {
    boolean ended = step instanceof EndStep end && end.phase() == PlayPhase.STOPPED;
    return new PlayState(
        step.phase(),
        ended ? Optional.of(((EndStep) step).reason()) : waiting,
        ended || waiting.isPresent() ? waitingFor : WaitingFor.NOTHING,
        ledger.good(),
        ledger.made(),
        ledger.unjudged(),
        ledger.wanted(),
        ledger.pending(),
        step.kicker(),
        ledger.remarks());
  }

  /**
   * Whether it is over.
   *
   * @return true when all kicks are made, or when it was stopped and no ball is watched any more
   */
  public boolean over() {
    return step.phase().over();
  }
}
