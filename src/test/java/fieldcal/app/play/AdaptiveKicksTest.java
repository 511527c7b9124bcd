package fieldcal.app.play;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.Camera;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import java.util.List;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class AdaptiveKicksTest {

  private static PlaySession.Outcome play(SessionRequest request, long seed) throws Exception {
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(seed),
            request.first(),
            request.second(),
            List.of());
    return new PlaySession(
            request, new EmbeddedPlayField(field, Double.POSITIVE_INFINITY), snapshot -> {})
        .run();
  }

  @ParameterizedTest
  @EnumSource(KickKind.class)
  void itIsOverAsSoonAsEverythingIsKnownWellEnough(KickKind kind) throws Exception {
    SessionRequest request = SessionRequest.of(kind, 20).withChoice(true, 4, 0.01);
    PlaySession.Outcome outcome = play(request, 4);
    assertThat(outcome.complete()).isTrue();
    // Fewer do not show what differs from kick to kick.
    assertThat(outcome.last().kicks()).hasSizeBetween(6, 10);
    assertThat(outcome.last().kicks().stream().map(k -> k.played().robot()).distinct()).hasSize(2);
    assertThat(outcome.last().kicks())
        .anyMatch(
            k ->
                k.played().planned().speed()
                    < request.slowest() + (request.fastest() - request.slowest()) / 3)
        .anyMatch(
            k ->
                k.played().planned().speed()
                    > request.fastest() - (request.fastest() - request.slowest()) / 3);
    List<String> names =
        kind == KickKind.FLAT
            ? List.of("accSlide", "accRoll", "kSwitch")
            : List.of("dampingXyFirstHop", "dampingXyOtherHops", "dampingZ");
    assertThat(names)
        .allSatisfy(
            name -> {
              var average = outcome.last().model().get(name);
              assertThat(average.standardError()).isLessThan(0.01 * Math.abs(average.mean()));
            });
  }

  @Test
  void whatAKickWillTellIsWhatItsFitTells() throws Exception {
    SessionRequest request = SessionRequest.of(KickKind.FLAT, 4).withChoice(false, 9);
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT.withSeed(9), request.first(), request.second(), List.of());
    List<SeeingCamera> cameras =
        field.geometry().cameras().stream()
            .map(c -> new SeeingCamera(Camera.of(c), c.imageWidth(), c.imageHeight()))
            .toList();
    PlaySession.Outcome outcome =
        new PlaySession(
                request, new EmbeddedPlayField(field, Double.POSITIVE_INFINITY), snapshot -> {})
            .run();
    // The noise that the session itself goes by.
    double[] rms =
        outcome.last().kicks().stream().mapToDouble(KickResult::rmsMm).sorted().toArray();
    KickInformation information = new KickInformation(cameras, rms[rms.length / 2] / 1000, 0.6);
    for (KickResult kick : outcome.last().kicks()) {
      var played = kick.played();
      var fit = kick.fit().orElseThrow();
      double run = fit.trajectory().distanceAt(fit.kick().endTime());
      RealMatrix told =
          information.flat(
              new FlatModel(-3.1, -0.28, 0.65),
              played.x(),
              played.y(),
              played.direction(),
              kick.speed(),
              run);
      RealMatrix covariance = KickInformation.inverse(told);
      for (int i = 0; i < 3; i++) {
        double predicted = Math.sqrt(covariance.getEntry(i, i));
        double reported = fit.modelEstimates().get(i).standardError();
        assertThat(predicted / reported)
            .as("%s of %s", fit.modelEstimates().get(i).name(), played)
            // A slow ball that stops in sight tells more of accRoll than is counted on.
            .isBetween(0.5, 2.0);
      }
    }
  }

  /** Over the half-way line, half a metre beside the images of all cameras, a high chip is out of sight for too long. */
  @Test
  void chipsThatLeaveTheImagesTellLittle() {
    SessionRequest request = SessionRequest.of(KickKind.CHIP, 1);
    InteractiveField field =
        InteractiveField.of(
            SimulationSettings.DEFAULT, request.first(), request.second(), List.of());
    List<SeeingCamera> cameras =
        field.geometry().cameras().stream()
            .map(c -> new SeeingCamera(Camera.of(c), c.imageWidth(), c.imageHeight()))
            .toList();
    KickInformation information = new KickInformation(cameras, 0.002, 0.6);
    ChipModel model = ChipModel.typical();
    double angle = Math.PI / 4;
    RealMatrix low = information.chip(model, 0, 3.4, -Math.PI / 2, 5, angle, 6.5);
    RealMatrix high = information.chip(model, 0, 3.4, -Math.PI / 2, 6.5, angle, 6.5);
    assertThat(KickInformation.inverse(low).getEntry(2, 2)).isLessThan(1e-4);
    assertThat(high.getEntry(2, 2)).isLessThan(0.01 * low.getEntry(2, 2));
  }

  @Test
  void turningTheFieldDoesNotChangeWhatAChipTells() {
    Camera above = Camera.ofPosition(0, 0, 0, 5);
    KickInformation information =
        new KickInformation(List.of(new SeeingCamera(above, 0, 0)), 0.001, 0.6);
    ChipModel model = ChipModel.typical();
    RealMatrix along = information.chip(model, -3, 0, 0, 5, 0.8, 6);
    RealMatrix across = information.chip(model, 0, -3, Math.PI / 2, 5, 0.8, 6);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double scale = Math.sqrt(along.getEntry(i, i) * along.getEntry(j, j));
        assertThat(across.getEntry(i, j)).isCloseTo(along.getEntry(i, j), within(1e-6 * scale));
      }
    }
  }
}
