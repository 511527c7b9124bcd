package fieldcal.app.hardening;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.calibrate.InitialModels;
import fieldcal.app.calibrate.RecordingFolder;
import fieldcal.app.calibrate.SelectionFile;
import fieldcal.app.console.ActionsFuzz;
import fieldcal.app.console.ConsoleFuzz;
import fieldcal.app.diagnose.ExtendedModelFile;
import fieldcal.app.diagnose.ResultsFuzz;
import fieldcal.app.export.ExportFuzz;
import fieldcal.app.export.ExportModel;
import fieldcal.app.export.ProcessorFuzz;
import fieldcal.app.history.History;
import fieldcal.app.monitor.StateFile;
import fieldcal.app.sslsim.SimulatorFuzz;
import fieldcal.app.twin.TwinFile;
import fieldcal.gamelog.GameLogReader;
import fieldcal.gamelog.RefereeDecoder;
import fieldcal.testing.ExpectationsFuzz;
import fieldcal.vision.Epoch;
import fieldcal.vision.VisionDecoder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;

/**
 * Changes good inputs at random, and requires of everything that reads bytes that it reads them or ends with one line for the operator: an {@link IOException}, nothing else. Seeded: a failure names
 * parser, seed and number, and comes again. As a program it runs as long as wanted; {@link ParserFuzzTest} runs a little of it.
 */
public final class ParserFuzz implements AutoCloseable {
  /** A file or packet that the parser reads; what it throws besides {@link IOException} is a defect. */
  public interface Parser {
    /**
     * Reads.
     *
     * @param input changed at random
     * @throws IOException with one line, when it cannot be read
     */
    void read(byte[] input) throws IOException;
  }

  /**
   * A parser and good inputs for it.
   *
   * @param parser what is to be broken
   * @param corpus at least one input
   */
  public record Target(Parser parser, List<byte[]> corpus) {}

  /** Bytes and texts at which parsers break. */
  private static final byte[][] SPLINTERS = {
    {0},
    {(byte) 0xff},
    {(byte) 0xff, (byte) 0xff, (byte) 0xff, (byte) 0xff, 0x7f},
    {0, 0, 0, 0, 0, 0, (byte) 0xf0, 0x7f},
    {0, 0, 0, 0, 0, 0, (byte) 0xf8, 0x7f},
    text("NaN"),
    text("1e999"),
    text("-1e308"),
    text("9999999999999999999"),
    text("null"),
    text("[[[[[[[[[["),
    text("{\"a\":{"),
    text("\"\\u0000\""),
    text(","),
    text("\n"),
    text("é\u202e"),
  };

  /** What a whole word or number of a text is exchanged for, so that the text stays one and the readers' own checks are reached. */
  private static final byte[][] VALUES = {
    text("0"),
    text("-0.0"),
    text("-1"),
    text("1e-320"),
    text("1e308"),
    text("-1e308"),
    text("2147483648"),
    text("-9223372036854775808"),
    text("NaN"),
    text("Infinity"),
    text("null"),
    text("true"),
    text("\"\""),
    text("\"\u001b[2J\""),
    text("[]"),
    text("{}"),
  };

  /** An input that takes longer has hung: the slowest ones take some milliseconds, and 10 s cover pauses of a busy machine. */
  private static final long HUNG = 10_000_000_000L; // ns

  private static final Epoch EPOCH = new Epoch(1_700_000_000_000_000_000L);

  private final Map<String, Target> targets = new LinkedHashMap<>();
  private final Path scratch;
  private final ProcessorFuzz vision;
  private final ActionsFuzz actions;
  private final ConsoleFuzz console;

  private volatile String now = "nothing";
  private volatile long began = Long.MAX_VALUE; // ns

  /**
   * What a parser made of its inputs.
   *
   * @param read how many it read without an error
   * @param slowest the longest time of one input, ns
   * @param slowestNumber the number of that input
   */
  record Outcome(long read, long slowest, long slowestNumber) {}

