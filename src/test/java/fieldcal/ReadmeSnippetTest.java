package fieldcal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.ObjectMapper;
import fieldcal.app.calibrate.MadeFrom;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.app.wording.EffectName;
import fieldcal.ball.BallState;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.ball.FlatTrajectory;
import fieldcal.camera.Camera;
import fieldcal.effect.Effect;
import fieldcal.effect.EffectCatalogue;
import fieldcal.effect.ExtendedModel;
import fieldcal.effect.ExtendedModelDocument;
import fieldcal.effect.ExtendedTrajectory;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.effect.motion.AirDrag;
import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.FitProblem;
import fieldcal.fit.FitSettings;
import fieldcal.fit.KickFit;
import fieldcal.fit.KickFitter;
import fieldcal.kick.Kick;
import fieldcal.kick.KickFinder;
import fieldcal.kick.KickFinderSettings;
import fieldcal.live.BallParameter;
import fieldcal.live.BallSamples;
import fieldcal.live.ConfiguredLimits;
import fieldcal.live.LiveListener;
import fieldcal.live.LiveMonitor;
import fieldcal.live.LiveSettings;
import fieldcal.live.LiveSnapshot;
import fieldcal.live.LiveStateDocument;
import fieldcal.live.LiveWarning;
import fieldcal.live.ParameterEstimate;
import fieldcal.live.SimulatedMatch;
import fieldcal.movement.PlayPhase;
import fieldcal.movement.TeamLimits;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.SimulatedRecording;
import fieldcal.simulation.Simulation;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.Epoch;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.Team;
import fieldcal.vision.VisionDecoder;
import fieldcal.vision.VisionEncoder;
import fieldcal.vision.VisionPacket;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The Java of the README and of docs/ is this test's Java, and it works; their links lead somewhere. */
class ReadmeSnippetTest {
  /** Words; chosen, so that a newcomer reads all of it. */
  private static final int LONGEST_README = 1500;

  private static final String IMPORT = "import ";

  @Test
  void theLibraryIsUsedAsTheReadmeShows() {
    SimulatedRecording recording =
        Simulation.record(
            SimulationSettings.DEFAULT.withScenario(ScenarioKind.FLAT, 3).withSeed(5));
    VisionEncoder encoder = new VisionEncoder(recording.epoch());
    List<byte[]> packets =
        recording.packets().stream().map(p -> encoder.encode(p.packet())).toList();
    double now = recording.epoch().unixSeconds(0);

    Epoch epoch = Epoch.atSecondOf(now); // now: Unix time, s
    VisionDecoder decoder = new VisionDecoder(epoch);
    Map<Integer, Camera> cameras = new HashMap<>();
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    for (byte[] packet : packets) { // each packet of vision, as it comes
      VisionPacket vision = decoder.decode(packet);
      if (vision.geometry().isPresent()) { // whenever vision publishes it
        FieldGeometry field = vision.geometry().get();
        field.cameras().forEach(c -> cameras.put(c.id(), Camera.of(c)));
        finder.geometry(field, cameras);
      }
      vision.frame().ifPresent(finder::accept); // every frame of every camera
    }
    finder.finish();

    CameraViews views =
        CameraViews.of(
            cameras.values().stream().map(c -> CameraView.of(c.id(), Optional.of(c))).toList());
    KickFitter fitter = new KickFitter(FitSettings.defaults());
    KickFit fit =
        fitter.fit(FitProblem.of(kicks.get(0), views, FlatModel.typical(), ChipModel.typical()));

    FlatModel model =
        new FlatModel(
            -3.1, -0.28, 0.65); // acc_slide, acc_roll (m/s²) and k_switch of calibration.json
    double speed = model.kickSpeedToArrive(4.0, 1.5); // m/s, to arrive 4 m away with 1.5 m/s
    FlatTrajectory path = FlatTrajectory.fromKick(model, 0, 0, 0, speed, 0);
    double arrival = path.timeAtDistance(4.0).orElseThrow(); // s

    assertThat(kicks).hasSize(3);
    assertThat(fit.failure()).isEmpty();
    assertThat(fit.toString()).contains("accSlide");
    assertThat(path.stateAt(arrival).groundSpeed()).isCloseTo(1.5, within(1e-9));
  }

