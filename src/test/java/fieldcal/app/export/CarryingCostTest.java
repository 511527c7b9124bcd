package fieldcal.app.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import fieldcal.ball.FlatModel;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.SpeedDependentRoll;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a target cannot carry is named, and its price is the distance between two predictions. */
class CarryingCostTest {
  @TempDir private Path folder;

  private static List<String> notes(String target, String model, String beside) throws IOException {
    ExportModel read = ExportModel.read(TargetsTest.file(model));
    if (beside != null) {
      read = read.beside(ExportModel.read(TargetsTest.file(beside)));
    }
    return new Exporter(Target.of(target), read, Optional.of("yellow"), Optional.of("YELLOW"))
        .notes();
  }

  @Test
  void whatIsLostIsNamedTheMostExpensiveFirst() throws IOException {
    List<String> notes = notes("ssl-vision-processor", "extended_model.json", null);
    assertThat(notes.get(0)).startsWith("Not carried: air drag (cd 0.45)");
    assertThat(notes.get(1)).startsWith("Not carried: rolling that depends on speed (slope 0.045");
    assertThat(notes).anyMatch(n -> n.contains("camera 1") && n.contains("not of the ball"));
    assertThat(notes).anyMatch(n -> n.startsWith("In all, the target's prediction is off"));
    assertThat(notes).anyMatch(n -> n.contains("calibrate without --model"));
  }

  /** The part costs more than the whole, and diagnose has a third number: a reader must not have to guess why. */
  @Test
  void partAndWholeAreRelated() throws IOException {
    String related = "The calibrated parameters make up for a part of what is not carried.";
    assertThat(notes("ssl-vision", "calibration.json", "extended_model.json"))
        .anyMatch(n -> n.startsWith("Not carried: air drag") && n.contains("That alone costs"))
        .anyMatch(n -> n.startsWith("In all") && n.contains(related) && n.contains("diagnose"));
    assertThat(notes("ssl-vision", "extended_model.json", null))
        .noneMatch(n -> n.contains(related));
  }

  @Test
  void aTargetThatHasAKeyCarriesTheEffect() throws IOException {
    List<String> notes = notes("immortals", "extended_model.json", null);
    assertThat(notes).noneMatch(n -> n.contains("rolling that depends on speed"));
  }

  @Test
  void parametersCalibratedWithoutAnEffectAreNotMixedWithIt() throws IOException {
    Exporter exporter =
        new Exporter(
            Target.of("immortals"),
            ExportModel.read(TargetsTest.file("calibration.json"))
                .beside(ExportModel.read(TargetsTest.file("extended_model.json"))),
            Optional.empty(),
            Optional.empty());
    assertThat(exporter.settings())
        .filteredOn(s -> s.path().contains("roll_speed_coefficient"))
        .singleElement()
        .satisfies(s -> assertThat(s.value()).isZero());
    assertThat(exporter.notes()).anyMatch(n -> n.contains("export extended_model.json itself"));
  }

  @Test
  void thePriceOfAirIsTheWayThatTheBallLoses() throws IOException {
    ExtendedModel model =
        new ExtendedModel(
            Optional.of(new FlatModel(-3.1, -0.24, 0.66)),
            Optional.empty(),
            List.of(new AirDrag(0.45)),
            0);
    // One kick along x, so that the root mean square is its distance.
    Path file = folder.resolve("calibration.json");
    Files.writeString(
        file,
        """
        {"schema": "fieldcal.calibration/1", "cameras": [], "sources": [],
         "kicks": [{"id": 1, "kind": "flat", "t": 10, "rms_mm": 1, "kick_position": [0, 0],
                    "kick_velocity": [6, 0, 0], "selected": true}],
         "flat": {"acc_slide": {"mean": -3.1}, "acc_roll": {"mean": -0.24}, "k_switch": {"mean": 0.66}},
         "chip": {},
         "extended_model": {"effects": [{"effect": "air_drag", "parameters": {"cd": 0.45}}]}}
        """);
    ExtendedTrajectory with = model.flatPath(10, 0, 0, 6, 0);
    ExtendedTrajectory without =
        new ExtendedModel(model.flat(), model.chip(), List.of(), 0).flatPath(10, 0, 0, 6, 0);
    double expected = 1000 * (without.stateAt(11).x() - with.stateAt(11).x());
    assertThat(expected).isGreaterThan(50);
    List<String> notes =
        new Exporter(
                Target.of("ssl-vision"), ExportModel.read(file), Optional.empty(), Optional.empty())
            .notes();
    assertThat(notes)
        .filteredOn(n -> n.startsWith("Not carried: air drag"))
        .singleElement()
        .satisfies(n -> assertThat(oneSecond(n)).isCloseTo(expected, within(0.5)));
  }

  /** grSim slides with a friction of its own, which costs most after half a second. */
  @Test
  void noKickIsFartherOffThanTheLargestDistance() throws IOException {
    String note =
        notes("grsim", "calibration.json", null).stream()
            .filter(n -> n.startsWith("In all"))
            .findFirst()
            .orElseThrow();
    Matcher mm = Pattern.compile("([0-9.]+) mm").matcher(note);
    List<Double> all = mm.results().map(r -> Double.valueOf(r.group(1))).toList();
    assertThat(all).hasSize(4);
    assertThat(all.get(0)).isGreaterThan(all.get(2));
    assertThat(all.get(3)).isGreaterThanOrEqualTo(Collections.max(all.subList(0, 3)));
  }