  /**
   * Gathers the good inputs.
   *
   * @param project the project's folder
   * @param scratch a folder for the files that parsers read
   * @throws IOException when the corpus cannot be read
   */
  ParserFuzz(Path project, Path scratch) throws IOException {
    this.scratch = scratch;
    Path corpus = project.resolve("src/test/resources/fieldcal/app/hardening");
    byte[] log = head(project.resolve("test-data/erforce-flat.log.gz"), 20_000);
    List<byte[]> packets = payloads(project.resolve("test-data/erforce-flat.log.gz"));
    packets.addAll(payloads(project.resolve("test-data/world-null-chip.log.gz")));
    targets.put("game-log", new Target(file("f.log", ParserFuzz::readLog), List.of(log)));
    targets.put("gzip", new Target(file("f.log.gz", ParserFuzz::readLog), List.of(packed(log))));
    targets.put("vision", new Target(b -> new VisionDecoder(EPOCH).decode(b), packets));
    targets.put(
        "referee",
        new Target(
            b -> new RefereeDecoder(EPOCH).decode(b, 0, b.length), List.of(refereeMessage())));
    targets.put("tracker", new Target(b -> TrackerFuzz.read(b, scratch), TrackerFuzz.messages()));
    add("models", corpus, InitialModels::read, "calibration.json", "geometry_models.txt");
    add("selection", corpus, SelectionFile::read, "selection.json");
    add("extended-model", corpus, f -> ExtendedModelFile.read(f, EPOCH), "extended_model.json");
    add("state", corpus, StateFile::read, "state.json");
    add("commands", corpus, CommandFile::read, "commands.csv");
    add("twin", corpus, TwinFile::read, "twin.json");
    add("limits", corpus, ExportModel::read, "limits.json");
    add("history", corpus, f -> new History(f.getParent()).entries(), "history.jsonl");
    add("recordings", corpus, f -> RecordingFolder.decisions(f.getParent()), "recordings.json");
    targets.put("notes", new Target(ConsoleFuzz.notes(scratch), files(corpus, "console.json")));
    targets.put(
        "simulator-control", new Target(SimulatorFuzz.control(), SimulatorFuzz.controlMessages()));
    targets.put(
        "simulator-robots", new Target(SimulatorFuzz.robots(), SimulatorFuzz.robotMessages()));
    targets.put(
        "simulator-answers", new Target(SimulatorFuzz.answers(), SimulatorFuzz.answerMessages()));
    targets.putAll(ExportFuzz.targets(scratch));
    targets.putAll(ResultsFuzz.targets(scratch));
    targets.put("expected", ExpectationsFuzz.target(scratch));
    vision = new ProcessorFuzz();
    targets.put("processor-host", new Target(vision, ProcessorFuzz.good()));
    actions = new ActionsFuzz(scratch);
    targets.putAll(actions.targets());
    console = new ConsoleFuzz(scratch);
    targets.put(
        "http", new Target(console, files(corpus, "request-get.http", "request-post.http")));
  }

  private interface FileReader {
    void read(Path file) throws IOException;
  }

  private void add(String name, Path corpus, FileReader reader, String... files)
      throws IOException {
    // In a folder of its own, under its own name: some are found by it.
    Files.createDirectories(scratch.resolve(name));
    targets.put(name, new Target(file(name + "/" + files[0], reader), files(corpus, files)));
  }

  private static List<byte[]> files(Path corpus, String... names) throws IOException {
    List<byte[]> good = new ArrayList<>();
    for (String one : names) {
      good.add(Files.readAllBytes(corpus.resolve(one)));
    }
    return good;
  }

  private Parser file(String name, FileReader reader) {
    Path file = scratch.resolve(name);
    return bytes -> {
      replace(file, bytes);
      reader.read(file);
    };
  }

  /**
   * Puts an input where a parser looks for it.
   *
   * @param file new each time: a file system may wait for the disk when a file is cut to zero and written again
   * @param bytes of the input
   * @throws IOException when it cannot be written
   */
  public static void replace(Path file, byte[] bytes) throws IOException {
    Files.deleteIfExists(file);
    Files.write(file, bytes);
  }

  List<String> names() {
    return List.copyOf(targets.keySet());
  }