  @Test
  void anExtendedModelIsUsedAsTheReadmeShows(@TempDir Path folder) throws IOException {
    ExtendedModel drag =
        new ExtendedModel(
            Optional.of(FlatModel.typical()), Optional.empty(), List.of(new AirDrag(0.45)), 0);
    Path written = folder.resolve("extended_model.json");
    ExtendedModelFile.write(drag, new Epoch(0), MadeFrom.UNKNOWN, written);
    File file = written.toFile();
    double t0 = 0;
    double x = 1;
    double y = 2;
    double vx = 5;
    double vy = 0;

    Map<?, ?> document = new ObjectMapper().readValue(file, Map.class); // extended_model.json
    ExtendedModel model =
        ExtendedModelDocument.read(
            document); // kick times in Unix time; IllegalArgumentException names a damaged field
    ExtendedTrajectory pass =
        model.flatPath(t0, x, y, vx, vy); // right after the kick, in vision's field frame
    BallState ball = pass.stateAt(t0 + 0.5);
    double rest = pass.restTime();
    OptionalDouble there = pass.timeAtDistance(3.0);

    assertThat(model).isEqualTo(drag);
    assertThat(ball.x()).isBetween(2.5, 3.5);
    assertThat(rest).isBetween(2.0, 20.0);
    assertThat(there.orElseThrow()).isBetween(0.6, 1.0);
  }

  @Test
  void aMatchIsWatchedAsTheReadmeShows() {
    SimulatedRecording match = SimulatedMatch.play(8, 0.4, -0.28).recording();
    Epoch epoch = match.epoch();
    VisionDecoder decoder = new VisionDecoder(epoch);
    VisionEncoder encoder = new VisionEncoder(epoch);
    List<byte[]> packets = match.packets().stream().map(p -> encoder.encode(p.packet())).toList();
    Map<String, Object> earlier = LiveStateDocument.of(BallSamples.NONE);
    Consumer<String> screen = text -> {};
    FlatModel model = FlatModel.typical();

    LiveListener listener =
        new LiveListener() {
          @Override
          public void warningRaised(LiveWarning warning) {
            screen.accept(warning.text()); // raised once, until warningCleared
          }
        };
    ExecutorService fits =
        Executors.newSingleThreadExecutor(); // or none: call monitor.poll() when you have time
    LiveMonitor monitor = new LiveMonitor(LiveSettings.defaults(), epoch, listener, fits);
    monitor.add(LiveStateDocument.read(earlier)); // earlier matches on this carpet, if you keep any
    monitor.configured(Team.YELLOW, new ConfiguredLimits(3.0, 3.5, 5.0)); // your robots

    for (byte[] packet : packets) { // your vision thread
      VisionPacket vision = decoder.decode(packet);
      vision.geometry().ifPresent(monitor::geometry);
      monitor.phase(PlayPhase.RUNNING); // from the referee; without it, everything counts
      vision.frame().ifPresent(monitor::accept);
    }

    LiveSnapshot snapshot = monitor.snapshot(); // from any thread, immutable
    ParameterEstimate roll = snapshot.ball().of(BallParameter.ACC_ROLL);
    double accRoll = roll.enough() ? roll.median() : model.accRoll(); // from 31 kicks on
    Optional<TeamLimits> opponent =
        Optional.ofNullable(snapshot.movement().limits().get(Team.BLUE));

    monitor.finish();
    Map<String, Object> kept = LiveStateDocument.of(monitor.samples()); // for any JSON library

    fits.shutdown();
    assertThat(snapshot.frames()).isGreaterThan(1000);
    assertThat(snapshot.ball().counts().found()).isPositive();
    assertThat(accRoll).isEqualTo(model.accRoll());
    assertThat(opponent).isNotNull();
    assertThat(kept).containsKey("samples");
  }

  @ParameterizedTest
  @MethodSource("fieldcal.Documents#all")
  void everyLineOfASnippetStandsHere(Path document) throws IOException {
    Path tests = Documents.PROJECT.resolve("src/test/java/fieldcal");
    String source =
        squeezed(
            Files.readString(tests.resolve("ReadmeSnippetTest.java"))
                + Files.readString(tests.resolve("play/HostAdapterTest.java"))
                + Files.readString(tests.resolve("testing/CarpetExample.java")));
    assertThat(Documents.code(document, "java"))
        .filteredOn(line -> !line.startsWith("System.out") && !line.startsWith(IMPORT))
        .allSatisfy(line -> assertThat(source).as(line).contains(squeezed(line)));
  }

