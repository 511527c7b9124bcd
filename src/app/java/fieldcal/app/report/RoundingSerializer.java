package fieldcal.app.report;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.BeanProperty;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.ser.ContextualSerializer;
import java.io.IOException;

/** Writes the numbers that {@link Rounded} marks: a page of 60 000 observations is mostly digits nobody can see. */
final class RoundingSerializer extends JsonSerializer<Object> implements ContextualSerializer {
  /** Beyond 2^53 a double has no decimals left to round. */
  private static final double EXACT_INTEGERS = 0x1p53;

  private final double power;

  /** For Jackson, which then asks for the contextual one. */
  RoundingSerializer() {
    this(0);
  }

  private RoundingSerializer(int decimals) {
    power = Math.pow(10, decimals);
  }

  @Override
  public JsonSerializer<?> createContextual(SerializerProvider provider, BeanProperty property) {
    return new RoundingSerializer(property.getAnnotation(Rounded.class).value());
  }

  @Override
  public void serialize(Object value, JsonGenerator generator, SerializerProvider provider)
      throws IOException {
    if (value instanceof double[] numbers) {
      generator.writeStartArray();
      for (double number : numbers) {
        write(number, generator);
      }
      generator.writeEndArray();
    } else {
      write((Double) value, generator);
    }
  }

  private void write(double number, JsonGenerator generator) throws IOException {
    double scaled = Math.rint(number * power);
    if (!Double.isFinite(number)) {
      generator.writeNull();
    } else if (Math.abs(scaled) >= EXACT_INTEGERS) {
      generator.writeNumber(number);
    } else if (scaled % power == 0) {
      generator.writeNumber((long) (scaled / power));
    } else {
      generator.writeNumber(scaled / power);
    }
  }
}