  /**
   * Feeds one parser.
   *
   * @param name of the parser
   * @param seed of the changes
   * @param inputs how many
   * @return what it made of them
   * @throws AssertionError when one broke it, with what is needed to do it again
   */
  Outcome run(String name, long seed, long inputs) {
    Target target = targets.get(name);
    Random random = new Random(seed);
    long read = 0;
    long slowest = 0;
    long slowestNumber = 0;
    for (long i = 0; i < inputs; i++) {
      byte[] good = target.corpus.get(random.nextInt(target.corpus.size()));
      byte[] input = i == 0 ? good : changed(good, random);
      long start = System.nanoTime();
      begin(name, seed, i, start);
      try {
        target.parser.read(input);
        read++;
      } catch (IOException e) {
        if (e.getMessage() == null || e.getMessage().isBlank()) {
          throw broke(name, seed, i, e);
        }
      } catch (RuntimeException | Error e) {
        throw broke(name, seed, i, e);
      }
      long took = System.nanoTime() - start;
      if (took > slowest) {
        slowest = took;
        slowestNumber = i;
      }
    }
    began = Long.MAX_VALUE;
    return new Outcome(read, slowest, slowestNumber);
  }

  private void begin(String name, long seed, long number, long start) {
    if (number % 1000 == 0) {
      now = name + " at input " + number + " or one of the next 1000 of seed " + seed;
    }
    began = start;
  }

  /** Ends the program, with the parser and the place where it is, when an input hangs. */
  private void watch(PrintStream out) {
    Thread watch =
        new Thread(
            () -> {
              while (true) {
                try {
                  Thread.sleep(1000);
                } catch (InterruptedException e) {
                  return;
                }
                if (began != Long.MAX_VALUE && System.nanoTime() - began > HUNG) {
                  out.println("hangs: " + now);
                  System.exit(1);
                }
              }
            },
            "watch");
    watch.setDaemon(true);
    watch.start();
  }

