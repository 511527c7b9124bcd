package fieldcal.app.export.format;

import fieldcal.app.calibrate.InputException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.api.lowlevel.Compose;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;

/** YAML. */
final class YamlForm implements ConfigForm {

  @Override
  public String title() {
    return "YAML";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    // A byte order mark is no part of the document.
    int skipped = base.text().startsWith("\uFEFF") ? 1 : 0;
    String text = base.text().substring(skipped);
    LoadSettings settings = LoadSettings.builder().setUseMarks(true).build();
    try {
      Optional<Node> root = new Compose(settings).composeString(text);
      Walk walk = new Walk(text, skipped);
      root.ifPresent(node -> walk.visit(node, List.of()));
      return walk.leaves;
    } catch (MarkedYamlEngineException e) {
      int line = e.getProblemMark().map(Mark::getLine).orElse(0) + 1;
      throw new InputException(
          base.name() + ", line " + line + ": is not valid YAML: " + e.getProblem());
    } catch (NumberFormatException e) {
      // The library's own answer to an escape in which the file ends.
      throw new InputException(base.name() + ": is not valid YAML: an escape is cut off");
    } catch (YamlEngineException e) {
      String words = e.getMessage().lines().findFirst().orElse("");
      throw new InputException(base.name() + ": is not valid YAML: " + words);
    }
  }

  /** Collects values. What an alias stands for is visited once, where it is written. */
  private static final class Walk {
    private final String text;
    private final int skipped;
    private final List<Leaf> leaves = new ArrayList<>();
    private final Set<Node> visited = Collections.newSetFromMap(new IdentityHashMap<>());

    Walk(String text, int skipped) {
      this.text = text;
      this.skipped = skipped;
    }

    void visit(Node node, List<String> path) {
      if (node instanceof ScalarNode) {
        leaves.add(new Leaf(path, index(node.getStartMark()), index(node.getEndMark())));
      } else if (!visited.add(node)) {
        return;
      } else if (node instanceof MappingNode mapping) {
        for (NodeTuple tuple : mapping.getValue()) {
          if (tuple.getKeyNode() instanceof ScalarNode key) {
            visit(tuple.getValueNode(), and(path, key.getValue()));
          }
        }
      } else if (node instanceof SequenceNode sequence) {
        for (int i = 0; i < sequence.getValue().size(); i++) {
          visit(sequence.getValue().get(i), and(path, "[" + i + "]"));
        }
      }
    }

    /** Marks count code points. */
    private int index(Optional<Mark> mark) {
      return skipped + text.offsetByCodePoints(0, mark.orElseThrow().getIndex());
    }
  }

  static List<String> and(List<String> path, String name) {
    List<String> longer = new ArrayList<>(path);
    longer.add(name);
    return longer;
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    StringBuilder text = new StringBuilder();
    comments.forEach(comment -> text.append("# ").append(comment).append('\n'));
    append(text, ConfigForm.tree(settings), "");
    return text.toString();
  }

  private static void append(StringBuilder text, Map<?, ?> tree, String indent) {
    tree.forEach(
        (name, value) -> {
          text.append(indent).append(quoted((String) name)).append(':');
          if (value instanceof Setting setting) {
            text.append(' ').append(setting.text()).append('\n');
          } else {
            text.append('\n');
            append(text, (Map<?, ?>) value, indent + "  ");
          }
        });
  }

  private static String quoted(String name) {
    return name.matches("[A-Za-z_][A-Za-z0-9_-]*")
        ? name
        : '"' + name.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }
}
