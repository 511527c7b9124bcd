package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.calibrate.CalibrationOutcome;
import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.cli.EditedLog;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.calibration.CalibratedKick;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.MessageType;
import fieldcal.gamelog.RecordingOrigin;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayLimits;
import fieldcal.play.PlayPhase;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.simulation.FieldTrouble;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.robot.RobotCharacter;
import fieldcal.vision.Epoch;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Sessions on the embedded field, as fast as they run. */
class PlaySessionTest {
  @TempDir Path directory;

  private static EmbeddedPlayField field(SessionRequest request, long seed) {
    return new EmbeddedPlayField(
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(seed),
            request.first(),
            request.second(),
            List.of()),
        Double.POSITIVE_INFINITY);
  }

  @Test
  void flatKicksAreMadeRecordedAndFitted() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 3).into(directory);
    List<SessionSnapshot> shown = new ArrayList<>();
    PlaySession.Outcome outcome = new PlaySession(request, field(request, 3), shown::add).run();

    assertThat(outcome.complete()).isTrue();
    SessionSnapshot last = outcome.last();
    assertThat(last.state().good()).isEqualTo(3);
    assertThat(last.kicks()).filteredOn(KickResult::good).hasSize(3);
    assertThat(last.model().get("kSwitch").mean()).isCloseTo(0.65, within(0.01));
    assertThat(shown).extracting(s -> s.state().phase()).contains(PlayPhase.WATCH, PlayPhase.KICK);

    Path log = outcome.log().orElseThrow();
    CollectedKicks found = new KickCollector((file, read, total) -> {}).collect(List.of(log));
    List<CommandFile.Command> told = CommandFile.read(outcome.commands().orElseThrow());
    assertThat(told).hasSize(last.kicks().size());
    assertThat(found.kicks()).hasSameSizeAs(told);
    for (var kick : found.kicks()) {
      double unix = found.epoch().unixSeconds(kick.time());
      assertThat(CommandFile.of(told, unix, kick.robot())).isPresent();
    }
  }

  @Test
  void aSecondSessionDoesNotOverwriteTheFirst() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 1).into(directory);
    Path first = new PlaySession(request, field(request, 1), s -> {}).run().log().orElseThrow();
    long size = Files.size(first);
    Path second = new PlaySession(request, field(request, 2), s -> {}).run().log().orElseThrow();
    assertThat(second).isNotEqualTo(first);
    assertThat(Files.size(first)).isEqualTo(size);
  }

  @Test
  void anAbortEndsItWithItsReason() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.CHIP, 12);
    PlaySession[] session = new PlaySession[1];
    EmbeddedPlayField field = field(request, 5);
    session[0] =
        new PlaySession(
            request,
            field,
            snapshot -> {
              if (snapshot.time() > 3) {
                session[0].abort("enough for today");
              }
            });
    PlaySession.Outcome outcome = session[0].run();
    assertThat(outcome.complete()).isFalse();
    assertThat(outcome.last().state().waiting()).contains("enough for today");
    assertThat(outcome.last().time()).isLessThan(4);
    assertThat(field.field().world().robots()).allSatisfy(r -> assertThat(r.speed()).isLessThan(1));
  }

  /** Driven as all others, they overshoot and push the ball away: the first kick came after 16 s, and with a radio as slow again none in 120 s. */
  @ParameterizedTest
  @ValueSource(longs = {801_000, 801_002})
  void robotsThatFollowLateAreDrivenMoreCalmly(long seed) throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 6).withChoice(false, seed);
    EmbeddedPlayField field = field(request, seed);
    field.field().robotsLike(Set.of(RobotCharacter.SLUGGISH));
    double[] first = {Double.NaN};
    PlaySession[] session = new PlaySession[1];
    session[0] =
        new PlaySession(
            request,
            field,
            s -> {
              if (s.state().made() > 0) {
                first[0] = Double.isNaN(first[0]) ? s.time() : first[0];
                session[0].abort("seen enough");
              }
            });
    session[0].run();
    assertThat(first[0]).isLessThan(8);
  }

  /** It is not in the way of a robot that drives to it, but goes with it: without a hand that takes it off nothing would ever change. */
  @Test
  void aBallThatSticksToARobotIsAskedToBeTakenOff() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 1);
    FieldTrouble sticks = new FieldTrouble(FieldTrouble.Kind.BALL_STUCK, 0.5, 300, 0);
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(4),
            request.first(),
            request.second(),
            List.of(sticks));
    List<String> reasons = new ArrayList<>();
    PlaySession session =
        new PlaySession(
            request,
            new EmbeddedPlayField(field, Double.POSITIVE_INFINITY),
            s ->
                s.state().waiting().filter(w -> !s.ballWanted().isEmpty()).ifPresent(reasons::add));
    PlaySession.Outcome outcome = session.run();
    assertThat(outcome.last().state().waiting()).isEmpty();
    assertThat(outcome.complete()).isTrue();
    assertThat(outcome.last().time()).isLessThan(60);
    assertThat(reasons).anyMatch(r -> r.contains("the ball moved before"));
  }

  /** A vision that is started anew has another clock: what was recorded before is calibrated all the same. */
  @Test
  void aFieldThatCannotGoOnEndsThePlayWithItsReasonAndAModel() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 12).into(directory);
    EmbeddedPlayField inner = field(request, 3);
    boolean[] restarted = new boolean[1];
    PlayField field =
        new OtherField(inner) {
          @Override
          public Optional<String> over() {
            return restarted[0] ? Optional.of("vision was started anew") : Optional.empty();
          }
        };
    PlaySession session =
        new PlaySession(request, field, s -> restarted[0] |= s.state().good() >= 2);
    PlayRun.Result result = PlayRun.run(session, directory, (file, done, total) -> {});
    assertThat(result.session().complete()).isFalse();
    assertThat(result.session().last().state().waiting()).contains("vision was started anew");
    assertThat(result.calibration().orElseThrow().calibration().kicks()).hasSize(2);
    assertThat(inner.field().world().robots()).allSatisfy(r -> assertThat(r.speed()).isLessThan(1));
  }

  /** The summary, the kicks that were judged and a calibration of the recording count the same. */
  private void assertCountedAlike(PlayRun.Result result) {
    SessionSnapshot last = result.session().last();
    assertThat(last.kicks()).hasSize(last.state().made());
    assertThat(last.kicks()).allMatch(k -> k.verdict().isPresent());
    assertThat(last.kicks()).filteredOn(KickResult::good).hasSize(last.state().good());
    List<CalibratedKick> calibrated = result.calibration().orElseThrow().calibration().kicks();
    assertThat(calibrated).hasSameSizeAs(last.kicks());
    assertThat(last.kicks())
        .filteredOn(KickResult::used)
        .hasSize((int) calibrated.stream().filter(CalibratedKick::selected).count());
  }

  @Test
  void aBallThatRollsAtTheEndIsRecordedUntilItRests() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 12).into(directory);
    PlaySession[] session = new PlaySession[1];
    double[] aborted = {Double.NaN};
    session[0] =
        new PlaySession(
            request,
            field(request, 3),
            s -> {
              if (s.state().made() == 2 && s.state().phase() == PlayPhase.WATCH) {
                aborted[0] = Double.isNaN(aborted[0]) ? s.time() : aborted[0];
                session[0].abort("enough");
              }
            });
    PlayRun.Result result = PlayRun.run(session[0], directory, (file, done, total) -> {});
    assertThat(result.session().last().state().waiting()).contains("enough");
    assertThat(result.session().last().state().made()).isEqualTo(2);
    assertThat(result.session().last().time() - aborted[0]).isBetween(0.5, 7.0);
    assertCountedAlike(result);
    assertThat(result.session().last().state().good()).isEqualTo(2);
  }

  /** While vision is silent nothing is found; what was recorded before is judged all the same. */
  @Test
  void aVisionThatDiesWhileABallRollsEndsThePlayWithEveryKickJudged() throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 12)
            .withLimits(PlayLimits.DEFAULT.withPatience(5, 60), Optional.empty())
            .into(directory);
    double[] dies = {Double.POSITIVE_INFINITY};
    double[] now = new double[1];
    PlayField field =
        new OtherField(field(request, 3)) {
          @Override
          public double next(Receiver receiver) throws IOException {
            boolean dead = now[0] > dies[0];
            now[0] = super.next(dead ? (time, packet, payload) -> {} : receiver);
            return now[0];
          }
        };
    PlaySession session =
        new PlaySession(
            request,
            field,
            s -> {
              if (s.state().made() == 2 && dies[0] == Double.POSITIVE_INFINITY) {
                dies[0] = now[0] + 1.5;
              }
            });
    PlayRun.Result result = PlayRun.run(session, directory, (file, done, total) -> {});
    assertThat(result.session().last().state().waiting().orElseThrow()).startsWith("no vision for");
    assertThat(result.session().last().state().made()).isEqualTo(2);
    assertCountedAlike(result);
  }

  @Test
  void aJumpOfVisionsClockIsNoFieldTime() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 2).into(directory);
    double[] jump = new double[1];
    PlayField field =
        new OtherField(field(request, 3)) {
          @Override
          public double next(Receiver receiver) throws IOException {
            return jump[0]
                + super.next(
                    (time, packet, payload) ->
                        receiver.vision(time, EditedLog.later(packet, jump[0]), payload));
          }

          @Override
          public double clockJumps() {
            return jump[0];
          }
        };
    PlaySession session =
        new PlaySession(
            request,
            field,
            s ->
                jump[0] =
                    s.state().good() > 0 && s.state().phase() == PlayPhase.CHECK ? 3600 : jump[0]);
    PlaySession.Outcome outcome = session.run();
    assertThat(jump[0]).isEqualTo(3600);
    assertThat(outcome.last().time()).isBetween(5.0, 200.0);
  }

  /** Two processes that were killed while they waited for vision, and a disk that was full: what is left of them takes nothing away. */
  @Test
  void whatDeadSessionsLeftDoesNotPreventACalibration() throws Exception {
    Files.createFile(directory.resolve("session-flat.log"));
    Files.createFile(directory.resolve("session-flat.commands.csv"));
    try (SessionRecorder killed =
        SessionRecorder.begin(directory, "session-flat", new Epoch(0), RecordingOrigin.FIELD)) {
      SessionRequest request = SessionRequest.of(KickKind.FLAT, 1).into(directory);
      PlaySession session = new PlaySession(request, field(request, 3), s -> {});
      PlayRun.Result result = PlayRun.run(session, directory, (file, done, total) -> {});
      CalibrationOutcome calibration = result.calibration().orElseThrow();
      assertThat(calibration.calibration().kicks()).hasSize(1);
      assertThat(calibration.data().problems()).anyMatch(p -> p.what().equals("cannot be read"));
      Path log = result.session().log().orElseThrow();
      assertThat(log).hasFileName("session-flat-3.log");
      assertThat(PlayRun.leftOut(directory, log)).anyMatch(o -> o.contains("session-flat.log"));
      Files.delete(killed.commands());
      Files.createFile(killed.commands());
      assertThat(PlayRun.calibrate(directory, (file, done, total) -> {}).calibration().kicks())
          .hasSize(1);
    }
  }

  /** Its first frame shows what its clock says; until then another one stands in for it. */
  @Test
  void aVisionWhoseClockIsFarAheadIsPlayedWith() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 1).into(directory);
    double ahead = 3600;
    int[] ticks = new int[1];
    PlayField field =
        new OtherField(field(request, 3)) {
          @Override
          public double next(Receiver receiver) throws IOException {
            ticks[0]++;
            return ticks[0] == 1
                ? super.next((time, packet, payload) -> {}) - ahead
                : super.next(receiver);
          }

          @Override
          public double clockJumps() {
            return ticks[0] > 1 ? ahead : 0;
          }
        };
    PlaySession.Outcome outcome = new PlaySession(request, field, s -> {}).run();
    assertThat(outcome.complete()).isTrue();
    assertThat(outcome.last().time()).isBetween(1.0, 100.0);
  }

  /** A network that is gone takes neither the recording away nor the reason why the play ended. */
  @Test
  void aFieldThatIsGoneLeavesAWholeRecordingAndItsReason() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 12).into(directory);
    int[] packets = new int[1];
    int[] orders = new int[1];
    PlayField field =
        new OtherField(field(request, 3)) {
          @Override
          public double next(Receiver receiver) throws IOException {
            return super.next(
                (time, packet, payload) -> {
                  packets[0]++;
                  receiver.vision(time, packet, payload);
                });
          }

          @Override
          public void order(List<RobotOrder> all) throws IOException {
            if (++orders[0] > 100) {
              throw new IOException("the network is gone, order " + orders[0]);
            }
            super.order(all);
          }
        };
    PlaySession session = new PlaySession(request, field, s -> {});
    assertThatThrownBy(session::run)
        .isInstanceOf(IOException.class)
        .hasMessage("the network is gone, order 101")
        .satisfies(
            e ->
                assertThat(e.getSuppressed())
                    .extracting(Throwable::getMessage)
                    .containsExactly("the network is gone, order 102"));
    int recorded = 0;
    try (GameLogReader log = GameLogReader.open(PlayRun.logs(directory).get(0))) {
      while (log.next()) {
        recorded += log.type() == MessageType.SSL_VISION_2014 ? 1 : 0;
      }
    }
    assertThat(recorded).isEqualTo(packets[0]);
  }

  /** Chips of 8 m/s rise 2 m; the cameras hang twice as high, and see little at half their height. */
  @Test
  void chipsThatLeaveTheImagesAreNamedAndMadeSlower() throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.CHIP, 4).withSpeeds(7, 8, Math.toRadians(60)).into(directory);
    List<SessionSnapshot> shown = new ArrayList<>();
    PlaySession[] session = new PlaySession[1];
    session[0] =
        new PlaySession(
            request,
            field(request, 3),
            s -> {
              shown.add(s);
              if (s.state().made() >= 4) {
                session[0].abort("seen enough");
              }
            });
    List<KickResult> kicks = session[0].run().last().kicks();
    List<KickResult> out = kicks.stream().filter(KickResult::outOfView).toList();
    assertThat(out).isNotEmpty();
    assertThat(out.get(0).reason())
        .startsWith("the ball flew out of the images of all cameras: not seen from 0.");
    int first = kicks.indexOf(out.get(0));
    assertThat(kicks.subList(first + 1, kicks.size()))
        .allMatch(k -> k.played().planned().speed() < out.get(0).played().planned().speed());
  }

  /** Another field behind that of this process. */
  private static class OtherField implements PlayField {
    private final EmbeddedPlayField inner;

    OtherField(EmbeddedPlayField inner) {
      this.inner = inner;
    }

    @Override
    public Epoch epoch() {
      return inner.epoch();
    }

    @Override
    public double next(Receiver receiver) throws IOException {
      return inner.next(receiver);
    }

    @Override
    public void order(List<RobotOrder> orders) throws IOException {
      inner.order(orders);
    }

    @Override
    public void layBall(BallRequest request) {
      inner.layBall(request);
    }

    @Override
    public Permission permission() {
      return inner.permission();
    }

    @Override
    public boolean goesOnByItself() {
      return inner.goesOnByItself();
    }

    @Override
    public void close() {
      inner.close();
    }
  }
}