  /** A newcomer's compiler must find what a snippet imports. */
  @ParameterizedTest
  @MethodSource("fieldcal.Documents#all")
  void everyImportOfASnippetIsAClass(Path document) throws IOException {
    assertThat(Documents.code(document, "java"))
        .filteredOn(line -> line.startsWith(IMPORT))
        .allSatisfy(
            line ->
                assertThatCode(
                        () -> Class.forName(line.substring(IMPORT.length(), line.length() - 1)))
                    .doesNotThrowAnyException());
  }

  @Test
  void readmeAndLibraryHaveSnippets() throws IOException {
    for (String name : List.of("README.md", "docs/library.md")) {
      assertThat(Documents.code(Documents.PROJECT.resolve(name), "java")).as(name).isNotEmpty();
    }
  }

  @ParameterizedTest
  @MethodSource("fieldcal.Documents#all")
  void everyLinkLeadsSomewhere(Path document) throws IOException {
    for (String link : Documents.links(document)) {
      String[] parts = link.split("#", 2);
      Path target = parts[0].isEmpty() ? document : document.resolveSibling(parts[0]).normalize();
      assertThat(target).as("%s in %s", link, document.getFileName()).exists();
      if (parts.length == 2) {
        assertThat(Documents.anchors(target))
            .as("%s in %s", link, document.getFileName())
            .contains(parts[1]);
      }
    }
  }

  @Test
  void everyDocumentIsReachedFromTheReadme() throws IOException {
    Set<Path> reached = new TreeSet<>();
    for (String link : Documents.links(Documents.PROJECT.resolve("README.md"))) {
      reached.add(Documents.PROJECT.resolve(link.split("#", 2)[0]).normalize());
    }
    List<Path> documents = new ArrayList<>(Documents.all());
    documents.remove(Documents.PROJECT.resolve("README.md"));
    assertThat(reached).containsAll(documents);
  }

  @Test
  void everyCauseHasItsSection() throws IOException {
    String text = Files.readString(Documents.PROJECT.resolve("docs/effects.md"));
    assertThat(EffectCatalogue.all())
        .allSatisfy(
            effect -> {
              String name = EffectName.of(effect.id());
              String heading = Character.toUpperCase(name.charAt(0)) + name.substring(1);
              assertThat(text)
                  .as("named as in the report")
                  .contains("\n### " + heading + "\n\n`" + effect.id() + "`:");
            });
  }

  /** What changes what other cameras report, too, is shared out among all; the document says so of exactly these. */
  @Test
  void whatIsMeasuredAgainstTheMeanOfAllCamerasSaysSo() throws IOException {
    String text = Files.readString(Documents.PROJECT.resolve("docs/effects.md"));
    ObservedCamera other =
        new ObservedCamera(
            0,
            4,
            Optional.of(Camera.ofPosition(0, -3, 2, 5)),
            Double.NaN,
            Double.NaN,
            Double.NaN,
            Double.NaN,
            0);
    List<String> shared = new ArrayList<>();
    List<String> said = new ArrayList<>();
    for (Effect effect : EffectCatalogue.all()) {
      boolean ofOneCamera = effect.parameters().stream().anyMatch(p -> p.name().equals("camera"));
      if (ofOneCamera && effect instanceof MeasurementEffect measurement) {
        MeasurementEffect first = (MeasurementEffect) measurement.with("camera", 1);
        if (first.concerns(other)) {
          shared.add(effect.id());
        }
        int from = text.indexOf("\n`" + effect.id() + "`:");
        String section = text.substring(from, text.indexOf("\n#", from));
        if (section.replaceAll("\\s+", " ").contains("measured against the mean of all cameras")) {
          said.add(effect.id());
        }
      }
    }
    assertThat(said).isEqualTo(shared).isNotEmpty();
    String introduction =
        text.substring(
            text.indexOf("\n## Causes in cameras"), text.indexOf("\n### Offset of a camera"));
    assertThat(introduction).doesNotContain("every value is measured against the mean");
  }

  @Test
  void theReadmeIsShort() throws IOException {
    String text = Files.readString(Documents.PROJECT.resolve("README.md"));
    assertThat(text.strip().split("\\s+")).hasSizeLessThanOrEqualTo(LONGEST_README);
  }

  /** The formatter breaks lines where it likes. */
  private static String squeezed(String code) {
    return code.replaceAll("\\s+", "");
  }
}