  /**
   * Feeds every parser what broke it once.
   *
   * @param found a folder with one folder for each parser
   * @return how many inputs there were
   * @throws IOException when they cannot be read
   */
  int runFound(Path found) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(found)) {
      files = all.filter(Files::isRegularFile).sorted().toList();
    }
    for (Path file : files) {
      String name = file.getParent().getFileName().toString();
      try {
        targets.get(name).parser.read(Files.readAllBytes(file));
      } catch (IOException e) {
        if (e.getMessage() == null || e.getMessage().isBlank()) {
          throw new AssertionError(file + " ends without a word", e);
        }
      } catch (RuntimeException | Error e) {
        throw new AssertionError(file + " breaks its parser again: " + e, e);
      }
    }
    return files.size();
  }

  private static AssertionError broke(String name, long seed, long number, Throwable why) {
    return new AssertionError(
        name + " breaks at input " + number + " of seed " + seed + ": " + why, why);
  }

  private static byte[] changed(byte[] good, Random random) {
    byte[] bytes = good.clone();
    int changes = 1 + random.nextInt(4);
    for (int i = 0; i < changes && bytes.length > 0; i++) {
      int at = random.nextInt(bytes.length);
      switch (random.nextInt(8)) {
        case 0 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
        case 1 -> bytes[at] = (byte) random.nextInt(256);
        case 2 -> bytes = Arrays.copyOf(bytes, at);
        case 3 -> bytes = spliced(bytes, at, at, SPLINTERS[random.nextInt(SPLINTERS.length)]);
        case 4 -> bytes = spliced(bytes, at, end(bytes, at, random), new byte[0]);
        case 5, 6 ->
            bytes =
                spliced(
                    bytes,
                    wordStart(bytes, at),
                    wordEnd(bytes, at),
                    VALUES[random.nextInt(VALUES.length)]);
        default -> {
          byte[] part = Arrays.copyOfRange(bytes, at, end(bytes, at, random));
          bytes = spliced(bytes, at, at, part);
        }
      }
    }
    return bytes;
  }

  private static int end(byte[] bytes, int from, Random random) {
    return Math.min(bytes.length, from + 1 + random.nextInt(40));
  }

  private static int wordStart(byte[] bytes, int at) {
    int start = at;
    while (start > 0 && isWord(bytes[start - 1])) {
      start--;
    }
    return start;
  }

  private static int wordEnd(byte[] bytes, int at) {
    int end = at;
    while (end < bytes.length && isWord(bytes[end])) {
      end++;
    }
    return end;
  }

  private static boolean isWord(byte letter) {
    return Character.isLetterOrDigit(letter) || letter == '.' || letter == '-' || letter == '+';
  }

  private static byte[] spliced(byte[] bytes, int from, int to, byte[] with) {
    byte[] result = new byte[bytes.length - (to - from) + with.length];
    System.arraycopy(bytes, 0, result, 0, from);
    System.arraycopy(with, 0, result, from, with.length);
    System.arraycopy(bytes, to, result, from + with.length, bytes.length - to);
    return result;
  }

  private static void readLog(Path file) throws IOException {
    try (GameLogReader reader = GameLogReader.open(file)) {
      VisionDecoder decoder = new VisionDecoder(EPOCH);
      while (reader.next()) {
        decoder.decode(reader.buffer(), reader.payloadOffset(), reader.payloadLength());
      }
    }
  }

  private static byte[] head(Path log, int most) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (var in = new java.util.zip.GZIPInputStream(Files.newInputStream(log))) {
      bytes.write(in.readNBytes(most));
    }
    return bytes.toByteArray();
  }

  private static byte[] packed(byte[] bytes) throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(packed)) {
      gzip.write(bytes);
    }
    return packed.toByteArray();
  }

  private static List<byte[]> payloads(Path log) throws IOException {
    List<byte[]> all = new ArrayList<>();
    try (GameLogReader reader = GameLogReader.open(log)) {
      while (all.size() < 40 && reader.next()) {
        all.add(reader.message().payload());
      }
    }
    return all;
  }

  private static byte[] refereeMessage() {
    fieldcal.proto.Referee.TeamInfo team =
        fieldcal.proto.Referee.TeamInfo.newBuilder()
            .setName("A team")
            .setScore(1)
            .setRedCards(0)
            .setYellowCards(0)
            .setTimeouts(4)
            .setTimeoutTime(300_000_000)
            .setGoalkeeper(3)
            .build();
    return fieldcal.proto.Referee.newBuilder()
        .setPacketTimestamp(1_700_000_000_000_000L)
        .setStage(fieldcal.proto.Referee.Stage.NORMAL_FIRST_HALF)
        .setCommand(fieldcal.proto.Referee.Command.NORMAL_START)
        .setCommandCounter(7)
        .setCommandTimestamp(1_700_000_000_000_000L)
        .setYellow(team)
        .setBlue(team)
        .build()
        .toByteArray();
  }

  private static byte[] text(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)).array();
  }

  /**
   * Runs for as long as wanted.
   *
   * @param args inputs per parser, seed, and, if not all, names of parsers
   * @throws IOException when the corpus cannot be read
   */
  public static void main(String[] args) throws IOException {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    long inputs = args.length > 0 ? Long.parseLong(args[0]) : 10_000_000;
    long seed = args.length > 1 ? Long.parseLong(args[1]) : 1;
    Path scratch = Files.createTempDirectory("fieldcal-fuzz");
    try (ParserFuzz fuzz =
        new ParserFuzz(Path.of(System.getProperty("fieldcal.projectDir", ".")), scratch)) {
      List<String> names =
          args.length > 2 ? Arrays.asList(args).subList(2, args.length) : fuzz.names();
      fuzz.watch(out);
      for (String name : names) {
        long begin = System.nanoTime();
        Outcome outcome = fuzz.run(name, seed, inputs);
        out.printf(
            "%-34s %,d inputs, %,d of them read, %.0f s, the slowest %.0f ms (number %d)%n",
            name,
            inputs,
            outcome.read(),
            (System.nanoTime() - begin) * 1e-9,
            outcome.slowest() * 1e-6,
            outcome.slowestNumber());
      }
    }
  }

  @Override
  public void close() throws IOException {
    vision.close();
    actions.close();
    console.close();
  }
}
