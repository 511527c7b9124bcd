package fieldcal.archive.venue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Venues, carpets and changes from matches with known truth. */
class VenueStudyTest {
  private static final long HOUR = 3_600_000_000L;
  private static final double ROLL_ERROR = 0.001;
  private static final double OFFSET_ERROR = 0.0002;

  /** A venue as it is at a time; values change from match to match by a scatter. */
  private static final class Field {
    private final Random random;
    private final List<MatchFacts> matches = new ArrayList<>();
    private double x;
    private double roll = -0.28;
    private double perDay;
    private double inertia = 0.65;
    private int cameras = 4;
    private double knock;

    /** The camera without kicks; -1 when all have some. */
    private int idle = -1;

    private double error = ROLL_ERROR;
    private int calibration;
    private long time;
    private double published = -0.26;

    Field(long seed) {
      random = new Random(seed);
      x = 3 * seed;
    }

    Field play(int count) {
      for (int i = 0; i < count; i++) {
        List<CameraFacts> installed = new ArrayList<>();
        // As the fit has them: the offsets of the cameras that share kicks sum to zero.
        double mean = idle == 1 ? 0 : knock / (idle < 0 ? cameras : cameras - 1);
        for (int id = 0; id < cameras; id++) {
          double offset = (id == 1 ? knock : 0) + 0.01 * id;
          double middle =
              mean
                  + 0.01
                      * IntStream.range(0, cameras).filter(c -> c != idle).average().orElseThrow();
          String fingerprint = x + " " + id + " " + calibration;
          installed.add(
              new CameraFacts(
                  id,
                  x + 5 * id + 0.01 * calibration,
                  1,
                  5.3,
                  fingerprint,
                  measured(id, offset - middle),
                  measured(id, 0),
                  72,
                  0.001,
                  0.0003,
                  0,
                  0,
                  0.1));
        }
        Map<String, Measured> model = new TreeMap<>();
        double now = roll + perDay * time / (24.0 * HOUR);
        model.put("acc_roll", new Measured(now + noise(1.5 * error), error));
        model.put("k_switch", new Measured(inertia + noise(0.002), 0.002));
        String log = String.format("%016d", random.nextLong() >>> 8);
        matches.add(
            new MatchFacts(
                log,
                "cup",
                "log",
                time,
                time + HOUR / 2,
                12,
                9,
                "g" + calibration,
                installed,
                model,
                Map.of("acc_roll", published)));
        time += 3 * HOUR;
      }
      return this;
    }

    private Measured measured(int id, double offset) {
      double value = id == idle ? Double.NaN : offset + noise(OFFSET_ERROR);
      return new Measured(value, OFFSET_ERROR);
    }

    private double noise(double sigma) {
      return sigma * random.nextGaussian();
    }

    VenueStudy study() {
      List<MatchFacts> shuffled = new ArrayList<>(matches);
      Collections.shuffle(shuffled, random);
      List<Venue> venues = VenueFinder.find(shuffled);
      assertThat(venues).hasSize(1);
      return VenueStudy.of(venues.get(0));
    }
  }

  @Test
  void matchesAreGroupedByTheirCameras() {
    Field one = new Field(1).play(4);
    // Calibrated again between two matches: one centimetre off.
    one.calibration++;
    one.play(3);
    Field other = new Field(2).play(5);
    List<MatchFacts> all = new ArrayList<>(one.matches);
    all.addAll(other.matches);
    Collections.shuffle(all, new Random(3));
    List<Venue> venues = VenueFinder.find(all);
    assertThat(venues).extracting(v -> v.matches().size()).containsExactlyInAnyOrder(7, 5);
    assertThat(venues).extracting(Venue::name).containsExactly("V01", "V02");
    assertThat(
            VenueStudy.of(venues.stream().filter(v -> v.matches().size() == 7).findFirst().get())
                .changes())
        .singleElement()
        .satisfies(
            change -> {
              assertThat(change.kind()).isEqualTo(Change.Kind.CAMERA_CALIBRATED);
              assertThat(change.camera()).isEmpty();
              assertThat(change.last()).isEqualTo(one.matches.get(3));
            });
  }

  @Test
  void afterHalfAYearTheSamePlaceIsAnotherVenue() {
    Field field = new Field(1).play(3);
    field.calibration++;
    field.time += 24 * 180 * HOUR;
    field.play(3);
    assertThat(VenueFinder.find(field.matches)).hasSize(2);
  }

  @Test
  void aMatchWithoutGeometryIsOfNoVenue() {
    MatchFacts blind =
        new MatchFacts(
            "0", "cup", "log", 0, 1, Double.NaN, Double.NaN, null, List.of(), Map.of(), Map.of());
    assertThat(VenueFinder.find(List.of(blind))).isEmpty();
  }

