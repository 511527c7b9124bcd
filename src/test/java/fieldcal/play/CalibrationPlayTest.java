package fieldcal.play;

import static fieldcal.play.FakeField.BLUE;
import static fieldcal.play.FakeField.GEOMETRY;
import static fieldcal.play.FakeField.THIRD;
import static fieldcal.play.FakeField.YELLOW;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayedKick.End;
import fieldcal.vision.RobotId;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The play on a scripted field: what it does when all is well, and in each kind of trouble. */
class CalibrationPlayTest {
  private final FakeField field = new FakeField();
  private final List<PlayedKick> kicks = new ArrayList<>();
  private CalibrationPlay play;

  private CalibrationPlay flat(int count) {
    return start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, count), count, 0);
  }

  private CalibrationPlay start(PlayPlan plan, int count, double elevation) {
    play =
        new CalibrationPlay(
            plan,
            new SpreadKicks(count, 2, 5, elevation, 1),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), true);
            });
    return play;
  }

  /** Ticks until the play is in a phase. */
  private void until(PlayPhase phase) {
    for (int i = 0; i < 5000 && play.state().phase() != phase; i++) {
      field.tick(play);
    }
    assertThat(play.state().phase()).isEqualTo(phase);
  }

  private void assertStanding(PlayAnswer answer) {
    assertThat(answer.orders())
        .hasSize(2)
        .allSatisfy(o -> assertThat(o).isEqualTo(RobotOrder.stop(o.robot())));
  }

  private void assertNobodyHurt() {
    assertThat(field.hardestContact).isLessThan(0.1);
    assertThat(field.farthestOut).isLessThan(0.2);
  }

  private void assertFinishes() {
    field.run(play, 400);
    assertThat(play.state().phase()).as(play.state().toString()).isEqualTo(PlayPhase.FINISHED);
    assertNobodyHurt();
  }

  @Test
  void flatKicksGoToAndFro() {
    flat(6);
    Set<PlayPhase> phases = EnumSet.noneOf(PlayPhase.class);
    while (!play.over() && field.time < 300) {
      field.tick(play);
      phases.add(play.state().phase());
    }
    assertThat(play.state().phase()).isEqualTo(PlayPhase.FINISHED);
    assertThat(phases)
        .contains(PlayPhase.CHECK, PlayPhase.POSITION, PlayPhase.KICK, PlayPhase.WATCH);
    assertThat(kicks).hasSize(6);
    assertThat(kicks).extracting(PlayedKick::robot).contains(YELLOW, BLUE);
    assertThat(kicks).extracting(k -> k.planned().otherLine()).contains(true, false);
    assertThat(kicks).allSatisfy(k -> assertThat(k.end()).isIn(End.STOPPED, End.RECEIVED));
    assertNobodyHurt();
    assertStanding(field.tick(play));
  }

  @Test
  void theFirstKickIsOneThatCanBeMadeFromWhereTheBallLies() {
    // From the middle of the field there is way for 2 m/s, but not for 5 m/s, which is due first.
    long seed = 1086;
    assertThat(new SpreadKicks(6, 2, 5, 0, seed).next().speed()).isEqualTo(5);
    play =
        new CalibrationPlay(
            PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 6),
            new SpreadKicks(6, 2, 5, 0, seed),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), true);
            });
    field.ball(0, 0);
    Set<PlayPhase> phases = EnumSet.noneOf(PlayPhase.class);
    while (kicks.isEmpty() && field.time < 60) {
      field.tick(play);
      phases.add(play.state().phase());
    }
    assertThat(kicks.get(0).planned().speed()).isEqualTo(2);
    assertThat(phases).doesNotContain(PlayPhase.FETCH, PlayPhase.PLACE);
    assertFinishes();
    assertThat(kicks)
        .extracting(k -> k.planned().speed())
        .containsExactlyInAnyOrder(2., 3.5, 5., 2., 3.5, 5.);
  }

  @Test
  void chipsGoAlongTheHalfWayLine() {
    field.ball(0.3, 0.5);
    start(PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 4), 4, Math.PI / 4);
    assertFinishes();
    assertThat(kicks)
        .allSatisfy(
            k -> {
              assertThat(Math.abs(k.x())).isLessThan(0.5);
              assertThat(Math.abs(Math.sin(k.direction()))).isGreaterThan(0.9);
            });
  }

  @Test
  void oneHalfOfTheFieldIsEnough() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.NEGATIVE, 4), 4, 0);
    assertFinishes();
    assertThat(kicks).allSatisfy(k -> assertThat(k.x()).isLessThan(0.0));
  }

  @Test
  void theReceiverStandsNoFartherThanToldTo() {
    PlayLimits near = PlayLimits.DEFAULT.withReceiverDistance(3);
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1).withLimits(near), 1, 0);
    until(PlayPhase.KICK);
    var receiver = field.robots.get(play.state().kicker() == 0 ? BLUE : YELLOW);
    double distance = Math.hypot(receiver.x - field.ballX, receiver.y - field.ballY);
    assertThat(distance).isCloseTo(3, within(0.2));
  }

  @Test
  void aKickerThatDoesNotFireIsTriedAgain() {
    flat(2);
    field.kickersFire = false;
    until(PlayPhase.KICK);
    field.run(play, 6);
    assertThat(kicks).isEmpty();
    field.kickersFire = true;
    assertFinishes();
  }

  @Test
  void aKickThatTurnsOutBadLaterIsMadeAgain() {
    play =
        new CalibrationPlay(
            PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 3),
            new SpreadKicks(3, 2, 5, 0, 1),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), true);
              if (kick.number() == 2) {
                play.judge(1, false);
                play.judge(1, false);
              }
            });
    assertFinishes();
    assertThat(kicks).hasSize(4);
    assertThat(play.state().good()).isEqualTo(3);
  }

  /** Chips start on a line in one half, and nobody kicks from the other: this ball has to be carried. */
  private void chipsFromAfar() {
    field.ball(1, -3);
    PlayPlan plan = PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 2);
    start(
        plan.withLines(PlayLine.across(GEOMETRY, -3, false), PlayLine.across(GEOMETRY, -3, true)),
        2,
        0.7);
  }

  @Test
  void aDribblerThatSlipsIsDrivenMoreGently() {
    field.pullsUpTo = 0.7;
    chipsFromAfar();
    assertFinishes();
    assertThat(field.lost).isBetween(1, 3);
    assertThat(field.requests).isZero();
    assertThat(kicks.get(0).time()).isLessThan(40);
  }

  /** It is hidden by the robot that carries it, and vision is off for a while. */
  @Test
  void aBallThatItsRobotHidesIsLookedForBeforeSomebodyIsAskedForIt() {
    chipsFromAfar();
    until(PlayPhase.PLACE);
    field.run(play, 0.5);
    FakeField.Body carrier = field.robots.get(field.holder);
    field.ballVisible = false;
    field.vision = false;
    field.run(play, 4);
    field.vision = true;
    while (!field.ballVisible && field.time < 30) {
      field.tick(play);
      assertThat(field.request).isEmpty();
      double away = Math.hypot(field.ballX - carrier.x, field.ballY - carrier.y);
      field.ballVisible = away > PlayArea.AT_DRIBBLER + 0.1;
    }
    assertFinishes();
    assertThat(field.requests).isZero();
  }

  /** The kicker has fired before it hears that it is disarmed: vision is off for a moment, or the referee stops the game. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aKickAtTheMomentOfAStopCounts(boolean referee) {
    flat(1);
    until(PlayPhase.KICK);
    while (Math.hypot(field.ballVx, field.ballVy) < 1) {
      field.tick(play);
    }
    assertThat(play.state().phase()).isEqualTo(PlayPhase.KICK);
    field.permission = referee ? Permission.STOP : Permission.RUN;
    field.vision = referee;
    field.run(play, 0.22);
    field.permission = Permission.RUN;
    field.vision = true;
    field.tick(play);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.WATCH);
    assertThat(play.state().made()).isEqualTo(1);
    field.run(play, 30);
    assertThat(kicks).hasSize(1);
  }

  @Test
  void aLossIsNoticedAtOnceAndNamed() {
    field.pullsUpTo = 0.7;
    chipsFromAfar();
    while (field.lost == 0) {
      field.tick(play);
    }
    double lost = field.time;
    until(PlayPhase.CHECK);
    assertThat(field.time - lost).isLessThan(0.4);
  }

  @Test
  void afterThreeLossesSomebodyIsAskedForHelp() {
    field.holdsUpTo = 0.15;
    chipsFromAfar();
    field.somebodyHelps = false;
    for (int i = 0; i < 5000 && field.request.isEmpty(); i++) {
      field.tick(play);
    }
    assertThat(field.request.orElseThrow().reason()).contains("ball");
    assertThat(field.time).isLessThan(40);
    field.somebodyHelps = true;
    assertFinishes();
  }

  @Test
  void aKickerThatNeverFiresEndsThePlay() {
    flat(2);
    field.kickersFire = false;
    field.run(play, 300);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting().orElseThrow()).containsPattern("did not kick|only pushed");
  }

  @Test
  void aBallInTheGoalIsAskedFor() {
    flat(2);
    field.ball(6.1, 0.2);
    field.run(play, 1.5);
    assertThat(play.state().waiting()).contains("the ball is in the goal");
    assertThat(field.request).isPresent();
    assertStanding(new PlayAnswer(field.tick(play).orders(), Optional.empty()));
    assertFinishes();
    assertThat(field.requests).isEqualTo(1);
  }

  /** Nobody drives to a ball for the first tenths of a second in which it lies where nobody gets at it. */
  @Test
  void aBallThatIsThrownOutIsAskedForAtOnce() {
    flat(2);
    field.somebodyHelps = false;
    until(PlayPhase.POSITION);
    field.ball(5.4, 4.8);
    field.run(play, 1);
    assertThat(play.state().waiting()).contains("the ball is where no robot can reach it");
    assertThat(field.request).isPresent();
  }

  @Test
  void aBallThatNobodyLaysDownEndsThePlay() {
    flat(2);
    field.somebodyHelps = false;
    field.ball(2, 4.85);
    field.run(play, 100);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting().orElseThrow()).contains("where no robot can reach it");
    assertThat(field.time).isLessThan(70);
  }

  @ParameterizedTest
  @ValueSource(strings = {"-5.9,4.6", "3,-4.62", "-6.1,2.5"})
  void aBallJustOutsideIsFetched(String place) {
    flat(2);
    String[] xy = place.split(",");
    field.ball(Double.parseDouble(xy[0]), Double.parseDouble(xy[1]));
    until(PlayPhase.FETCH);
    assertFinishes();
    assertThat(field.requests).isZero();
  }

  /** A robot would carry them for seconds, and may lose them on the way. */
  @ParameterizedTest
  @ValueSource(strings = {"5.95,4.45", "-5.95,-4.48", "4,-3"})
  void aBallFarFromTheLineIsKickedBackToIt(String place) {
    start(PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 2), 2, 0.7);
    String[] xy = place.split(",");
    field.ball(Double.parseDouble(xy[0]), Double.parseDouble(xy[1]));
    Set<PlayPhase> phases = EnumSet.noneOf(PlayPhase.class);
    while (kicks.isEmpty() && field.time < 20) {
      field.tick(play);
      phases.add(play.state().phase());
    }
    assertThat(kicks.get(0).x()).isCloseTo(Double.parseDouble(xy[0]), within(0.05));
    assertThat(phases).doesNotContain(PlayPhase.FETCH, PlayPhase.PLACE);
    assertFinishes();
    assertThat(field.requests).isZero();
    assertThat(Math.abs(kicks.get(1).x())).isLessThan(1.5);
  }

  /** Beyond the lines there is no room behind it, but just inside there is. */
  @Test
  void aBallIsCarriedNoFartherThanItMust() {
    start(PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 1), 1, 0.7);
    field.ball(4, -4.62);
    until(PlayPhase.PLACE);
    assertFinishes();
    assertThat(kicks.get(0).x()).isGreaterThan(2);
    assertThat(Math.abs(kicks.get(0).y())).isLessThan(4.5);
  }

  @Test
  void nobodyKicksFromTheHalfThatIsSomebodyElses() {
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.NEGATIVE, 1), 1, 0);
    field.ball(4, 2);
    until(PlayPhase.FETCH);
    assertFinishes();
    assertThat(kicks.get(0).x()).isLessThan(0);
  }

  @Test
  void aBallThatVanishesIsWaitedForAndAskedFor() {
    flat(2);
    until(PlayPhase.WATCH);
    field.ballVisible = false;
    field.run(play, 3);
    assertThat(kicks).hasSize(1);
    assertThat(kicks.get(0).end()).isIn(End.LOST, End.LEFT_FIELD);
    assertFinishes();
    assertThat(field.requests).isPositive();
  }

  @Test
  void nobodyDrivesUpToABallThatIsNotSeen() {
    flat(3);
    int begun = 0;
    PlayPhase before = PlayPhase.CHECK;
    while (field.time < 60 && !play.over()) {
      field.ballVisible = field.time % 0.45 < 0.05;
      field.tick(play);
      PlayPhase now = play.state().phase();
      if (now == PlayPhase.KICK && before != PlayPhase.KICK) {
        begun++;
        assertThat(field.time - field.ballSeen).isLessThan(0.25);
      }
      before = now;
    }
    assertThat(begun).isPositive();
  }

  @Test
  void aBallBetweenTheRobotsIsLeftToOneOfThem() {
    flat(2);
    field.put(YELLOW, 0, -0.16, Math.PI / 2);
    field.put(BLUE, 0, 0.16, -Math.PI / 2);
    field.ball(0, 0);
    assertFinishes();
    assertThat(field.nearest).isGreaterThan(0.18);
  }

  @Test
  void robotsThatStandTooCloseMoveApart() {
    flat(1);
    field.put(YELLOW, 2, 2, 0);
    field.put(BLUE, 2.185, 2, 0);
    assertFinishes();
  }

  @Test
  void aRobotThatDisappearsStopsBothUntilItIsBack() {
    flat(2);
    until(PlayPhase.POSITION);
    field.run(play, 0.5);
    field.robots.get(BLUE).visible = false;
    field.run(play, 0.4);
    assertStanding(field.tick(play));
    assertThat(play.state().waiting()).contains("blue 7 is not seen");
    assertThat(play.state().waitingFor().robot()).contains(BLUE);
    // It is looked for where it was last.
    WaitingFor.Place last = play.state().waitingFor().place().orElseThrow();
    FakeField.Body there = field.robots.get(BLUE);
    assertThat(Math.hypot(last.x() - there.x, last.y() - there.y)).isLessThan(0.1);
    field.run(play, 5);
    field.put(BLUE, -1, 3, 0).visible = true;
    assertFinishes();
  }

  @Test
  void aRobotThatIsTakenOffForGoodEndsThePlay() {
    flat(2);
    field.robots.get(BLUE).visible = false;
    field.run(play, 200);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting().orElseThrow()).startsWith("blue 7 is not seen for 60");
    assertThat(play.state().waitingFor().robot()).contains(BLUE);
  }

  /** Vision was restarted with another clock, for example. */
  @Test
  void aForwardJumpOfTheClockIsNoWait() {
    flat(2);
    field.robots.get(BLUE).visible = false;
    field.run(play, 5);
    field.time += 1000;
    field.run(play, 5);
    assertThat(play.state().waiting()).contains("blue 7 is not seen");
    assertThat(play.over()).isFalse();
    field.robots.get(BLUE).visible = true;
    assertFinishes();
  }

  @Test
  void aForwardJumpOfTheClockLeavesTimeToPlaceTheBall() {
    flat(2);
    field.ball(6.35, 3);
    field.somebodyHelps = false;
    field.run(play, 5);
    assertThat(field.request).isPresent();
    field.time += 1000;
    field.run(play, 5);
    assertThat(field.request).isPresent();
    assertThat(play.over()).isFalse();
    field.somebodyHelps = true;
    assertFinishes();
  }

  @Test
  void aRobotThatFellOverIsNamed() {
    flat(2);
    field.robots.get(YELLOW).obeys = false;
    field.run(play, 8);
    assertThat(play.state().waiting()).contains("yellow 3 does not move");
    assertThat(play.state().waitingFor().robot()).contains(YELLOW);
    field.run(play, 60);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting()).contains("yellow 3 does not move");
  }

  /** Its kicker cannot reach the ball: that is not the kicker's fault. */
  @Test
  void aRobotThatStopsMovingBeforeItsKickIsNotToldToHaveABadKicker() {
    flat(2);
    until(PlayPhase.KICK);
    double begin = field.time;
    field.robots.values().forEach(robot -> robot.obeys = false);
    field.run(play, 60);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting().orElseThrow()).endsWith("does not move");
    assertThat(play.state().remarks()).isEmpty();
    assertThat(field.time - begin).isBetween(19.0, 22.0);
  }

  @Test
  void aThirdRobotInTheWayIsDrivenRound() {
    flat(3);
    field.put(THIRD, -1, -0.75, 0);
    assertFinishes();
    assertThat(field.nearest).isGreaterThan(0.19);
  }

  @Test
  void aThirdRobotAtTheBallIsWaitedFor() {
    flat(1);
    field.put(THIRD, 1.13, 0.5, 0);
    Set<RobotId> waitedFor = new HashSet<>();
    for (int i = 0; i < 4 / FakeField.TICK; i++) {
      field.tick(play);
      play.state().waitingFor().robot().ifPresent(waitedFor::add);
    }
    assertThat(waitedFor).contains(THIRD);
    field.put(THIRD, 5, -4, 0);
    assertFinishes();
    assertThat(play.state().waitingFor()).isEqualTo(WaitingFor.NOTHING);
  }

  @Test
  void aBallBesideAThirdRobotThatStaysIsTakenFromTheOtherSide() {
    flat(1);
    field.ball(5.8, 4.3);
    field.put(THIRD, 5.94, 4.16, 2);
    assertFinishes();
    assertThat(field.requests).isZero();
  }

  @Test
  void aBallThatAThirdRobotHoldsIsAskedForElsewhere() {
    flat(1);
    field.ball(5.8, 4.3);
    field.put(THIRD, 5.8 + 0.08, 4.3 + 0.08, -2.4);
    assertFinishes();
    assertThat(field.requests).isEqualTo(1);
  }

  @Test
  void aBallThatAThirdRobotHoldsForGoodEndsThePlayWithItsName() {
    flat(1);
    field.ball(5.8, 4.3);
    field.put(THIRD, 5.8 + 0.08, 4.3 + 0.08, -2.4);
    field.somebodyHelps = false;
    field.run(play, 300);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(play.state().waiting().orElseThrow()).contains(THIRD + " ");
    assertNobodyHurt();
  }

  @Test
  void aThirdRobotThatDrivesAtOursIsGivenWayTo() {
    flat(1);
    FakeField.Body third = field.put(THIRD, -5, -2, 0);
    for (int i = 0; i < 150; i++) {
      third.x += 0.6 * FakeField.TICK;
      third.vx = 0.6;
      third.y = field.robots.get(YELLOW).y;
      third.order = null;
      field.tick(play);
      third.x -= third.vx * FakeField.TICK;
    }
    assertThat(field.hardestContact).isLessThan(0.1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"HALT", "STOP"})
  void theRefereeStopsBothInTheNextTick(String command) {
    flat(2);
    until(PlayPhase.KICK);
    field.permission = Permission.valueOf(command);
    assertStanding(field.tick(play));
    assertThat(play.state().waiting()).contains("referee: " + command);
    // A halt is no fault of anybody: however long it lasts, the play goes on.
    field.run(play, 150);
    field.permission = Permission.RUN;
    assertFinishes();
  }

  @Test
  void aHaltWhileTheBallRollsDoesNotSpoilTheKick() {
    flat(1);
    until(PlayPhase.WATCH);
    field.permission = Permission.HALT;
    field.run(play, 1);
    field.permission = Permission.RUN;
    field.run(play, 30);
    assertThat(kicks).hasSize(1);
  }

  @Test
  void withoutVisionNobodyMoves() {
    flat(2);
    until(PlayPhase.POSITION);
    field.run(play, 0.4);
    field.vision = false;
    field.run(play, 0.2);
    assertStanding(field.tick(play));
    assertThat(play.state().waiting()).contains("no vision");
    field.run(play, 3);
    field.vision = true;
    assertFinishes();
  }

  @Test
  void anAbortStopsBothInTheNextTick() {
    flat(2);
    until(PlayPhase.KICK);
    play.abort("enough");
    assertStanding(field.tick(play));
    // The kicker may have fired before it heard of it.
    field.run(play, 0.3);
    assertThat(play.over()).isTrue();
    assertThat(play.state().waiting()).contains("enough");
    assertThat(play.state().made()).isZero();
  }

  /** The ball rolls on when somebody ends the play, or when it has waited for long enough. */
  @ParameterizedTest
  @ValueSource(strings = {"aborted", "host gone", "vision gone"})
  void aKickUnderWayAtTheEndIsWatchedToItsEnd(String what) {
    PlayLimits impatient = PlayLimits.DEFAULT.withPatience(1, 100);
    start(
        PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 3).withLimits(impatient), 3, 0);
    until(PlayPhase.WATCH);
    switch (what) {
      case "aborted" -> play.abort("enough");
      case "host gone" -> play.hold(Optional.of("the bridge does not answer"));
      default -> field.vision = false;
    }
    assertThat(play.over()).isFalse();
    for (double end = field.time + 6.5; field.time < end && !play.over(); ) {
      PlayAnswer answer = field.tick(play);
      if (field.vision || field.time > end - 5.5) {
        assertStanding(answer);
      }
    }
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    assertThat(kicks).hasSize(1);
    assertThat(play.state().made()).isEqualTo(1);
    assertThat(play.state().good()).isEqualTo(1);
    assertThat(kicks.get(0).ended() - kicks.get(0).time()).isGreaterThan(1);
  }

  @Test
  void whoeverDoesNotWaitForTheLastBallEndsItAtOnce() {
    flat(3);
    until(PlayPhase.WATCH);
    play.abort("enough");
    field.tick(play);
    assertThat(play.over()).isFalse();
    play.endNow();
    assertStanding(field.tick(play));
    assertThat(play.over()).isTrue();
    assertThat(kicks).extracting(PlayedKick::end).containsExactly(End.TIMEOUT);
  }

  /** The first time may be chance. */
  @Test
  void aKickerWithoutEffectIsNamedWhenItHappensAgain() {
    flat(2);
    field.kickersFire = false;
    until(PlayPhase.KICK);
    RobotId kicker = play.state().kicker() == 0 ? YELLOW : BLUE;
    while (play.state().phase() == PlayPhase.KICK) {
      field.tick(play);
    }
    assertThat(play.state().remarks()).isEmpty();
    until(PlayPhase.KICK);
    field.run(play, 5);
    assertThat(play.state().remarks())
        .singleElement()
        .asString()
        .startsWith(kicker + " ")
        .endsWith(", twice in a row: check its kicker");
  }

  /** One robot's kicker is being charged for long; the ball now lies before the other one. */
  @Test
  void aKickerThatIsReadyIsNotBlamedForTheOther() {
    flat(2);
    field.kickersFire = false;
    until(PlayPhase.KICK);
    int first = play.state().kicker();
    for (int tried = 0; tried < 4; tried++) {
      until(PlayPhase.KICK);
      assertThat(play.state().kicker()).isEqualTo(first);
      while (play.state().phase() == PlayPhase.KICK) {
        field.tick(play);
      }
    }
    FakeField.Body other = field.robots.get(first == 0 ? BLUE : YELLOW);
    field.ball(
        other.x + 0.2 * Math.cos(other.orientation), other.y + 0.2 * Math.sin(other.orientation));
    field.kickersFire = true;
    double begin = field.time;
    List<String> said = new ArrayList<>();
    while (kicks.isEmpty() && field.time < begin + 60) {
      field.tick(play);
      if (play.state().kicker() == 1 - first) {
        play.state().waiting().ifPresent(said::add);
      }
    }
    assertThat(kicks.get(0).robot()).isEqualTo(first == 0 ? BLUE : YELLOW);
    assertThat(kicks.get(0).time()).isLessThan(begin + 4);
    assertThat(said).noneMatch(text -> text.contains("trying again"));
  }

  /** What is measured of the kicker is no reason why the receiver is late. */
  @Test
  void aReceiverThatIsLateIsNotReportedWithThePlaceOfTheKicker() {
    PlayLimits once =
        new PlayLimits(2.5, 1.2, 0.3, 2, 0.06, Double.POSITIVE_INFINITY, 0.6, 15, 60, 120, 1);
    start(PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 2).withLimits(once), 2, 0);
    until(PlayPhase.POSITION);
    RobotId late = play.state().kicker() == 0 ? BLUE : YELLOW;
    FakeField.Body body = field.robots.get(late);
    double x = body.x;
    double y = body.y;
    for (int i = 0; i < 1500 && !play.over(); i++) {
      // It moves, but not to where it should.
      body.x = x + 0.1 * (i / 50 % 2);
      body.y = y;
      field.tick(play);
    }
    assertThat(play.state().waiting().orElseThrow())
        .isEqualTo("1 failed kicks in a row; the last: " + late + " is not in its place yet");
  }

  @Test
  void aKickThatLeftTheImagesIsFollowedBySlowerOnes() {
    play =
        new CalibrationPlay(
            PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 4),
            new SpreadKicks(4, 2, 5, 0, 1),
            kick -> {
              kicks.add(kick);
              if (kick.planned().speed() > 3) {
                play.judgeOutOfView(kick.number(), "the ball left the images");
              } else {
                play.judge(kick.number(), true);
              }
            });
    assertFinishes();
    double slowestTooFast = Double.POSITIVE_INFINITY;
    for (PlayedKick kick : kicks) {
      assertThat(kick.planned().speed()).isLessThan(slowestTooFast);
      slowestTooFast = kick.planned().speed() > 3 ? kick.planned().speed() : slowestTooFast;
    }
  }

  @Test
  void aPauseStopsBothUntilItEnds() {
    flat(2);
    until(PlayPhase.POSITION);
    play.pause();
    assertStanding(field.tick(play));
    field.run(play, 200);
    assertThat(play.state().waiting()).contains("paused");
    play.resume();
    assertFinishes();
  }

  @Test
  void kicksThatDoNotCountAreMadeAgain() {
    PlayPlan plan = PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 2);
    play =
        new CalibrationPlay(
            plan,
            new SpreadKicks(2, 2, 4, 0, 1),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), kick.number() != 1);
            });
    assertFinishes();
    assertThat(kicks).hasSize(3);
    assertThat(play.state().good()).isEqualTo(2);
  }

  @Test
  void whenNoKickCountsItGivesUp() {
    PlayPlan plan = PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1);
    play =
        new CalibrationPlay(
            plan,
            new SpreadKicks(1, 3, 3, 0, 1),
            kick ->
                play.judge(kick.number(), false, kick.number() == 2 ? "it bounced" : "too short"));
    field.run(play, 600);
    assertThat(play.state().phase()).isEqualTo(PlayPhase.STOPPED);
    int made = play.state().made();
    assertThat(play.state().waiting().orElseThrow())
        .isEqualTo(
            String.format(
                "only 0 of %d kicks could be used; the most frequent reason, %d times: too short",
                made, made - 1));
  }

  /** How many were wanted at first says how many may fail, also when fewer turn out to be enough. */
  @Test
  void whatIsConcludedIsFinishedHoweverManyKicksDidNotCount() {
    PlayPlan plan = PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 6);
    int enough = plan.limits().maxAttempts() + 5;
    play =
        new CalibrationPlay(
            plan,
            new SpreadKicks(6, 3, 3, 0, 1),
            kick -> {
              kicks.add(kick);
              play.judge(kick.number(), kick.number() == 1, "too short");
              if (kick.number() == enough) {
                play.conclude();
              }
            });
    field.run(play, 600);
    assertThat(play.state().phase()).as(play.state().toString()).isEqualTo(PlayPhase.FINISHED);
    assertThat(kicks).hasSize(enough);
    assertThat(play.state().good()).isEqualTo(1);
    assertThat(play.state().wanted()).isEqualTo(1);
  }

  @Test
  void kicksThatAreNeverJudgedDoNotHangIt() {
    PlayPlan plan = PlayPlan.flat(YELLOW, BLUE, GEOMETRY, PlayLine.Half.WHOLE, 1);
    play = new CalibrationPlay(plan, new SpreadKicks(1, 3, 3, 0, 1), kick -> {});
    field.run(play, 300);
    assertThat(play.state().waiting()).contains("the last kicks were not judged");
  }

  @Test
  void nonsenseDoesNotBreakIt() {
    flat(1);
    Random random = new Random(5);
    for (int i = 0; i < 300; i++) {
      field.ballX = random.nextBoolean() ? Double.NaN : 1e9 * random.nextGaussian();
      field.robots.get(YELLOW).vx = random.nextInt(3) == 0 ? Double.NaN : 0;
      field.robots.get(YELLOW).x = -3;
      PlayAnswer answer = play.tick(field.world());
      assertThat(answer.orders())
          .allSatisfy(o -> assertThat(o.velocity().speed()).isBetween(0.0, 5.0));
      field.time += FakeField.TICK;
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void fromAnywhereNobodyIsHurt(long seed) {
    Random random = new Random(seed);
    flat(4);
    field.put(YELLOW, 11 * random.nextDouble() - 5.5, 8 * random.nextDouble() - 4, 0);
    do {
      field.put(BLUE, 11 * random.nextDouble() - 5.5, 8 * random.nextDouble() - 4, 0);
      field.nearest = Double.POSITIVE_INFINITY;
    } while (Math.hypot(
            field.robots.get(BLUE).x - field.robots.get(YELLOW).x,
            field.robots.get(BLUE).y - field.robots.get(YELLOW).y)
        < 0.3);
    field.ball(10 * random.nextDouble() - 5, 8 * random.nextDouble() - 4);
    assertFinishes();
  }

  @Test
  void wrongPlansAreRefused() {
    assertThatThrownBy(() -> PlayPlan.flat(YELLOW, YELLOW, GEOMETRY, PlayLine.Half.WHOLE, 3))
        .hasMessageContaining("two robots");
    assertThatThrownBy(() -> PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 0))
        .hasMessageContaining("at least one kick");
    assertThatThrownBy(
            () ->
                PlayPlan.chip(YELLOW, BLUE, GEOMETRY, 1)
                    .withLines(new PlayLine(0, -9, 0, 9), new PlayLine(0, 1, 0, -1)))
        .hasMessageContaining("leaves the field");
    assertThatThrownBy(() -> new PlannedKick(Double.NaN, 0, false))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> new PlayArea(12, 9, 2, 1)).hasMessageContaining("margin");
  }
}
