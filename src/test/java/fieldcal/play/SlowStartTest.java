package fieldcal.play;

import static fieldcal.play.FakeField.BLUE;
import static fieldcal.play.FakeField.GEOMETRY;
import static fieldcal.play.FakeField.THIRD;
import static fieldcal.play.FakeField.YELLOW;
import static org.assertj.core.api.Assertions.assertThat;

import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

/** What made plays slow to start: each was the cause of a first kick after more than 40 s on a drawn field. */
class SlowStartTest {
  private final FakeField field = new FakeField();
  private final List<PlayedKick> kicks = new ArrayList<>();
  private final Set<String> reasons = new HashSet<>();
  private CalibrationPlay play;

  private void start(PlayPlan plan, double elevation) {
    play =
        new CalibrationPlay(
            plan,
            new SpreadKicks(plan.kicks(), 2, 5, elevation, 1),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), true);
            });
  }

  private void chips() {
    start(PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 2), 0.7);
  }

  private void tick() {
    assertThat(field.time).as(play.state().toString()).isLessThan(90);
    field.tick(play);
    play.state().waiting().ifPresent(reasons::add);
  }

  private void untilKicked(double seconds) {
    while (kicks.isEmpty() && field.time < seconds) {
      tick();
    }
    assertThat(kicks).as(play.state().toString()).isNotEmpty();
    assertThat(field.hardestContact).isLessThan(0.1);
  }

  @Test
  void theOtherRobotTakesOverFromOneThatFellOver() {
    chips();
    field.ball(-4, -4.55);
    while (play.state().phase() != PlayPhase.FETCH) {
      tick();
    }
    FakeField.Body fallen = field.robots.get(YELLOW);
    assertThat(play.state().kicker()).isZero();
    fallen.obeys = false;
    while (play.state().kicker() != 1 && field.time < 60) {
      tick();
    }
    assertThat(field.time).isLessThan(5);
    assertThat(reasons).contains("yellow 3 does not move");
    while (play.state().phase() != PlayPhase.PLACE && field.time < 15) {
      tick();
    }
    assertThat(field.holder).isEqualTo(BLUE);
    fallen.obeys = true;
    untilKicked(30);
  }

  /** Between ball and edge there is no way to behind the ball, as seen from the kick's aim. */
  @Test
  void aBallInACornerIsTakenFromASideThatCanBeReached() {
    chips();
    field.ball(6.01, 4.53);
    untilKicked(20);
  }

  @Test
  void aRobotWithoutAWayIsNamed() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1), 0);
    field.ball(1.5, 0.5);
    for (int i = 0; i < 10; i++) {
      double angle = 2 * Math.PI * i / 10;
      for (RobotRing ring : RobotRing.values()) {
        FakeField.Body centre = field.robots.get(ring.around);
        field.put(
            ring.id(i), centre.x + 0.5 * Math.cos(angle), centre.y + 0.5 * Math.sin(angle), 0);
      }
    }
    for (int i = 0; i < 200; i++) {
      tick();
    }
    assertThat(reasons).anyMatch(r -> r.contains("finds no way to its target"));
  }

  /** Robots that stand around each of ours. */
  private enum RobotRing {
    ROUND_YELLOW(YELLOW),
    ROUND_BLUE(BLUE);

    private final RobotId around;

    RobotRing(RobotId around) {
      this.around = around;
    }

    RobotId id(int i) {
      return new RobotId(around.team(), 20 + i);
    }
  }

  @Test
  void aBallThatSomebodyTakesFromARobotIsNotLostByIt() {
    PlayPlan plan = PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 2);
    PlayLine line = PlayLine.across(GEOMETRY, -3, false);
    start(plan.withLines(line, PlayLine.across(GEOMETRY, -3, true)), 0.7);
    field.ball(2, -3);
    while (field.holder == null || field.ballX > 0.5) {
      tick();
    }
    field.ball(2, 3);
    double fastest = 0;
    while (kicks.isEmpty()) {
      tick();
      FakeField.Body b = field.robots.get(field.holder);
      boolean carries = play.state().phase() == PlayPhase.PLACE && b != null;
      fastest = Math.max(fastest, carries ? Math.hypot(b.vx, b.vy) : 0);
    }
    assertThat(fastest).isGreaterThan(1);
    assertThat(reasons).noneMatch(r -> r.contains("lost"));
  }

  @Test
  void aBallThatSomebodyMovesBeforeTheKickIsNoKickInVain() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1), 0);
    while (play.state().phase() != PlayPhase.KICK) {
      tick();
    }
    field.ball(2, -2);
    untilKicked(30);
    assertThat(reasons).noneMatch(r -> r.contains("pushed") || r.contains("did not kick"));
  }

  @Test
  void onlyLossesOfPushedBallsSlowDownARobotThatPushes() {
    PlayLimits limits = PlayLimits.DEFAULT;
    Ledger ledger =
        new Ledger(
            PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 2), new SpreadKicks(2, 2, 5, 0.7, 1), k -> {});
    assertThat(ledger.grip(0, true, limits).gentle()).isFalse();
    ledger.lost(0, false, "pulled away");
    assertThat(ledger.grip(0, false, limits).speed()).isEqualTo(limits.carrySpeed() / 2);
    assertThat(ledger.grip(0, true, limits).speed()).isEqualTo(limits.carrySpeed());
    assertThat(ledger.grip(0, true, limits).gentle()).isTrue();
    ledger.lost(0, true, "pushed away");
    assertThat(ledger.grip(0, true, limits).speed()).isEqualTo(limits.carrySpeed() / 2);
    // The other robot's dribbler will not be much better, but it has not lost twice.
    assertThat(ledger.grip(1, false, limits).speed()).isEqualTo(limits.carrySpeed() / 2);
  }

  @Test
  void oursLeaveRoomForAThirdRobotThatCannotLeave() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1), 0);
    field.ball(0, 0);
    field.put(THIRD, 0.11, 0, Math.PI);
    FakeField.Body ours = field.put(YELLOW, -0.5, 0, 0);
    for (int i = 0; i < 6 / FakeField.TICK; i++) {
      tick();
    }
    assertThat(reasons).contains("blue 9 is in the way");
    assertThat(Math.hypot(ours.x, ours.y)).isGreaterThan(0.9);
    assertThat(field.hardestContact).isZero();
  }

  /** Its radio was slow: it heard of the kick too late and of the end of it too late. */
  @Test
  void aKickerThatFiresJustAfterItWasDisarmedHasKicked() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1), 0);
    field.kickersFire = false;
    while (play.state().phase() != PlayPhase.KICK) {
      tick();
    }
    FakeField.Body kicker = field.robots.get(play.state().kicker() == 0 ? YELLOW : BLUE);
    while (kicker.order.kick().armed()) {
      tick();
    }
    assertThat(play.state().phase()).isEqualTo(PlayPhase.KICK);
    field.ballVx = 3 * Math.cos(kicker.orientation);
    field.ballVy = 3 * Math.sin(kicker.orientation);
    untilKicked(30);
    assertThat(reasons).noneMatch(r -> r.contains("did not kick"));
  }

  @Test
  void theBallIsAskedForWhereTheRobotsAreReadySoonest() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1), 0);
    field.put(YELLOW, -1, -0.7, 0);
    field.put(BLUE, 4.5, 3, Math.PI);
    field.ballVisible = false;
    while (field.request.isEmpty()) {
      tick();
    }
    // Yellow kicks from three tenths of the line, and blue stands where it receives.
    assertThat(Math.hypot(field.request.get().x() + 1.82, field.request.get().y() + 1.22))
        .isLessThan(0.1);
    untilKicked(15);
  }

  /** A fast chip needs more way than there is to the end of the line; it was fetched, carried and lost. */
  @Test
  void aBallBesideTheLineOfChipsIsKickedFromThereWhereOneOfTheKicksAllowsIt() {
    PlannedKick fast = new PlannedKick(5, 0.7, false);
    PlannedKick slow = new PlannedKick(2.5, 0.7, false);
    KickChooser either =
        new KickChooser() {
          @Override
          public PlannedKick next(double ballX, double ballY) {
            return fast;
          }

          @Override
          public PlannedKick next(double x, double y, Predicate<PlannedKick> fromHere) {
            return fromHere.test(slow) ? slow : fast;
          }

          @Override
          public void done(PlannedKick kick, boolean good) {}
        };
    play = new CalibrationPlay(PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 1), either, kicks::add);
    field.ball(0.6, 0);
    Set<PlayPhase> phases = EnumSet.noneOf(PlayPhase.class);
    while (kicks.isEmpty()) {
      tick();
      phases.add(play.state().phase());
    }
    assertThat(kicks.get(0).planned()).isEqualTo(slow);
    assertThat(phases).doesNotContain(PlayPhase.FETCH, PlayPhase.PLACE);
  }

  /** It was carried on to the end of the line, since it was looked for where it had been seen last: beyond the lines. */
  @Test
  void aCarriedBallThatItsRobotHidesIsLetGoWhereItCanBeKicked() {
    chips();
    field.ball(3, 4.6);
    while (field.holder == null) {
      tick();
    }
    field.ballVisible = false;
    while (play.state().phase() != PlayPhase.CHECK) {
      tick();
    }
    assertThat(field.ballX).isGreaterThan(1.5);
    assertThat(field.ballY).isLessThan(4.5);
    field.ballVisible = true;
    untilKicked(20);
  }
}
