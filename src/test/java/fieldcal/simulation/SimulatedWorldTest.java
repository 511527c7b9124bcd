package fieldcal.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.simulation.robot.RobotCommand;
import fieldcal.simulation.robot.RobotCommand.Kick;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.robot.SimulatedRobot;
import fieldcal.simulation.scenario.Scenario;
import fieldcal.simulation.truth.EndReason;
import fieldcal.simulation.truth.KickKind;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What robots do to the ball, driven tick by tick from outside. */
class SimulatedWorldTest {
  private final SimulatedRobot kicker =
      new SimulatedRobot(new RobotId(Team.YELLOW, 1), RobotLimits.DEFAULT, 0.145, -0.2, 0, 0);
  private final SimulatedRobot other =
      new SimulatedRobot(new RobotId(Team.BLUE, 2), RobotLimits.DEFAULT, 0.145, 2, 0, Math.PI);
  private final List<SimulatedPacket> packets = new ArrayList<>();
  private final Simulation simulation =
      Simulation.with(SimulationSettings.DEFAULT, new Driven(List.of(kicker, other)));

  /** Robots that the test commands. */
  private record Driven(List<SimulatedRobot> robots) implements Scenario {
    @Override
    public void tick(SimulatedWorld world) {}

    @Override
    public boolean finished(SimulatedWorld world) {
      return false;
    }

    @Override
    public double progress(SimulatedWorld world) {
      return 0;
    }
  }

  private void run(double seconds) {
    double until = simulation.world().time() + seconds;
    while (simulation.world().time() < until - 1e-9) {
      simulation.tick(packets::add);
    }
  }

  private void kick(double speed, double elevation) {
    kicker.command(RobotCommand.driveTo(-0.05, 0, 0, 0.3).kicking(new Kick(speed, elevation)));
    while (!simulation.world().kicks().running()) {
      simulation.tick(packets::add);
    }
    kicker.command(RobotCommand.HALT);
  }

  @Test
  void anArmedKickerKicksOnceAtTheDribbler() {
    other.place(2, 2, Math.PI);
    kick(3, 0);
    run(2);
    Truth truth = simulation.finish(packets::add);
    assertThat(truth.kicks()).hasSize(1);
    KickTruth kick = truth.kicks().get(0);
    assertThat(kick.kind()).isEqualTo(KickKind.FLAT);
    assertThat(kick.position().x() - kick.robotPose().x()).isBetween(0.0965, 0.1);
    assertThat(kick.end()).isEqualTo(EndReason.RECORDING_ENDED);
    assertThat(packets)
        .isSortedAccordingTo(Comparator.comparingDouble(SimulatedPacket::receivedTime));
  }

  @Test
  void aDribblerStopsAndHoldsTheBall() {
    other.command(RobotCommand.HALT.dribbling());
    kick(3, 0);
    run(2);
    assertThat(simulation.world().holder()).contains(other);
    other.command(RobotCommand.driveTo(2.5, 0.3, Math.PI, 1).dribbling());
    run(1.5);
    assertThat(other.ahead(simulation.world().ball().x(), simulation.world().ball().y()))
        .isEqualTo(SimulatedRobot.FRONT + 0.0215, within(1e-9));
    other.command(RobotCommand.HALT);
    run(0.1);
    Truth truth = simulation.finish(packets::add);
    assertThat(truth.kicks().get(0).end()).isEqualTo(EndReason.TOUCHED_ROBOT);
    assertThat(truth.kicks().get(0).endRobot()).contains(other.id());
    assertThat(truth.holds()).hasSize(1);
    assertThat(truth.holds().get(0).to() - truth.holds().get(0).from()).isGreaterThan(1.5);
  }

  @Test
  void aBallBouncesOffARobotWithoutDribbler() {
    kick(4, 0);
    run(2);
    Truth truth = simulation.finish(packets::add);
    assertThat(truth.kicks()).hasSize(2);
    KickTruth deflection = truth.kicks().get(1);
    assertThat(deflection.kind()).isEqualTo(KickKind.DEFLECTION);
    assertThat(deflection.velocity().x()).isBetween(-1.5, -0.3);
    assertThat(deflection.position().x()).isEqualTo(2 - 0.075 - 0.0215, within(0.006));
  }

  @Test
  void aChipFliesOverARobot() {
    other.place(1, 0, Math.PI);
    kick(5, Math.PI / 4);
    run(0.8);
    assertThat(simulation.world().ball().x()).isGreaterThan(1.5);
    assertThat(simulation.world().kicks().running()).isTrue();
  }

  @Test
  void aCarriedBallIsNotSeen() {
    simulation.world().carryBall(1, 1, 1);
    run(1.5);
    simulation.finish(packets::add);
    long during =
        packets.stream()
            .flatMap(p -> p.packet().frame().stream())
            .filter(f -> f.captureTime() > 0.05 && f.captureTime() < 0.95)
            .flatMap(f -> f.balls().stream())
            .filter(b -> Math.hypot(b.x(), b.y()) < 0.1 || Math.hypot(b.x() - 1, b.y() - 1) < 0.1)
            .count();
    assertThat(during).isZero();
    assertThat(simulation.world().ball().x()).isEqualTo(1);
  }

  @ParameterizedTest
  @EnumSource(Preset.class)
  void presetsAreTheFieldsTheyClaimToBe(Preset preset) {
    SimulationSettings settings = preset.applyTo(SimulationSettings.DEFAULT);
    assertThat(Preset.of(preset.label())).isEqualTo(preset);
    double beta = settings.physics().ball().slidingInertiaFactor();
    double kSwitch = (1 + beta * settings.kickBehaviour().rollSpin()) / (1 + beta);
    double accSlide = settings.physics().ground().slidingFriction() * 9.81;
    if (preset == Preset.LAB) {
      assertThat(kSwitch).isEqualTo(0.65, within(1e-12));
    } else {
      assertThat(kSwitch).isEqualTo(0.66, within(0.001));
      assertThat(beta / (1 + beta) * settings.kickBehaviour().rollSpinScatter())
          .isEqualTo(0.075, within(0.001));
      assertThat(accSlide).isEqualTo(3.3, within(1e-12));
      assertThat(settings.cameras().disagreement()).isBetween(0.019, 0.027);
    }
  }
}
