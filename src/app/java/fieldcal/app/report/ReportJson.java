package fieldcal.app.report;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.module.SimpleModule;
import java.io.IOException;
import java.util.Optional;

/** A view model as the page's scripts read it. Numbers are rounded, unknown ones are null. */
final class ReportJson {
  private static final ObjectMapper MAPPER =
      new ObjectMapper()
          .registerModule(new SimpleModule().addSerializer(Optional.class, new OrNull()));

  private ReportJson() {}

  /** JSON that can stand inside a script element: no text in it can end the element. */
  static String inScript(Object model) throws JsonProcessingException {
    // A '<' occurs only within strings of JSON, and there the escape means the same.
    return of(model).replace("<", "\\u003c");
  }

  static String of(Object model) throws JsonProcessingException {
    return MAPPER.writeValueAsString(model);
  }

  @SuppressWarnings("rawtypes")
  private static final class OrNull extends JsonSerializer<Optional> {
    @Override
    public void serialize(Optional value, JsonGenerator generator, SerializerProvider provider)
        throws IOException {
      if (value.isPresent()) {
        generator.writePOJO(value.get());
      } else {
        generator.writeNull();
      }
    }
  }
}