  /** Of grSim's chips only the bounce factor can be set. */
  @Test
  void aTargetWhoseChipsAreNotKnownIsNotSaidToRepeatThem() throws IOException {
    String file =
        """
        {"schema": "fieldcal.calibration/1", "cameras": [], "sources": [],
         "kicks": [{"id": 1, "kind": "chip", "t": 10, "rms_mm": 1, "kick_position": [0, 0],
                    "kick_velocity": [3, 0, 3], "selected": true}],
         "flat": {},
         "chip": {"damping_xy_first_hop": {"mean": 0.7}, "damping_xy_other_hops": {"mean": 0.9},
                  "damping_z": {"mean": 0.5}}}
        """;
    assertThat(ofText("grsim", file))
        .noneMatch(n -> n.startsWith("The target repeats"))
        .contains("How far its chips are off is not known: it has horizontal dampings of its own.");
    assertThat(ofText("sumatra", file)).anyMatch(n -> n.startsWith("The target repeats"));
  }

  /** A kick long after the session's begin: what changes during the session had changed by then. */
  @Test
  void effectsCountFromTheBeginOfTheSession() throws IOException {
    String file =
        """
        {"schema": "fieldcal.calibration/1", "cameras": [], "sources": [],
         "kicks": [{"id": 2, "kind": "flat", "t": 1090, "rms_mm": 1, "kick_position": [0, 0],
                    "kick_velocity": [6, 0, 0], "selected": true},
                   {"id": 1, "kind": "flat", "t": 1030, "rms_mm": 1, "kick_position": [0, 0],
                    "kick_velocity": [6, 0, 0], "selected": true}],
         "flat": {"acc_slide": {"mean": -3.1}, "acc_roll": {"mean": -0.24}, "k_switch": {"mean": 0.66}},
         "chip": {},
         "extended_model": {START "effects": [
             {"effect": "air_drag", "parameters": {"cd": 0.45}}]}}
        """;
    Path path = folder.resolve("calibration.json");
    Files.writeString(path, file.replace("START", "\"session_start_unix\": 1000,"));
    assertThat(ExportModel.read(path).extended().orElseThrow().sessionStart()).isEqualTo(1000);
    Files.writeString(path, file.replace("START", ""));
    assertThat(ExportModel.read(path).extended().orElseThrow().sessionStart()).isEqualTo(1030);
  }

  private List<String> ofText(String target, String text) throws IOException {
    Path file = folder.resolve("calibration.json");
    Files.writeString(file, text);
    return new Exporter(
            Target.of(target), ExportModel.read(file), Optional.empty(), Optional.empty())
        .notes();
  }

  private static double oneSecond(String note) {
    Matcher m = Pattern.compile("([0-9.]+) mm after 1 s").matcher(note);
    assertThat(m.find()).as(note).isTrue();
    return Double.parseDouble(m.group(1));
  }

  /** Rolling of Immortals' simulator in closed form: v = (v0 + a0/b)·e^(−bt) − a0/b (its trajectory.rs). */
  @Test
  void rollingThatDependsOnSpeedIsTheSameLawInImmortals() {
    double slope = 0.045;
    double a0 = 0.24;
    FlatModel model = new FlatModel(-3.1, -a0, 0.66);
    ExtendedModel ours =
        new ExtendedModel(
            Optional.of(model), Optional.empty(), List.of(new SpeedDependentRoll(slope)), 0);
    ExtendedTrajectory path = ours.flatPath(0, 0, 0, 5, 0);
    double switched = (0.66 * 5 - 5) / -3.1;
    for (double u = 0; u < 4; u += 0.5) {
      double v = (0.66 * 5 + a0 / slope) * Math.exp(-slope * u) - a0 / slope;
      assertThat(path.stateAt(switched + u).vx()).isCloseTo(v, within(1e-4));
    }
  }

  @Test
  void aDampingThatATargetLacksHasAPrice() throws IOException {
    assertThat(notes("erforce-tracker", "calibration.json", null))
        .anyMatch(n -> n.startsWith("The target has no horizontal damping at later impacts"))
        .anyMatch(n -> n.startsWith("In all, the target's prediction is off"));
    assertThat(notes("geometry-text", "calibration.json", null))
        .anyMatch(n -> n.startsWith("The target repeats the calibrated model"));
  }

  @Test
  void aValueOutOfTheTargetsRangeIsSaidAndPaidFor() throws IOException {
    List<String> notes = notes("ssl-vision", "calibration.json", null);
    assertThat(notes.get(0)).contains("takes at most 1.0").contains("1.0123 becomes 1.0");
  }

  /** v' = a·(1 − c·v/vmax): v(t) = vmax/c·(1 − e^(−c·a·t/vmax)), and the way is its integral. */
  @Test
  void robotsThatAccelerateLessAtSpeedComeLessFar() throws IOException {
    double a = 3.5;
    double c = 0.4;
    double top = 3.25;
    double k = c * a / top;
    double real = top / c * (1 - (1 - Math.exp(-k)) / k);
    // Without the effect the robot reaches its top speed within the second.
    double reached = top / a;
    double ideal = reached >= 1 ? a / 2 : a * reached * reached / 2 + top * (1 - reached);
    List<String> notes = notes("sumatra", "limits.json", null);
    Matcher m = Pattern.compile("comes (\\d+) mm too far").matcher(String.join(" ", notes));
    assertThat(m.find()).isTrue();
    assertThat(Double.parseDouble(m.group(1))).isCloseTo(1000 * (ideal - real), within(1.0));
    assertThat(notes).anyMatch(n -> n.contains("never seen at their braking limit"));
  }
}
