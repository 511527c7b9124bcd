package fieldcal.app.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import io.javalin.http.Context;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/** Reads what pages send, and says which field is wrong. */
final class Requests {
  /** Far more than any decision needs. */
  static final int LARGEST_BODY = 1 << 20;

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private Requests() {}

  /**
   * The body of a request.
   *
   * @throws ApiException when it is too large or no JSON object
   */
  static JsonNode body(Context request) throws IOException {
    byte[] bytes = request.bodyInputStream().readNBytes(LARGEST_BODY + 1);
    if (bytes.length > LARGEST_BODY) {
      throw new ApiException(413, "the request is larger than " + LARGEST_BODY + " bytes");
    }
    return body(bytes);
  }

  /**
   * A body that was read.
   *
   * @throws ApiException when it is no JSON object
   */
  static JsonNode body(byte[] bytes) throws IOException {
    JsonNode body;
    try {
      body = MAPPER.readTree(bytes);
    } catch (JsonProcessingException e) {
      throw ApiException.badRequest("the request is not valid JSON: " + e.getOriginalMessage());
    }
    if (body == null || !body.isObject()) {
      throw ApiException.badRequest("the request must be a JSON object");
    }
    return body;
  }

  /** One of some values, in lower case. */
  static <E extends Enum<E>> E oneOf(JsonNode body, String field, E[] values) {
    String text = body.path(field).asText();
    return Arrays.stream(values)
        .filter(value -> name(value).equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                ApiException.badRequest(
                    field
                        + " must be one of "
                        + Arrays.stream(values)
                            .map(Requests::name)
                            .collect(Collectors.joining(", "))));
  }

  static String name(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  /** A text; empty when there is none. */
  static String text(JsonNode body, String field, int longest) {
    JsonNode value = body.path(field);
    if (value.isMissingNode() || value.isNull()) {
      return "";
    }
    if (!value.isTextual() || value.asText().length() > longest) {
      throw ApiException.badRequest(
          field + " must be a text of at most " + longest + " characters");
    }
    return value.asText();
  }

  /** A whole number; empty when there is none. */
  static OptionalLong number(JsonNode body, String field) {
    JsonNode value = body.path(field);
    if (value.isMissingNode() || value.isNull()) {
      return OptionalLong.empty();
    }
    if (!value.isIntegralNumber() || !value.canConvertToLong()) {
      throw ApiException.badRequest(field + " must be a whole number");
    }
    return OptionalLong.of(value.asLong());
  }
}
