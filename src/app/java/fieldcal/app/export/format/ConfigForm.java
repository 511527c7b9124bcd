package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A form of configuration files. Implementations have no state. */
public interface ConfigForm {

  /**
   * The form of a name.
   *
   * @param name as descriptors of targets have it
   * @return the form
   * @throws IllegalArgumentException when there is none
   */
  static ConfigForm of(String name) {
    return switch (name) {
      case "yaml" -> new YamlForm();
      case "json" -> new JsonForm();
      case "protobuf-text" -> new ProtobufTextForm();
      case "vartypes-xml" -> new VarTypesForm();
      case "elements-xml" -> new ElementsForm();
      case "toml" -> new TomlForm();
      case "ini" -> new IniForm();
      default -> throw new IllegalArgumentException("there is no form " + name);
    };
  }

  /**
   * What the form is called.
   *
   * @return a few words
   */
  String title();

  /**
   * All single values of a file, in its order.
   *
   * @param base the file
   * @return the values; a key that is there twice is there twice
   * @throws InputException when the file is not of this form, with the place
   */
  List<Leaf> leaves(BaseFile base) throws InputException;

  /**
   * A new file.
   *
   * @param settings what it shall hold
   * @param comments lines for whoever reads it; JSON has no place for them
   * @return its text
   */
  String render(List<Setting> settings, List<String> comments);

  /** The settings as nested maps, in their order: values are maps and settings. */
  static Map<String, Object> tree(List<Setting> settings) {
    Map<String, Object> root = new LinkedHashMap<>();
    for (Setting setting : settings) {
      Map<String, Object> at = root;
      List<String> path = setting.path();
      for (String name : path.subList(0, path.size() - 1)) {
        @SuppressWarnings("unchecked")
        Map<String, Object> next =
            (Map<String, Object>) at.computeIfAbsent(name, n -> new LinkedHashMap<>());
        at = next;
      }
      at.put(path.get(path.size() - 1), setting);
    }
    return root;
  }
}
