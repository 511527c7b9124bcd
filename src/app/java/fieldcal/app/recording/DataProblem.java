package fieldcal.app.recording;

import fieldcal.app.wording.Harmless;
import fieldcal.app.wording.WordList;
import fieldcal.gamelog.LogProblem;
import fieldcal.gamelog.ProblemAccount;
import fieldcal.vision.ProblemKind;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Something that was wrong with the data, in one line for the operator.
 *
 * @param where file, with the offset where there is one
 * @param what in words
 * @param count how often
 * @param advice what it means or what to do
 */
public record DataProblem(String where, String what, long count, String advice) {
  private static final Pattern ONE_CAMERA = Pattern.compile(", camera (\\d+)$");

  /**
   * Makes the texts one line. {@inheritDoc}
   *
   * @throws IllegalArgumentException when there is no advice: a problem of which nobody says what it means helps nobody
   */
  public DataProblem {
    where = Harmless.line(where);
    what = Harmless.line(what);
    if (advice.isBlank()) {
      throw new IllegalArgumentException("nothing says what it means that " + what);
    }
  }

  /**
   * One kind of what was wrong with a recording, with the first place.
   *
   * @param log the recording
   * @param account of what was wrong with it
   * @param kind that was met
   * @return the problem
   */
  public static DataProblem of(Path log, ProblemAccount account, ProblemKind kind) {
    ProblemAccount.Occurrence first = account.first(kind).get(0);
    // Of the frames before the first geometry, only the first one's camera is known.
    boolean ofFirstOnly = kind == LogProblem.FRAME_BEFORE_GEOMETRY;
    String detail = first.detail().isEmpty() || ofFirstOnly ? "" : ": " + first.detail();
    String place = log + ", " + account.place(first.offset());
    return new DataProblem(place, kind.text() + detail, account.count(kind), advice(kind));
  }

  /**
   * The same about several cameras in one line: with eight cameras, the lines of one problem would hide all others.
   *
   * @param problems in order
   * @return the same, where those that differ by the camera alone are one
   */
  public static List<DataProblem> folded(List<DataProblem> problems) {
    Map<List<Object>, List<DataProblem>> alike = new LinkedHashMap<>();
    for (DataProblem p : problems) {
      String rest = ONE_CAMERA.matcher(p.where).replaceFirst("");
      alike
          .computeIfAbsent(List.of(rest, p.what, p.count, p.advice), key -> new ArrayList<>())
          .add(p);
    }
    return alike.values().stream().map(DataProblem::ofCameras).toList();
  }

  private static DataProblem ofCameras(List<DataProblem> same) {
    DataProblem first = same.get(0);
    List<String> cameras =
        same.stream()
            .map(p -> ONE_CAMERA.matcher(p.where))
            .filter(Matcher::find)
            .map(found -> found.group(1))
            .distinct()
            .toList();
    if (cameras.size() < 2) {
      return first;
    }
    String where =
        ONE_CAMERA.matcher(first.where).replaceFirst("") + ", cameras " + WordList.of(cameras);
    return new DataProblem(where, first.what, first.count, first.advice);
  }

  private static String advice(ProblemKind kind) {
    if (kind == LogProblem.GEOMETRY_CHANGED) {
      return "cameras that changed are treated as new ones";
    }
    if (kind == LogProblem.TRUNCATED_GZIP || kind == LogProblem.DAMAGED_GZIP) {
      return "kicks after that place are lost";
    }
    if (kind == LogProblem.TRUNCATED_RECORD) {
      return "the recording before it is used";
    }
    return kind == LogProblem.FRAME_BEFORE_GEOMETRY || kind == LogProblem.FRAME_BEFORE_CAMERA
        ? "nothing to do: the frames are used"
        : "the rest of the recording is used";
  }

  private String howOften() {
    if (count < 2) {
      return what;
    }
    return what.equals(LogProblem.FRAME_BEFORE_GEOMETRY.text())
        ? count + " frames come before the first geometry"
        : what + " (" + count + " times)";
  }

  @Override
  public String toString() {
    return where
        + ": "
        + howOften()
        + ". "
        + Character.toUpperCase(advice.charAt(0))
        + advice.substring(1)
        + (advice.endsWith("?") ? "" : ".");
  }
}
