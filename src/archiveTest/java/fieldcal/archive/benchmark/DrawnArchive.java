package fieldcal.archive.benchmark;

import fieldcal.app.recording.LogOpener;
import fieldcal.app.recording.RecordingFacts;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.camera.CameraCalibration;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.GameLogWriter;
import fieldcal.gamelog.MessageType;
import fieldcal.proto.Referee;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.Region;
import fieldcal.simulation.robot.RobotLimits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * An archive with known truth: three venues, six teams, two changes of carpet, one camera that is knocked, 5 % broken logs. The same seed draws the same archive.
 *
 * @param folder where the logs are
 * @param matches in the order of their logs' names
 * @param broken names of the logs that cannot be read
 */
record DrawnArchive(Path folder, List<Match> matches, List<String> broken) {
  static final List<String> TEAMS =
      List.of("Aldebaran", "Betelgeuse", "Capella", "Deneb", "Electra", "Fomalhaut");

  private static final int VENUES = 3;
  private static final double BROKEN = 0.05;

  /** How far the knocked camera reports everything shifted, m: what cameras of real fields disagree by at least. */
  static final double KNOCK = 0.012;

  /** Of a session: the simulator's time moves by an hour with each seed, two hours from match to match, half a year from venue to venue. */
  private static final long HOURS_BETWEEN_MATCHES = 2;

  private static final long HOURS_BETWEEN_VENUES = 4380;

  /** A ball model: acc_slide, acc_roll, k_switch, damping_xy_first_hop, damping_xy_other_hops, damping_z. */
  private static final double[][] CARPETS = {
    {-3.1, -0.28, 0.65, 0.75, 0.95, 0.52},
    {-3.4, -0.235, 0.65, 0.72, 0.94, 0.50},
    {-2.8, -0.31, 0.66, 0.78, 0.92, 0.55},
    {-3.3, -0.26, 0.66, 0.70, 0.91, 0.48},
    {-3.6, -0.33, 0.64, 0.73, 0.90, 0.53},
  };

  /** Limits of the teams: speed, acceleration, braking. */
  static final double[][] LIMITS = {
    {3.0, 3.2, 3.8},
    {3.4, 3.9, 4.4},
    {2.6, 2.8, 3.1},
    {3.2, 4.4, 5.0},
    {2.2, 2.4, 2.9},
    {3.6, 3.5, 4.1}
  };

  /** A match: its log, the venue from 0 on, whether it is the first on a new carpet or with a knocked camera, and the truth of the ball. */
  record Match(
      String file,
      int venue,
      boolean newCarpet,
      boolean knocked,
      double[] ball,
      int yellow,
      int blue) {}

  /** Draws what is to be played; nothing is written yet. */
  static DrawnArchive plan(Path folder, int count, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Match> matches = new ArrayList<>();
    int each = (count + VENUES - 1) / VENUES;
    int carpet = 0;
    for (int i = 0; i < count; i++) {
      int venue = i / each;
      int within = i % each;
      int size = Math.min(each, count - venue * each);
      // The first two venues get another carpet midway, at the third a camera is knocked.
      boolean changed = venue < 2 && within == size / 2;
      carpet += within == 0 && i > 0 || changed ? 1 : 0;
      int yellow = random.nextInt(TEAMS.size());
      int blue = (yellow + 1 + random.nextInt(TEAMS.size() - 1)) % TEAMS.size();
      matches.add(
          new Match(
              String.format(Locale.ROOT, "match-%03d.log.gz", i),
              venue,
              changed,
              venue == 2 && within == size / 2,
              CARPETS[carpet],
              yellow,
              blue));
    }
    List<String> broken = new ArrayList<>();
    for (int i = 0; i < Math.round(BROKEN * count); i++) {
      broken.add(String.format(Locale.ROOT, "broken-%03d.log.gz", i));
    }
    return new DrawnArchive(folder, List.copyOf(matches), List.copyOf(broken));
  }

  /** The folder of a venue's tournament. */
  String tournament(int venue) {
    return "cup-" + (char) ('a' + venue);
  }

