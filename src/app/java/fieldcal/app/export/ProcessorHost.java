package fieldcal.app.export;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.export.format.Editor;
import fieldcal.app.export.format.Editor.Change;
import fieldcal.app.export.format.Setting;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * The host of the league's new vision, RoboCup-SSL/ssl-vision-processor: reads its configuration and writes the ball models into it.
 *
 * <p>{@code GET /api/config} answers with the document and its revision; {@code PUT /api/config} takes a document that was based on the present revision, else the answer is 409 with {@code "error":
 * "stale"}; {@code POST /api/config/save} writes it to disk, or answers 409 with {@code "disk_changed"} when somebody edited the file meanwhile ({@code gui/cmd/ssl-vision-processor-gui/server.go} at
 * 0b07a69).
 */
public final class ProcessorHost {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String MODELS = "models";
  private static final int CONFLICT = 409;

  /** The host is in the same hall. */
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  /** Somebody who moves a slider makes many revisions in a row. */
  private static final int ATTEMPTS = 5;

  private final String url;
  private final Duration patience;
  private final HttpClient client;

  /** Is called with what would change, before it is written. */
  public interface Preview {
    /**
     * Shows the difference.
     *
     * @param changes the values with what is there now
     */
    void show(List<Change> changes);
  }

  /** Is called when the host uses the values, before they are saved: what was there must not be lost if that fails. */
  public interface Accepted {
    /**
     * Keeps what was there.
     *
     * @param before the models as they were, JSON; "null" when there were none
     * @throws IOException when it cannot be kept; then nothing is saved
     */
    void replaced(byte[] before) throws IOException;
  }

  /** Changes the models of a document. */
  private interface Edit {
    void in(ObjectNode document) throws InputException;
  }

  /**
   * A host.
   *
   * @param url for example {@code http://192.168.0.10:8085}
   * @throws InputException when it is no such address
   */
  public ProcessorHost(String url) throws InputException {
    this(url, PATIENCE);
  }

  ProcessorHost(String url, Duration patience) throws InputException {
    this.patience = patience;
    this.url = address(url);
    if (!this.url.matches("https?://[^/\\s?#@]+")) {
      throw new InputException(url + ": is not an address like http://HOST:8085");
    }
    client = HttpClient.newBuilder().connectTimeout(patience).build();
  }

  /**
   * One name for each host.
   *
   * @param url as somebody wrote it
   * @return without spaces around it and slashes at its end
   */
  public static String address(String url) {
    return url.strip().replaceFirst("/+$", "");
  }

  /**
   * Writes values and saves them. When somebody else changes the configuration meanwhile, it is read again.
   *
   * @param settings the values; their paths begin with {@code models}
   * @param preview is called with what changes, before it is written
   * @param accepted is called once with what was there
   * @throws IOException when the host cannot be reached or refuses; one line
   */
  public void apply(List<Setting> settings, Preview preview, Accepted accepted) throws IOException {
    write(
        document -> {
          List<Change> changes = new ArrayList<>();
          for (Setting setting : settings) {
            changes.add(new Change(setting, set(document, setting)));
          }
          preview.show(changes);
        },
        accepted);
  }

  /**
   * What would change.
   *
   * @param settings the values; their paths begin with {@code models}
   * @return the values with what is there now
   * @throws IOException when the host cannot be reached or refuses; one line
   */
  public List<Change> difference(List<Setting> settings) throws IOException {
    ObjectNode document = document(read());
    List<Change> changes = new ArrayList<>();
    for (Setting setting : settings) {
      changes.add(new Change(setting, set(document, setting)));
    }
    return changes;
  }

  private JsonNode read() throws IOException {
    JsonNode answer = accepted(send("GET", "/api/config", Optional.empty()));
    document(answer);
    return answer;
  }

  private ObjectNode document(JsonNode answer) throws InputException {
    if (answer.path("document") instanceof ObjectNode document
        && answer.path("state").path("revision").isNumber()) {
      return document;
    }
    throw new InputException(url + ": answers, but is not a host of ssl-vision-processor");
  }

  private static String set(ObjectNode document, Setting setting) {
    ObjectNode at = document;
    List<String> path = setting.path();
    for (String name : path.subList(0, path.size() - 1)) {
      at = at.get(name) instanceof ObjectNode known ? known : at.putObject(name);
    }
    String key = path.get(path.size() - 1);
    String before = at.path(key).asText();
    at.put(key, Double.parseDouble(setting.text()));
    return before;
  }

