package fieldcal.app.export;

import fieldcal.app.export.format.BaseFile;
import fieldcal.app.hardening.ParserFuzz;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The files of other programs that an export edits, for {@link ParserFuzz}. */
public final class ExportFuzz {
  private ExportFuzz() {}

  /**
   * One parser for each file of each target.
   *
   * @param scratch a folder for the files
   * @return by name
   * @throws IOException when a sample cannot be read
   */
  public static Map<String, ParserFuzz.Target> targets(Path scratch) throws IOException {
    Map<String, ParserFuzz.Target> all = new LinkedHashMap<>();
    for (TargetsTest.Sample sample : TargetsTest.samples().toList()) {
      Exporter exporter = sample.exporter();
      Path file = scratch.resolve(sample.base());
      ParserFuzz.Parser parser =
          bytes -> {
            ParserFuzz.replace(file, bytes);
            exporter.into(BaseFile.read(file));
          };
      byte[] good = Files.readAllBytes(TargetsTest.file(sample.base()));
      all.put("export-" + sample.base(), new ParserFuzz.Target(parser, List.of(good)));
    }
    return all;
  }
}