  @Test
  void anotherCarpetIsFoundAndDatedWhereverItComes() {
    for (int before = 2; before <= 10; before++) {
      Field field = new Field(before).play(before);
      field.roll = -0.24;
      field.play(12 - before);
      VenueStudy study = field.study();
      assertThat(study.changes()).as("after " + before).hasSize(1);
      Change change = study.changes().get(0);
      assertThat(change.kind()).isEqualTo(Change.Kind.CARPET_OR_BALL);
      assertThat(change.last()).isEqualTo(field.matches.get(before - 1));
      assertThat(change.next()).isEqualTo(field.matches.get(before));
      assertThat(study.carpets()).extracting(Carpet::name).containsExactly("V01-1", "V01-2");
      Carpet.Pooled pooled = study.carpets().get(1).parameters().get("acc_roll");
      assertThat(pooled.value()).isEqualTo(-0.24, within(4 * pooled.error()));
      assertThat(pooled.published()).isEqualTo(-0.26);
    }
  }

  @Test
  void anotherBallIsToldFromAnotherCarpet() {
    Field field = new Field(4).play(6);
    field.inertia = 0.62;
    field.play(6);
    assertThat(field.study().changes())
        .singleElement()
        .satisfies(change -> assertThat(change.kind()).isEqualTo(Change.Kind.BALL));
  }

  @Test
  void nothingIsFoundWhereNothingChangesAndDriftIsNoChange() {
    int changes = 0;
    for (int seed = 0; seed < 200; seed++) {
      Field field = new Field(seed);
      field.perDay = seed % 2 * -0.01;
      VenueStudy study = field.play(12).study();
      changes += study.changes().size();
      if (seed % 2 == 1 && study.changes().isEmpty()) {
        Carpet.Pooled roll = study.carpets().get(0).parameters().get("acc_roll");
        assertThat(roll.drift()).isEqualTo(-0.01, within(4.5 * roll.driftError()));
      }
    }
    // Each field has eight numbers that could seem to change: 1 in 40 of the fields, at most.
    assertThat(changes).isLessThanOrEqualTo(5);
  }

  /** However well hundreds of kicks determine a parameter, a thousandth is no other carpet. */
  @Test
  void whatIsTooSmallToMatterIsNoChange() {
    Field field = new Field(5);
    field.error = 1e-6;
    field.play(6);
    field.roll = -0.2803;
    assertThat(field.play(6).study().changes()).isEmpty();
  }

  /** A field of so many cameras, one of which is knocked after five of nine matches. */
  private static Field knocked(int cameras) {
    Field field = new Field(6);
    field.cameras = cameras;
    field.play(5);
    field.knock = 0.012;
    return field.play(4);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 6})
  void aCameraThatWasKnockedIsNamed(int cameras) {
    Field field = knocked(cameras);
    assertThat(field.study().changes())
        .singleElement()
        .satisfies(
            change -> {
              assertThat(change.kind()).isEqualTo(Change.Kind.CAMERA_MOVED);
              assertThat(change.camera()).hasValue(1);
              assertThat(change.next()).isEqualTo(field.matches.get(5));
              assertThat(change.what())
                  .matches("camera 1 reports everything shifted by \\+1[12]\\.\\d mm in x.*");
            });
  }

  @Test
  void ofTwoCamerasItIsNotKnownWhichOneMoved() {
    Field field = knocked(2);
    assertThat(field.study().changes())
        .singleElement()
        .satisfies(
            change -> {
              assertThat(change.kind()).isEqualTo(Change.Kind.CAMERA_MOVED);
              assertThat(change.camera()).isEmpty();
              assertThat(change.what())
                  .matches(
                      "one or more of the cameras 0 and 1 report .* by up to 1[12]\\.\\d mm.*");
            });
  }

  /** The mean of the others is another one without it. */
  @Test
  void aCameraWithoutKicksMovesNoOther() {
    Field field = new Field(7).play(4);
    field.idle = 3;
    field.play(2);
    field.idle = -1;
    field.play(4);
    assertThat(field.study().changes()).isEmpty();
  }

  @Test
  void aSeriesThatTurnsRoundIsAChangeOfDrift() {
    Field field = new Field(8);
    field.perDay = 0.05;
    field.play(10);
    field.roll += 2 * field.perDay * field.time / (24.0 * HOUR);
    field.perDay = -field.perDay;
    field.play(10);
    assertThat(field.study().changes())
        .singleElement()
        .satisfies(
            change -> {
              assertThat(change.kind()).isEqualTo(Change.Kind.DRIFT);
              assertThat(change.what()).startsWith("drift of ").endsWith(" per day");
              assertThat(change.sigmas()).isGreaterThan(3);
            });
  }

  @Test
  void whatWasPublishedIsTheMedianOfAnEvenCountToo() {
    Field field = new Field(9).play(2);
    field.published = -0.3;
    field.play(2);
    Carpet.Pooled pooled = field.study().carpets().get(0).parameters().get("acc_roll");
    assertThat(pooled.published()).isEqualTo(-0.28, within(1e-12));
  }
}