  /**
   * Puts models back.
   *
   * @param before as {@link #apply} gave them away
   * @return the models as they were until now, in the same form
   * @throws IOException when the host cannot be reached or refuses; one line
   */
  public byte[] restore(byte[] before) throws IOException {
    JsonNode models = MAPPER.readTree(before);
    return write(
        document -> {
          if (models.isObject()) {
            document.set(MODELS, models);
          } else {
            document.remove(MODELS);
          }
        },
        present -> {
          // Nothing is lost: what is put back is still in the history.
        });
  }

  private byte[] write(Edit edit, Accepted accepted) throws IOException {
    byte[] untouched = null;
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      JsonNode answer = read();
      ObjectNode document = document(answer);
      byte[] before =
          MAPPER.writeValueAsBytes(
              document.path(MODELS).isObject() ? document.path(MODELS) : MAPPER.nullNode());
      edit.in(document);
      ObjectNode request = MAPPER.createObjectNode();
      request.set("revision", answer.path("state").path("revision"));
      request.set("document", document);
      Optional<JsonNode> put = unlessStale("PUT", "/api/config", request);
      if (put.isEmpty()) {
        continue;
      }
      // Where somebody edits between writing and saving, what is read again are the new values.
      if (untouched == null) {
        untouched = before;
        accepted.replaced(before);
      }
      ObjectNode save = MAPPER.createObjectNode();
      save.set("revision", put.get().path("revision"));
      save.put("force", false);
      if (unlessStale("POST", "/api/config/save", save).isPresent()) {
        return untouched;
      }
    }
    throw new InputException(
        url + ": somebody else keeps changing the configuration; try again in a moment");
  }

  /** Empty when somebody else was faster. */
  private Optional<JsonNode> unlessStale(String method, String path, ObjectNode body)
      throws IOException {
    HttpResponse<String> response = send(method, path, Optional.of(body));
    if (response.statusCode() == CONFLICT) {
      String error = tree(response).path("error").asText();
      if (error.equals("stale")) {
        return Optional.empty();
      }
      if (error.equals("disk_changed")) {
        throw new InputException(
            url
                + ": uses the new values, but did not save them: somebody changed its file on disk."
                + " Decide on its page which of the two is right.");
      }
    }
    return Optional.of(accepted(response));
  }

  private JsonNode accepted(HttpResponse<String> response) throws IOException {
    if (response.statusCode() / 100 != 2) {
      String words = response.body().lines().findFirst().orElse("").strip();
      throw new InputException(
          url
              + ": refuses with status "
              + response.statusCode()
              + (words.isEmpty()
                  ? ""
                  : ": " + (words.length() > 200 ? words.substring(0, 200) : words)));
    }
    return tree(response);
  }

  private JsonNode tree(HttpResponse<String> response) throws IOException {
    try {
      return MAPPER.readTree(response.body());
    } catch (JsonProcessingException e) {
      throw new InputException(url + ": answers, but is not a host of ssl-vision-processor");
    }
  }

  private HttpResponse<String> send(String method, String path, Optional<ObjectNode> body)
      throws IOException {
    try {
      HttpRequest.Builder request =
          HttpRequest.newBuilder(URI.create(url + path)).timeout(patience);
      request.method(
          method,
          body.isEmpty()
              ? BodyPublishers.noBody()
              : BodyPublishers.ofByteArray(MAPPER.writeValueAsBytes(body.get())));
      body.ifPresent(b -> request.header("Content-Type", "application/json"));
      return whole(client.sendAsync(request.build(), head -> new LimitedText()));
    } catch (IllegalArgumentException e) {
      throw new InputException(url + ": is not an address like http://HOST:8085");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InputException(url + ": interrupted");
    } catch (IOException e) {
      String words = e.getMessage() == null ? "no connection" : e.getMessage();
      throw new InputException(url + ": cannot be reached: " + words);
    }
  }

  /** The request's own patience ends when an answer begins. */
  private HttpResponse<String> whole(CompletableFuture<HttpResponse<String>> answer)
      throws IOException, InterruptedException {
    try {
      return answer.get(2 * patience.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      throw e.getCause() instanceof IOException io ? io : new IOException(e.getCause());
    } catch (TimeoutException e) {
      answer.cancel(true);
      throw new IOException("it does not end its answer", e);
    }
  }

  /**
   * A change in words.
   *
   * @param change a value before and after
   * @return one line
   */
  public static String words(Change change) {
    Setting s = change.setting();
    String unit = s.unit().isEmpty() ? "" : " " + s.unit();
    String before = change.before().isEmpty() ? "" : change.before() + " → ";
    return Editor.words(s.path()) + "  " + before + s.text() + unit;
  }
}
