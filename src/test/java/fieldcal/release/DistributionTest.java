package fieldcal.release;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.cyclonedx.Version;
import org.cyclonedx.parsers.JsonParser;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The distribution runs where nothing is built, and says what it ships. */
class DistributionTest {
  private static final Path PROJECT = Path.of(System.getProperty("fieldcal.projectDir", "."));
  private static final String NAME = "fieldcal-" + System.getProperty("fieldcal.version");

  @TempDir private static Path folder;
  private static Path unpacked;

  @BeforeAll
  static void unpack() throws IOException {
    Path zip = PROJECT.resolve("build/distributions/" + NAME + ".zip");
    // A space, as many folders of operators have.
    Path place = Files.createDirectories(folder.resolve("un packed"));
    try (ZipInputStream in = new ZipInputStream(Files.newInputStream(zip))) {
      for (ZipEntry entry = in.getNextEntry(); entry != null; entry = in.getNextEntry()) {
        Path to = place.resolve(entry.getName());
        if (entry.isDirectory()) {
          Files.createDirectories(to);
        } else {
          Files.createDirectories(to.getParent());
          Files.copy(in, to);
        }
      }
    }
    unpacked = place.resolve(NAME);
    // What unzip does with the mode that the archive holds, java.util.zip cannot.
    assertThat(unpacked.resolve("bin/fieldcal").toFile().setExecutable(true)).isTrue();
  }

  @Test
  void runsFromAnyFolderAndThroughALink() throws Exception {
    Path link =
        Files.createSymbolicLink(folder.resolve("linked"), unpacked.resolve("bin/fieldcal"));
    Path recording = PROJECT.resolve("test-data/grsim-flat.log.gz").toAbsolutePath();

    assertThat(output(List.of(link.toString(), "--help"))).startsWith("Usage: fieldcal");
    assertThat(
            output(
                List.of(unpacked.resolve("bin/fieldcal").toString(), "info", recording.toString())))
        .contains("grsim-flat");
  }

  /** The shell makes the name: the machine that tests may have no such locale either. */
  @Test
  void opensNamesBeyondAsciiWithoutALocale() throws Exception {
    String script =
        "name=$(printf 'Gr\\303\\266\\303\\237e.log.gz'); cp \"$1\" \"$name\";"
            + " LC_ALL=C \"$2\" info \"$name\"";
    String recording = PROJECT.resolve("test-data/grsim-flat.log.gz").toAbsolutePath().toString();
    String program = unpacked.resolve("bin/fieldcal").toString();
    assertThat(output(List.of("sh", "-c", script, "sh", recording, program)))
        .startsWith("Größe.log.gz\n")
        .contains("SSL_VISION_2014 25213");
  }

  @Test
  void startsFromAnArchiveOfItsClassesThatTheFirstStartMakes() throws Exception {
    // Java 17 finds no classes in its archive where the path has a space.
    Path here = folder.resolve("packed");
    output(List.of("cp", "-r", unpacked.toString(), here.toString()));
    String program = here.resolve("bin/fieldcal").toString();
    Path archive = here.resolve("start/classes.jsa");
    Files.deleteIfExists(archive);
    Files.deleteIfExists(here.resolve("start/made-for"));
    String usage = output(List.of(program, "--help"));
    assertThat(archive).isNotEmptyFile();
    assertThat(output(List.of("env", "FIELDCAL_JAVA_OPTS=-Xlog:class+load", program, "--help")))
        .containsPattern("fieldcal\\.app\\.cli\\.Main source: shared objects file");

    Files.setPosixFilePermissions(archive, PosixFilePermissions.fromString("rw-r--r--"));
    Files.writeString(archive, "damaged");
    assertThat(output(List.of(program, "--help"))).isEqualTo(usage);

    // Another version of a library: as after an update in place.
    Path jar =
        files(here.resolve("lib")).stream()
            .filter(file -> file.getFileName().toString().startsWith("picocli"))
            .findFirst()
            .orElseThrow();
    Files.setLastModifiedTime(jar, FileTime.fromMillis(0));
    assertThat(output(List.of(program, "--help"))).isEqualTo(usage);
    assertThat(Files.size(archive)).isGreaterThan(1 << 20);
  }

  @Test
  void theListOfWhatIsShippedIsValidAndComplete() throws Exception {
    Path sbom = unpacked.resolve("sbom.json");
    assertThat(new JsonParser().validate(sbom.toFile(), Version.VERSION_16)).isEmpty();

    Set<String> listed = new TreeSet<>();
    for (JsonNode component : new ObjectMapper().readTree(sbom.toFile()).get("components")) {
      listed.add(component.get("name").asText() + "-" + component.get("version").asText() + ".jar");
      assertThat(component.get("licenses")).as(component.toString()).isNotEmpty();
      assertThat(component.get("hashes").get(0).get("content").asText()).hasSize(64);
    }
    Set<String> shipped = new TreeSet<>();
    for (Path jar : files(unpacked.resolve("lib"))) {
      if (!jar.getFileName().toString().startsWith("fieldcal-")) {
        shipped.add(jar.getFileName().toString());
      }
    }
    assertThat(listed).isEqualTo(shipped);
  }

  @Test
  void everyLibraryHasItsLicence() throws IOException {
    Path licences = unpacked.resolve("licences");
    List<String> rows =
        Files.readAllLines(licences.resolve("README.txt")).stream()
            .filter(line -> line.contains(": "))
            .toList();
    assertThat(rows)
        .hasSizeGreaterThan(10)
        .allSatisfy(
            row ->
                assertThat(licences.resolve(row.replaceFirst(".*\\((.*)\\)$", "$1")))
                    .isNotEmptyFile());
    assertThat(unpacked.resolve("NOTICE")).isNotEmptyFile();
    assertThat(unpacked.resolve("LICENSE")).isNotEmptyFile();
  }

  @Test
  void windowsGetsTheSameOptions() throws IOException {
    String unix = Files.readString(unpacked.resolve("bin/fieldcal"));
    String windows = Files.readString(unpacked.resolve("bin/fieldcal.bat"));
    assertThat(windows.replace("\r\n", "")).doesNotContain("\n");
    for (String option : List.of("-Xmx512m", "-Xmx1g", "-Dfile.encoding", "fieldcal.app.cli")) {
      assertThat(unix).contains(option);
      assertThat(windows).contains(option);
    }
    String spelledOut = windows.replace("%HOTONLY%", "$hot_only");
    Matcher tuning = Pattern.compile("tuning=(\"[^\"]+\"|-\\S+)").matcher(unix);
    int found = 0;
    while (tuning.find()) {
      found++;
      String options = tuning.group(1).replaceAll("[\";]", "");
      assertThat(spelledOut.replace("%QUICK%", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC"))
          .contains("set \"TUNING=" + options + "\"");
    }
    assertThat(found).isGreaterThan(5);
    for (String command : List.of("info", "calibrate", "monitor")) {
      assertThat(windows).contains("if \"%~1\"==\"" + command + "\" goto short");
    }
  }

  private static List<Path> files(Path directory) throws IOException {
    try (Stream<Path> all = Files.list(directory)) {
      return all.sorted().toList();
    }
  }

  private static String output(List<String> command) throws Exception {
    Process process =
        new ProcessBuilder(new ArrayList<>(command))
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .start();
    try (InputStream in = process.getInputStream()) {
      String text = new String(in.readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
      assertThat(process.waitFor()).as(text).isZero();
      return text;
    }
  }
}