  /** Simulates all matches, several at the same time. */
  void write(double minutes) throws IOException {
    List<List<InstalledCamera>> rigs = new ArrayList<>();
    for (int venue = 0; venue < VENUES; venue++) {
      Files.createDirectories(folder.resolve(tournament(venue)));
      rigs.add(rig(venue));
    }
    matches.parallelStream()
        .forEach(
            match -> {
              try {
                write(match, minutes, rigs.get(match.venue()));
              } catch (IOException e) {
                throw new java.io.UncheckedIOException(e);
              }
            });
    SplittableRandom random = new SplittableRandom(5);
    for (String name : broken) {
      byte[] noise = new byte[20_000];
      random.nextBytes(noise);
      Files.write(folder.resolve(tournament(0)).resolve(name), noise);
    }
  }

  /** The cameras of a venue hang still: drawn once, and installed for every match. */
  private List<InstalledCamera> rig(int venue) throws IOException {
    Path trial = folder.resolve("trial.log");
    RecordingFiles files = RecordingFiles.besides(trial);
    files.write(
        SimulationSettings.DEFAULT
            .withSeed(1000 + venue)
            .withScenario(ScenarioSettings.of(ScenarioKind.FLAT, 1)),
        share -> {});
    List<CameraCalibration> cameras =
        RecordingFacts.of(trial, LogOpener.USUAL).geometry().orElseThrow().cameras();
    for (Path file : List.of(files.log(), files.truth(), files.commands())) {
      Files.delete(file);
    }
    List<InstalledCamera> rig = new ArrayList<>();
    for (CameraCalibration camera : cameras) {
      rig.add(
          new InstalledCamera(
              camera,
              camera,
              true,
              Region.NONE,
              0.0015,
              InstalledCamera.NoiseGrowth.IMAGE,
              0.002,
              0.01,
              71 + camera.id(),
              0.003 * camera.id(),
              0.012,
              0.001,
              Nuisance.TYPICAL,
              CameraErrors.NONE));
    }
    return rig;
  }

  private void write(Match match, double minutes, List<InstalledCamera> rig) throws IOException {
    int index = matches.indexOf(match);
    long seed = match.venue() * HOURS_BETWEEN_VENUES + (index + 1) * HOURS_BETWEEN_MATCHES;
    double[] b = match.ball();
    boolean knocked = matches.subList(0, index + 1).stream().anyMatch(Match::knocked);
    List<InstalledCamera> cameras = new ArrayList<>(rig);
    if (knocked) {
      cameras.set(1, cameras.get(1).withErrors(CameraErrors.NONE.withOffset(KNOCK, -KNOCK)));
    }
    SimulationSettings settings =
        SimulationSettings.DEFAULT
            .withSeed(seed)
            .withPhysics(BallPhysics.ideal(b[0], b[1], b[2], b[3], b[4], b[5]))
            .withInstalled(cameras)
            .withScenario(
                ScenarioSettings.of(ScenarioKind.MATCH, 0)
                    .withMatch(6, minutes)
                    .withLimits(limits(match.yellow()), limits(match.blue())));
    Path plain = folder.resolve("plain-" + match.file());
    RecordingFiles files = RecordingFiles.besides(plain);
    files.write(settings, share -> {});
    name(match, plain, folder.resolve(tournament(match.venue())).resolve(match.file()));
    for (Path file : List.of(files.log(), files.truth(), files.commands())) {
      Files.delete(file);
    }
  }

  private static RobotLimits limits(int team) {
    double[] v = LIMITS[team];
    return RobotLimits.uniform(v[0], v[1], v[2]);
  }

  /** Copies a log, with the names of the teams in the referee's messages. */
  private static void name(Match match, Path from, Path to) throws IOException {
    try (GameLogReader in = GameLogReader.open(from);
        GameLogWriter out = GameLogWriter.create(to)) {
      while (in.next()) {
        int begin = in.payloadOffset();
        byte[] payload = Arrays.copyOfRange(in.buffer(), begin, begin + in.payloadLength());
        if (in.type() == MessageType.SSL_REFBOX_2013) {
          Referee.Builder referee = Referee.parseFrom(payload).toBuilder();
          referee.getYellowBuilder().setName(TEAMS.get(match.yellow()));
          referee.getBlueBuilder().setName(TEAMS.get(match.blue()));
          payload = referee.build().toByteArray();
        }
        out.write(in.receivedNanos(), in.typeCode(), payload, 0, payload.length);
      }
    }
  }

  /** The first match on the second carpet of a venue, or with its camera knocked. */
  Optional<Match> change(int venue) {
    return matches.stream()
        .filter(m -> m.venue() == venue && (m.newCarpet() || m.knocked()))
        .findFirst();
  }
}
