package fieldcal.app.export.format;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** JSON. */
final class JsonForm implements ConfigForm {

  @Override
  public String title() {
    return "JSON";
  }

  @Override
  public List<Leaf> leaves(BaseFile base) throws InputException {
    List<Leaf> leaves = new ArrayList<>();
    try (JsonParser parser = new JsonFactory().createParser(base.text())) {
      if (parser.nextToken() == null) {
        throw new InputException(base.name() + ": is empty, not JSON");
      }
      value(parser, List.of(), leaves);
      if (parser.nextToken() != null) {
        int index = (int) parser.currentTokenLocation().getCharOffset();
        throw base.error(index, "is not valid JSON: something follows the document");
      }
      return leaves;
    } catch (InputException e) {
      throw e;
    } catch (JsonProcessingException e) {
      int line = e.getLocation() == null ? 1 : e.getLocation().getLineNr();
      throw new InputException(
          base.name() + ", line " + line + ": is not valid JSON: " + e.getOriginalMessage());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void value(JsonParser parser, List<String> path, List<Leaf> leaves)
      throws IOException {
    JsonToken token = parser.currentToken();
    if (token == JsonToken.START_OBJECT) {
      while (parser.nextToken() != JsonToken.END_OBJECT) {
        String name = parser.currentName();
        parser.nextToken();
        value(parser, YamlForm.and(path, name), leaves);
      }
    } else if (token == JsonToken.START_ARRAY) {
      for (int i = 0; parser.nextToken() != JsonToken.END_ARRAY; i++) {
        value(parser, YamlForm.and(path, "[" + i + "]"), leaves);
      }
    } else {
      int start = (int) parser.currentTokenLocation().getCharOffset();
      int end = start + (token == JsonToken.VALUE_STRING ? 1 : parser.getText().length());
      leaves.add(new Leaf(path, start, end));
    }
  }

  @Override
  public String render(List<Setting> settings, List<String> comments) {
    try {
      return new ObjectMapper()
              .writerWithDefaultPrettyPrinter()
              .writeValueAsString(object(ConfigForm.tree(settings)))
          + "\n";
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static ObjectNode object(Map<?, ?> tree) {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    tree.forEach(
        (name, value) ->
            node.set(
                (String) name,
                value instanceof Setting setting
                    ? DecimalNode.valueOf(new BigDecimal(setting.text()))
                    : object((Map<?, ?>) value)));
    return node;
  }
}
