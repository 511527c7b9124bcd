package fieldcal.app.export;

import fieldcal.app.export.format.BaseFile;
import fieldcal.app.hardening.ParserFuzz;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.vision.BallModels;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The models that are exported, the files of other programs that an export edits, and what a vision answers, for {@link ParserFuzz}. */
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
    all.put("export-model", new ParserFuzz.Target(model(scratch), models()));
    return all;
  }

  private static List<byte[]> models() throws IOException {
    List<byte[]> all = new ArrayList<>();
    for (String name : List.of("calibration.json", "extended_model.json", "twin.json")) {
      all.add(Files.readAllBytes(TargetsTest.file(name)));
    }
    // As geometry_models.pb has it.
    all.add(
        new BallModels(Optional.of(FlatModel.typical()), Optional.of(ChipModel.typical()))
            .toBytes());
    return all;
  }

  /** Reads the model from the name that is looked for beside others, and writes what a simulator takes of it. */
  private static ParserFuzz.Parser model(Path scratch) throws IOException {
    Path file = Files.createDirectories(scratch.resolve("model")).resolve("calibration.json");
    return bytes -> {
      ParserFuzz.replace(file, bytes);
      ExportModel model = ExportModel.read(file);
      new Exporter(Target.of("erforce-realism"), model, Optional.empty(), Optional.empty()).fresh();
    };
  }
}
