package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.recording.CollectedKicks;
import fieldcal.app.recording.KickCollector;
import fieldcal.kick.KickKind;
import fieldcal.play.PlayAnswer.BallRequest;
import fieldcal.play.PlayLimits;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.RobotOrder;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionPacket;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sessions on the embedded field whose vision is late and loses frames, and whose robots hear late. */
class LateVisionTest {
  private static final double LOST = 0.2;

  @TempDir Path directory;

  /** Everything takes longer from the field to the play, and back. */
  private static final class LateField implements PlayField {
    private final EmbeddedPlayField field;
    private final double latency;
    private final double radio;
    private final boolean told;
    private final Random luck = new Random(7);
    private final Deque<Frame> frames = new ArrayDeque<>();
    private final Deque<Orders> onTheWay = new ArrayDeque<>();
    private double now;

    private record Frame(double received, VisionPacket packet, byte[] payload) {}

    private record Orders(double arrive, List<RobotOrder> orders) {}

    /** Whether vision's time stamps tell that it is late: where frames are held up after they were sent, they do not. */
    LateField(EmbeddedPlayField field, double latency, double radio, boolean told) {
      this.field = field;
      this.told = told;
      this.latency = latency;
      this.radio = radio;
    }

    @Override
    public Epoch epoch() {
      return field.epoch();
    }

    @Override
    public double next(Receiver receiver) throws IOException {
      now =
          field.next(
              (received, packet, payload) -> {
                if (packet.frame().isEmpty() || luck.nextDouble() >= LOST) {
                  frames.add(new Frame(received + latency, packet, payload));
                }
              });
      while (!frames.isEmpty() && frames.peek().received() <= now) {
        Frame frame = frames.remove();
        receiver.vision(frame.received(), frame.packet(), frame.payload());
      }
      while (!onTheWay.isEmpty() && onTheWay.peek().arrive() <= now) {
        field.order(onTheWay.remove().orders());
      }
      return told ? now : now - latency;
    }

    @Override
    public void order(List<RobotOrder> orders) {
      onTheWay.add(new Orders(now + radio, orders));
    }

    @Override
    public void layBall(BallRequest request) {
      field.layBall(request);
    }

    @Override
    public Permission permission() {
      return field.permission();
    }

    @Override
    public boolean goesOnByItself() {
      return false;
    }

    @Override
    public void close() {
      field.close();
    }
  }

  private static LateField field(SessionRequest request, double latency, double radio) {
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(3), request.first(), request.second(), List.of());
    EmbeddedPlayField embedded = new EmbeddedPlayField(field, Double.POSITIVE_INFINITY);
    return new LateField(embedded, latency, radio, true);
  }

  /** Its latency was taken for silence: from 0.14 s on, every lost frame stopped the robots. Kicks came to light when they were given up, or after their commands were matched. */
  @ParameterizedTest
  @CsvSource({"0.05,0.02", "0.15,0.02", "0.14,0.12", "0.25,0.1"})
  void aLateVisionIsNotSilentAndShowsEveryKick(double latency, double radio) throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 6).into(directory);
    List<String> waited = new ArrayList<>();
    PlaySession.Outcome outcome =
        new PlaySession(
                request,
                field(request, latency, radio),
                s -> s.state().waiting().ifPresent(waited::add))
            .run();
    assertThat(outcome.complete()).as(outcome.last().state().toString()).isTrue();
    assertThat(waited)
        .filteredOn(w -> w.contains("vision") || w.contains("robot") || w.contains("not kick"))
        .isEmpty();

    CollectedKicks found =
        new KickCollector((file, read, total) -> {}).collect(List.of(outcome.log().orElseThrow()));
    List<CommandFile.Command> told = CommandFile.read(outcome.commands().orElseThrow());
    assertThat(found.kicks()).hasSameSizeAs(told).hasSameSizeAs(outcome.last().kicks());
    for (var kick : found.kicks()) {
      double unix = found.epoch().unixSeconds(kick.time());
      Optional<CommandFile.Command> command = CommandFile.of(told, unix, kick.robot());
      assertThat(command).isPresent();
      assertThat(command.get().unixTime()).isCloseTo(unix, within(0.06));
    }
  }

  @Test
  void aVisionThatIsTooLateToPlayIsNamed() throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 1)
            .withLimits(PlayLimits.DEFAULT.withPatience(2, 10), Optional.empty());
    LateField field = field(request, 0.4, 0.02);
    PlaySession.Outcome outcome = new PlaySession(request, field, s -> {}).run();
    assertThat(outcome.complete()).isFalse();
    assertThat(outcome.last().state().waiting().orElseThrow())
        .isEqualTo("vision is more than 0.3 s late for 2 s");
  }

  /** The robots then do everything late, which shows it. */
  @Test
  void framesThatAreHeldUpAfterTheyWereSentAreNamed() throws Exception {
    SessionRequest request =
        SessionRequest.of(KickKind.FLAT, 1)
            .withLimits(PlayLimits.DEFAULT.withPatience(2, 40), Optional.empty());
    LateField field = new LateField(field(request, 0, 0).field, 0.5, 0.02, false);
    List<String> waited = new ArrayList<>();
    PlaySession.Outcome outcome =
        new PlaySession(request, field, s -> s.state().waiting().ifPresent(waited::add)).run();
    assertThat(waited).anyMatch(w -> w.contains("follows its commands too late"));
  }
}
